// The files of `wythe contact`: one joint law (TOML), the path it is driven along and its answer.
#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "core/files.h"
#include "core/limits.h"
#include "core/text.h"
#include "io/text/csv.h"
#include "io/text/toml_reader.h"
#include "wythe/io.h"

namespace wythe {
namespace io {

// A law file, or a whole model file of which only the materials are read.
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

constexpr const char* kOtherTables[] = {"name",  "note",  "wall",  "contact",
                                        "stage", "solve", "output"};

// The one law meant: the only one, or the one called joint. Bodies (density only) do not count.
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

struct PathColumn {
  std::string name;
  std::size_t index = 0;
};

class PathReader {
  static constexpr double kFarthest = 1e6;  // [mm]

 public:
  explicit PathReader(const std::string& file) : context_{file} {}

  std::vector<ContactPathRow> read(const std::string& text) {
    std::vector<ContactPathRow> rows;
    CsvLines lines(text, context_.file);
    const bool has_header = lines.next() && read_header(lines);
    while (has_header && !enough(context_.faults) && lines.next()) read_row(lines, rows);
    if (rows.empty() && context_.faults.empty())
      context_.fault("", 0, "", has_header ? "has no rows" : "is empty",
                     "write a header opening_mm,slip_mm and one row for each point of the path");
    throw_faults(context_);
    return rows;
  }

 private:
  bool read_header(const CsvLines& lines) {
    header_ = lines.cells();
    line_ = lines.line();
    for (PathColumn* column : {&opening_, &slip_}) {
      const auto found = std::find(header_.begin(), header_.end(), column->name);
      column->index = static_cast<std::size_t>(found - header_.begin());
      if (found == header_.end())
        context_.fault(column->name, line_, "", "no such column in the header",
                       fmt::format("the columns are {}; opening_mm and slip_mm are needed",
                                   joined(header_, ", ")));
    }
    return context_.faults.empty();
  }

  void read_row(const CsvLines& lines, std::vector<ContactPathRow>& rows) {
    const std::vector<std::string>& cells = lines.cells();
    line_ = lines.line();
    if (cells.size() != header_.size())
      return context_.fault(
          "", line_, lines.text(),
          fmt::format("has {} cells, the header has {}", cells.size(), header_.size()),
          "separate the cells by commas");
    rows.push_back({.opening = read_mm(cells, opening_), .slip = read_mm(cells, slip_)});
  }

  double read_mm(const std::vector<std::string>& cells, const PathColumn& column) {
    const std::string& cell = cells[column.index];
    const double value = number_in(cell);
    if (std::fabs(value) <= kFarthest) return value / 1e3;
    if (!std::isnan(value)) {
      context_.fault(column.name, line_, cell,
                     fmt::format("is farther than a kilometre ({:.0f} mm)", kFarthest),
                     "write it in millimetres; a joint is open or worn smooth long before");
      return 0;
    }
    context_.fault(column.name, line_, cell, "must be a finite number",
                   "write it in millimetres with a decimal point, e.g. 0.05");
    return 0;
  }

  ReadContext context_;
  int line_ = 0;
  std::vector<std::string> header_;
  PathColumn opening_{.name = "opening_mm"}, slip_{.name = "slip_mm"};
};

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
  io::resolve_materials(context, root);
  for (const char* name : io::kOtherTables) root.erase(name);
  io::LawFile file;
  io::read_table(context, root, "", file);
  if (!context.faults.empty()) io::throw_faults(context);
  const JointMaterial law = io::pick_law(context, file);
  io::throw_faults(context);
  return law;
}

std::vector<ContactPathRow> read_contact_path(const std::string& path) {
  return io::PathReader(path).read(io::read_input(path, "path.csv", kMostCsv));
}

void write_contact_answer(const std::string& path, const std::vector<ContactPathRow>& rows,
                          const std::vector<ContactAnswer>& answers) {
  std::string text =
      "opening_mm,slip_mm,normal_stress_MPa,shear_stress_MPa,damage_tension,damage_shear,"
      "damage,crushing,dissipated_N_per_m\n";
  for (std::size_t i = 0; i < rows.size() && i < answers.size(); ++i)
    text += io::answer_row(rows[i], answers[i]);
  write_file(path, text);
}

}  // namespace wythe
