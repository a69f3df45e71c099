// Where the number of steps must be an integer, it is the one that changes a step least. The last mortar joint may be
// present or absent (docs/theory/conventions.md, "The lattice of a wall"). After a fault the axis is that of its first cure,
// so that later cures are consistent with it.
#include "geometry/wall/fit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/to_int.h"
#include "geometry/text.h"
#include "geometry/wall/storeys.h"

namespace wythe::geometry {
namespace {

// One direction of a storey as the user stated it.
struct AxisRequest {
  double extent, step;      // [m]
  double origin, joint;     // [m]
  std::string whose;        // "the wall's", "storey 0 (ground)'s"
  std::string extent_name;  // "length"
  std::string size_path;    // "wall.unit.length"
  double size_per_step;     // unit length is two half units, a course is one unit height
  std::string step_name;    // "half unit"
  const char* step_code;    // code of its message
  const char* last_code;    // code of the message for the last step of a row or column
  Fit fit;
  std::string fit_key;  // "wall.fit"
};

// The extent that `count` steps cover: the last joint may be present or absent.
double measured(const AxisRequest& request, int count) {
  // a negative joint is refused elsewhere, but std::clamp needs ordered bounds
  return std::clamp(count * request.step, request.extent,
                    request.extent + std::max(0.0, request.joint));
}

double change_of(const AxisRequest& request, int count) {
  return measured(request, count) / count / request.step - 1;
}

int best_count(const AxisRequest& request) {
  const int below = std::max(1, to_int(std::floor(request.extent / request.step)));
  return std::abs(change_of(request, below)) <= std::abs(change_of(request, below + 1)) ? below
                                                                                        : below + 1;
}

void note_change(const char* what, double from, double to, std::vector<Message>& notes) {
  const double change = to / from - 1;
  if (std::abs(change) < 1e-9) return;
  notes.push_back({"fit.changed",
                   {{"what", Message{what}},
                    {"from_mm", 1e3 * from},
                    {"to_mm", 1e3 * to},
                    {"change_percent", 100 * change}}});
}

// n units without a joint at the end: the missing joint is distributed over all of them.
void note_end_joint(const AxisRequest& request, int count, std::vector<Message>& notes) {
  notes.push_back({"fit.end_joint",
                   {{"what", Message{request.step_code}},
                    {"count", count},
                    {"joint_mm", 1e3 * request.joint},
                    {"from_mm", 1e3 * request.step},
                    {"to_mm", 1e3 * request.extent / count},
                    {"change_percent", 100 * (request.extent / count / request.step - 1)}}});
}

void refuse_fit(const AxisRequest& request, FaultList& faults) {
  const int below = std::max(1, to_int(std::floor(request.extent / request.step)));
  const auto size = [&](int n) {
    return millimetres(request.size_per_step * request.extent / n - request.joint);
  };
  const auto extent = [&](int n) { return metres(request.step * n); };
  const int best = best_count(request), other = best == below ? below + 1 : below;
  add_fault(faults, request.size_path,
            millimetres(request.size_per_step * request.step - request.joint),
            fmt::format("{} {} of {} holds {:.4g} {}s; a whole number of them would change the "
                        "size by {}, more than 2 %",
                        request.whose, request.extent_name, metres(request.extent),
                        request.extent / request.step, request.step_name,
                        percent(change_of(request, best))),
            fmt::format("write {} = \"{}\" (or {}), or a {} of {} or {}, or {} = \"cut\"",
                        last_key(request.size_path), size(best), size(other), request.extent_name,
                        extent(below), extent(below + 1), request.fit_key));
}

// After a fault it is the axis of the first cure, so that cures of openings are consistent with it.
Axis fit_whole(const AxisRequest& request, std::vector<Message>& notes, FaultList& faults) {
  const int count = best_count(request);
  if (std::abs(change_of(request, count)) > kFitTolerance + 1e-9)
    refuse_fit(request, faults);
  else if (request.joint > 0 &&
           std::abs(request.extent + request.joint - count * request.step) < 1e-6 * request.step)
    note_end_joint(request, count, notes);
  else
    note_change(request.step_code, request.step, request.extent / count, notes);
  return {.extent = request.extent, .step = request.extent / count, .count = count};
}

Axis lay_and_cut(const AxisRequest& request, std::vector<Message>& notes) {
  int count = std::max(1, to_int(std::floor(request.extent / request.step + 1e-9)));
  const double rest = request.extent - count * request.step;
  if (rest >= kSliver * request.step) ++count;
  const double last = request.extent - (count - 1) * request.step;
  note_change(request.last_code, request.step, last, notes);
  return {.extent = request.extent, .step = request.step, .count = count};
}

Axis fit_axis(const AxisRequest& request, std::vector<Message>& notes, FaultList& faults) {
  Axis axis =
      request.fit == Fit::kCut ? lay_and_cut(request, notes) : fit_whole(request, notes, faults);
  axis.origin = request.origin;
  axis.joint = request.joint;
  return axis;
}

bool needs_header(Bond bond) {
  return bond == Bond::kFlemish || bond == Bond::kEnglish || bond == Bond::kHeader;
}

bool sizes_are_given(const Storey& storey, FaultList& faults) {
  const auto given = [&](const char* key, double value, const char* example) {
    return is_positive({storey.path_of(key), value, "m", example}, faults);
  };
  bool all = given("length", storey.length, "5.10 m");
  all &= given("height", storey.height, "3.62 m");
  all &= given("unit.length", storey.unit.length, "310 mm");
  all &= given("unit.height", storey.unit.height, "110 mm");
  if (needs_header(storey.bond) && !std::isnan(storey.unit.width))
    all &= given("unit.width", storey.unit.width, "155 mm");
  return all;
}

double stated_header(const UnitSpec& unit) {
  return std::isnan(unit.width) ? unit.length / 2 : unit.width;
}

// In english bond a header is half a stretcher: with any other length joints would sometimes align.
// In flemish bond it only has to be shorter than the stretcher.
double fit_header(const Storey& storey, double half_unit, std::vector<Message>& notes,
                  FaultList& faults) {
  const double scale = half_unit / (storey.unit.length / 2);
  const double header = scale * stated_header(storey.unit);
  if (std::abs(header / half_unit - 1) <= kHeaderTolerance) {
    note_change("fit.header", stated_header(storey.unit), half_unit, notes);
    return half_unit;
  }
  const double limit = storey.bond == Bond::kFlemish ? 2 * half_unit - half_unit / 2 : half_unit;
  if (storey.bond == Bond::kEnglish || header > limit) {
    add_fault(faults, storey.path_of("unit.width"),
              millimetres(stated_header(storey.unit) - storey.head_mortar()),
              storey.bond == Bond::kEnglish
                  ? "english bond needs headers of half a unit length, within 5 %"
                  : "flemish bond needs headers of three quarters of a unit length or less",
              "width = \"" + millimetres(storey.unit.length / 2 - storey.head_mortar()) +
                  "\" (or leave it out)");
  }
  return header;
}

}  // namespace

double Axis::line(int i) const {
  if (i >= count) return end();
  return half_line(2 * i);
}

double Axis::end() const { return origin + extent; }

double Axis::half_line(int q) const {
  const bool is_even = std::abs(extent - count * step) < 1e-9 * extent;
  return origin + (is_even ? extent * q / (2 * count) : step * q / 2);
}

int Axis::nearest(double x) const {
  const int guess = std::clamp(to_int(std::floor((x - origin) / step)), 0, count - 1);
  return std::abs(x - line(guess)) <= std::abs(line(guess + 1) - x) ? guess : guess + 1;
}

bool Axis::is_on_line(double x) const { return std::abs(line(nearest(x)) - x) < 1e-9 * extent; }

Lattice fit_lattice(const Storey& storey, std::vector<Message>& notes, FaultList& faults) {
  if (!sizes_are_given(storey, faults) || !std::isfinite(storey.foot)) return {};
  const bool is_header_bond = storey.bond == Bond::kHeader;
  const double column = (is_header_bond ? stated_header(storey.unit) : storey.unit.length) / 2;
  const char* sized_key = "unit.length";
  if (is_header_bond) sized_key = "unit.width";
  const std::string whose = storey.index < 0 ? "the wall's" : storey.called() + "'s";
  Lattice lattice;
  lattice.columns =
      fit_axis({storey.length, column, 0, storey.head_mortar(), "the wall's", "length",
                storey.path_of(sized_key), 2, is_header_bond ? "half header" : "half unit",
                is_header_bond ? "fit.half_header" : "fit.half_unit",
                is_header_bond ? "fit.last_half_header" : "fit.last_half_unit", storey.fit,
                storey.path_of("fit")},
               notes, faults);
  lattice.courses = fit_axis({storey.height, storey.unit.height, storey.foot, storey.bed_mortar(),
                              whose, "height", storey.path_of("unit.height"), 1, "course",
                              "fit.course", "fit.last_course", storey.fit, storey.path_of("fit")},
                             notes, faults);
  lattice.stretcher = lattice.header = 2 * lattice.columns.step;
  if (needs_header(storey.bond) && !is_header_bond && lattice.columns.count > 0) {
    lattice.header = fit_header(storey, lattice.columns.step, notes, faults);
  }
  return lattice;
}

}  // namespace wythe::geometry
