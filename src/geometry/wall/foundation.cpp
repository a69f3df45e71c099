// Moves the level of each step to a course line, and its side to a column line of every storey that the side crosses. Edges
// move by up to 2 % or one joint; with fit = "cut" a level may move by a quarter of a course. Farther from a line, units are cut
// there or the step is refused. Soil beside a step is not in contact (docs/theory/ring_beams.md, "Ground in steps").
#include "geometry/wall/foundation.h"

#include <algorithm>
#include <cmath>

#include "geometry/text.h"

namespace wythe::geometry {
namespace {

std::string step_path(std::size_t index, const std::string& key) {
  return "wall.foundation." + std::to_string(index) + "." + key;
}

bool numbers_are_sound(const std::vector<FoundationStep>& steps, const WallSpec& wall,
                       FaultList& faults) {
  const std::size_t before = faults.all().size();
  for (std::size_t i = 0; i < steps.size(); ++i) {
    (void)is_not_negative({step_path(i, "x"), steps[i].x, "m", i == 0 ? "0 m" : "3.10 m"}, faults);
    (void)is_not_negative({step_path(i, "y"), steps[i].y, "m", "0.55 m"}, faults);
  }
  if (faults.all().size() > before) return false;
  if (steps.front().x > 0)
    add_fault(faults, step_path(0, "x"), metres(steps.front().x),
              "the first step begins beside the wall's left end", "write x = \"0 m\"");
  for (std::size_t i = 0; i + 1 < steps.size(); ++i) {
    if (!(steps[i + 1].x > steps[i].x))
      add_fault(faults, step_path(i + 1, "x"), metres(steps[i + 1].x),
                "begins before the step on its left (" + metres(steps[i].x) + ")",
                "list the steps from left to right");
    if (steps[i + 1].y == steps[i].y)
      add_fault(faults, step_path(i + 1, "y"), metres(steps[i + 1].y),
                "is as high as the step on its left: no step", "leave one of the two out");
  }
  if (steps.back().x >= wall.length)
    add_fault(faults, step_path(steps.size() - 1, "x"), metres(steps.back().x),
              "begins beyond the wall's right end (wall.length = " + metres(wall.length) + ")",
              "leave it out, or write a smaller x");
  double lowest = steps.front().y;
  for (const FoundationStep& step : steps) lowest = std::min(lowest, step.y);
  if (lowest > 0)
    add_fault(faults, step_path(0, "y"), metres(steps.front().y),
              "no step is at y = 0 m, the wall's base: the lowest is at " + metres(lowest),
              "lower every step by " + metres(lowest) + " and the wall's openings and height too");
  return faults.all().size() == before;
}

// An edge of a step, to be placed on one axis.
struct StepEdge {
  std::size_t step;
  std::string key;       // "x" or "y"
  double stated, reach;  // [m]
  const char* moved_code;
};

// The edge moved to a near joint line; as stated where units are cut; otherwise a fault.
double settle(const StepEdge& edge, const Axis& axis, const Storey& storey,
              std::vector<Message>& notes, FaultList& faults) {
  const double line = axis.line(axis.nearest(edge.stated));
  const double off = std::abs(line - edge.stated);
  if (off <= edge.reach + 1e-9) {
    if (off > 1e-9)
      notes.push_back(
          {edge.moved_code,
           {{"step", static_cast<int>(edge.step)}, {"from_m", edge.stated}, {"to_m", line}}});
    return line;
  }
  if (storey.fit == Fit::kWhole)
    add_fault(faults, step_path(edge.step, edge.key), metres(edge.stated),
              millimetres(off) + " from the nearest joint line, more than 2 % of the step",
              "write " + edge.key + " = \"" + metres(line) + "\", on the joint lines every " +
                  millimetres(axis.step) + "; or " + storey.path_of("fit") + " = \"cut\"");
  return edge.stated;
}

bool crosses(const Storey& storey, double y0, double y1) {
  return storey.top() > y0 + 1e-9 && storey.foot < y1 - 1e-9;
}

}  // namespace

std::vector<GroundStep> place_ground(const Shape& shape, const std::vector<Storey>& storeys,
                                     std::vector<Message>& notes, FaultList& faults) {
  const double length = shape.wall.length, top = storeys.back().top();
  std::vector<FoundationStep> steps = shape.wall.foundation;
  if (steps.empty()) return {{0, length, 0}};
  if (!numbers_are_sound(steps, shape.wall, faults)) return {};
  const std::size_t before = faults.all().size();
  for (std::size_t i = 0; i < steps.size(); ++i) {
    FoundationStep& step = steps[i];
    const double wide = (i + 1 < steps.size() ? steps[i + 1].x : length) - step.x;
    const double left = i > 0 ? shape.wall.foundation[i - 1].y : step.y;
    const Storey& storey = storey_at(storeys, step.y);
    const Axis& courses = storey.lattice.courses;
    if (courses.count == 0) return {};
    const double slack = std::max(kFitTolerance * step.y, courses.joint);
    const double reach = storey.fit == Fit::kCut ? std::max(slack, kSliver * courses.step) : slack;
    if (step.y >= top - courses.step / 2)
      add_fault(faults, step_path(i, "y"), metres(step.y),
                "leaves no masonry on the step: the wall ends at " + metres(top),
                "write a smaller y, or end the wall beside the step (wall.length)");
    const double stated = step.y;
    step.y = settle({i, "y", stated, reach, "foundation.y_moved"}, courses, storey, notes, faults);
    for (const Storey& beside : storeys) {
      if (i == 0 || !crosses(beside, std::min(left, stated), std::max(left, stated))) continue;
      const Axis& columns = beside.lattice.columns;
      step.x = settle(
          {i, "x", step.x, std::max(kFitTolerance * wide, columns.joint), "foundation.x_moved"},
          columns, beside, notes, faults);
    }
  }
  if (faults.all().size() > before) return {};
  std::vector<GroundStep> ground;
  for (std::size_t i = 0; i < steps.size(); ++i)
    ground.push_back({steps[i].x, i + 1 < steps.size() ? steps[i + 1].x : length, steps[i].y});
  return ground;
}

std::vector<Contact> find_step_contacts(const std::vector<Block>& blocks,
                                        const std::vector<GroundStep>& ground) {
  if (ground.size() == 1) return find_ground_contacts(blocks, ground.front().y);
  constexpr double kShortest = 1e-3;  // of an edge: as between blocks
  std::vector<Contact> contacts;
  for (const GroundStep& step : ground)
    for (Contact contact : find_ground_contacts(blocks, step.y)) {
      const double edge = contact.p1.x - contact.p0.x;
      contact.p0.x = std::max(contact.p0.x, step.x0);
      contact.p1.x = std::min(contact.p1.x, step.x1);
      if (contact.p1.x - contact.p0.x > kShortest * edge) contacts.push_back(contact);
    }
  return contacts;
}

}  // namespace wythe::geometry
