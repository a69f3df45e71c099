// The laws of joints while a model is filled, in the plane or in space: names of materials and their indices.
#pragma once

#include <map>
#include <set>
#include <string>
#include <utility>

#include "model/field_places.h"
#include "wythe/parts/error.h"
#include "wythe/parts/model.h"

namespace wythe {

// Each material is checked at its first use.
class JointLaws {
 public:
  JointLaws(const ModelSpec& spec, Model& model, FaultList& faults, bool in_space)
      : spec_(spec), model_(model), faults_(faults), in_space_(in_space) {}

  [[nodiscard]] int index_of(const std::string& name, bool shares_bed = false);
  // Of face `number` with this centre: a law of its own where a field acts on it.
  [[nodiscard]] int index_of(const std::string& name, bool shares_bed, int number,
                             const Vec3& centre, const FieldValues& fields);
  // Of a law that is derived from the moduli of a body.
  [[nodiscard]] int derived(const std::string& name, const JointMaterial& law);
  // Reports values from fields that are inadmissible: for each key the first joint, and the number of others.
  void report_drawn();

 protected:
  int append(const std::string& name, const JointMaterial& law);

  const ModelSpec& spec_;
  Model& model_;
  FaultList& faults_;

 private:
  // Of head joints beside beds with the law `bed`.
  int head_index(const std::string& name, int bed);

  struct Drawn {
    MaterialFault first;
    Vec3 centre;  // of the first joint [m]
    int joints = 0;
  };
  bool in_space_;
  std::map<std::pair<std::string, bool>, int> index_;  // by name and whether it shares a bed's
  std::set<std::string> bad_;                          // inadmissible as stated
  std::map<std::string, Drawn> drawn_;                 // by path of a key
};

}  // namespace wythe
