// Where a field (wythe/parts/field.h) acts: its key, and its joints or blocks in the assembly; and how it
// changes their material. draw_fields() uses the places; compile() applies the drawn values.
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

// A key that a field may vary.
struct FieldKey {
  const char* name;
  double JointMaterial::*value;
  const char *si_unit, *shown;
};
[[nodiscard]] std::span<const FieldKey> field_keys();

// The target of a path: a key of a joint material, or a density (of a material, or of units where
// `material` is empty).
struct FieldTarget {
  std::string material;
  const FieldKey* key = nullptr;
  [[nodiscard]] bool is_density() const { return key->value == &JointMaterial::density; }
};
[[nodiscard]] std::optional<FieldTarget> field_target(const std::string& path);
// The value in the model file, which is the mean of the field [SI].
[[nodiscard]] double mean_of(const ModelSpec& spec, const FieldTarget& target);

struct FieldPlace {
  int entity = 0;       // face, or block for a density
  double x = 0, y = 0;  // its centre [m]
  int course = -1;      // of a joint: that of the block above or right of it
  int unit = -1;        // numbered over the wall
  double z = 0;         // in space
};
[[nodiscard]] std::vector<FieldPlace> field_places(const ModelSpec& spec,
                                                   const geometry::Assembly& assembly,
                                                   const FieldTarget& target);
// In space the units of a course have one number and feet at one height, by the builder's names. A joint belongs to its upper
// block; a vertical joint to the block on the side of +x, else of +z.
[[nodiscard]] std::vector<FieldPlace> field_places(const ModelSpec& spec,
                                                   const geometry::SpaceAssembly& assembly,
                                                   const FieldTarget& target);

// Drawn values by face and block. Adds a fault for a field that was drawn for another wall, or not at all.
class FieldValues {
 public:
  FieldValues(const ModelSpec& spec, const geometry::Assembly& assembly, FaultList& faults);
  FieldValues(const ModelSpec& spec, const geometry::SpaceAssembly& assembly, FaultList& faults);
  [[nodiscard]] bool act_on(const std::string& material) const;
  // The material of face `face`, derived from the stated one.
  [[nodiscard]] JointMaterial of_face(int face, const JointMaterial& stated) const;
  // The density of block `block`, derived from the stated one [kg/m^3].
  [[nodiscard]] double density_of(int block, double stated) const;
  // Writes the values of each field into model.anatomy.
  void describe(const ModelSpec& spec, const geometry::Assembly& assembly, const BlockMap& map,
                Model& model) const;
  void describe(const ModelSpec& spec, const geometry::SpaceAssembly& assembly, const BlockMap& map,
                Model& model) const;

 private:
  struct Item {
    FieldTarget target;
    bool is_factor = true;
    std::vector<double> value;  // for each face or block; NaN where the field does not act
  };
  template <class Assembly>
  void take(const ModelSpec& spec, const Assembly& assembly, std::size_t blocks, FaultList& faults);
  // `density` gives the density of a block as the model states it.
  template <class Density>
  void put_into(const ModelSpec& spec, const BlockMap& map, const Density& density,
                Model& model) const;
  static double put(const Item& item, int entity, double stated);
  std::vector<Item> items_;
};

}  // namespace wythe
