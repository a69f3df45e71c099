// Small walls shared by tests and benchmarks, built in code; only tuff_wall() reads a file.
//
//   rectangles + assembly()     blocks on the ground with one joint material
//   block_on_ground, stack      one block, n blocks one on the other
//   small_wall                  8 x 8 half units in running bond with a window, the fast wall
//   tuff_wall                   the paper's wall, read from examples/tuff_wall/model.toml
//
// turned(), mirrored(), reversed(), scaled() change an assembly for the property tests.
#pragma once

#include <string>
#include <vector>

#include "wythe/parts/model.h"
#include "wythe/parts/wall_spec.h"

namespace wythe::scenes {

inline constexpr double kPi = 3.14159265358979323846;
[[nodiscard]] constexpr double degrees(double angle) { return angle * kPi / 180; }

// --- materials -----------------------------------------------------------------------------------

// Strengths that are never reached: a linear spring in w and slip.
[[nodiscard]] JointMaterial elastic_joint(double normal_stiffness, double shear_stiffness);
// No tension, no cohesion, one friction angle, no crushing.
[[nodiscard]] JointMaterial dry_joint(double normal_stiffness, double shear_stiffness,
                                      double friction_angle);
// Table 1 of the D-RBA paper.
[[nodiscard]] JointMaterial paper_joint();
[[nodiscard]] JointMaterial capped_joint();  // with a compression cap, hardening and dilatancy
[[nodiscard]] JointMaterial paper_unit();

// --- assemblies ----------------------------------------------------------------------------------

[[nodiscard]] BlockSpec rectangle(const std::string& id, double x, double y, double width,
                                  double height);
// Blocks on the line of their lowest corner, or on the fixed ones among them; no stage.
[[nodiscard]] ModelSpec assembly(std::vector<BlockSpec> blocks, const JointMaterial& joint,
                                 double thickness, double density);
// "b0" on the ground, from x = 0.
[[nodiscard]] ModelSpec block_on_ground(double width, double height, const JointMaterial& joint,
                                        double thickness, double density);
// "b0" (lowest) ... "b<n-1>", each width x height.
[[nodiscard]] ModelSpec stack(int n, double width, double height, const JointMaterial& joint,
                              double thickness, double density);
// A grid of half units 0.155 m x 0.11 m with one joint material. It has a hole of `hole`
// columns x `hole` courses, which begins at column `hole_at_column` and course
// `hole_at_course`. Blocks are named "r<course>c<column>" and stand on a fixed block "sill".
struct BondSize {
  int columns = 8, courses = 8;
  int hole_at_column = 3, hole_at_course = 3, hole = 2;
};
[[nodiscard]] ModelSpec half_units(const BondSize& size, const JointMaterial& joint);

// --- in space ------------------------------------------------------------------------------------

// A box from its lowest corner.
[[nodiscard]] BodySpec box(const std::string& id, Vec3 corner, Vec3 size, bool fixed = false);
// Bodies with one joint material, density 2000 kg/m^3 where none is given; no stage.
[[nodiscard]] ModelSpec in_space(std::vector<BodySpec> bodies, const JointMaterial& joint,
                                 double density = 2000);
// The blocks of a plane assembly as prisms with its thickness, which can move in that plane only.
[[nodiscard]] ModelSpec prisms(const ModelSpec& plane);
// A wall of bricks, with its openings and frames, along a line in plan: "w". A pressure acts on its top course.
[[nodiscard]] ModelSpec along_a_line(ModelSpec plane, int wythes = 1);
// Turns every body about the vertical axis, and the directions of the stages with it.
[[nodiscard]] ModelSpec turned_about_y(ModelSpec spec, double angle);

// --- walls from a WallSpec -----------------------------------------------------------------------

// 1.24 m x 0.88 m x 0.31 m, window of 2 x 2 half units, joint and unit of Table 1; stages gravity,
// precompression of `pier_load` and a push of `until` [m] at `velocity` [m/s].
[[nodiscard]] ModelSpec small_wall(double until = 2e-3, double velocity = 0.02,
                                   double pier_load = 20e3);
// The same with columns x courses half units and no opening.
[[nodiscard]] ModelSpec plain_wall(int columns, int courses, double until, double velocity);
// Two dry piers of five courses and a lintel of dry stones over them, with
// free contacts. A push by `until` [m], then a release: the portal collapses.
[[nodiscard]] ModelSpec falling_portal(double until);
// examples/tuff_wall/model.toml under source_dir(), pushed to `until` [m].
[[nodiscard]] ModelSpec tuff_wall(const std::string& source_dir, double until);

// The same with a prestressed tie that yields, a tie to an anchor, a floor and a cross wall.
[[nodiscard]] ModelSpec tied(ModelSpec spec);
// small_wall with a frame of soft bars in its window, which yields in the first tenth of a millimetre.
[[nodiscard]] ModelSpec framed(ModelSpec spec);
// small_wall, framed or not: its window is cut in a stage before the push.
[[nodiscard]] ModelSpec cut_under_load(ModelSpec spec);
// small_wall with weak fibres in both directions, which detach and break in the first tenth of a millimetre.
[[nodiscard]] ModelSpec layered(ModelSpec spec);

// --- stages --------------------------------------------------------------------------------------

[[nodiscard]] StageSpec gravity_stage();
// The vector along which a push, a body force, a tilt or a load acts; null for any other stage.
[[nodiscard]] std::vector<double>* along_of(StageSpec& stage);
[[nodiscard]] StageSpec push_stage(const std::string& block, Direction direction, double velocity,
                                   double until);

// One full sine period of the base along +x, with damping of every kind.
[[nodiscard]] StageSpec shake_stage(double amplitude, double period);

// --- changes to an assembly ----------------------------------------------------------------------

// Tensile strength, friction and stiffness of the joint material `joint` differ from joint to joint.
[[nodiscard]] ModelSpec with_fields(ModelSpec spec, int seed);

[[nodiscard]] ModelSpec turned(ModelSpec spec, double angle);  // about the origin
[[nodiscard]] ModelSpec mirrored(ModelSpec spec);              // x -> -x
[[nodiscard]] ModelSpec reversed(ModelSpec spec);              // blocks in reverse order
// Lengths times `s` with strengths, density and velocities kept: stiffness / s, energies * s,
// gravity / s, times * s. Displacements come out times s, forces times s^2.
[[nodiscard]] ModelSpec scaled(ModelSpec spec, double s);

// --- parts of a model ----------------------------------------------------------------------------

// Adds a stage with one dead load in full force; returns the stage's index.
std::size_t add_load(Model& model, const PointLoad& load);
[[nodiscard]] BlockId block_named(const Model& model, const std::string& id);

}  // namespace wythe::scenes
