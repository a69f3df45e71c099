// Each frame sees the bodies that its plane cuts as rectangles there: what moves is its wall, what is fixed its ground.
#include "geometry/builder/space_frames.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/elementary.h"
#include "geometry/builder/builder.h"
#include "geometry/text.h"
#include "geometry/wall/frames.h"

namespace wythe::geometry {
namespace {

// A body as the plane sees it; nothing where the plane does not cut it.
std::optional<Rect> seen_in(const FramePlane& plane, const BodySpec& body) {
  Rect box{1e300, 1e300, -1e300, -1e300};
  double near = 1e300, far = -1e300;
  for (const Polyhedron& part : body.part)
    for (const Vec3& v : part.vertex) {
      const Vec3 d = v - plane.origin;
      const double x = dot(d, plane.along), z = dot(d, plane.across);
      box = {std::min(box.x0, x), std::min(box.y0, d.y), std::max(box.x1, x),
             std::max(box.y1, d.y)};
      near = std::min(near, z), far = std::max(far, z);
    }
  if (!(near < 0 && far > 0)) return std::nullopt;
  return box;
}

FramePlane plane_of(const FrameSpec& frame, bool z_up) {
  FramePlane plane;
  plane.origin = z_up ? Vec3{frame.x, frame.z, -frame.y} : Vec3{frame.x, frame.y, frame.z};
  const double sine = elementary::sin(frame.turn), cosine = elementary::cos(frame.turn);
  plane.along = {cosine, 0, -sine};
  plane.across = {sine, 0, cosine};
  return plane;
}

bool is_whole(const HoleSpec& hole, const std::string& path, FaultList& faults) {
  bool whole = true;
  for (const auto& [key, value] :
       {std::pair("x", hole.x), {"y", hole.y}, {"width", hole.width}, {"height", hole.height}}) {
    if (!std::isnan(value)) continue;
    whole = false;
    add_fault(faults, path + ".hole." + key, "", "is missing",
              "write hole = { x, y, width, height } of the opening, in the frame's plane");
  }
  return whole;
}

BodySpec body_of(const Block& segment, const FramePlane& plane, const FrameSpec& frame) {
  BodySpec body;
  body.id = segment.id;
  body.material = segment.material;
  body.role = "frame";
  body.put_in = frame.stage;
  std::vector<Vec3> back, front;
  for (const Vec2& p : segment.outline) {
    back.push_back(plane.place(p) - 0.5 * segment.thickness * plane.across);
    front.push_back(plane.place(p) + 0.5 * segment.thickness * plane.across);
  }
  body.part = {solid_between(back, front)};
  return body;
}

}  // namespace

std::vector<SpaceFrame> place_frames_in_space(const ModelSpec& spec, std::vector<BodySpec>& bodies,
                                              FaultList& faults) {
  check_frame_names(spec.frame, faults);
  std::vector<SpaceFrame> frames;
  for (std::size_t k = 0; k < spec.frame.size(); ++k) {
    const FrameSpec& frame = spec.frame[k];
    const std::string path = fmt::format("frame.{}", k);
    if (!frame.round.empty() || !frame.wall.empty()) {
      add_fault(faults, path + (frame.wall.empty() ? ".round" : ".wall"), "",
                "names what a wall of the builder has, and this one is of blocks",
                "write hole = { ... } or line, and x, y, z and turn of the plane of both");
      continue;
    }
    if (std::isnan(frame.x) || std::isnan(frame.y) || std::isnan(frame.z)) {
      add_fault(faults, path + ".wall", "", "is missing: a frame in space stands in a wall",
                "write wall = \"the name of a [[plan_wall]]\", or x, y, z and turn of its plane");
      continue;
    }
    const FramePlane plane = plane_of(frame, spec.wall.up == "z");
    FrameSite site;
    bool first = true;
    for (const BodySpec& body : spec.body) {
      const std::optional<Rect> seen = seen_in(plane, body);
      if (!seen) continue;
      if (body.fixed) {
        site.ground.push_back(*seen);
      } else {
        site.wall = first ? *seen : join(site.wall, *seen);
        first = false;
      }
    }
    if (first) {
      add_fault(faults, path + ".x", "", "stands in a plane that cuts no block that moves",
                "move it into the middle plane of its wall");
      continue;
    }
    const HoleSpec& hole = frame.hole;
    if (has_hole(frame) && !is_whole(hole, path, faults)) continue;
    const PlacedOpening opening{.called = "its opening",
                                .words = {},
                                .hole = {hole.x, hole.y, hole.x + hole.width, hole.y + hole.height},
                                .segment = {},
                                .arch = {}};
    std::optional<PlacedFrame> placed =
        place_frame(frame, k, has_hole(frame) ? &opening : nullptr, site, faults);
    if (!placed) continue;
    const auto first_body = bodies.size();
    for (const Block& segment : placed->segments) bodies.push_back(body_of(segment, plane, frame));
    frames.push_back({std::move(*placed), plane, first_body});
  }
  return frames;
}

}  // namespace wythe::geometry
