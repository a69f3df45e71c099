// Laws of bodies in space in any frame: moments of inertia turn as a tensor, joint faces keep their
// areas, and the order of the bodies does not matter. Tolerances are round-off of coordinates in metres.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "geometry/bodies/joint_faces.h"
#include "scenes/solids.h"

namespace wythe::geometry::bodies_property_test {
namespace {

using scenes::box_body;
using scenes::Frame;

double drawn(int low, int high) { return *rc::gen::inRange(low, high) / 100.0; }

Frame any_frame() {
  const double w = drawn(-100, 101), x = drawn(-100, 101), y = drawn(-100, 101);
  return Frame::turned(w, x, y, drawn(10, 101),
                       {drawn(-500, 500), drawn(-500, 500), drawn(-500, 500)});
}

// Three stones: one beside and one on the first, shifted by what is drawn.
std::vector<BodySpec> any_stones() {
  const double x = drawn(20, 80), y = drawn(20, 80), z = drawn(20, 80);
  const double s = drawn(-15, 15), t = drawn(-15, 15);
  return {box_body("foot", {0, 0, 0}, {x, y, z}, true),
          box_body("head", {s, y, t}, {s + x, y + 0.3, t + z}),
          box_body("side", {x, s, t}, {x + 0.4, s + y, t + z})};
}

std::vector<double> areas_of(const SpaceAssembly& assembly) {
  std::vector<double> areas;
  for (const JointFace& face : assembly.faces) areas.push_back(face.area);
  std::sort(areas.begin(), areas.end());
  return areas;
}

RC_GTEST_PROP(Bodies, moments_turn_as_a_tensor, ()) {
  const Frame frame = any_frame();
  const BodySpec body = any_stones()[1];
  const SolidMoments a = solid_moments(body), b = solid_moments(frame.body(body));
  RC_ASSERT(std::abs(a.volume - b.volume) < 1e-13);
  RC_ASSERT(norm(frame.point(a.centroid) - b.centroid) < 1e-13);
  const auto tensor = [](const SolidMoments& m, Vec3 v) {
    const auto& i = m.inertia;
    return Vec3{i[0] * v.x + i[3] * v.y + i[4] * v.z, i[3] * v.x + i[1] * v.y + i[5] * v.z,
                i[4] * v.x + i[5] * v.y + i[2] * v.z};
  };
  for (const Vec3 v : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) {
    const Vec3 turned = frame.direction(tensor(a, v));
    RC_ASSERT(norm(turned - tensor(b, frame.direction(v))) < 1e-13);
  }
}

RC_GTEST_PROP(Bodies, joint_faces_keep_their_areas_in_every_frame, ()) {
  const Frame frame = any_frame();
  const std::vector<BodySpec> here = any_stones();
  std::vector<BodySpec> there;
  for (const BodySpec& body : here) there.push_back(frame.body(body));
  FaultList faults;
  const SpaceAssembly a = assemble(here, faults), b = assemble(there, faults);
  RC_ASSERT(a.faces.size() == b.faces.size());
  RC_ASSERT(a.lost_faces == b.lost_faces);
  for (std::size_t i = 0; i < a.faces.size(); ++i) {
    RC_ASSERT(std::abs(a.faces[i].area - b.faces[i].area) < 1e-11);
    RC_ASSERT(a.faces[i].polygon.size() == b.faces[i].polygon.size());
    RC_ASSERT(norm(frame.point(a.faces[i].centre) - b.faces[i].centre) < 1e-11);
    RC_ASSERT(norm(frame.direction(a.faces[i].normal) - b.faces[i].normal) < 1e-11);
  }
}

RC_GTEST_PROP(Bodies, joint_faces_do_not_depend_on_the_order, ()) {
  const std::vector<BodySpec> here = any_stones();
  std::vector<BodySpec> other = here;
  std::rotate(other.begin(), other.begin() + *rc::gen::inRange(1, 3), other.end());
  FaultList faults;
  const auto a = areas_of(assemble(here, faults)), b = areas_of(assemble(other, faults));
  RC_ASSERT(a.size() == b.size());
  for (std::size_t i = 0; i < a.size(); ++i) RC_ASSERT(std::abs(a[i] - b[i]) < 1e-14);
}

// The area of a face is the sum of its joint areas and its free area.
RC_GTEST_PROP(Bodies, free_and_joint_areas_add_up_to_the_surface, ()) {
  const std::vector<BodySpec> stones = any_stones();
  FaultList faults;
  const SpaceAssembly assembly = assemble(stones, faults);
  RC_PRE(faults.empty());
  double surface = 0, free = 0;
  for (const BodySpec& body : stones)
    for (const auto& face : body.part[0].face) surface += facet_of(body.part[0], face).area;
  for (const OuterFace& outer : assembly.outer) free += outer.area;
  for (const JointFace& face : assembly.faces) free += 2 * face.area;
  RC_ASSERT(std::abs(surface - free) < 2e-3 * surface);  // slivers below a thousandth of a face
}

}  // namespace
}  // namespace wythe::geometry::bodies_property_test
