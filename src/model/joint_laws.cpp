// A name without a material is a fault in space, where rules name them. In the plane the assembly has checked all names.
#include "model/joint_laws.h"

#include <fmt/core.h>

#include "contact/parameters.h"

namespace wythe {

int JointLaws::index_of(const std::string& name, bool shares_bed) {
  const auto known = index_.find({name, shares_bed});
  if (known != index_.end()) return known->second;
  if (shares_bed) return index_[{name, true}] = head_index(name, index_of(name));
  const auto stated = spec_.material.find(name);
  if (stated == spec_.material.end()) {
    faults_.add({"", "material." + name, "", "is missing; joints of the wall are made of it",
                 fmt::format("add [material.{}], or name another in [[contact]]", name), 0});
    return index_[{name, false}] = append(name, {});
  }
  const JointMaterial& law = stated->second;
  for (const MaterialFault& fault : contact::missing_as_one(check_joint_material(law))) {
    bad_.insert(name);
    faults_.add({"", "material." + name + (fault.key.empty() ? "" : "." + fault.key), fault.value,
                 fault.problem, fault.cure, 0});
  }
  if (!in_space_ && law.tensile_strength == 0 && law.cohesion > 0)
    model_.anatomy.notes.push_back({"material.cohesion_lost", {{"material", name}}});
  return index_[{name, false}] = append(name, law);
}

int JointLaws::index_of(const std::string& name, bool shares_bed, int number, const Vec3& centre,
                        const FieldValues& fields) {
  const int stated = index_of(name, shares_bed);
  if (!fields.act_on(name)) return stated;
  JointMaterial own = fields.of_face(number, model_.materials[index_of(name)]);
  if (!bad_.contains(name))
    for (const MaterialFault& fault : check_joint_material(own))
      ++drawn_.try_emplace("material." + name + "." + fault.key, Drawn{fault, centre})
            .first->second.joints;
  if (shares_bed && own.head_joint_bond < 1) own = contact::head_joint_law(own);
  const int index = append(name, own);
  model_.stated_material.back() = stated;
  return index;
}

int JointLaws::derived(const std::string& name, const JointMaterial& law) {
  const auto known = index_.find({name, false});
  if (known != index_.end()) return known->second;
  return index_[{name, false}] = append(name, law);
}

void JointLaws::report_drawn() {
  for (const auto& [path, drawn] : drawn_)
    faults_.add(
        {"", path, drawn.first.value,
         fmt::format("at the joint at x = {:.3f} m, y = {:.3f} m{}{}: {}", drawn.centre.x,
                     drawn.centre.y, in_space_ ? fmt::format(", z = {:.3f} m", drawn.centre.z) : "",
                     drawn.joints > 1 ? fmt::format(" (and at {} more)", drawn.joints - 1) : "",
                     drawn.first.problem),
         "give the field a smaller cov or cut it off by lower and upper, or let what must "
         "keep step follow it by a formula ([field.NAME] formula)",
         0});
}

int JointLaws::append(const std::string& name, const JointMaterial& law) {
  const auto index = static_cast<int>(model_.materials.size());
  model_.materials.push_back(law);
  model_.material_names.push_back(name);
  if (!spec_.field.empty()) model_.stated_material.push_back(index);
  return index;
}

int JointLaws::head_index(const std::string& name, int bed) {
  const JointMaterial law = model_.materials[bed];
  if (!(law.head_joint_bond < 1)) return bed;
  model_.anatomy.notes.push_back(head_bond_note(name, law));
  return append(name, contact::head_joint_law(law));
}

}  // namespace wythe
