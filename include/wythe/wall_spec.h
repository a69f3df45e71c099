// The content of a model file: the wall, its materials, the stages of the test and the settings.
//
// Plain data in SI units. src/io/describe.h describes every member once; reading, writing, --set,
// error messages and the reference page follow from it. Physical values start as NaN (kUnset).
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "wythe/contact_law.h"
#include "wythe/field.h"
#include "wythe/masonry.h"
#include "wythe/words.h"

namespace wythe {

enum class Bond { kRunning, kStack, kFlemish, kEnglish, kHeader };
inline constexpr Word<Bond> kBondWords[] = {{"running", Bond::kRunning},
                                            {"stack", Bond::kStack},
                                            {"flemish", Bond::kFlemish},
                                            {"english", Bond::kEnglish},
                                            {"header", Bond::kHeader}};
static_assert(names_all(kBondWords));
enum class Split { kMiddle, kAtJoints, kNone };
inline constexpr Word<Split> kSplitWords[] = {
    {"middle", Split::kMiddle}, {"at_joints", Split::kAtJoints}, {"none", Split::kNone}};
static_assert(names_all(kSplitWords));
// What to do where units or courses do not fit evenly into the wall or an opening.
enum class Fit { kWhole, kCut };
inline constexpr Word<Fit> kFitWords[] = {{"whole", Fit::kWhole}, {"cut", Fit::kCut}};
static_assert(names_all(kFitWords));
enum class Freedom { kFree, kBlocked };
inline constexpr Word<Freedom> kFreedomWords[] = {{"free", Freedom::kFree},
                                                  {"blocked", Freedom::kBlocked}};
static_assert(names_all(kFreedomWords));

// A lintel of rigid segments joined by springs, or one deformable block of zones.
enum class LintelModel { kSegments, kZones };
inline constexpr Word<LintelModel> kLintelModelWords[] = {{"segments", LintelModel::kSegments},
                                                          {"zones", LintelModel::kZones}};
static_assert(names_all(kLintelModelWords));
// Zones: both pairs of constant-strain triangles of a quadrilateral laid over each other, with half
// the weight each; mixed gives them one common volumetric strain.
enum class ZoneKind { kMixed, kCst };
inline constexpr Word<ZoneKind> kZoneKindWords[] = {{"mixed", ZoneKind::kMixed},
                                                    {"cst", ZoneKind::kCst}};
static_assert(names_all(kZoneKindWords));
enum class Plane { kStress, kStrain };
inline constexpr Word<Plane> kPlaneWords[] = {{"stress", Plane::kStress},
                                              {"strain", Plane::kStrain}};
static_assert(names_all(kPlaneWords));

// How a deformable block is divided into zones, and its plane condition.
struct ZoneSpec {
  int zones = 0;           // through the depth; 0: the block is rigid
  double length = kUnset;  // of a zone [m]; unset: as long as deep
  ZoneKind kind = ZoneKind::kMixed;
  Plane plane = Plane::kStress;
};

struct LintelSpec {
  std::string kind;            // "": no lintel; "timber", "stone", ...: only a label
  double depth = kUnset;       // structural depth [m]; occupies the nearest whole number of courses
  double bearing = kUnset;     // length of support on each side [m]
  std::string material;        // key in `material`: density, youngs_modulus, shear_modulus
  std::string bond = "joint";  // joint material between lintel and masonry
  std::string bearing_bond = "";  // of the faces it rests on; "": bond
  std::string top_bond = "";      // of the faces above it; "": bond
  LintelModel model = LintelModel::kSegments;
  int zones = 2;                // through the depth, for model = zones
  double zone_length = kUnset;  // [m]
  ZoneKind zone_kind = ZoneKind::kMixed;
  Plane plane = Plane::kStress;
};

struct OpeningSpec {
  std::string name;
  double x = kUnset;       // left jamb from the wall's left end [m]
  double y = kUnset;       // sill above the wall's base [m]
  double width = kUnset;   // [m]
  double height = kUnset;  // [m]
  LintelSpec lintel;
};

struct UnitSpec {
  double length = kUnset;  // nominal, joint included [m]
  double height = kUnset;  // nominal course height, joint included [m]
  double width =
      kUnset;  // header face width [m]; default half the length (flemish, english, header)
  Split split = Split::kMiddle;
  double density = kUnset;  // [kg/m^3]
};

// Rigid beam over the whole wall top, for tests loaded through one.
struct BeamSpec {
  double height = kUnset;  // [m]; unset: no beam
  double density = 0;      // [kg/m^3]
  Freedom rotation = Freedom::kFree;
  std::string joint = "joint";  // joint material between beam and masonry
};

struct WallSpec {
  double length = kUnset;     // [m]
  double height = kUnset;     // [m]
  double thickness = kUnset;  // [m]
  Bond bond = Bond::kRunning;
  Fit fit = Fit::kWhole;
  std::string blocks;  // path of a blocks file; then length, height, bond, unit sizes are not used
  UnitSpec unit;
  std::vector<OpeningSpec> opening;
  BeamSpec beam;
};

// For blocks files: the joint between two block materials ("ground" is the support).
struct ContactRule {
  std::vector<std::string> between;  // two block material names
  std::string material;              // joint material
};

enum class StageKind { kGravity, kLoad, kPush, kBodyForce, kTilt, kHold };
inline constexpr Word<StageKind> kStageKindWords[] = {
    {"gravity", StageKind::kGravity},      {"load", StageKind::kLoad}, {"push", StageKind::kPush},
    {"body_force", StageKind::kBodyForce}, {"tilt", StageKind::kTilt}, {"hold", StageKind::kHold}};
static_assert(names_all(kStageKindWords));
enum class Direction { kPlusX, kMinusX, kPlusY, kMinusY };
inline constexpr Word<Direction> kDirectionWords[] = {{"+x", Direction::kPlusX},
                                                      {"-x", Direction::kMinusX},
                                                      {"+y", Direction::kPlusY},
                                                      {"-y", Direction::kMinusY}};
static_assert(names_all(kDirectionWords));
// How a stage acts on the wall. Load: kPressure or kPlate. Push: kSpreader or kEach.
enum class Manner { kDefault, kPressure, kPlate, kSpreader, kEach };
inline constexpr Word<Manner> kMannerWords[] = {{"pressure", Manner::kPressure},
                                                {"plate", Manner::kPlate},
                                                {"spreader", Manner::kSpreader},
                                                {"each", Manner::kEach}};
static_assert(names_all(kMannerWords, 1));  // kDefault is not written

// Where a push acts: the blocks whose outline holds the point (x, y), widened to `courses` courses;
// or every block whose centroid lies in the box (x, y, width, height); or one block by id; or the beam.
struct PlaceSpec {
  double x = kUnset, y = kUnset;           // [m]
  double width = kUnset, height = kUnset;  // [m]
  int courses = 1;
  std::string block;
  bool beam = false;
};

// How the force of a push is shared between blocks (docs/theory/integration.md, "The pattern of a push").
enum class Pattern { kNone, kGiven, kMassHeight, kUniform, kMass };
inline constexpr Word<Pattern> kPatternWords[] = {{"given", Pattern::kGiven},
                                                  {"mass_height", Pattern::kMassHeight},
                                                  {"uniform", Pattern::kUniform},
                                                  {"mass", Pattern::kMass}};
static_assert(names_all(kPatternWords, 1));  // kNone is not written

struct StageSpec {
  std::string name;
  StageKind kind = StageKind::kGravity;  // inferred from the keys present
  double ramp = kUnset;     // duration of the smooth start [s]; unset: documented default
  double damping = kUnset;  // local damping of this stage; unset: solve.damping
  // load
  double pier_load = kUnset;  // on the top of each pier [N]
  double pressure = kUnset;   // on the whole wall top [Pa]
  double beam_load = kUnset;  // on the beam's centre [N]
  Manner as = Manner::kDefault;
  std::string plate_joint = "foundation";  // joint material under a plate
  // push
  PlaceSpec at;
  Pattern pattern = Pattern::kNone;  // forces at several levels in the place of `at`
  std::vector<double> levels;        // their heights [m]
  std::vector<double> shares;        // kGiven: of the force, one a level
  PlaceSpec control;                 // whose displacement the push follows; unset: the driven mean
  Direction direction = Direction::kPlusX;
  double velocity = kUnset;       // [m/s]
  double fast_velocity = kUnset;  // while the wall is near balance [m/s]; unset: one velocity
  double fast_below = 2e-4;       // unbalance ratio below which the wall is near balance
  double until = kUnset;          // [m]
  std::vector<double> targets;    // cyclic: displacements along `direction`, in turn [m]
  double stop_below = 0;          // stop when the reaction falls below this share of the peak
  Freedom rotation = Freedom::kFree;
  Freedom across = Freedom::kFree;  // motion across the push direction
  // body force: horizontal force lambda W_i on every block, growing at `rate` up to `factor`
  double rate = kUnset;    // [1/s]
  double factor = kUnset;  // largest lambda
  // tilt
  double tilt_rate = kUnset;   // [rad/s]
  double tilt_until = kUnset;  // [rad]
  // hold
  double duration = kUnset;  // [s]
};

// Where the contact points of a face stand and what area each takes (model/point_rule.h).
enum class PointRule { kDefault, kCorners, kTrapezoid, kLobatto, kGauss };
inline constexpr Word<PointRule> kPointRuleWords[] = {{"corners", PointRule::kCorners},
                                                      {"trapezoid", PointRule::kTrapezoid},
                                                      {"lobatto", PointRule::kLobatto},
                                                      {"gauss", PointRule::kGauss}};
static_assert(names_all(kPointRuleWords, 1));  // kDefault is not written

struct SolveSpec {
  PointRule point_rule = PointRule::kDefault;
  int points_per_face = 0;          // 0: as the rule has it; both unstated: lobatto, 3
  double step_fraction = 0.95;      // of the longest stable step, damping included
  double damping = 0.8;             // local damping
  double gravity = 9.81;            // [m/s^2]
  double settle_ratio = 1e-5;       // a stage has settled below this unbalance ratio
  double settle_limit = 20;         // give up settling after this time [s]
  double mass_scaling = 1;          // density scaling of the gravity and load stages
  bool raise_light_inertia = true;  // of lintels, plates, beams that would shorten the time step
  double collapse_displacement = kUnset;  // [m]; unset: the smallest block height
};

struct OutputSpec {
  int rows = 500;                   // rows of force_displacement.csv
  double window = kUnset;           // averaging window of the reaction [m]; unset: one row
  std::vector<double> states = {};  // displacements at which a state is written [m]
};

// One block of a blocks file, already read (src/io): a simple polygon, any orientation.
struct BlockSpec {
  std::string id;
  std::vector<std::array<double, 2>> polygon;  // [m]
  std::string material = "masonry";  // names a material with a density, else wall.unit.density
  bool fixed = false;                // a support: never moves
  bool beam = false;                 // the loading beam: at = { beam = true } and beam_load find it
  ZoneSpec zone = {};                // deformable where zone.zones > 0
};

struct ModelSpec {
  std::string name;
  std::string note;
  WallSpec wall;
  MasonrySpec masonry;  // inputs of rules
  std::map<std::string, JointMaterial> material;
  std::map<std::string, FieldSpec> field;  // what varies within the wall (study.h, draw_fields)
  std::vector<ContactRule> contact;
  std::vector<StageSpec> stage;
  SolveSpec solve;
  OutputSpec output;
  std::vector<BlockSpec> block;  // content of the file wall.blocks; not a key
  std::string folder;            // folder of the model file, for relative paths; not a key
};

}  // namespace wythe
