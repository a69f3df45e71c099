// The content of a model file: the wall, its materials, the stages of the test and the settings.
//
// Plain data in SI units. src/io/keys/describe.h describes every member once; reader, writer, --set,
// error messages and reference page are derived from it. Physical values start as NaN (kUnset).
#pragma once

#include <array>
#include <cstdint>
#include <iterator>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "wythe/parts/body.h"
#include "wythe/parts/contact_law.h"
#include "wythe/parts/error.h"
#include "wythe/parts/field.h"
#include "wythe/parts/free_contacts.h"
#include "wythe/parts/masonry.h"
#include "wythe/parts/message.h"
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
// How to fit units or courses that do not divide a wall or an opening evenly.
enum class Fit { kWhole, kCut };
inline constexpr Word<Fit> kFitWords[] = {{"whole", Fit::kWhole}, {"cut", Fit::kCut}};
enum class Freedom { kFree, kBlocked };
inline constexpr Word<Freedom> kFreedomWords[] = {{"free", Freedom::kFree},
                                                  {"blocked", Freedom::kBlocked}};

// A lintel as rigid segments joined by springs, or as one deformable block of zones.
enum class LintelModel { kSegments, kZones };
inline constexpr Word<LintelModel> kLintelModelWords[] = {{"segments", LintelModel::kSegments},
                                                          {"zones", LintelModel::kZones}};
// The last two are for walls in space only.
enum class Direction { kPlusX, kMinusX, kPlusY, kMinusY, kPlusZ, kMinusZ };
inline constexpr Word<Direction> kDirectionWords[] = {
    {"+x", Direction::kPlusX},  {"-x", Direction::kMinusX}, {"+y", Direction::kPlusY},
    {"-y", Direction::kMinusY}, {"+z", Direction::kPlusZ},  {"-z", Direction::kMinusZ}};

// Where a push acts: on the blocks whose outline contains the point (x, y), widened to `courses` courses;
// on all blocks whose centroid lies in the box (x, y, width, height); on one block by id; or on the beam.
// In space points and boxes also have z and depth. An id that ends with * selects all ids that begin so, and a role all
// blocks of that role.
struct PlaceSpec {
  double x = kUnset, y = kUnset, z = kUnset;               // [m]
  double width = kUnset, height = kUnset, depth = kUnset;  // [m]
  int courses = 1;
  std::string block = {};
  bool beam = false;
  std::string role = {};  // in space: word of BlockRole (model.h)
};

struct LintelSpec {
  std::string kind;            // "": no lintel; "timber", "stone", ... are labels only
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

// An arch of voussoirs over an opening, in place of a lintel (docs/theory/conventions.md).
enum class ArchKind { kNone, kFlat, kSegmental, kRound };
inline constexpr Word<ArchKind> kArchKindWords[] = {
    {"flat", ArchKind::kFlat}, {"segmental", ArchKind::kSegmental}, {"round", ArchKind::kRound}};
struct ArchSpec {
  ArchKind kind = ArchKind::kNone;
  double rise = kUnset;       // of the intrados above the springing [m]; segmental
  double depth = kUnset;      // of the voussoirs, from intrados to extrados [m]
  double skewback = kUnset;   // angle of the end joints from the vertical [rad]; flat
  int voussoirs = 0;          // 0: as many as units of a course fit in
  std::string joint = "";     // joint material between voussoirs; "": joint
  std::string material = "";  // of the voussoirs, for their density; "": the masonry's
};

// A sill below an opening: a stone or a chain of segments, as a lintel is above it.
struct SillSpec {
  std::string kind;         // "": no sill; a label, as LintelSpec::kind
  double depth = kUnset;    // structural depth [m]; occupies the nearest whole number of courses
  double bearing = kUnset;  // length in the masonry on each side [m]
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

// Thickness of mortar, for units given by their bare size.
struct MortarSpec {
  double bed = kUnset, head = kUnset;  // [m]
};

// The size of units as built, where the model draws them larger; members as in UnitSpec.
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

// Names of the joint materials of masonry; "": those of the wall, whose own defaults are joint, joint, unit.
struct MasonryJoints {
  std::string joint = "";       // of bed joints
  std::string head_joint = "";  // of head joints; "": joint
  std::string unit_joint = "";  // of crack planes inside units; "": unit
};

// One storey of a building, from the ground up. Unset values are those of the wall.
struct StoreySpec {
  std::string name;
  double height = kUnset;     // [m]
  double thickness = kUnset;  // [m]
  std::string bond;           // word of Bond; "": the wall's
  UnitSpec unit;
  MasonryJoints joints = {};
  std::string fit = "";  // word of Fit; "": the wall's
};

// Where a region of a wall lies: a storey, a pier, a box or a polygon.
struct RegionPlace {
  std::string storey;                          // its name
  int pier = 0;                                // of the storey, from the left, 1 is the first
  double x = kUnset, y = kUnset;               // lower left corner of a box [m]
  double width = kUnset, height = kUnset;      // [m]
  std::vector<std::array<double, 2>> polygon;  // [m]
};

// A part of the masonry with other materials.
struct RegionSpec {
  std::string name;
  RegionPlace place = {};
  MasonryJoints joints = {};
  double density = kUnset;  // [kg/m^3]
  double thickness =
      kUnset;  // out of plane: thickness of a niche, a pilaster or a transverse wall (flange) [m]
};

// A beam of concrete, timber or steel within the masonry at one level, as a chain of rigid segments
// (docs/theory/ring_beams.md).
struct RingBeamSpec {
  std::string name;
  std::string storey;           // its top lies at this storey's top
  double y = kUnset;            // or height of its underside above the wall's base [m]
  double x = kUnset;            // left end [m]; unset: along the whole wall
  double width = kUnset;        // length along the wall [m]
  double height = kUnset;       // of its section [m]; occupies the nearest whole number of courses
  double thickness = kUnset;    // of its section [m]; unset: the wall's
  std::string material;         // key in `material`: density, youngs_modulus, shear_modulus
  std::string joint = "joint";  // joint material between it and the masonry below and beside it
  std::string top_joint = "";   // of what lies on it; "": joint
};

// The cross-section of a frame's member in numbers, where no profile names it; of a single piece.
struct SectionSpec {
  double height = kUnset, width = kUnset;     // in the wall's plane, across it [m]
  double area = kUnset, shear_area = kUnset;  // [m^2]
  double second_moment = kUnset;              // I [m^4]
  double plastic_modulus = kUnset;            // Wpl [m^3]
  double mass = kUnset;                       // [kg/m]
  // for bending and shear out of the wall's plane and torsion, of frames in space [m^4], [m^2]
  double weak_second_moment = kUnset, torsion_constant = kUnset, weak_shear_area = kUnset;
};

// Supports of a frame's columns: clamped to the ground, hinged to it, on a base beam, or resting on the blocks below.
enum class FrameFeet { kNone, kFixed, kHinged, kBaseBeam, kResting };
inline constexpr Word<FrameFeet> kFrameFeetWords[] = {{"fixed", FrameFeet::kFixed},
                                                      {"hinged", FrameFeet::kHinged},
                                                      {"base_beam", FrameFeet::kBaseBeam},
                                                      {"resting", FrameFeet::kResting}};

// Anchors between a frame and the masonry beside it, spread along its members (docs/theory/frames.md, "Anchors").
struct AnchorSpec {
  double spacing = kUnset;                  // along a member [m]
  double depth = kUnset;                    // embedment behind the face of the masonry [m]
  double tension = kUnset, shear = kUnset;  // strength of one anchor [N]
  double slip = 1e-3;                       // at these strengths, from zero force [m]
};
// Wedges or jacks that press the beam of a frame against the masonry above during installation.
struct WedgeSpec {
  double force = kUnset;    // of all together [N]
  double spacing = kUnset;  // along the beam [m]
};
// The opening in which a frame in space stands, in the frame's plane [m].
struct HoleSpec {
  double x = kUnset, y = kUnset, width = kUnset, height = kUnset;
};
// A frame of columns and beams, around an opening or along a line, as a chain of rigid segments joined by
// elastic-plastic sections (docs/theory/frames.md).
struct FrameSpec {
  std::string name;
  std::string round;                        // name of its opening
  std::vector<std::array<double, 2>> line;  // or its axis, corner by corner [m]
  FrameFeet feet = FrameFeet::kNone;
  std::string profile;       // name of a rolled section; "": section
  int count = 1;             // number of profiles side by side
  SectionSpec section;       // in place of a profile
  std::string beam_profile;  // of beams; "" without beam_section: as columns
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
  // In space: the wall of the builder in whose middle plane it stands. Or its plane in the file's axes: the origin
  // (x = y = 0 there) [m] and the rotation in plan from x [rad], with the opening in it.
  std::string wall;
  double x = kUnset, y = kUnset, z = kUnset, turn = 0;
  HoleSpec hole;
};

// The fibres of a layer on one face.
struct LayerFibreSpec {
  double horizontal = 0,
         vertical = 0;                // area of the fibres so directed per metre of width [m^2/m]
  double youngs_modulus = kUnset;     // [Pa]
  double strength = kUnset;           // in tension [Pa]; or
  double strain_at_rupture = kUnset;  // [-]
};
// Bond of a layer to the masonry, which slips along it (docs/theory/layers.md).
struct LayerBondSpec {
  double energy = kUnset;  // energy to detach it by slip [N/m]
  double slip = kUnset;    // slip at the largest bond stress [m]
};
// The mortar of a layer, where it carries more than the bond of its fibres (docs/theory/layers.md, "The mortar").
struct LayerMortarSpec {
  double thickness = kUnset;       // of one face [m]
  double youngs_modulus = kUnset;  // [Pa]
  std::string
      joint;  // joint material with its strengths; it cracks where a joint of the masonry does
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

// Actions of a floor or roof on the wall at one level (docs/theory/integration.md, "Floors").
struct FloorSpec {
  std::string name;
  std::string storey;          // at whose top it bears
  double y = kUnset;           // or the height of its bearing above the wall's base [m]
  double x = kUnset;           // left end [m]; unset: along the whole wall
  double width = kUnset;       // [m]
  double load = kUnset;        // vertical line load, downwards [N/m]
  std::vector<double> joists;  // x of point loads that share load * width [m]; empty: a line
  double bearing = kUnset;     // depth of the bearing, from the inner face [m]
  double thrust = 0;           // horizontal force of a roof on the wall, +x to the right [N]
  double mass = 0;             // additional mass, inertia alone [kg/m]
  PlaceSpec from, to;          // in space: ends of its line, in place of y, x, width
  std::vector<std::string> origin = {};  // sources of load and mass that were not given
};

// A tie: a bar that resists tension only, between two points of the wall or from one to a rigid anchor.
struct TieSpec {
  std::string name;
  PlaceSpec from, to;
  bool anchored = false;                // `to` is a fixed point
  double area = kUnset;                 // of its section [m^2]
  double youngs_modulus = kUnset;       // [Pa]
  double yield_strength = kUnlimited;   // [Pa]
  double anchor_strength = kUnlimited;  // force at which an anchor yields [N]
  double prestress = 0;                 // [Pa]
};

// How a floor connects its points.
enum class DiaphragmKind { kElastic, kRigid };
inline constexpr Word<DiaphragmKind> kDiaphragmKindWords[] = {{"elastic", DiaphragmKind::kElastic},
                                                              {"rigid", DiaphragmKind::kRigid}};
struct DiaphragmSpec {
  std::string name;
  DiaphragmKind kind = DiaphragmKind::kElastic;
  std::string storey;         // at whose top it lies
  double y = kUnset;          // or its height above the wall's base [m]
  std::vector<double> x;      // of the connected points [m], at least two
  std::vector<double> z;      // in space: theirs too [m]
  double stiffness = kUnset;  // axial stiffness E A of its acting strip [N]; elastic
};

// A transverse wall or a neighbour: a spring to the ground at one point, with limits.
struct SpringSpec {
  std::string name;
  PlaceSpec at;
  Direction direction = Direction::kPlusX;  // along which the point is held, both ways
  double stiffness = kUnset;                // [N/m]
  double strength = kUnlimited;             // [N], plastic beyond
  bool pushes_only = false;                 // no force for displacements away from it: a gap opens
};

// Rigid beam on the whole wall top, for tests that load through one.
struct BeamSpec {
  double height = kUnset;  // [m]; unset: no beam
  double density = 0;      // [kg/m^3]
  Freedom rotation = Freedom::kFree;
  std::string joint = "joint";  // joint material between beam and masonry
};

// A step of the foundation: from x to the next step the ground is at height y.
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
  std::string up;      // of a file in space: axis that points up, "y" or "z"; "": by its format
  std::vector<std::string> supports;  // fixed blocks of such a file, by id; * at the end
  UnitSpec unit;
  std::vector<OpeningSpec> opening;
  BeamSpec beam;
  MasonryJoints joints = {};
  std::vector<FoundationStep> foundation = {};  // from left to right; empty: level ground at 0
};

// For blocks files: the joint material between two block materials ("ground" is the support).
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

// How blocks share the force of a push (docs/theory/integration.md, "The pattern of a push").
// kArea, in space only: by the free faces towards the push, as a pressure on them would be shared.
enum class Pattern { kNone, kGiven, kMassHeight, kUniform, kMass, kArea };
inline constexpr Word<Pattern> kPatternWords[] = {{"given", Pattern::kGiven},
                                                  {"mass_height", Pattern::kMassHeight},
                                                  {"uniform", Pattern::kUniform},
                                                  {"mass", Pattern::kMass},
                                                  {"area", Pattern::kArea}};

// Unit of a record's numbers.
enum class RecordUnit { kNone, kGravity, kMetres, kCentimetres };
inline constexpr Word<RecordUnit> kRecordUnitWords[] = {{"g", RecordUnit::kGravity},
                                                        {"m/s2", RecordUnit::kMetres},
                                                        {"cm/s2", RecordUnit::kCentimetres}};
enum class PulseShape { kNone, kHalfCycle, kCycle, kRicker };
inline constexpr Word<PulseShape> kPulseShapeWords[] = {{"half_cycle", PulseShape::kHalfCycle},
                                                        {"cycle", PulseShape::kCycle},
                                                        {"ricker", PulseShape::kRicker}};

// One component of an earthquake: an acceleration over time, from a file, from lists, or of a pulse
// (docs/theory/dynamics.md).
struct RecordSpec {
  std::string file;    // of any format of records, relative to the model file
  std::string column;  // of a CSV: header or number; ""; the second or only column
  RecordUnit unit = RecordUnit::kNone;
  double step = kUnset;               // of numbers without times [s]
  std::vector<double> times;          // [s]
  std::vector<double> accelerations;  // in `unit`
  PulseShape pulse = PulseShape::kNone;
  double amplitude = kUnset;  // of a pulse [m/s^2]
  double period = kUnset;     // of a pulse [s]
  Direction direction = Direction::kPlusX;
  PlaceSpec at;      // supports or blocks with this motion; unset: the base
  std::string hash;  // of a file's numbers, written by a run; "": not compared
  std::vector<double> read_times, read_accelerations;  // read from the file [s], [m/s^2]; not keys
};

// Scale of a shake, one factor for all components: as given, or so that the first component gets a stated peak or spectral
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

// A point whose motion is recorded over time.
struct HistorySpec {
  std::string name;
  PlaceSpec at;
};

// Velocities of a push that states none [m/s]: the first where the wall cracks, the second while it is near balance
// (docs/theory/integration.md).
inline constexpr double kWaitingVelocity = 0.1e-3, kAdaptedVelocity = 5e-3;

// Direction in which a push, a body force or a tilt drives the wall.
struct DriveSpec {
  Direction direction = Direction::kPlusX;
  std::vector<double> along = {};  // in space: any direction, in place of `direction`
};

// Whether driven blocks may turn, and move across their drive.
struct FixitySpec {
  Freedom rotation = Freedom::kFree;
  Freedom across = Freedom::kFree;
};

// The actions of stages follow, one record for each StageKind and in its order.

// The weight of the wall, and of floors that no load stage sets.
struct GravityStage {};

// A dead load: one of the loads, or all floors.
struct LoadStage {
  double pier_load = kUnset;     // on the top of each pier [N]
  double pressure = kUnset;      // on the whole wall top [Pa]
  double beam_load = kUnset;     // on the beam's centre [N]
  bool floors = false;           // applies every [[floor]]; without such a stage gravity does
  Manner as = Manner::kDefault;  // kPressure or kPlate
  std::string plate_joint = "foundation";  // joint material under a plate
  PlaceSpec on = {};                       // in space: blocks under the pressure; unset: all
  std::string face = {};      // in space: direction of those faces, a word of Direction; "": up
  double force = kUnset;      // in space: load at the point `at` [N]
  PlaceSpec at = {};          // of that force
  double line_load = kUnset;  // in space: load along the line `from` - `to` [N/m]
  PlaceSpec from = {}, to = {};
  std::vector<double> along = {};  // direction of force and line load; empty: downwards
};

// A push moves blocks with a given velocity, one way or to and fro (docs/theory/integration.md).
struct PushStage {
  PlaceSpec at = {};                 // the pushed blocks
  Manner as = Manner::kDefault;      // kSpreader or kEach
  Pattern pattern = Pattern::kNone;  // forces at several levels, in place of `at`
  std::vector<double> levels = {};   // their heights [m]
  std::vector<double> shares = {};   // kGiven: of the force, one a level
  PlaceSpec on = {};                 // in space: blocks that a pattern drives; unset: all
  PlaceSpec control = {};            // its displacement is controlled; unset: the driven mean
  // Height of the zero of the push's moment above the wall's foot, over the height of the wall: the push acts along that
  // line; unset: through the centroids of the pushed blocks.
  double contraflexure = kUnset;
  DriveSpec drive = {};
  FixitySpec fixity = {};
  double velocity = kUnset;          // [m/s]
  double fast_velocity = kUnset;     // while the wall is near balance [m/s]; unset: one velocity
  double fast_below = 1e-4;          // unbalance ratio below which the wall is near balance
  double until = kUnset;             // displacement at its end [m]
  std::vector<double> targets = {};  // cyclic: displacements along the drive, in turn [m]
  // cyclic, by a protocol (model/protocol.h): amplitude of each level as a length or a drift, and number of its cycles
  std::vector<double> amplitudes = {};  // [m]
  std::vector<double> drifts = {};      // over the height that the rows' drift uses [-]
  std::vector<double> cycles = {};  // one number for all levels, or one for each; empty: one cycle
  double stop_below = 0;            // share of the peak: stop when the reaction stays below it
};

// A horizontal force lambda W_i on every block grows at `rate` up to `factor`.
struct BodyForceStage {
  DriveSpec drive = {};
  double rate = kUnset;    // [1/s]
  double factor = kUnset;  // largest lambda
};

// The ground tilts.
struct TiltStage {
  DriveSpec drive = {};
  double tilt_rate = kUnset;   // [rad/s]
  double tilt_until = kUnset;  // [rad]
};

// Loads stay, and pushed blocks keep their place.
struct HoldStage {
  double duration = kUnset;  // [s]
  bool release = false;      // releases what a previous push holds
};

// An earthquake: motion of the base, or of some blocks against it (docs/theory/dynamics.md).
struct ShakeStage {
  std::vector<RecordSpec> record = {};
  ScaleSpec scale = {};
  FixitySpec fixity = {};          // of blocks that have a record of their own
  double free_vibration = 0;       // after the record [s]
  double interval = kUnset;        // between rows of the history [s]
  ViscousSpec mass_damping = {};   // on the velocity relative to the base
  ViscousSpec joint_damping = {};  // of closed points, proportional to their stiffness
  double restitution = kUnset;     // of a block that falls flat on another; unset: elastic
  // Of closed contacts, largest at its frequency: a spring and a dashpot in series, parallel to the contact.
  ViscousSpec maxwell_damping = {};
};

// Takes the masonry out of the openings that name the stage, and puts up their frames.
struct CutStage {};

using StageAction = std::variant<GravityStage, LoadStage, PushStage, BodyForceStage, TiltStage,
                                 HoldStage, ShakeStage, CutStage>;
template <StageKind kind>
using ActionOf = std::variant_alternative_t<static_cast<std::size_t>(kind), StageAction>;
static_assert(std::variant_size_v<StageAction> == std::size(kStageKindWords));
static_assert(std::is_same_v<ActionOf<StageKind::kGravity>, GravityStage>);
static_assert(std::is_same_v<ActionOf<StageKind::kLoad>, LoadStage>);
static_assert(std::is_same_v<ActionOf<StageKind::kPush>, PushStage>);
static_assert(std::is_same_v<ActionOf<StageKind::kBodyForce>, BodyForceStage>);
static_assert(std::is_same_v<ActionOf<StageKind::kTilt>, TiltStage>);
static_assert(std::is_same_v<ActionOf<StageKind::kHold>, HoldStage>);
static_assert(std::is_same_v<ActionOf<StageKind::kShake>, ShakeStage>);
static_assert(std::is_same_v<ActionOf<StageKind::kCut>, CutStage>);

// One phase of the test.
struct StageSpec {
  std::string name = {};
  double ramp = kUnset;     // duration of the smooth start [s]; unset: documented default
  double damping = kUnset;  // local damping of this stage; unset: solve.damping
  StageAction action = {};

  [[nodiscard]] StageKind kind() const { return static_cast<StageKind>(action.index()); }
  // The action of a stage of this kind; throws std::bad_variant_access for another.
  template <class Kind>
  [[nodiscard]] const Kind& get() const {
    return std::get<Kind>(action);
  }
  template <class Kind>
  [[nodiscard]] Kind& get() {
    return std::get<Kind>(action);
  }
};

// Direction in which a stage drives the wall; +x for one that does not.
[[nodiscard]] inline DriveSpec drive_of(const StageSpec& stage) {
  if (const auto* push = std::get_if<PushStage>(&stage.action)) return push->drive;
  if (const auto* force = std::get_if<BodyForceStage>(&stage.action)) return force->drive;
  if (const auto* tilt = std::get_if<TiltStage>(&stage.action)) return tilt->drive;
  return {};
}
// How a stage guides the blocks that it drives.
[[nodiscard]] inline FixitySpec fixity_of(const StageSpec& stage) {
  if (const auto* push = std::get_if<PushStage>(&stage.action)) return push->fixity;
  if (const auto* shake = std::get_if<ShakeStage>(&stage.action)) return shake->fixity;
  return {};
}
// The records of a shake; none of any other stage.
[[nodiscard]] inline std::span<RecordSpec> records_of(StageSpec& stage) {
  auto* shake = std::get_if<ShakeStage>(&stage.action);
  return shake != nullptr ? std::span(shake->record) : std::span<RecordSpec>();
}
[[nodiscard]] inline std::span<const RecordSpec> records_of(const StageSpec& stage) {
  const auto* shake = std::get_if<ShakeStage>(&stage.action);
  return shake != nullptr ? std::span(shake->record) : std::span<const RecordSpec>();
}

// Positions of a face's contact points and their shares of its area (model/quadrature.h).
enum class PointRule { kDefault, kCorners, kTrapezoid, kLobatto, kGauss };
inline constexpr Word<PointRule> kPointRuleWords[] = {{"corners", PointRule::kCorners},
                                                      {"trapezoid", PointRule::kTrapezoid},
                                                      {"lobatto", PointRule::kLobatto},
                                                      {"gauss", PointRule::kGauss}};

// Local damping in space: of each component in the axes of the wall, as in the paper; or of force and moment as
// vectors, which does not depend on axes (docs/theory/space.md).
enum class DampingForm { kVector, kComponents };
inline constexpr Word<DampingForm> kDampingFormWords[] = {{"vector", DampingForm::kVector},
                                                          {"components", DampingForm::kComponents}};

struct SolveSpec {
  PointRule point_rule = PointRule::kDefault;
  int points_per_face = 0;                          // 0: by the rule; without both: lobatto, 3
  double step_fraction = 0.95;                      // of the largest stable step, damping included
  double damping = 0.8;                             // local damping
  DampingForm damping_form = DampingForm::kVector;  // in space alone
  double gravity = 9.81;                            // [m/s^2]
  double settle_ratio = 1e-5;             // unbalance ratio below which a stage has settled
  double settle_limit = 20;               // longest time for settling [s]
  double mass_scaling = 1;                // density scaling of the gravity and load stages
  bool raise_light_inertia = true;        // of lintels, plates, beams that would shorten the step
  double collapse_displacement = kUnset;  // [m]; unset: the smallest block height; unlimited
                                          // with free contacts
  Contacts contacts = Contacts::kJoints;
  double ground = kUnset;  // height of level ground for falling blocks, with free contacts [m]
};

// Headings and the engineer responsible, for the printed sheet.
struct ProjectSpec {
  std::string title, client, author, date, place;
};

// The demand of an earthquake as a spectrum: by the parameters of a code, or as a table.
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
// Spectra of single limit states; one that is missing is AssessmentSpec::spectrum.
struct SpectraSpec {
  SpectrumSpec operational, damage_limitation, life_safety, near_collapse;
};
// What holds a part of a wall at one height: a through-tie or an anchored floor.
struct HoldSpec {
  std::string name;
  double height = kUnset;  // above the wall's base [m]
  double force = kUnset;   // largest holding force [N]
  double travel = kUnset;  // displacement at which it fails [m]; unset: not known
};
// Toothing of a part with transverse walls: units of both lie on each other, course by course.
struct TeethSpec {
  int corners = 0;           // number of transverse walls
  double length = kUnset;    // of the teeth along the part: thickness of a transverse wall [m]
  double course = kUnset;    // height between sliding faces [m]
  double friction = kUnset;  // tangent of the angle [-]
};
enum class Fall { kOutwards, kInwards };
inline constexpr Word<Fall> kFallWords[] = {{"outwards", Fall::kOutwards},
                                            {"inwards", Fall::kInwards}};
// A part of a wall that may fall out of plane: one rigid strip that rotates about a line at its foot. Where its head is
// held, there are two strips with a further line between them (docs/theory/local_mechanisms.md).
struct PartSpec {
  std::string name;
  double foot = kUnset, head = kUnset;   // above the wall's base [m]
  double left = kUnset, right = kUnset;  // ends along the wall [m]
  Fall falls = Fall::kOutwards;
  bool head_held = false;
  double lean = 0;          // initial inclination towards the fall [rad]
  double inset = kUnset;    // rotation line from the face [m]; unset: by crushing
  double bearing = kUnset;  // depth of its floors' bearings [m]; unset: their own
  std::vector<HoldSpec> hold;
  TeethSpec teeth;
};
// The building of a part, for the spectrum at its height.
struct BuildingSpec {
  double base = 0;         // height of the wall's foot in it [m]
  double height = kUnset;  // [m]; unset: of the wall, above the building's foot
  double period = kUnset;  // T1 [s]; unset: by its height
  int storeys = 0;         // 0: those of the model
};
// What a run or campaign is asked besides its curve (docs/theory/assessment.md).
struct AssessmentSpec {
  std::string code;       // "": none; circolare_2019, en1998_3
  SpectrumSpec spectrum;  // for `limit_state`
  SpectraSpec spectra;    // for other limit states, or in its place
  std::string limit_state = "life_safety";
  double confidence_factor = kUnset;  // of the knowledge level; unset: 1, with a caution
  double masonry_share = 1;           // share of the building's mass and force for this wall
  double added_mass = 0;              // in an earthquake, beside blocks and loads [kg]
  double added_height = kUnset;       // height of that mass [m]; unset: at the control point
  double record_scatter = kUnset;     // beta of records, for fragility [-]
  BuildingSpec building;
  std::vector<PartSpec> part;  // that may fall out of the wall's plane
};

struct OutputSpec {
  int rows = 500;                   // rows of force_displacement.csv
  double window = kUnset;           // averaging window of the reaction [m]; unset: one row
  std::vector<double> states = {};  // displacements at which a state is written [m]
};

// One block of a blocks file as read by src/io: a simple polygon of either orientation.
struct BlockSpec {
  std::string id;
  std::vector<std::array<double, 2>> polygon;  // [m]
  std::string material = "masonry";  // names a material with a density, else wall.unit.density
  bool fixed = false;                // a fixed support
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
  MasonrySpec masonry;  // inputs of material rules
  std::map<std::string, JointMaterial> material;
  std::map<std::string, FieldSpec> field;  // variation within the wall (study.h, draw_fields)
  // Whether a field is drawn, rather than following others by its formula.
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
  std::vector<BlockSpec> block;           // content of the file wall.blocks; not a key
  std::vector<BodySpec> body;             // the same in space; not a key
  std::vector<Message> built;             // what the builder in space noted; not a key
  std::vector<UnitSpec> built_unit = {};  // of its walls, one each; not a key
  std::string folder;                     // folder of the model file, for relative paths; not a key
  std::shared_ptr<const KeyPlaces> places =
      {};                                // of a spec that was read, as it was then; not a key
  std::vector<Message> text_notes = {};  // of reading, for the model's notes; not a key
};

}  // namespace wythe
