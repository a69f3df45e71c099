// The files of `wythe contact`: one joint law (TOML), its loading path and its response.
#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "core/files.h"
#include "core/limits.h"
#include "core/text.h"
#include "io/keys/meant_names.h"
#include "io/text/table.h"
#include "io/text/toml_reader.h"
#include "wythe/parts/io.h"
#include "wythe/parts/units.h"

namespace wythe {
namespace io {

// A law file, or a whole model file, of which only the materials are read.
struct LawFile {
  MasonrySpec masonry;
  std::map<std::string, JointMaterial> material;
};

template <class Visitor>
void describe(Visitor& v, LawFile& file) {
  v.table("masonry", file.masonry, {});
  v.map("material", file.material, {});
}

namespace {

// The selected law: the only one, or the one named joint. Materials of bodies (density only) do not count.
JointMaterial pick_law(ReadContext& context, const LawFile& file) {
  std::vector<std::string> names;
  for (const auto& [name, material] : file.material)
    if (!std::isnan(material.normal_stiffness)) names.push_back(name);
  const auto joint = std::find(names.begin(), names.end(), "joint");
  if (joint != names.end()) return file.material.at("joint");
  if (names.size() == 1) return file.material.at(names.front());
  if (names.empty())
    context.fault("material", 0, "", "is missing, the file has no joint law",
                  "write [material.joint] and its keys under it");
  else
    context.fault("material", 0, joined(names, ", "), "several laws, and none is called joint",
                  "leave one, or call the one meant [material.joint]");
  return {};
}

// --- path ----------------------------------------------------------------------------------------

class PathReader {
  static constexpr double kFarthest = 1e3;  // [m]

 public:
  explicit PathReader(const std::string& file) : context_{file} {}

  std::vector<ContactPathRow> read(const std::string& text) {
    std::vector<ContactPathRow> rows;
    NumberTable table(text, context_.file, HeadRule::kNeeded);
    if (!table.is_empty()) {
      find(table, opening_);
      find(table, slip_);
      refuse_missing(table);
    }
    const bool is_known = !table.is_empty() && context_.faults.empty();
    while (is_known && !enough(context_.faults) && table.next())
      rows.push_back({.opening = parse_cell(table, opening_), .slip = parse_cell(table, slip_)});
    if (!thousands_.value.empty() && !tells_decimals_) context_.faults.add(std::move(thousands_));
    if (rows.empty() && context_.faults.empty())
      context_.fault("", 0, "", table.is_empty() ? "is empty" : "has no rows",
                     "write a header opening_mm,slip_mm and one row for each point of the path");
    throw_faults(context_);
    return rows;
  }

 private:
  struct Column {
    std::string name, unit;
    std::size_t index = 0;
  };

  void find(const NumberTable& table, Column& column) {
    int found = 0;
    for (std::size_t k = 0; k < table.width(); ++k) {
      const ColumnHead head = column_head(table.head()[k], {"m"});
      if (head.name != column.name || head.unit.empty()) continue;
      if (const std::string factor = factor_in_head(table.head()[k]); !factor.empty())
        context_.fault(column.name + "_mm", table.head_line(), table.head()[k],
                       fmt::format("may not be the value itself: {} changes it", factor),
                       "write the values under their name and unit alone");
      column.index = k;
      column.unit = spelt_unit(head.unit, "m");
      ++found;
    }
    if (found == 0)
      missing_.push_back(column.name + "_mm");
    else if (found > 1)
      context_.fault(column.name + "_mm", table.head_line(), "", "stands there twice",
                     "leave one of the two");
    else if (column.unit.empty())
      context_.fault(column.name + "_mm", table.head_line(), table.head()[column.index],
                     "is in no unit of length", "write it in mm");
  }

  // Refuses both columns at once, because a header with other words is one mistake.
  void refuse_missing(const NumberTable& table) {
    if (missing_.empty()) return;
    const std::vector<std::string> meant = {"opening_mm", "slip_mm"};
    std::string cure = fmt::format("the columns are {}; opening_mm and slip_mm are needed",
                                   joined(table.head(), ", "));
    for (const std::string& head : table.head())
      if (const std::string near = nearest_name(head, meant); !near.empty() && near != head) {
        cure = fmt::format("write {} in the place of {}", joined(missing_, ", "),
                           joined(table.head(), ", "));
        break;
      }
    context_.fault(
        joined(missing_, ", "), table.head_line(), "",
        missing_.size() == 1 ? "no such column in the header" : "no such columns in the header",
        cure);
  }

  double parse_cell(NumberTable& table, const Column& column) {
    const double number = table.number(column.index);
    if (std::isnan(number)) {
      Fault fault = table.no_number(column.index);
      fault.path = column.name + '_' + column.unit;
      context_.faults.add(std::move(fault));
      return 0;
    }
    tells_decimals_ = tells_decimals_ || table.tells_decimals(column.index);
    if (thousands_.value.empty() && table.may_be_thousands(column.index))
      thousands_ = {context_.file,
                    column.name + '_' + column.unit,
                    table.cell(column.index),
                    "may have three decimals or marks of thousands",
                    "write each value with a point, and with more or fewer than three decimals",
                    table.line()};
    constexpr double kNoWay = 1e100;  // in any unit
    const double value = std::fabs(number) < kNoWay
                             ? parse_quantity(fmt::format("{} {}", number, column.unit), "m")
                             : number;
    if (std::fabs(value) <= kFarthest) return value;
    context_.fault(column.name + '_' + column.unit, table.line(), table.cell(column.index),
                   fmt::format("is farther than a kilometre ({:.0f} m)", kFarthest),
                   "write it in millimetres; a joint is open or worn smooth long before");
    return 0;
  }

  ReadContext context_;
  std::vector<std::string> missing_;
  Fault thousands_;  // the first value that may contain thousands
  bool tells_decimals_ = false;
  Column opening_{.name = "opening", .unit = ""}, slip_{.name = "slip", .unit = ""};
};

constexpr const char* kAnswerHead =
    "opening_mm,slip_mm,normal_stress_MPa,shear_stress_MPa,damage_tension,damage_shear,"
    "damage,crushing,dissipated_N_per_m\n";

std::string answer_row(const ContactPathRow& row, const ContactAnswer& answer) {
  return fmt::format("{},{},{},{},{},{},{},{},{}\n", row.opening * 1e3, row.slip * 1e3,
                     answer.normal_stress / 1e6, answer.shear_stress / 1e6, answer.damage_tension,
                     answer.damage_shear, answer.damage, answer.crushing, answer.dissipated);
}

}  // namespace
}  // namespace io

JointMaterial read_law(const std::string& path) {
  return parse_law(io::read_input(path, "law.toml"), path);
}

JointMaterial parse_law(const std::string& toml_text, const std::string& file_name) {
  io::ReadContext context{file_name};
  toml::table root = io::parse_toml(toml_text, file_name);
  io::refuse_study(root, file_name);
  io::read_names_as_meant(context, root, io::known_names<ModelSpec>());
  io::resolve_materials(context, root);
  for (const io::KnownName& one : io::known_names<ModelSpec>())
    if (one.name != "masonry" && one.name != "material") root.erase(one.name);
  io::LawFile file;
  io::parse_table(context, root, "", file);
  if (!context.faults.empty()) io::throw_faults(context);
  const JointMaterial law = io::pick_law(context, file);
  io::throw_faults(context);
  return law;
}

std::vector<ContactPathRow> read_contact_path(const std::string& path) {
  return io::PathReader(path).read(io::read_input(path, "path.csv", kMostCsv));
}

void check_contact_answer(const std::string& path, const std::vector<std::string>& inputs) {
  check_answer_file(path, inputs, io::kAnswerHead);
}

void write_contact_answer(const std::string& path, const std::vector<ContactPathRow>& rows,
                          const std::vector<ContactAnswer>& answers) {
  std::string text = io::kAnswerHead;
  for (std::size_t i = 0; i < rows.size() && i < answers.size(); ++i)
    text += io::answer_row(rows[i], answers[i]);
  write_file(path, text);
}

}  // namespace wythe
