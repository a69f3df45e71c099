// The steps of compile(): each fills its group of Model's arrays from the assembly.
#pragma once

#include <algorithm>
#include <iterator>

#include "geometry/assembly.h"
#include "wythe/parts/error.h"
#include "wythe/parts/model.h"

namespace wythe::geometry {
struct Section;
struct FrameSections;
}  // namespace wythe::geometry

namespace wythe {

// Number of each assembly block among the moving rigid blocks; kGroundBlock for supports, solid_id()
// for deformable ones.
using BlockMap = std::vector<BlockId>;
[[nodiscard]] constexpr BlockId solid_id(int body) { return -2 - body; }
[[nodiscard]] constexpr bool is_solid(BlockId block) { return block < kGroundBlock; }
[[nodiscard]] constexpr int solid_of(BlockId block) { return -2 - block; }

// Whether a place says anything. One that does may still name every block.
[[nodiscard]] inline bool is_stated(const PlaceSpec& p) {
  const double numbers[] = {p.x, p.y, p.z, p.width, p.height, p.depth};
  return std::any_of(std::begin(numbers), std::end(numbers), [](double v) { return is_set(v); }) ||
         !p.block.empty() || p.beam || !p.role.empty();
}

// A note on head joints with less than the full bond of their beds.
[[nodiscard]] Message head_bond_note(const std::string& name, const JointMaterial& bed);

class FieldValues;  // field_places.h

// A face of a deformable block, and its joint material.
struct SolidFace {
  const geometry::Face* face;
  int material;
};

// compiles mass, inertia, centroids, outlines and names.
[[nodiscard]] BlockMap compile_blocks(const ModelSpec& spec, const geometry::Assembly& assembly,
                                      const FieldValues& fields, Model& model, FaultList& faults);
// compiles joints, points, gather lists and their materials; chains get their beam stiffness.
void compile_joints(const ModelSpec& spec, const geometry::Assembly& assembly, const BlockMap& map,
                    const FieldValues& fields, Model& model, FaultList& faults);
// Fills Model::block_begin and block_entry from the sides of the joints, in the plane and in space.
void list_joints_of_blocks(Model& model);
// compiles nodes and zones of deformable blocks.
void compile_solids(const ModelSpec& spec, const geometry::Assembly& assembly, Model& model,
                    FaultList& faults);
// compiles faces of deformable blocks; compile_joints calls it, since it finds their materials.
void compile_contacts(const geometry::Assembly& assembly, const BlockMap& map,
                      std::vector<SolidFace> faces, Model& model, FaultList& faults);
// Top of a storey as laid [m]; NaN with a fault where no storey has the name.
[[nodiscard]] double top_of_storey(const geometry::Assembly& assembly, const std::string& name,
                                   const std::string& path, FaultList& faults);
// loads of floors on blocks, for the stage that applies them; also adds their inertia to the blocks.
[[nodiscard]] std::vector<PointLoad> compile_floors(const ModelSpec& spec,
                                                    const geometry::Assembly& assembly,
                                                    const BlockMap& map, Model& model,
                                                    FaultList& faults);
// shapes for free contacts, where the model requests them; needs blocks and joints.
void compile_free(const ModelSpec& spec, const geometry::Assembly& assembly, Model& model,
                  FaultList& faults);
// The mortar of a layer over one joint of the masonry, and its mass on the units; needs blocks.
struct Coat {
  geometry::Face face;
  double thickness;  // of all coated faces together [m]
  JointMaterial law;
  std::string name;  // of the material
};
// Whether a layer may cover a block: masonry, lintels, sills and ring beams that stand from the first stage on.
[[nodiscard]] bool holds_layers(const ModelSpec& spec, const geometry::Block& block);
[[nodiscard]] std::vector<Coat> compile_coats(const ModelSpec& spec,
                                              const geometry::Assembly& assembly,
                                              const BlockMap& map, Model& model, FaultList& faults);
// Data of a future row of Links; arms and span as there.
struct NewLink {
  std::string name;
  LinkKind kind;
  BlockId a, b;
  Vec3 arm_a, arm_b, span;
  bool follows;
  double stiffness, tension = kUnlimited, compression = kUnlimited;  // [N/m], [N]
  double jack = 0;                                                   // [N]
};
void add_link(Links& links, const NewLink& link);
// compiles ties, diaphragms and springs.
void compile_links(const ModelSpec& spec, const geometry::Assembly& assembly, const BlockMap& map,
                   Model& model, FaultList& faults);
// --- frames, in the plane and in space
struct FrameSteel {
  double yield = kUnset, youngs = kUnset, shear = kUnset;  // [Pa]
};
// Faults stand at the frame's `path`.
[[nodiscard]] FrameSteel frame_steel(const FrameSpec& frame, const std::string& path,
                                     FaultList& faults);
void check_frame_gap(const ModelSpec& spec, const FrameSpec& frame, const std::string& path,
                     FaultList& faults);
// Section of a member: an upright one is a column.
[[nodiscard]] const geometry::Section& section_of(const geometry::FramePart& part,
                                                  const geometry::FrameSections& sections);
// The frame's name and members; the number of the first one.
std::int32_t add_members(const geometry::PlacedFrame& placed,
                         const geometry::FrameSections& sections, const FrameSteel& steel,
                         Frames& frames);
// What a section has in the frame's plane, its fibres and its place, and counts it; `first`: of add_members().
void add_fibres(const geometry::FrameJoint& joint, std::int32_t first, const FrameSteel& steel,
                Frames& frames);
void note_frame(const geometry::PlacedFrame& placed, const FrameSpec& frame, Model& model);
// compiles sections between segments of frames.
void compile_frames(const ModelSpec& spec, const geometry::Assembly& assembly, const BlockMap& map,
                    Model& model, FaultList& faults);
// which blocks stand in which stage, where stages cut openings and install frames; needs frames.
void compile_standing(const ModelSpec& spec, const geometry::Assembly& assembly,
                      const BlockMap& map, Model& model, FaultList& faults);
// Notes stages of kind cut that are not among `used`.
void note_idle_cuts(const ModelSpec& spec, const std::vector<int>& used, Model& model);
// refuses loads, ties and pushes on masonry that a stage cuts out.
void check_standing(const Model& model, FaultList& faults);
// compiles strands of layers: nodes on blocks, and where they cross joints; needs joints.
void compile_layers(const ModelSpec& spec, const geometry::Assembly& assembly, const BlockMap& map,
                    Model& model, FaultList& faults);
// Index of the stage that applies floors: the load stage that requests them, else the first gravity stage; the number of stages: none.
[[nodiscard]] std::size_t stage_of_floors(const ModelSpec& spec, FaultList& faults);
// compiles stages with their loads and driven blocks.
void compile_stages(const ModelSpec& spec, const geometry::Assembly& assembly, const BlockMap& map,
                    const std::vector<PointLoad>& floors, Model& model, FaultList& faults);

// Sets the targets of a push by a protocol, once the height of its drifts is known; `path` is that of the stage.
void set_targets(const std::string& path, PushStage& push, const Stage& stage, FaultList& faults);
// Fills in how a load or a push acts where its spec does not say so.
void set_manner(StageSpec& stage);

// First period of the elastic wall along (px, py) [s], with all contacts closed; NaN where it has none.
[[nodiscard]] double first_period(const Model& model, double px, double py);
// Sets the default smooth start of each push from that period; needs masses and joints.
void set_push_ramps(Model& model);

// Joint between two rigid segments of a beam whose centres are `spacing` apart [m], with structural
// depth `depth` in a face `face` long [m]: kn = E/l d/face, ks = 5/6 G/l d/face, no strength limit.
// With the points at half_scale (below) a chain of such joints has the beam's EI, EA and GA.
[[nodiscard]] JointMaterial chain_material(const JointMaterial& body, double spacing, double depth,
                                           double face);
// Factor on the half face vector that gives the points the second moment of a full section:
// sum weight (xi e)^2 = depth^2/12.
[[nodiscard]] double chain_half_scale(const Model& model, double depth, double face);

}  // namespace wythe
