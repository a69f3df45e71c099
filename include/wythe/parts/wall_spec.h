// The content of a model file: the wall, its materials, the stages of the test and the settings.
//
// Plain data in SI units. src/io/keys/describe.h describes every member once; reading, writing, --set,
// error messages and the reference page follow from it. Physical values start as NaN (kUnset).
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "wythe/parts/body.h"
#include "wythe/parts/contact_law.h"
#include "wythe/parts/field.h"
#include "wythe/parts/free_contacts.h"
#include "wythe/parts/masonry.h"
#include "wythe/parts/words.h"
#include "wythe/parts/zone_spec.h"

namespace wythe {

enum class Bond { kRunning, kStack, kFlemish, kEnglish, kHeader };
inline constexpr Word<Bond> kBondWords[] = {{"running", Bond::kRunning},
                                            {"stack", Bond::kStack},
                                            {"flemish", Bond::kFlemish},
                                            {"english", Bond::kEnglish},
                                            {"header", Bond::kHeader}};
enum class Split { kMiddle, kAtJoints, kNone };
inline constexpr Word<Split> kSplitWords[] = {
    {"middle", Split::kMiddle}, {"at_joints", Split::kAtJoints}, {"none", Split::kNone}};
// What to do where units or courses do not fit evenly into the wall or an opening.
enum class Fit { kWhole, kCut };
inline constexpr Word<Fit> kFitWords[] = {{"whole", Fit::kWhole}, {"cut", Fit::kCut}};
enum class Freedom { kFree, kBlocked };
inline constexpr Word<Freedom> kFreedomWords[] = {{"free", Freedom::kFree},
                                                  {"blocked", Freedom::kBlocked}};

// A lintel of rigid segments joined by springs, or one deformable block of zones.
enum class LintelModel { kSegments, kZones };
inline constexpr Word<LintelModel> kLintelModelWords[] = {{"segments", LintelModel::kSegments},
                                                          {"zones", LintelModel::kZones}};
// The last two are for walls in space alone.
enum class Direction { kPlusX, kMinusX, kPlusY, kMinusY, kPlusZ, kMinusZ };
inline constexpr Word<Direction> kDirectionWords[] = {
    {"+x", Direction::kPlusX},  {"-x", Direction::kMinusX}, {"+y", Direction::kPlusY},
    {"-y", Direction::kMinusY}, {"+z", Direction::kPlusZ},  {"-z", Direction::kMinusZ}};

// Where a push acts: the blocks whose outline holds the point (x, y), widened to `courses` courses;
// or every block whose centroid lies in the box (x, y, width, height); or one block by id; or the beam.
// In space a point or box has z and depth too, and an id may end with * for all that begin so; or all blocks
// of a role.
struct PlaceSpec {
  double x = kUnset, y = kUnset, z = kUnset;               // [m]
  double width = kUnset, height = kUnset, depth = kUnset;  // [m]
  int courses = 1;
  std::string block;
  bool beam = false;
  std::string role;  // in space: word of BlockRole (model.h)
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

// An arch of voussoirs over an opening, in the place of a lintel (docs/theory/conventions.md).
enum class ArchKind { kNone, kFlat, kSegmental, kRound };
inline constexpr Word<ArchKind> kArchKindWords[] = {
    {"flat", ArchKind::kFlat}, {"segmental", ArchKind::kSegmental}, {"round", ArchKind::kRound}};
struct ArchSpec {
  ArchKind kind = ArchKind::kNone;
  double rise = kUnset;       // of the intrados above the springing [m]; segmental
  double depth = kUnset;      // of the voussoirs, from intrados to extrados [m]
  double skewback = kUnset;   // angle of the end joints from upright [rad]; flat
  int voussoirs = 0;          // 0: as many as units of a course fit
  std::string joint = "";     // joint material between voussoirs; "": joint
  std::string material = "";  // of the voussoirs, for their density; "": the masonry's
};

// A stone or a chain below an opening, as a lintel above it.
struct SillSpec {
  std::string kind;         // "": no sill; a label, as LintelSpec::kind
  double depth = kUnset;    // structural depth [m]; occupies the nearest whole number of courses
  double bearing = kUnset;  // how far it reaches into the masonry on each side [m]
  std::string material;     // key in `material`: density, youngs_modulus, shear_modulus
  std::string joint = "joint";  // joint material between sill and masonry
};

struct OpeningSpec {
  std::string name;
  double x = kUnset;       // left jamb from the wall's left end [m]
  double y = kUnset;       // sill above the wall's base [m]
  double width = kUnset;   // [m]
  double height = kUnset;  // [m], up to the springing of an arch
  LintelSpec lintel;
  ArchSpec arch = {};
  std::string storey = "";  // its name: y counts from the storey's foot; "": from the wall's
  SillSpec sill = {};
  std::string cut =
      "";  // name of the stage that cuts it out of standing masonry; "": built with the wall
};

// Thickness of the mortar, for units given by their own size.
struct MortarSpec {
  double bed = kUnset, head = kUnset;  // [m]
};

// The size of units as they were built, where the model draws them larger; as `length` and `height` of UnitSpec.
struct RealUnitSpec {
  double length = kUnset, height = kUnset;  // [m]; unset: as drawn
};

struct UnitSpec {
  double length = kUnset;  // nominal, joint included [m]; with `mortar` that of the bare unit
  double height = kUnset;  // nominal course height, joint included [m]; with `mortar` bare
  double width =
      kUnset;  // header face width [m]; default half the length (flemish, english, header)
  Split split = Split::kMiddle;
  double density = kUnset;  // [kg/m^3]
  MortarSpec mortar = {};
  RealUnitSpec real = {};
};

// Names of the joint materials of masonry; "": those of the wall, and there joint, joint, unit.
struct MasonryJoints {
  std::string joint = "";       // of bed joints
  std::string head_joint = "";  // of head joints; "": joint
  std::string unit_joint = "";  // of crack planes inside units; "": unit
};

// One storey of a building, from the ground up. What it leaves unset is the wall's.
struct StoreySpec {
  std::string name;
  double height = kUnset;     // [m]
  double thickness = kUnset;  // [m]
  std::string bond;           // word of Bond; "": the wall's
  UnitSpec unit;
  MasonryJoints joints = {};
  std::string fit = "";  // word of Fit; "": the wall's
};

// A part of the masonry with other materials: a storey, a pier, a box or a polygon.
struct RegionSpec {
  std::string name;
  std::string storey;                          // its name
  int pier = 0;                                // of the storey, from the left, 1 is the first
  double x = kUnset, y = kUnset;               // lower left corner of a box [m]
  double width = kUnset, height = kUnset;      // [m]
  std::vector<std::array<double, 2>> polygon;  // [m]
  MasonryJoints joints = {};
  double density = kUnset;  // [kg/m^3]
  double thickness =
      kUnset;  // out of the plane: a niche, a pilaster, a wall across as a flange [m]
};

// A beam of concrete, timber or steel within the masonry at one level, as a chain of rigid segments
// (docs/theory/ring_beams.md).
struct RingBeamSpec {
  std::string name;
  std::string storey;           // its top lies at this storey's top
  double y = kUnset;            // or the height of its foot above the wall's base [m]
  double x = kUnset;            // left end [m]; unset: along the whole wall
  double width = kUnset;        // how much of the wall's length it takes [m]
  double height = kUnset;       // of its section [m]; occupies the nearest whole number of courses
  double thickness = kUnset;    // of its section [m]; unset: the wall's
  std::string material;         // key in `material`: density, youngs_modulus, shear_modulus
  std::string joint = "joint";  // joint material between it and the masonry below and beside it
  std::string top_joint = "";   // of what lies on it; "": joint
};

// The section of a frame's member in numbers, where no profile names it; of one piece.
struct SectionSpec {
  double height = kUnset, width = kUnset;     // in the wall's plane, across it [m]
  double area = kUnset, shear_area = kUnset;  // [m^2]
  double second_moment = kUnset;              // I [m^4]
  double plastic_modulus = kUnset;            // Wpl [m^3]
  double mass = kUnset;                       // [kg/m]
  // across the wall's plane, of frames in space [m^4]
  double weak_second_moment = kUnset, torsion_constant = kUnset;
};

// Where a frame's columns end: held by the ground, hinged on it, on a base beam, or resting on what is below.
enum class FrameFeet { kNone, kFixed, kHinged, kBaseBeam, kResting };
inline constexpr Word<FrameFeet> kFrameFeetWords[] = {{"fixed", FrameFeet::kFixed},
                                                      {"hinged", FrameFeet::kHinged},
                                                      {"base_beam", FrameFeet::kBaseBeam},
                                                      {"resting", FrameFeet::kResting}};

// Anchors that hold a frame to the masonry beside it, spread along its members (docs/theory/frames.md, "Anchors").
struct AnchorSpec {
  double spacing = kUnset;                  // along a member [m]
  double depth = kUnset;                    // how far behind its face the masonry holds it [m]
  double tension = kUnset, shear = kUnset;  // strength of one [N]
  double slip = 1e-3;                       // at these strengths, from no force on [m]
};
// Wedges or jacks that press a frame's beam against the masonry above while it is put up.
struct WedgeSpec {
  double force = kUnset;    // of all together [N]
  double spacing = kUnset;  // along the beam [m]
};
// The opening that a frame in space stands in, in the frame's plane [m].
struct HoleSpec {
  double x = kUnset, y = kUnset, width = kUnset, height = kUnset;
};
// A frame of columns and beams, round an opening or along a line, as a chain of rigid segments joined by
// elastic-plastic sections (docs/theory/frames.md).
struct FrameSpec {
  std::string name;
  std::string round;                        // name of the opening that it stands in
  std::vector<std::array<double, 2>> line;  // or its axis, from corner to corner [m]
  FrameFeet feet = FrameFeet::kNone;
  std::string profile;       // name of a rolled section; "": section
  int count = 1;             // of them side by side
  SectionSpec section;       // in the place of a profile
  std::string beam_profile;  // of level members; "" and no beam_section: as the columns
  int beam_count = 0;        // 0: as the columns
  SectionSpec beam_section;
  std::string grade;               // of steel: S235, S275, S355; "": the next three
  double yield_strength = kUnset;  // fy [Pa]
  double youngs_modulus = kUnset;  // [Pa]
  double shear_modulus = kUnset;   // [Pa]
  std::string joint;               // joint material between it and what it touches
  double gap = 0;                  // between it and the jambs and head of its opening [m]
  std::string stage =
      "";  // name of the stage that puts it up; "": that which cuts its opening, or the first
  AnchorSpec anchors;
  WedgeSpec wedges;
  // In space: the wall of the builder in whose middle plane it stands; or the place in the file's axes where that
  // plane has x = y = 0 [m], its turn in plan from x [rad], and the opening that it stands in.
  std::string wall;
  double x = kUnset, y = kUnset, z = kUnset, turn = 0;
  HoleSpec hole;
};

// The fibres of a layer; of one face.
struct LayerFibreSpec {
  double horizontal = 0,
         vertical = 0;             // area of the fibres that run so, per metre across them [m^2/m]
  double youngs_modulus = kUnset;  // [Pa]
  double strength = kUnset;        // in tension [Pa]; or
  double strain_at_rupture = kUnset;  // [-]
};
// How a layer holds on to the masonry, as it slips along it (docs/theory/layers.md).
struct LayerBondSpec {
  double energy = kUnset;  // to detach it by slip [N/m]
  double slip = kUnset;    // at the greatest bond stress [m]
};
// The mortar of a layer, where it bears more than the bond of its fibres (docs/theory/layers.md, "The mortar").
struct LayerMortarSpec {
  double thickness = kUnset;       // of one face [m]
  double youngs_modulus = kUnset;  // [Pa]
  std::string
      joint;  // name of the joint material with its strengths, which cracks where a joint of the masonry does
  double density = 0;  // [kg/m^3]
};
// Fibres in mortar on the faces of the masonry: reinforced plaster, textile mortars, nets.
struct LayerSpec {
  std::string name;
  double x = kUnset, y = kUnset;           // lower left corner [m]; unset: the masonry's
  double width = kUnset, height = kUnset;  // [m]; unset: to its end
  int sides = 0;                           // 1 or 2 faces
  LayerFibreSpec fibres;
  LayerBondSpec bond;
  LayerMortarSpec mortar;
};

// What a floor or roof does to the wall at one level (docs/theory/integration.md, "Floors").
struct FloorSpec {
  std::string name;
  std::string storey;          // on whose top it lies
  double y = kUnset;           // or the height of its bearing above the wall's base [m]
  double x = kUnset;           // left end [m]; unset: along the whole wall
  double width = kUnset;       // [m]
  double load = kUnset;        // vertical line load, downwards [N/m]
  std::vector<double> joists;  // x of point loads [m], which share load * width; empty: a line
  double bearing = kUnset;     // depth of the bearing, from the inner face [m]
  double thrust = 0;           // horizontal force of a roof on the wall, +x to the right [N]
  double mass = 0;             // that moves with the wall as inertia [kg/m]
  PlaceSpec from, to;  // in space: the ends of the line it lies on, in the place of y, x, width
  std::vector<std::string> origin = {};  // how load and mass came about, where they were not given
};

// A tie: a bar that only pulls, between two points of the wall, or from one to a rigid anchor.
struct TieSpec {
  std::string name;
  PlaceSpec from, to;
  bool anchored = false;                // `to` is a point that does not move
  double area = kUnset;                 // of its section [m^2]
  double youngs_modulus = kUnset;       // [Pa]
  double yield_strength = kUnlimited;   // [Pa]
  double anchor_strength = kUnlimited;  // force at which an anchor gives way, plastic [N]
  double prestress = 0;                 // [Pa]
};

// What a floor does for the points it connects.
enum class DiaphragmKind { kElastic, kRigid };
inline constexpr Word<DiaphragmKind> kDiaphragmKindWords[] = {{"elastic", DiaphragmKind::kElastic},
                                                              {"rigid", DiaphragmKind::kRigid}};
struct DiaphragmSpec {
  std::string name;
  DiaphragmKind kind = DiaphragmKind::kElastic;
  std::string storey;         // at whose top it lies
  double y = kUnset;          // or its height [m]
  std::vector<double> x;      // of the connected points [m], at least two
  std::vector<double> z;      // in space: theirs too [m]
  double stiffness = kUnset;  // axial, E A of the strip that acts [N]; elastic
};

// A wall across, or a neighbour: a spring to the ground at one point, with limits.
struct SpringSpec {
  std::string name;
  PlaceSpec at;
  Direction direction = Direction::kPlusX;  // that the point is held in, both ways
  double stiffness = kUnset;                // [N/m]
  double strength = kUnlimited;             // [N], plastic beyond
  bool pushes_only = false;                 // holds nothing that moves away: a gap opens
};

// Rigid beam over the whole wall top, for tests loaded through one.
struct BeamSpec {
  double height = kUnset;  // [m]; unset: no beam
  double density = 0;      // [kg/m^3]
  Freedom rotation = Freedom::kFree;
  std::string joint = "joint";  // joint material between beam and masonry
};

// From x on, up to the next step, the wall stands on ground at height y.
struct FoundationStep {
  double x = kUnset, y = kUnset;  // [m]
};

struct WallSpec {
  double length = kUnset;     // [m]
  double height = kUnset;     // [m]
  double thickness = kUnset;  // [m]
  Bond bond = Bond::kRunning;
  Fit fit = Fit::kWhole;
  std::string blocks;  // path of a blocks file; then length, height, bond, unit sizes are not used
  std::string up;  // axis of a file in space that points up, "y" or "z"; "": as its format has it
  std::vector<std::string> supports;  // blocks of such a file that stand still, by id; * at the end
  UnitSpec unit;
  std::vector<OpeningSpec> opening;
  BeamSpec beam;
  MasonryJoints joints = {};
  std::vector<FoundationStep> foundation = {};  // from left to right; empty: level ground at 0
};

// For blocks files: the joint between two block materials ("ground" is the support).
struct ContactRule {
  std::vector<std::string> between;  // two block material names
  std::string material;              // joint material
};

enum class StageKind { kGravity, kLoad, kPush, kBodyForce, kTilt, kHold, kShake, kCut };
inline constexpr Word<StageKind> kStageKindWords[] = {
    {"gravity", StageKind::kGravity},      {"load", StageKind::kLoad}, {"push", StageKind::kPush},
    {"body_force", StageKind::kBodyForce}, {"tilt", StageKind::kTilt}, {"hold", StageKind::kHold},
    {"shake", StageKind::kShake},          {"cut", StageKind::kCut}};
// How a stage acts on the wall. Load: kPressure or kPlate. Push: kSpreader or kEach.
enum class Manner { kDefault, kPressure, kPlate, kSpreader, kEach };
inline constexpr Word<Manner> kMannerWords[] = {{"pressure", Manner::kPressure},
                                                {"plate", Manner::kPlate},
                                                {"spreader", Manner::kSpreader},
                                                {"each", Manner::kEach}};

// How the force of a push is shared between blocks (docs/theory/integration.md, "The pattern of a push").
// kArea, in space alone: the free faces that look against the push, as a pressure on them would.
enum class Pattern { kNone, kGiven, kMassHeight, kUniform, kMass, kArea };
inline constexpr Word<Pattern> kPatternWords[] = {{"given", Pattern::kGiven},
                                                  {"mass_height", Pattern::kMassHeight},
                                                  {"uniform", Pattern::kUniform},
                                                  {"mass", Pattern::kMass},
                                                  {"area", Pattern::kArea}};

// Unit of the numbers of a record.
enum class RecordUnit { kNone, kGravity, kMetres, kCentimetres };
inline constexpr Word<RecordUnit> kRecordUnitWords[] = {{"g", RecordUnit::kGravity},
                                                        {"m/s2", RecordUnit::kMetres},
                                                        {"cm/s2", RecordUnit::kCentimetres}};
enum class PulseShape { kNone, kHalfCycle, kCycle, kRicker };
inline constexpr Word<PulseShape> kPulseShapeWords[] = {{"half_cycle", PulseShape::kHalfCycle},
                                                        {"cycle", PulseShape::kCycle},
                                                        {"ricker", PulseShape::kRicker}};

// One component of an earthquake: an acceleration over time from a file, from lists or of a pulse
// (docs/theory/dynamics.md).
struct RecordSpec {
  std::string file;    // CSV or AT2, relative to the model file
  std::string column;  // of a CSV: its head or number; "": the second, or the only
  RecordUnit unit = RecordUnit::kNone;
  double step = kUnset;               // of numbers without times [s]
  std::vector<double> times;          // [s]
  std::vector<double> accelerations;  // in `unit`
  PulseShape pulse = PulseShape::kNone;
  double amplitude = kUnset;  // of a pulse [m/s^2]
  double period = kUnset;     // of a pulse [s]
  Direction direction = Direction::kPlusX;
  PlaceSpec at;      // supports or blocks that move so; unset: the base
  std::string hash;  // of the numbers of a file, as a run writes it; "": not compared
  std::vector<double> read_times, read_accelerations;  // of the file [s], [m/s^2]; not keys
};

// All components of a shake by one factor: as given, or so that the first one gets a stated peak or spectral
// acceleration.
struct ScaleSpec {
  double factor = kUnset;
  double pga = kUnset;      // [m/s^2]
  double pgv = kUnset;      // [m/s]
  double sa = kUnset;       // pseudo-acceleration at `period` [m/s^2]
  double period = kUnset;   // [s]
  double damping = kUnset;  // of critical; unset: 0.05
};

// A fraction of critical damping at one frequency.
struct ViscousSpec {
  double fraction = kUnset;
  double frequency = kUnset;  // [Hz]
};

// A point whose motion is told over time.
struct HistorySpec {
  std::string name;
  PlaceSpec at;
};

// A push without a velocity goes at the second while the wall is near balance, and waits at the first where it
// cracks (docs/theory/integration.md) [m/s].
inline constexpr double kWaitingVelocity = 0.1e-3, kAdaptedVelocity = 5e-3;

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
  // Height above the wall's foot where the moment of the push is nil, over the wall's height: the line along
  // which the push acts; unset: through the centroids of what is pushed.
  double contraflexure = kUnset;
  Direction direction = Direction::kPlusX;
  double velocity = kUnset;       // [m/s]
  double fast_velocity = kUnset;  // while the wall is near balance [m/s]; unset: one velocity
  double fast_below = 1e-4;       // unbalance ratio below which the wall is near balance
  double until = kUnset;          // [m]
  std::vector<double> along;      // in space: any direction, in the place of `direction`
  PlaceSpec on;                   // in space: blocks whose faces the pressure acts on; unset: all
  std::string face;               // in space: where those faces look, a word of Direction; "": up
  double force = kUnset;          // in space: load at the point `at` [N]
  double line_load = kUnset;      // in space: load along the line `from` - `to` [N/m]
  PlaceSpec from, to;             //
  std::vector<double> targets;    // cyclic: displacements along `direction`, in turn [m]
  // cyclic, by a protocol (model/protocol.h): how far each level goes, as lengths or as drifts, and how often
  std::vector<double> amplitudes;  // [m]
  std::vector<double> drifts;      // over the height of the rows' drift [-]
  std::vector<double> cycles;  // one number for all levels, or one a level; empty: one cycle each
  double stop_below = 0;       // stop when the reaction falls below this share of the peak
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
  bool release = false;      // lets go of what a push before it holds
  // load
  bool floors = false;  // sets every [[floor]] on the wall; without such a stage gravity does
  // shake
  std::vector<RecordSpec> record;
  ScaleSpec scale;
  double free_vibration = 0;    // after the record [s]
  double interval = kUnset;     // between rows of the history [s]
  ViscousSpec mass_damping;     // on the motion against the base
  ViscousSpec joint_damping;    // of closed points, in proportion to their stiffness
  double restitution = kUnset;  // of a block that falls flat on another; unset: elastic
  // Of closed contacts, largest at its frequency: a spring and a dashpot in series beside them.
  ViscousSpec maxwell_damping;
};

// Where the contact points of a face stand and what area each takes (model/quadrature.h).
enum class PointRule { kDefault, kCorners, kTrapezoid, kLobatto, kGauss };
inline constexpr Word<PointRule> kPointRuleWords[] = {{"corners", PointRule::kCorners},
                                                      {"trapezoid", PointRule::kTrapezoid},
                                                      {"lobatto", PointRule::kLobatto},
                                                      {"gauss", PointRule::kGauss}};

// Local damping in space: of each component in the wall's axes, as in the paper, or of force and moment as
// vectors, which knows no axes (docs/theory/space.md).
enum class DampingForm { kVector, kComponents };
inline constexpr Word<DampingForm> kDampingFormWords[] = {{"vector", DampingForm::kVector},
                                                          {"components", DampingForm::kComponents}};

struct SolveSpec {
  PointRule point_rule = PointRule::kDefault;
  int points_per_face = 0;      // 0: as the rule has it; both unstated: lobatto, 3
  double step_fraction = 0.95;  // of the longest stable step, damping included
  double damping = 0.8;         // local damping
  DampingForm damping_form = DampingForm::kVector;  // in space alone
  double gravity = 9.81;                            // [m/s^2]
  double settle_ratio = 1e-5;       // a stage has settled below this unbalance ratio
  double settle_limit = 20;         // give up settling after this time [s]
  double mass_scaling = 1;          // density scaling of the gravity and load stages
  bool raise_light_inertia = true;  // of lintels, plates, beams that would shorten the time step
  double collapse_displacement = kUnset;  // [m]; unset: the smallest block height; unlimited where
                                          // contacts are free
  Contacts contacts = Contacts::kJoints;
  double ground = kUnset;  // height of level ground that blocks fall on, for free contacts [m]
};

// Heads and who answers for the sheet that is handed over.
struct ProjectSpec {
  std::string title, client, author, date, place;
};

// The demand of an earthquake as a spectrum: by a code's parameters, or as a table.
enum class SpectrumKind { kNone, kEn1998, kNtc2018, kTable };
inline constexpr Word<SpectrumKind> kSpectrumKindWords[] = {{"en1998", SpectrumKind::kEn1998},
                                                            {"ntc2018", SpectrumKind::kNtc2018},
                                                            {"table", SpectrumKind::kTable}};
struct SpectrumSpec {
  SpectrumKind kind = SpectrumKind::kNone;
  double ground_acceleration = kUnset;  // ag on rock [m/s^2]
  std::string ground = "A";             // ground type A to E
  std::string shape = "1";              // en1998: type 1 or 2
  double amplification = kUnset;        // ntc2018: F0 [-]
  double corner_period = kUnset;        // ntc2018: TC* [s]
  double topography = 1;                // ST [-]
  double damping = 0.05;                // of critical [-]
  std::vector<double> periods;          // table [s]
  std::vector<double> accelerations;    // table [m/s^2]
};
// The spectra of limit states that have one of their own; none: that of `AssessmentSpec::spectrum`.
struct SpectraSpec {
  SpectrumSpec operational, damage_limitation, life_safety, near_collapse;
};
// What holds a part of a wall back at one height: a tie through the wall, a floor that is anchored.
struct HoldSpec {
  std::string name;
  double height = kUnset;  // above the wall's base [m]
  double force = kUnset;   // with which it holds at most [N]
  double travel = kUnset;  // how far it goes along before it lets go [m]; unset: not known
};
// Teeth of a part with walls across: units of either lie on each other, course by course.
struct TeethSpec {
  int corners = 0;           // how many walls across
  double length = kUnset;    // of the teeth along the part: the thickness of a wall across [m]
  double course = kUnset;    // height between the faces that slide [m]
  double friction = kUnset;  // tangent of the angle [-]
};
enum class Fall { kOutwards, kInwards };
inline constexpr Word<Fall> kFallWords[] = {{"outwards", Fall::kOutwards},
                                            {"inwards", Fall::kInwards}};
// A part of a wall that may fall on its face, as one rigid strip about a line at its foot, or, where its head is held,
// as two about a line between (docs/theory/local_mechanisms.md).
struct PartSpec {
  std::string name;
  double foot = kUnset, head = kUnset;   // above the wall's base [m]
  double left = kUnset, right = kUnset;  // ends along the wall [m]
  Fall falls = Fall::kOutwards;
  bool head_held = false;
  double lean = 0;          // out of plumb, towards the fall [rad]
  double inset = kUnset;    // of the line it turns about, from the face [m]; unset: by crushing
  double bearing = kUnset;  // depth of its floors' bearings [m]; unset: their own
  std::vector<HoldSpec> hold;
  TeethSpec teeth;
};
// The building that a part belongs to, for the spectrum at its height.
struct BuildingSpec {
  double height = kUnset;  // [m]; unset: of the wall
  double period = kUnset;  // first one, T1 [s]; unset: by its height
  int storeys = 0;         // 0: those of the model
};
// What a run or campaign is asked for beside its curve (docs/theory/assessment.md).
struct AssessmentSpec {
  std::string code;       // "": none; circolare_2019, en1998_3
  SpectrumSpec spectrum;  // of `limit_state`
  SpectraSpec spectra;    // of others, or in its place
  std::string limit_state = "life_safety";
  double confidence_factor = kUnset;  // of the knowledge level; unset: 1, and said
  double masonry_share = 1;           // of the building's mass and force that this wall stands for
  double added_mass = 0;              // that the wall carries in an earthquake, but not here [kg]
  double added_height = kUnset;       // where that mass acts [m]; unset: at the control point
  double record_scatter = kUnset;     // beta of records, for fragility [-]
  BuildingSpec building;
  std::vector<PartSpec> part;  // that may fall out of the wall's plane
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
  ProjectSpec project;
  WallSpec wall;
  std::vector<StoreySpec> storey;
  std::vector<RegionSpec> region;
  std::vector<RingBeamSpec> ring_beam;
  std::vector<FrameSpec> frame;
  std::vector<LayerSpec> layer;
  std::vector<FloorSpec> floor;
  std::vector<TieSpec> tie;
  std::vector<DiaphragmSpec> diaphragm;
  std::vector<SpringSpec> spring;
  MasonrySpec masonry;  // inputs of rules
  std::map<std::string, JointMaterial> material;
  std::map<std::string, FieldSpec> field;  // what varies within the wall (study.h, draw_fields)
  // Whether a field is drawn, and does not only follow others by its formula.
  [[nodiscard]] bool draws_fields() const {
    for (const auto& one : field)
      if (one.second.formula.empty()) return true;
    return false;
  }
  ScatterSpec scatter;  // fields by the kind of masonry
  std::vector<ContactRule> contact;
  std::vector<StageSpec> stage;
  std::vector<HistorySpec> history;
  SolveSpec solve;
  AssessmentSpec assessment;
  OutputSpec output;
  std::vector<BlockSpec> block;  // content of the file wall.blocks; not a key
  std::vector<BodySpec> body;    // the same in space; not a key
  std::string folder;            // folder of the model file, for relative paths; not a key
};

}  // namespace wythe
