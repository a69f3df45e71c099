// parse_office: the requests of [masonry] to the tables of Circolare 7/2019, parsed before any value is searched.
#include "io/model/office.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/text.h"
#include "io/text/magnitude.h"
#include "units/quantity_error.h"
#include "wythe/parts/units.h"

namespace wythe::io {
namespace {

using materials::Datum;
using materials::Entry;
using materials::KnowledgeLevel;
using materials::Role;

class Reader {
 public:
  Reader(ReadContext& context, toml::table& table, const Entry* use, bool use_is_told)
      : context_(context), table_(table), use_(use), use_is_told_(use_is_told) {}

  OfficeMasonry parse_office() {
    parse_level();
    for (const materials::Correction& correction : materials::corrections()) read(correction);
    refuse_contradictions();
    parse_tests();
    for (const char* key : {"core", "thin_joints"}) {
      if (!table_.contains(key)) continue;
      fault(key, "has no coefficient in Table C8.5.II of 2019, unlike that of 2009",
            std::string_view(key) == "core"
                ? "draw the wall without its core (C8.5.3.1), or give values of the whole wall"
                : "leave it out");
      table_.erase(key);
    }
    table_.erase("knowledge_level");
    return std::move(out_);
  }

 private:
  void fault(const std::string& key, const std::string& problem, const std::string& cure) {
    const toml::node* node = table_.get(key);
    context_.fault("masonry." + key, line_of(node ? *node : static_cast<toml::node&>(table_)),
                   node ? shown(*node) : "", problem, cure);
  }

  // A stress [Pa]; `otherwise` if the text is none.
  static double quantity(const std::optional<std::string>& text, double otherwise) {
    try {
      const double value = parse_quantity(text.value_or(""), "Pa");
      if (magnitude_problem(value, "Pa").empty()) return value;
    } catch (const std::invalid_argument&) {
    }
    return otherwise;
  }

  void parse_level() {
    const toml::node* node = table_.get("knowledge_level");
    if (!node) return;
    const auto* text = node->as_string();
    for (const auto& known : materials::kKnowledgeLevelWords)
      if (text && text->get() == known.word) out_.level = known.value;
    if (out_.level == KnowledgeLevel::kNone) {
      fault("knowledge_level", "is no knowledge level", "write one of: LC1, LC2, LC3");
      is_told_ = true;
      return;
    }
    if (use_ && materials::is_in_table(*use_)) return;
    std::vector<std::string> rows;
    for (const Entry& entry : materials::library())
      if (materials::is_in_table(entry)) rows.emplace_back(entry.name);
    if (use_)
      fault("knowledge_level", fmt::format("{} is no row of Table C8.5.I", use_->name),
            "leave it out, or use one of: " + joined(rows, ", "));
    else if (!use_is_told_)
      fault("knowledge_level", "needs a row of Table C8.5.I",
            "write use = one of: " + joined(rows, ", "));
    out_.level = KnowledgeLevel::kNone;
    is_told_ = true;
  }

  // The given strength of the mortar in the wall.
  double stated_mortar() { return quantity(table_["mortar_strength"].value<std::string>(), 0); }

  void read(const materials::Correction& correction) {
    const std::string key = correction.key;
    const toml::node* node = table_.get(key);
    if (!node) return;
    const auto flag = node->value_exact<bool>();
    const double number = node->is_number() ? *node->value<double>() : kUnset;
    if (flag != false && !is_told_) {
      if (!flag && std::isnan(number))
        fault(key, "must be true, or a number without quotes", fmt::format("write {} = true", key));
      else
        apply(correction, number);
    }
    table_.erase(key);
  }

  // `number`: NaN means the value of the table.
  void apply(const materials::Correction& correction, double number) {
    const std::string key = correction.key;
    if (out_.level == KnowledgeLevel::kNone) {
      if (!use_is_told_)
        fault(key, "acts on values of Table C8.5.I, and none are taken",
              "write knowledge_level = \"LC1\", \"LC2\" or \"LC3\" beside it");
      return;
    }
    const Entry& entry = *use_;
    const double mortar = stated_mortar();
    const double most = materials::allowed(entry, correction, mortar);
    if (std::isnan(most)) {
      fault(key, "of bricks follows from a mortar above 2 MPa (note to Table C8.5.II)",
            "give mortar_strength = \"... MPa\" above that, or leave it out");
    } else if (most == 0) {
      std::vector<std::string> has;
      for (const materials::Correction& other : materials::corrections())
        if (materials::allowed(entry, other, 4e6) != 0) has.emplace_back(other.key);
      fault(key, fmt::format("Table C8.5.II has no such coefficient for {}", entry.name),
            fmt::format("leave it out; there are: {}", joined(has, ", ")));
    } else if (!std::isnan(number) && most < 1) {
      fault(key, "reduces by fixed factors", fmt::format("write {} = true", key));
    } else if (number < 1 || number > most) {
      fault(key, fmt::format("must lie from 1 to {:.4g}, the coefficient for {}", most, entry.name),
            fmt::format("write {} = true, or a smaller number", key));
    } else {
      out_.applied.push_back({&correction, std::isnan(number) ? most : number});
    }
  }

  void refuse_contradictions() {
    const auto has = [&](std::string_view key) {
      return std::any_of(out_.applied.begin(), out_.applied.end(),
                         [&](const materials::Applied& a) { return a.correction->key == key; });
    };
    if (has("good_mortar") && has("poor_mortar"))
      fault("poor_mortar", "stands beside good_mortar", "leave one of the two");
  }

  void parse_tests() {
    const toml::node* node = table_.get("test");
    const toml::array* list = node ? node->as_array() : nullptr;
    if (node && (!list || !list->is_homogeneous<toml::table>() || list->empty()))
      fault("test", "must be tables",
            "write [[masonry.test]] and under it of, mean, number, method");
    for (std::size_t i = 0; list && i < list->size(); ++i)
      if (const toml::table* test = list->get(i)->as_table()) parse_test(*test, std::to_string(i));
    if (out_.level == KnowledgeLevel::kLc3 && !node)
      fault("knowledge_level", "LC3 updates the table by tests, and there are none",
            "write [[masonry.test]] for each value that was tested, or LC2");
    table_.erase("test");
  }

  void parse_test(const toml::table& test, const std::string& number) {
    const std::string path = "masonry.test." + number;
    const auto refuse = [&](const char* key, const std::string& problem, const std::string& cure) {
      const toml::node* node = test.get(key);
      context_.fault(under(path, key), line_of(node ? *node : static_cast<const toml::node&>(test)),
                     node ? shown(*node) : "", problem, cure);
    };
    for (const auto& [name, value] : test)
      if (const std::string key(name.str());
          key != "of" && key != "mean" && key != "number" && key != "method" && key != "kappa")
        refuse(key.c_str(), "unknown key",
               name_advice(key, {"of", "mean", "number", "method", "kappa"}));
    if (out_.level != KnowledgeLevel::kLc3) {
      if (!is_told_ && !use_is_told_)
        refuse("of", "tests update the table at LC3 alone (C8.5.4.1)",
               "write knowledge_level = \"LC3\", or give the tested value itself");
      return;
    }
    const std::string key = test["of"].value<std::string>().value_or("");
    const std::vector<std::string> methods = materials::methods_of(key);
    if (methods.empty())
      return refuse("of", "must be a value that tests update",
                    "write one of: masonry_strength, diagonal_shear_strength, "
                    "initial_shear_strength, youngs_modulus, shear_modulus");
    const Datum* datum = materials::datum_of(*use_, Role::kMasonry, key);
    if (!datum)
      return refuse("of", fmt::format("Table C8.5.I gives none for {}", use_->name),
                    "give the tested value itself, under [masonry]");
    if (out_.tests.contains(key) || table_.contains(key))
      return refuse("of", "has a value or tests already",
                    "keep one of them; put all tests of one method together");
    const std::string method = test["method"].value<std::string>().value_or("");
    const auto kappa = materials::kappa_of(method, key);
    if (!kappa)
      return refuse("method", fmt::format("is no method of Table C8.5.III for {}", key),
                    "write one of: " + joined(methods, ", "));
    const double mean = quantity(test["mean"].value<std::string>(), kUnset);
    if (!(mean > 0))
      return refuse("mean", "must be a stress of more than 0, the mean of the tests",
                    "write e.g. mean = \"3 MPa\"");
    const auto count = test["number"].value_exact<std::int64_t>();
    if (!count || *count < 1 || *count > 1000)
      return refuse("number", "must be a whole number of tests, at least 1",
                    "write e.g. number = 3");
    const auto own = test["kappa"].value<double>();
    if (test.contains("kappa") && !(own && *own > 0 && std::isfinite(*own)))
      return refuse("kappa", "must be a number more than 0",
                    fmt::format("leave it out: Table C8.5.III has {:.4g}", *kappa));
    out_.tests[key] = {method, mean / unit_factor(datum->unit, "Pa"), static_cast<int>(*count),
                       own.value_or(*kappa)};
  }

  ReadContext& context_;
  toml::table& table_;
  const Entry* use_;
  bool use_is_told_;      // its fault is reported elsewhere
  bool is_told_ = false;  // the fault of the level is reported
  OfficeMasonry out_;
};

}  // namespace

OfficeMasonry parse_office(ReadContext& context, toml::table& masonry, const materials::Entry* use,
                           bool use_is_told) {
  return Reader(context, masonry, use, use_is_told).parse_office();
}

}  // namespace wythe::io
