// Where a field (wythe/parts/field.h) acts: on which key, at which joints or blocks of the assembly, and what it
// makes of their material. draw_fields() asks for the places; compile() puts in what was drawn.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "geometry/assembly.h"
#include "geometry/bodies/joint_faces.h"
#include "model/parts.h"
#include "wythe/parts/model.h"

namespace wythe {

// A number that may vary within a wall.
struct FieldKey {
  const char* name;
  double JointMaterial::*value;
  const char *si_unit, *shown;
};
[[nodiscard]] std::span<const FieldKey> field_keys();

// What a path names: a key of a joint material, or a density of blocks (of a material, or of the units where
// `material` is empty).
struct FieldTarget {
  std::string material;
  const FieldKey* key = nullptr;
  [[nodiscard]] bool is_density() const { return key->value == &JointMaterial::density; }
};
[[nodiscard]] std::optional<FieldTarget> field_target(const std::string& path);
// Its value in the model file, the mean of the field [SI].
[[nodiscard]] double mean_of(const ModelSpec& spec, const FieldTarget& target);

struct FieldPlace {
  int entity = 0;       // face, or block of a density
  double x = 0, y = 0;  // its centre [m]
  int course = -1;      // of a joint: that of the block above or right of it
  int unit = -1;        // numbered in the wall
  double z = 0;         // in space
};
[[nodiscard]] std::vector<FieldPlace> field_places(const ModelSpec& spec,
                                                   const geometry::Assembly& assembly,
                                                   const FieldTarget& target);
// In space: a course are the units of one number whose feet are at one height, as builders name them; a joint is its
// upper block's, of upright ones that on the side of +x, else of +z.
[[nodiscard]] std::vector<FieldPlace> field_places(const ModelSpec& spec,
                                                   const geometry::SpaceAssembly& assembly,
                                                   const FieldTarget& target);

// What was drawn, by face and block; adds a fault for a field that was drawn for another wall or not at all.
class FieldValues {
 public:
  FieldValues(const ModelSpec& spec, const geometry::Assembly& assembly, FaultList& faults);
  FieldValues(const ModelSpec& spec, const geometry::SpaceAssembly& assembly, FaultList& faults);
  [[nodiscard]] bool act_on(const std::string& material) const;
  // The material of face `face`, from the one as stated.
  [[nodiscard]] JointMaterial of_face(int face, const JointMaterial& stated) const;
  // The density of block `block`, from the one as stated [kg/m^3].
  [[nodiscard]] double density_of(int block, double stated) const;
  // Puts each field, as it stands in the model, into its anatomy.
  void describe(const ModelSpec& spec, const geometry::Assembly& assembly, const BlockMap& map,
                Model& model) const;
  void describe(const ModelSpec& spec, const geometry::SpaceAssembly& assembly, const BlockMap& map,
                Model& model) const;

 private:
  struct Item {
    FieldTarget target;
    bool is_factor = true;
    std::vector<double> value;  // of each face or block; NaN where the field does not act
  };
  template <class Assembly>
  void take(const ModelSpec& spec, const Assembly& assembly, std::size_t blocks, FaultList& faults);
  // `density` says what the model states of a block.
  template <class Density>
  void put_into(const ModelSpec& spec, const BlockMap& map, const Density& density,
                Model& model) const;
  static double put(const Item& item, int entity, double stated);
  std::vector<Item> items_;
};

}  // namespace wythe
