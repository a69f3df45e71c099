// Motion of joints and blocks in the form that the rules need; scan lines and bed
// sections over a region. Used by element_states.cpp, mode_flags.cpp and features.cpp.
#pragma once

#include <functional>
#include <vector>

#include "judge/modes/wall_parts.h"
#include "wythe/parts/model.h"
#include "wythe/parts/reading.h"
#include "wythe/parts/vector.h"

namespace wythe::study {

struct JointMotion {
  JointKind kind = JointKind::kOther;
  BlockId a = kGroundBlock, b = 0;
  bool is_bed = false;              // closer to horizontal than to vertical
  bool on_ground = false;           // the foundation: on the ground or a fixed block
  double x = 0, y = 0;              // centre at the start [m]
  double reach_x = 0, reach_y = 0;  // half its extent [m]
  double opening = 0;               // mean over its points now, closed points 0 [m]
  double widest = 0;                // largest of its points, now or before [m]
  double opened = 0;                // mean of its points' largest openings so far [m]
  double slip = 0;      // mean now; bed: upper against lower along +x, upright: left against right
                        // along +y [m]
  double crushing = 0;  // share of the strength lost, largest of its points [-]
  double slid = 0;      // plastic part of the slip, mean, same signs [m]
  double crushed = 0;   // crushing shortening, mean of its points [m]
  double force = 0;     // compression across it [N]
  double bond = 0;      // the greater of its tensile strength and cohesion, times its area [N]
  bool has_slid_off = false;  // pressed, and its faces overlap by less than half
  double share = 1;           // of the wall's thickness there: half in one of two leaves
  // Length along the wall, as if the joint went through the thickness [m].
  [[nodiscard]] double length() const { return share * 2 * (is_bed ? reach_x : reach_y); }
};

// A small rigid motion: the displacement of the point `at`, and a rotation about it.
struct RigidMotion {
  Vec3 at;     // [m]
  Vec3 moved;  // [m]
  Vec3 turn;   // axis times angle [rad]
};
struct BlockMotion : RigidMotion {  // of a block's centroid
  BlockRole role = BlockRole::kMasonry;
  double mass = 0, inertia = 0;  // [kg], [kg m^2]
};

struct WallMotion {
  std::vector<JointMotion> joints;  // of masonry and lintels
  std::vector<JointMotion> top;     // of the plates and of the beam
  std::vector<BlockMotion> blocks;
};
// The motion in the view of one wall. Blocks of other walls keep their numbers, but have no mass and no place.
[[nodiscard]] WallMotion evaluate_motion(const Model& model, const WallReading& now,
                                         const Elevation& seen);
[[nodiscard]] WallMotion evaluate_motion(const Model& model, const State& state,
                                         const Elevation& seen = {});

// The rigid motion that fits the chosen blocks best, by
// least squares weighted by mass; zero where there is none.
using Chosen = std::function<bool(const BlockMotion&)>;
[[nodiscard]] RigidMotion fitted(const std::vector<BlockMotion>& blocks, const Chosen& chosen);

// Connected blocks that have left the rest of the wall: their displacements relative to
// its rigid motion are `parted` or more, and no joint between them moved by as much.
struct PieceOff {
  std::vector<std::size_t> blocks;  // of masonry and lintels, into WallMotion::blocks
  double share = 0;                 // of the mass of all masonry and lintels
  double way = 0;                   // mean, of its blocks [m]
  double torn = 0;  // share of the length of the joints around it that opened or slid by `crack`
};
// The heaviest first. The rest of the wall is at least half of it, with a motion as rigid as possible.
[[nodiscard]] std::vector<PieceOff> pieces_off(const WallMotion& motion, double crack,
                                               double parted);

// Sum over the joints that one straight line through a region crosses, each weighted by its share of the thickness.
struct LineSum {
  double at = 0;                          // height of a level line, place of an upright one [m]
  double opening = 0;                     // now [m]
  double opened = 0;                      // largest so far [m]
  double slip = 0;                        // signed [m]
  [[nodiscard]] double movement() const;  // opened and slipped together [m]
};
// Level lines cross head joints, upright lines cross bed joints, with four lines for each `pitch`.
// Only masonry counts: lintel chain and bond, and joints on the region's edge are left out.
enum class Lines { kLevel, kUpright };
[[nodiscard]] std::vector<LineSum> scan(const std::vector<JointMotion>& joints, const Box& box,
                                        Lines lines, double pitch);

// The bed joints of a region at one height.
struct BedSection {
  double y = 0;  // [m]
  std::vector<const JointMotion*> joints;
};
[[nodiscard]] std::vector<BedSection> bed_sections(const std::vector<JointMotion>& joints,
                                                   const Box& box, double course);
// The slip that 90 % of `width` reaches [m].
[[nodiscard]] double slip_all_across(const BedSection& section, double width);
// The same along a plane that steps from one section to another: the slips at a place add up. `in_first`: share of the first
// section in what slips.
struct SteppedSlip {
  double slip = 0, in_first = 0;
};
[[nodiscard]] SteppedSlip slip_in_steps(const BedSection& first, const BedSection& second,
                                        double width);
// Share of `width` whose joints have opened by `crack` or more so far.
[[nodiscard]] double open_share(const BedSection& section, double width, double crack);
// Share of the box's width, from one of its sides on without a gap, below or above which some section is open: a crack may step.
[[nodiscard]] double open_share_in_steps(const std::vector<BedSection>& sections, const Box& box,
                                         double crack);
// The plastic slip in one direction that 90 % of `width` reaches; signed [m].
[[nodiscard]] double slid_all_across(const BedSection& section, double width);

}  // namespace wythe::study
