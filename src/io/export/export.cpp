// wythe export: a run or a campaign as plain CSV tables (docs/howto/export.md).
//
//   curves.csv  samples.csv  state_blocks.csv  state_joints.csv  state_zones.csv  columns.json
//
// A run counts as a campaign with one sample, number 1. A store is read and written a few
// samples at a time, so neither its curves nor its states are in memory at once. Numbers
// have the shortest digits that read back as the same double. Name, unit and meaning of each
// column come from its table: curve.h, responses.h, element_columns.h, the study's inputs.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <numeric>
#include <optional>
#include <span>
#include <type_traits>

#include "core/files.h"
#include "core/limits.h"
#include "core/text.h"
#include "io/export/export_samples.h"
#include "io/results/element_columns.h"
#include "io/results/vtu.h"
#include "io/text/csv.h"
#include "io/text/hdf5_tables.h"
#include "io/text/json.h"
#include "wythe/parts/error.h"
#include "wythe/parts/formats.h"
#include "wythe/parts/io.h"
#include "wythe/parts/reading.h"
#include "wythe/parts/stored_states.h"

namespace wythe {
namespace {

namespace fs = std::filesystem;
using namespace io;

constexpr const char *kCurves = "curves.csv", *kSamples = "samples.csv",
                     *kBlocks = "state_blocks.csv", *kJoints = "state_joints.csv",
                     *kZones = "state_zones.csv", *kColumns = "columns.json", *kHdf5 = "results.h5";

bool is_export_file(const std::string& name) {
  for (const char* file : {kCurves, kSamples, kBlocks, kJoints, kZones, kColumns, kHdf5})
    if (name == file) return true;
  return false;
}

[[noreturn]] void refuse(const std::string& file, const std::string& problem,
                         const std::string& cure) {
  throw InputError({{.file = file, .problem = problem, .cure = cure}});
}

// --- tables ----------------------------------------------------------------------------------------

std::string row_of(const std::vector<std::string>& cells) {
  return joined(cells, ",") + "\r\n";  // RFC 4180
}

// Output of the tables: CSV files in a folder, or one HDF5 file there.
class Sink {
 public:
  virtual ~Sink() = default;
  virtual int add_table(const char* name, const std::vector<ExportColumn>& columns) = 0;
  virtual void add_row(int table, const std::vector<std::string>& cells) = 0;
  virtual void close() = 0;

  // Name, unit and meaning of the columns of every table.
  nlohmann::ordered_json told;
};

class CsvSink : public Sink {
 public:
  explicit CsvSink(std::string folder) : folder_(std::move(folder)) {}
  int add_table(const char* name, const std::vector<ExportColumn>& columns) override {
    std::vector<std::string> titles;
    for (const ExportColumn& column : columns) titles.push_back(csv_cell(column.name));
    files_.push_back(std::make_unique<GrowingFile>(folder_ + "/" + name));
    files_.back()->add(row_of(titles));
    return static_cast<int>(files_.size()) - 1;
  }
  void add_row(int table, const std::vector<std::string>& cells) override {
    files_[table]->add(row_of(cells));
  }
  void close() override {
    for (const std::unique_ptr<GrowingFile>& file : files_) file->close();
    write_file(folder_ + "/" + kColumns, told.dump(2) + "\n");
  }

 private:
  std::string folder_;
  std::vector<std::unique_ptr<GrowingFile>> files_;
};

class Hdf5Sink : public Sink {
 public:
  explicit Hdf5Sink(const std::string& folder) : file_(folder + "/" + kHdf5) {}
  int add_table(const char* name, const std::vector<ExportColumn>& columns) override {
    return file_.add_table(fs::path(name).stem().string(), columns);
  }
  void add_row(int table, const std::vector<std::string>& cells) override {
    file_.add_row(table, cells);
  }
  void close() override { file_.close(); }

 private:
  Hdf5File file_;
};

class Table {
 public:
  Table(Sink& sink, const char* name, std::vector<ExportColumn> columns)
      : sink_(sink), columns_(std::move(columns)), number_(sink.add_table(name, columns_)) {
    sink_.told[name] = columns_json(columns_);
  }
  void add(const std::vector<std::string>& cells) { sink_.add_row(number_, cells); }
  [[nodiscard]] const std::vector<ExportColumn>& columns() const { return columns_; }

 private:
  Sink& sink_;
  std::vector<ExportColumn> columns_;
  int number_;
};

const ExportColumn kSampleNumber{"sample", "", "number of the sample, from 1; of a run 1"};

std::vector<ExportColumn> curve_columns(ShownColumns of) {
  std::vector<ExportColumn> columns = {kSampleNumber};
  for (const CurveColumn& c : columns_shown(of))
    columns.push_back({c.name, c.unit, std::string(c.meaning) + " (" + c.over + ")"});
  return columns;
}

template <class Reading, std::size_t n>
std::vector<ExportColumn> state_columns(std::vector<ExportColumn> fixed, bool in_space,
                                        const ElementColumn<Reading> (&values)[n]) {
  std::vector<ExportColumn> columns = {
      kSampleNumber,
      {"state", "", "number of the state in its sample, from 0 in order of time"},
      {"label", "", "which state it is: peak, end, a displacement; empty of a run", true},
      {"push_displacement_mm", "mm", "displacement of the push at this state"}};
  columns.insert(columns.end(), fixed.begin(), fixed.end());
  columns.insert(columns.end(),
                 {{"x_m", "m", "its centre at the start, along the wall"},
                  {"y_m", "m", "its centre at the start, above the ground"},
                  {"displacement_x_mm", "mm", "how far its centre went along the wall"},
                  {"displacement_y_mm", "mm", "how far its centre went up"}});
  if (in_space)
    columns.insert(columns.end(),
                   {{"z_m", "m", "its centre at the start, out of the plane of x and y"},
                    {"displacement_z_mm", "mm", "how far its centre went along z"}});
  for (const ElementColumn<Reading>& c : values) columns.push_back({c.name, c.unit, c.meaning});
  return columns;
}

// --- states ----------------------------------------------------------------------------------------

// Blocks, joints or zones of one state: the displacement of each centre [mm], then a list for each column.
struct Elements {
  std::vector<Vec3> moved;
  std::vector<std::vector<double>> value;
};
struct WallState {
  std::string label;
  double displacement = 0;  // of the push [mm]
  Elements blocks = {}, joints = {}, zones = {};
};

template <class Reading, std::size_t n>
void take_values(const ElementColumn<Reading> (&columns)[n], const Reading& reading, Vec3 moved,
                 Elements& elements) {
  elements.value.resize(n);
  elements.moved.push_back(1e3 * moved);
  for (std::size_t c = 0; c < n; ++c) elements.value[c].push_back(columns[c].shown(reading));
}

Vec3 mean_of(std::span<const Vec3> places) {
  Vec3 sum;
  for (const Vec3& place : places) sum = sum + place;
  return sum / static_cast<double>(places.size());
}

// Data that do not change: the wall at the start.
struct Wall {
  const Model& model;
  State start;
  std::vector<Vec3> joint;  // middles [m]
  std::vector<Vec3> zone;   // middles [m]
  std::vector<int> zone_body;
  std::vector<std::size_t> corner_begin = {0};  // of the joints' places
  std::vector<std::size_t> cell_begin = {0};    // of the convex parts of blocks
  bool all_turns;  // rotations about all axes; not in the plane, nor in runs of early versions

  explicit Wall(const Model& of)
      : model(of), start(initial_state(of)), all_turns(dimension_of(of) == 3) {
    for (JointId j = 0; j < joint_count(model); ++j) {
      const std::vector<Vec3> places = face_now(model, start, j);
      joint.push_back(mean_of(places));
      corner_begin.push_back(corner_begin.back() + places.size());
    }
    for (std::size_t b = 0; b < static_cast<std::size_t>(model.n_block); ++b)
      cell_begin.push_back(cell_begin.back() +
                           (model.space.body.empty() ? 1 : model.space.body[b].part.size()));
    for (const ZoneReading& z : read_zones(model, start))
      zone.push_back(mean_of(std::span(z.corner).first(z.corners)));
    for (const SpaceZoneReading& z : read_space_zones(model, start)) zone.push_back(z.middle);
    zone_body.resize(zone.size());
    number_zones(model.solids.bodies);
    number_zones(model.space.solids.bodies);
  }

 private:
  template <class Body>
  void number_zones(const std::vector<Body>& bodies) {
    for (std::size_t b = 0; b < bodies.size(); ++b)
      for (int z = 0; z < bodies[b].n_zone; ++z)
        zone_body[bodies[b].first_zone + z] = static_cast<int>(b);
  }
};

WallState state_of(const Wall& wall, const Snapshot& snapshot) {
  const Model& model = wall.model;
  WallState state{.label = snapshot.label, .displacement = 1e3 * snapshot.displacement};
  for (BlockId b = 0; b < model.n_block; ++b) {
    const BlockReading now = read_block(model, snapshot.state, b);
    if (wall.all_turns)
      take_values(kSpaceBlockColumns, now, now.moved, state.blocks);
    else
      take_values(kBlockColumns, now, now.moved, state.blocks);
  }
  const std::vector<JointReading> joints = read_wall(model, snapshot.state).joints;
  for (std::size_t j = 0; j < joints.size(); ++j)
    take_values(kJointColumns, joints[j],
                mean_of(face_now(model, snapshot.state, joints[j].shape.id)) - wall.joint[j],
                state.joints);
  for (const ZoneReading& z : read_zones(model, snapshot.state))
    take_values(kZoneColumns, z, z.moved, state.zones);
  for (const SpaceZoneReading& z : read_space_zones(model, snapshot.state))
    take_values(kSpaceZoneColumns, z, z.moved, state.zones);
  return state;
}

// The first cell of each element of a file; it stands for all parts of a block.
std::vector<std::size_t> one_each(std::size_t n) {
  std::vector<std::size_t> begin(n + 1);
  std::iota(begin.begin(), begin.end(), std::size_t{0});
  return begin;
}

// The same from the VTU files of a run. `cell_begin` gives the first
// cell of each element, `corner_begin` the first point of each joint.
template <class Reading, std::size_t n>
Elements elements_in(const std::string& file, const ElementColumn<Reading> (&columns)[n],
                     const std::vector<std::size_t>& cell_begin,
                     const std::vector<std::size_t>* corner_begin = nullptr,
                     const std::vector<Vec3>* starts = nullptr) {
  const auto arrays = vtu_arrays(read_file(file, kMostPacked), file);
  const auto array = [&](const char* name, std::size_t size) -> const std::vector<double>& {
    const auto found = arrays.find(name);
    if (found == arrays.end() || found->second.size() != size)
      throw IoError(
          fmt::format("{}: its array {} has not the {} numbers of model.used.toml's "
                      "wall; the files of this run don't belong together",
                      file, name, size));
    return found->second;
  };
  Elements elements;
  const std::size_t count = cell_begin.size() - 1, cells = cell_begin.back();
  const std::vector<double>& place = corner_begin != nullptr
                                         ? array("Points", 3 * corner_begin->back())
                                         : array("displacement_mm", 3 * cells);
  const auto triple = [&](std::size_t i) {
    return Vec3{place[3 * i], place[3 * i + 1], place[3 * i + 2]};
  };
  for (std::size_t i = 0; i < count; ++i) {
    if (corner_begin == nullptr) {
      elements.moved.push_back(triple(cell_begin[i]));
      continue;
    }
    std::vector<Vec3> now;
    for (std::size_t k = (*corner_begin)[i]; k < (*corner_begin)[i + 1]; ++k)
      now.push_back(triple(k));
    elements.moved.push_back(1e3 * (mean_of(now) - (*starts)[i]));
  }
  for (const ElementColumn<Reading>& column : columns) {
    const std::vector<double>& all = array(column.name, cells);
    std::vector<double>& own = elements.value.emplace_back();
    for (std::size_t i = 0; i < count; ++i) own.push_back(all[cell_begin[i]]);
  }
  return elements;
}

class StateTables {
 public:
  explicit StateTables(Sink& sink) : sink_(sink) {}

  // Tables are created with their first row, so each file that exists has rows.
  void add(int sample, int number, const Wall& wall, const WallState& state) {
    const Model& model = wall.model;
    ++count;
    in_space_ = dimension_of(model) == 3;
    if (!blocks_) open_tables(in_space_, wall.all_turns);
    for (BlockId b = 0; b < model.n_block; ++b) {
      const BlockReading at = read_block(model, wall.start, b);
      add_row(*blocks_, {sample, number, state},
              {std::to_string(b), word_of(kBlockRoleWords, at.role),
               std::to_string(model.anatomy.block_course[b])},
              at.start, state.blocks, static_cast<std::size_t>(b));
    }
    for (std::size_t j = 0; j < wall.joint.size(); ++j) {
      const JointShape shape = joint_shape(model, static_cast<JointId>(j));
      add_row(*joints_, {sample, number, state},
              {std::to_string(j), word_of(kJointKindWords, shape.kind), std::to_string(shape.a),
               std::to_string(shape.b), csv_cell(shape.area)},
              wall.joint[j], state.joints, j);
    }
    if (!wall.zone.empty() && !zones_) open_zones(in_space_);
    for (std::size_t z = 0; z < wall.zone.size(); ++z)
      add_row(*zones_, {sample, number, state},
              {std::to_string(z), std::to_string(wall.zone_body[z])}, wall.zone[z], state.zones, z);
  }

  std::int64_t count = 0;

 private:
  struct Which {
    int sample, number;
    const WallState& state;
  };
  void open_tables(bool in_space, bool all_turns) {
    const std::vector<ExportColumn> own = {
        {"block", "", "number of the block, from 0"},
        {"role", "", "masonry, lintel, plate, beam, sill or slab", true},
        {"course", "", "number of its course, from 0; -1: none"}};
    blocks_.emplace(sink_, kBlocks,
                    all_turns ? state_columns(own, in_space, kSpaceBlockColumns)
                              : state_columns(own, in_space, kBlockColumns));
    joints_.emplace(
        sink_, kJoints,
        state_columns(
            {{"joint", "",
              "number of the joint, from 0; contacts of deformable blocks "
              "follow"},
             {"kind", "", "bed, head, split (crack plane of a unit), foundation, ...", true},
             {"block_a", "", "block on one side, -1: the ground"},
             {"block_b", "", "block on the other side"},
             {"area_m2", "m^2", "its area"}},
            in_space, kJointColumns));
  }
  void open_zones(bool in_space) {
    const std::vector<ExportColumn> own = {{"zone", "", "number of the zone, from 0"},
                                           {"body", "", "number of its deformable block, from 0"}};
    zones_.emplace(sink_, kZones,
                   in_space ? state_columns(own, true, kSpaceZoneColumns)
                            : state_columns(own, false, kZoneColumns));
  }
  void add_row(Table& table, const Which& which, const std::vector<std::string>& fixed, Vec3 at,
               const Elements& elements, std::size_t i) {
    std::vector<std::string> cells = {std::to_string(which.sample), std::to_string(which.number),
                                      csv_cell(which.state.label),
                                      csv_cell(which.state.displacement)};
    cells.insert(cells.end(), fixed.begin(), fixed.end());
    const Vec3 moved = elements.moved[i];
    for (const double value : {at.x, at.y, moved.x, moved.y}) cells.push_back(csv_cell(value));
    if (in_space_)
      for (const double value : {at.z, moved.z}) cells.push_back(csv_cell(value));
    for (const std::vector<double>& column : elements.value) cells.push_back(csv_cell(column[i]));
    table.add(cells);
  }
  Sink& sink_;
  bool in_space_ = false;
  std::optional<Table> blocks_, joints_, zones_;
};

// --- a campaign ------------------------------------------------------------------------------------

// `head` is a row with these columns.
void write_samples(Sink& sink, const std::vector<ExportCell>& head,
                   const std::vector<std::vector<ExportCell>>& rows) {
  std::vector<ExportColumn> titles;
  for (const ExportCell& cell : head) titles.push_back(cell.column);
  Table table(sink, kSamples, std::move(titles));
  for (const std::vector<ExportCell>& row : rows) {
    std::vector<std::string> cells;
    for (const ExportCell& cell : row) cells.push_back(cell.text);
    table.add(cells);
  }
}

void export_states(StoredStates& stored, const Campaign& campaign, const SampleRecord& record,
                   const ModelBuilder& build, StateTables& tables) {
  if (record.status == "refused") return;  // this wall was never built
  const Model model = compile(build(settings_of(campaign.samples, record.sample - 1)));
  const std::vector<Snapshot> snapshots = stored.of(record.sample, model);
  if (snapshots.empty()) return;
  const Wall wall(model);
  int number = 0;
  for (const Snapshot& snapshot : snapshots)
    tables.add(record.sample, number++, wall, state_of(wall, snapshot));
}

Exported export_campaign(const std::string& folder, Sink& sink) {
  Exported made;
  std::optional<Table> curves;
  std::vector<CurveColumn> shown;
  StateTables states(sink);
  std::vector<std::vector<ExportCell>> samples;
  ModelBuilder build;
  StoredStates stored(folder);
  const auto begin = [&](const Campaign& campaign) {
    build = model_builder(campaign.study);
    const ShownColumns of = columns_of(compile(build({})));
    shown = columns_shown(of);
    curves.emplace(sink, kCurves, curve_columns(of));
  };
  const Campaign campaign =
      read_campaign(folder, [&](const Campaign& head, const SampleRecord& record) {
        if (!curves) begin(head);
        samples.push_back(sample_cells(head, record));
        for (const CurveRow& row : record.curve) {
          std::vector<std::string> cells = {std::to_string(record.sample)};
          for (const CurveColumn& c : shown) cells.push_back(csv_cell(row.*c.value * c.to_unit));
          curves->add(cells);
        }
        made.rows += static_cast<std::int64_t>(record.curve.size());
        export_states(stored, head, record, build, states);
      });
  if (!curves) begin(campaign);
  made.samples = static_cast<int>(samples.size());
  made.missing = campaign.samples.n_sample() - made.samples;
  write_samples(sink, sample_cells(campaign, {}), samples);
  made.states = states.count;
  return made;
}

// --- a run -----------------------------------------------------------------------------------------

// Displacement of a state by its file in run.pvd [mm]; NaN where it is not listed.
double displacement_in(const std::string& series, const std::string& file) {
  constexpr std::string_view kTime = "timestep=\"";
  const std::size_t at = series.find("file=\"" + file + "\"");
  const std::size_t time = at == std::string::npos ? at : series.rfind(kTime, at);
  if (time == std::string::npos) return kUnset;
  const std::size_t begin = time + kTime.size();
  return number_in(std::string_view(series).substr(begin, series.find('"', begin) - begin));
}

void export_run_states(const std::string& folder, StateTables& tables) {
  const auto file = [&](const char* kind, int number) {
    return fmt::format("state_{}_{:02}.vtu", kind, number);
  };
  const auto inside = [&](const std::string& name) { return folder + "/" + name; };
  std::error_code error;
  if (!fs::exists(inside(file("blocks", 0)), error)) return;
  const std::string series = read_text(inside("run.pvd"), kMostJson);
  const Model model = compile(read_model(inside("model.used.toml")));
  Wall wall(model);
  const auto knows = [&](const char* array) {
    return read_file(inside(file("blocks", 0)), kMostPacked).find(array) != std::string::npos;
  };
  wall.all_turns = wall.all_turns && knows("\"rotation_total_mrad\"");
  for (int number = 0; fs::exists(inside(file("blocks", number)), error); ++number) {
    WallState state{.label = "", .displacement = displacement_in(series, file("blocks", number))};
    const std::string blocks = inside(file("blocks", number));
    state.blocks = wall.all_turns ? elements_in(blocks, kSpaceBlockColumns, wall.cell_begin)
                                  : elements_in(blocks, kBlockColumns, wall.cell_begin);
    state.joints = elements_in(inside(file("joints", number)), kJointColumns,
                               one_each(wall.joint.size()), &wall.corner_begin, &wall.joint);
    const std::vector<std::size_t> zones = one_each(wall.zone.size());
    if (!wall.zone.empty())
      state.zones = dimension_of(model) == 3
                        ? elements_in(inside(file("zones", number)), kSpaceZoneColumns, zones)
                        : elements_in(inside(file("zones", number)), kZoneColumns, zones);
    tables.add(1, number, wall, state);
  }
}

// Copies the cells of force_displacement.csv.
std::int64_t export_run_curve(const std::string& folder, Sink& sink) {
  const std::string path = folder + "/force_displacement.csv";
  const std::string text = read_text(path, kMostCsv);
  CsvLines lines(text, path);
  const auto has = [&](const char* name) {
    return std::find(lines.cells().begin(), lines.cells().end(), name) != lines.cells().end();
  };
  const bool has_head = lines.next();
  const ShownColumns of{.lintel_of_zones = has_head && has("lintel_axial_kN"),
                        .held_head = has_head && has("head_axial_kN")};
  std::vector<std::string> names;
  for (const CurveColumn& c : columns_shown(of)) names.emplace_back(c.name);
  if (!has_head || names != lines.cells())
    throw IoError(path + ": is not a curve of wythe run; run the model again");
  Table table(sink, kCurves, curve_columns(of));
  std::int64_t rows = 0;
  for (; lines.next(); ++rows) {
    std::vector<std::string> cells = {"1"};
    for (const std::string& cell : lines.cells()) {
      if (cell != "nan" && std::isnan(number_in(cell)))
        throw IoError(fmt::format("{}:{}: \"{}\" is not a number; run the model again", path,
                                  lines.line(), cell));
      cells.push_back(cell == "nan" ? "" : cell);
    }
    if (cells.size() != table.columns().size())
      throw IoError(fmt::format("{}:{}: has {} cells, its head {}", path, lines.line(),
                                cells.size() - 1, table.columns().size() - 1));
    table.add(cells);
  }
  return rows;
}

Exported export_run(const std::string& folder, Sink& sink) {
  Exported made;
  made.samples = 1;
  made.rows = export_run_curve(folder, sink);
  const std::string file = folder + "/summary.json";
  const auto summary = parse_json(read_text(file, kMostJson), file);
  if (!summary.is_object() || !summary.contains("status"))
    throw IoError(file + ": is no summary of a run (it has no status); run the model again");
  const std::vector<ExportCell> row = run_cells(summary);
  write_samples(sink, row, {row});
  StateTables states(sink);
  export_run_states(folder, states);
  made.states = states.count;
  return made;
}

Exported export_into(const std::string& folder, Sink& sink) {
  Exported made;
  if (holds_campaign(folder))
    made = export_campaign(folder, sink);
  else if (fs::exists(folder + "/summary.json") && fs::exists(folder + "/force_displacement.csv"))
    made = export_run(folder, sink);
  else
    refuse(folder, "holds neither a run (summary.json) nor a campaign (campaign.db)",
           "name the --out folder of a finished wythe run or wythe campaign");
  sink.close();
  return made;
}

}  // namespace

std::unique_ptr<Replacement> replace_export(const std::string& out, const Origin& origin) {
  std::error_code error;
  finish_replacement(out);
  const bool of_export =
      fs::exists(out + "/" + kColumns, error) || fs::exists(out + "/" + kHdf5, error);
  for (const fs::directory_entry& entry : fs::directory_iterator(out, error)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with(".") || name == "lost+found") continue;
    if (!of_export || !is_export_file(name))
      refuse(out, "holds " + name + ", which no export wrote: tables are not put among other files",
             "name a new folder, an empty one, or one that holds an earlier export alone");
  }
  check_origin(out, origin);
  prepare_folder(out);
  return std::make_unique<Replacement>(out, is_export_file);
}

Exported write_export(const std::string& folder, const std::string& out) {
  CsvSink sink(out);
  return export_into(folder, sink);
}

Exported write_export_hdf5(const std::string& folder, const std::string& out) {
  Hdf5Sink sink(out);
  return export_into(folder, sink);
}

}  // namespace wythe
