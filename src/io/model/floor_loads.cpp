// resolve_floors: the line load of a floor from its loads per area, put into the tree before it is read.
//
//   g1, g2, q [kN/m^2], psi2, span [m]  ─►  load = (g1 + g2 + psi2 q) span / 2 [kN/m]
//   mass = "rule"                       ─►  mass = load / 9.81 m/s^2 [kg/m]
//
// The combination is that for earthquakes (NTC 2018, 2.5.3), with masses of the same loads. As for materials,
// `origin` records the source of a number, and model.used.toml can be run again without these keys.
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "core/text.h"
#include "io/text/magnitude.h"
#include "io/text/toml_reader.h"
#include "materials/origin.h"
#include "units/quantity_error.h"
#include "wythe/parts/units.h"

namespace wythe::io {
namespace {

constexpr double kGravity = 9.81;  // in the load rules of codes [m/s^2]

struct Part {
  const char* key;
  const char* unit;  // "": a number
  Range range;
  const char* example;
};
constexpr std::array<Part, 5> kParts = {{{"g1", "Pa", kNotNegative, "2.6 kN/m^2"},
                                         {"g2", "Pa", kNotNegative, "1.4 kN/m^2"},
                                         {"q", "Pa", kNotNegative, "2 kN/m^2"},
                                         {"psi2", "", kZeroToOne, "0.3"},
                                         {"span", "m", kLength, "4.8 m"}}};

class Floor {
 public:
  Floor(ReadContext& context, toml::table& table, std::string path)
      : context_(context), table_(table), path_(std::move(path)) {}

  void resolve() {
    make_load();
    make_mass();
    keep_origin();
  }

 private:
  void fault(const char* key, const std::string& problem, const std::string& cure) {
    const toml::node* node = table_.get(key);
    context_.fault(under(path_, key), line_of(node ? *node : static_cast<toml::node&>(table_)),
                   node ? shown(*node) : "", problem, cure);
  }

  // The value of a key; NaN where it has a reported fault.
  double value_of(const Part& part) {
    const std::string example =
        *part.unit ? fmt::format("\"{}\"", part.example) : std::string(part.example);
    const toml::node* node = table_.get(part.key);
    double value = kUnset;
    if (!node) {
      fault(part.key, "is missing beside the other loads of this floor",
            fmt::format("write e.g. {} = {}, or load alone", part.key, example));
      return value;
    }
    try {
      if (!*part.unit && node->is_number()) value = *node->value<double>();
      if (*part.unit && node->is_string())
        value = parse_quantity(node->as_string()->get(), part.unit);
    } catch (const std::invalid_argument&) {
    }
    const bool fits = part.range.holds(value) && std::isfinite(value) &&
                      magnitude_problem(value, *part.unit ? part.unit : "1").empty();
    if (fits) return value;
    fault(part.key,
          !*part.unit                          ? "must be a number from 0 to 1, without quotes"
          : std::string_view(part.unit) == "m" ? "must be a length of more than 0 m"
                                               : "must be a load an area, at least 0 kN/m^2",
          fmt::format("write e.g. {} = {}", part.key, example));
    return kUnset;
  }

  void make_load() {
    bool any = false;
    for (const Part& part : kParts) any = any || table_.contains(part.key);
    if (!any) return;
    if (table_.contains("load"))
      fault("load", "stands beside g1, g2, q, psi2 and span, which make it", "keep load, or these");
    std::array<double, 5> v{};
    std::array<std::string, 5> words;
    for (std::size_t i = 0; i < kParts.size(); ++i) {
      v[i] = value_of(kParts[i]);
      const char* unit = kParts[i].unit;
      words[i] = !*unit ? fmt::format("{}", v[i])
                        : format_quantity(v[i], unit, *unit == 'P' ? "kN/m^2" : "m");
    }
    for (const Part& part : kParts) table_.erase(part.key);
    load_ = (v[0] + v[1] + v[3] * v[2]) * v[4] / 2;
    if (std::isnan(load_)) return;  // fault is reported
    put("load", load_, "N/m", "kN/m",
        fmt::format("by floor_load from (g1 {} + g2 {} + psi2 {} x q {}) x span {} / 2", words[0],
                    words[1], words[3], words[2], words[4]));
  }

  void make_mass() {
    const toml::node* node = table_.get("mass");
    const auto* text = node ? node->as_string() : nullptr;
    if (!text || text->get() != "rule") return;
    double load = kUnset;
    try {
      load = parse_quantity(table_["load"].value<std::string>().value_or(""), "N/m");
    } catch (const std::invalid_argument&) {
    }
    if (std::isnan(load)) {
      if (!context_.has_fault_at(under(path_, "load")) && !std::isnan(load_))
        fault("mass", "is that of load, and there is none", "give load, or the mass itself");
      table_.erase("mass");
      return;
    }
    put("mass", load / kGravity, "kg/m", "kg/m",
        "by floor_mass from load " + *table_["load"].value<std::string>() + " / 9.81 m/s^2");
  }

  void put(const char* key, double value, const char* si_unit, const char* unit,
           const std::string& by) {
    const double factor = unit_factor(unit, si_unit);
    const std::string text = fmt::format("{:.6g} {}", value / factor, unit);
    toml::node* node = table_.get(key);
    if (auto* old = node ? node->as_string() : nullptr)
      *old = text;  // keeps the line of the key
    else
      table_.insert_or_assign(key, text);
    origin_.push_back(materials::to_text({key, text, materials::Origin::kDerived, by}));
    context_.derived[under(path_, key)] = {"derived " + by, line_of(table_)};
  }

  // Lines of an earlier run stay valid while the value is unchanged.
  void keep_origin() {
    const toml::node* node = table_.get("origin");
    const toml::array* old = node ? node->as_array() : nullptr;
    if (node && !(old && (old->empty() || old->is_homogeneous<std::string>()))) return;
    for (std::size_t i = 0; old && i < old->size(); ++i) {
      const auto origin = materials::origin_of(old->get(i)->as_string()->get());
      const toml::node* value = origin ? table_.get(origin->key) : nullptr;
      if (value && shown(*value) == origin->value &&
          !context_.derived.contains(under(path_, origin->key)))
        origin_.push_back(materials::to_text(*origin));
    }
    if (!node && origin_.empty()) return;
    toml::array lines;
    for (const std::string& line : origin_) lines.push_back(line);
    table_.insert_or_assign("origin", std::move(lines));
  }

  ReadContext& context_;
  toml::table& table_;
  std::string path_;
  double load_ = 0;  // NaN: a fault prevents it
  std::vector<std::string> origin_;
};

}  // namespace

void resolve_floors(ReadContext& context, toml::table& root) {
  toml::array* floors = root["floor"].as_array();
  for (std::size_t i = 0; floors && i < floors->size(); ++i)
    if (toml::table* floor = floors->get(i)->as_table())
      Floor(context, *floor, fmt::format("floor.{}", i)).resolve();
}

}  // namespace wythe::io
