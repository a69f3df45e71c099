// Output of `wythe drawing`: the wall and its openings from the drawing of a facade.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

#include <fmt/format.h>

#include "core/limits.h"
#include "core/text.h"
#include "geometry/polygon.h"
#include "io/bodies/dxf.h"
#include "wythe/parts/drawing.h"
#include "wythe/parts/wall_spec.h"

namespace wythe {
namespace io {
namespace {

using geometry::Rect;

constexpr double kUpright = 5e-3;  // largest deviation of a corner from a rectangle [m]
constexpr double kClose = 1e-2;    // from a lintel's foot to the head of its opening, at most [m]

struct Box {
  Rect at;
  const DrawnOutline* drawn;
};

class Facade {
 public:
  Facade(std::string file, const std::string& unit, const DrawingLayers& layers)
      : file_(std::move(file)), layers_(layers), drawing_(parse_drawing(file_, unit)) {}

  std::string text() {
    const std::vector<Box> outline = boxes_on(layers_.outline, "a generated wall is a rectangle");
    openings_ = boxes_on(layers_.openings, "a generated opening is a rectangle");
    lintels_ = boxes_on(layers_.lintels, "a lintel is a rectangle");
    refuse_unread();
    refuse_absent(layers_.outline, "outline", outline.empty());
    refuse_absent(layers_.openings, "openings", openings_.empty());
    if (outline.size() > 1)
      fault(*outline[1].drawn, "is a second outline on this layer", "keep one, around the wall");
    faults_.throw_if_any();
    wall_ = outline.front().at;
    check_openings();
    give_lintels();
    faults_.throw_if_any();
    return written();
  }

 private:
  void fault(const DrawnOutline& drawn, std::string problem, std::string cure) {
    if (!enough(faults_))
      faults_.add(fault_of(
          {drawn.layer, "polyline", drawn.handle, std::move(problem), std::move(cure), drawn.line},
          file_));
  }

  std::vector<Box> boxes_on(const std::string& layer, const char* why) {
    std::vector<Box> boxes;
    for (const DrawnOutline& drawn : drawing_.outlines) {
      if (!same_layer(drawn.layer, layer)) continue;
      geometry::Polygon corners;
      for (const auto& [x, y] : drawn.corners) corners.push_back({x, y});
      const Rect box = geometry::bounds(corners);
      const bool is_box = geometry::is_upright_rectangle(corners, kUpright) &&
                          std::min(box.x1 - box.x0, box.y1 - box.y0) > kUpright;
      if (is_box)
        boxes.push_back({box, &drawn});
      else
        fault(drawn,
              fmt::format("has {} corners and is no upright rectangle: {}", corners.size(), why),
              "draw it as one, an arched opening up to its springing (its arch is stated in the "
              "model); or draw "
              "every stone and read them by wall.blocks");
    }
    return boxes;
  }

  bool is_asked_for(const std::string& layer) const {
    return same_layer(layer, layers_.outline) || same_layer(layer, layers_.openings) ||
           same_layer(layer, layers_.lintels);
  }

  void refuse_unread() {
    for (const Unread& entity : drawing_.unread)
      if (is_asked_for(entity.layer) && !enough(faults_)) faults_.add(fault_of(entity, file_));
  }

  void refuse_absent(const std::string& layer, const char* what, bool is_absent) {
    if (!is_absent || layer == "none" || !faults_.empty()) return;
    faults_.add({.file = file_,
                 .path = "layer " + layer,
                 .problem = "holds no closed polyline",
                 .cure = fmt::format("name the layer, --{} LAYER{}; the drawing has {}", what,
                                     std::string_view(what) == "openings" ? " (or none)" : "",
                                     drawing_.layers.empty() ? "no layer with anything on it"
                                                             : joined(drawing_.layers, ", ")),
                 .line = 0});
  }

  // Checks openings from the bottom up, then from left to right.
  void check_openings() {
    std::sort(openings_.begin(), openings_.end(), [](const Box& a, const Box& b) {
      return std::abs(a.at.y0 - b.at.y0) > kClose ? a.at.y0 < b.at.y0 : a.at.x0 < b.at.x0;
    });
    const auto are_same = [](const Rect& a, const Rect& b) {
      return std::abs(a.x0 - b.x0) <= kClose && std::abs(a.x1 - b.x1) <= kClose &&
             std::abs(a.y0 - b.y0) <= kClose && std::abs(a.y1 - b.y1) <= kClose;
    };
    for (std::size_t k = 1; k < openings_.size(); ++k)
      if (are_same(openings_[k - 1].at, openings_[k].at))
        fault(*openings_[k].drawn, "is drawn a second time", "keep one");
    for (Box& opening : openings_) {
      Rect& r = opening.at;
      if (r.x0 < wall_.x0 - kUpright || r.x1 > wall_.x1 + kUpright || r.y0 < wall_.y0 - kUpright ||
          r.y1 > wall_.y1 + kUpright)
        fault(*opening.drawn, "reaches outside the outline", "draw it inside");
      r = {std::max(r.x0, wall_.x0), std::max(r.y0, wall_.y0), std::min(r.x1, wall_.x1),
           std::min(r.y1, wall_.y1)};
    }
  }

  void give_lintels() {
    for (const Box& lintel : lintels_) {
      const Rect& l = lintel.at;
      const auto carries = [&](const Box& opening) {
        const Rect& o = opening.at;
        return std::abs(l.y0 - o.y1) <= kClose && l.x0 < o.x0 && l.x1 > o.x1;
      };
      const auto found = std::find_if(openings_.begin(), openings_.end(), carries);
      if (found == openings_.end()) {
        fault(lintel.drawn[0], "lies on no opening",
              "its foot lies on the head of one, and it is longer on both sides");
      } else if (!over_.emplace(found->drawn, l).second) {
        fault(lintel.drawn[0], "is a second lintel over its opening", "keep one");
      }
    }
  }

  static std::string metres(double value) {
    std::string text = fmt::format("{:.4f}", value == 0 ? 0 : value);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.ends_with('.')) text += '0';
    return "\"" + (text == "-0.0" ? "0.0" : text) + " m\"";
  }

  std::string written() const {
    std::string text = fmt::format(
        "# From {}: {} openings, {} lintels. Not drawn: thickness, bond, unit, "
        "materials.\n[wall]\nlength = {}\n"
        "height = {}\nfit = \"cut\"   # a surveyed wall: units are cut at its edges\n",
        file_.substr(file_.find_last_of('/') + 1), openings_.size(), over_.size(),
        metres(wall_.x1 - wall_.x0), metres(wall_.y1 - wall_.y0));
    int number = 0;
    for (const Box& opening : openings_) {
      const Rect& o = opening.at;
      text += fmt::format(
          "\n[[wall.opening]]\nname = \"o{}\"\nx = {}\ny = {}\nwidth = {}\nheight = {}\n", ++number,
          metres(o.x0 - wall_.x0), metres(o.y0 - wall_.y0), metres(o.x1 - o.x0),
          metres(o.y1 - o.y0));
      const auto lintel = over_.find(opening.drawn);
      if (lintel == over_.end()) continue;
      const Rect& l = lintel->second;
      text += fmt::format(
          "lintel = {{ kind = \"lintel\", depth = {}, bearing = {} }}   # not drawn: kind, "
          "material\n",
          metres(l.y1 - l.y0), metres(std::min(o.x0 - l.x0, l.x1 - o.x1)));
    }
    return text + left_aside();
  }

  // Lists other layers with outlines, so that a layer with another name is not overlooked.
  std::string left_aside() const {
    std::map<std::string, int> closed, other;
    for (const DrawnOutline& drawn : drawing_.outlines)
      if (!is_asked_for(drawn.layer)) ++closed[drawn.layer];
    for (const Unread& entity : drawing_.unread)
      if (!is_asked_for(entity.layer)) ++other[entity.layer];
    std::string text;
    for (const std::string& layer : drawing_.layers)
      if (closed.contains(layer) || other.contains(layer))
        text += fmt::format("# Left aside: layer {}, {} closed polylines, {} other entities\n",
                            layer, closed[layer], other[layer]);
    for (const std::string& layer : drawing_.hidden)
      text += fmt::format("# Left aside: layer {}, which is off or frozen\n", layer);
    if (drawing_.invisible > 0)
      text += fmt::format("# Left aside: {} invisible entities\n", drawing_.invisible);
    if (drawing_.thick > 0)
      text += fmt::format("# Left aside: the thickness of {} polylines, {:g} of the first\n",
                          drawing_.thick, drawing_.thickness);
    return text.empty() ? text : "\n" + text;
  }

  std::string file_;
  const DrawingLayers& layers_;
  Drawing drawing_;
  FaultList faults_;
  Rect wall_;
  std::vector<Box> openings_, lintels_;
  std::map<const DrawnOutline*, Rect> over_;  // lintels, by their opening
};

}  // namespace
}  // namespace io

std::string drawing_text(const std::string& path, const std::string& unit,
                         const DrawingLayers& layers) {
  return io::Facade(path, unit, layers).text();
}

std::vector<Message> notes_of_drawing(const ModelSpec& spec) {
  const std::filesystem::path file = std::filesystem::path(spec.folder) / spec.wall.blocks;
  if (!io::is_drawing(file.string())) return {};
  std::vector<Message> notes;
  const io::Drawing drawing = io::parse_drawing(file.string(), "m");  // with any unit
  if (!drawing.hidden.empty())
    notes.push_back(
        {"drawing.hidden", {{"file", spec.wall.blocks}, {"layers", joined(drawing.hidden, ", ")}}});
  if (drawing.invisible > 0)
    notes.push_back(
        {"drawing.invisible", {{"file", spec.wall.blocks}, {"count", drawing.invisible}}});
  const double metre = io::units_in_a_metre(drawing.stated_unit);  // 0: not stated
  constexpr double kSame = 1e-6;                                   // [m]
  const bool is_walls =
      metre > 0 && std::abs(std::abs(drawing.thickness) / metre - spec.wall.thickness) <= kSame;
  if (drawing.thick > 0 && !is_walls)
    notes.push_back({"drawing.thickness",
                     {{"file", spec.wall.blocks},
                      {"count", drawing.thick},
                      {"drawn", drawing.thickness},
                      {"unit", drawing.stated_unit},
                      {"thickness_m", spec.wall.thickness}}});
  return notes;
}

}  // namespace wythe
