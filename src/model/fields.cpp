// Functions derived from the table of fields: the initial state, the hash of a state, the identity of a topology.
#include "model/fields.h"

#include <type_traits>

#include "contact/parameters.h"
#include "core/hash.h"
#include "model/geometry.h"

namespace wythe {
namespace {

void add(Hash& hash, const std::vector<double>& numbers) { hash.add(numbers); }
void add(Hash& hash, const std::vector<std::int32_t>& ids) {
  hash.add(ids.data(), ids.size() * sizeof(std::int32_t));
}
void add(Hash& hash, const std::vector<ZoneShape>& shapes) {
  static_assert(std::is_trivially_copyable_v<ZoneShape> &&
                sizeof(ZoneShape) == (4 + 4 + 4 + 4 + 64 + 9 + 4 + 4) * sizeof(double));
  for (const ZoneShape& shape : shapes) {
    const auto* number = reinterpret_cast<const double*>(&shape);
    for (std::size_t k = 0; k < sizeof(ZoneShape) / sizeof(double); ++k) hash.add(number[k]);
  }
}

void add(Hash& hash, const std::vector<Vec3>& vectors) {
  for (const Vec3& v : vectors)
    for (const double number : {v.x, v.y, v.z}) hash.add(number);
}

}  // namespace

std::size_t count_of(const Model& model, const StateField& field) {
  if (field.array == &State::crush_path &&
      std::none_of(model.materials.begin(), model.materials.end(),
                   [](const JointMaterial& m) { return contact::choice_of(m).cap; }))
    return 0;
  return count_of(model, field.entity);
}

State initial_state(const Model& model) {
  State s;
  for (const StateField& field : kStateFields) (s.*field.array).assign(count_of(model, field), 0.0);
  std::fill(s.qw.begin(), s.qw.end(), 1.0);
  for (std::size_t k = 0; k < model.frames.moved.size(); ++k) {
    const std::size_t block = model.frames.moved[k];
    s.ux[block] = model.frames.moved_x[k];
    s.uy[block] = model.frames.moved_y[k];
    if (!model.frames.moved_z.empty()) s.uz[block] = model.frames.moved_z[k];
  }
  s.load_scale.assign(model.stages.size(), 0.0);
  return s;
}

std::string state_hash(const State& s) {
  Hash hash;
  for (const StateField& field : kStateFields) hash.add(s.*field.array);
  for (const FreeContact& c : s.free_contacts) {
    hash.add(&c, 5 * sizeof(std::int32_t));
    for (const double number : {c.rest, c.area, c.slip_x, c.slip_y, c.slip_z}) hash.add(number);
    if (c.maxwell_n != 0 || c.maxwell_x != 0 || c.maxwell_y != 0 || c.maxwell_z != 0)
      for (const double number : {c.maxwell_n, c.maxwell_x, c.maxwell_y, c.maxwell_z})
        hash.add(number);
  }
  for (const HandOver& h : s.hand_overs) {
    hash.add(&h, 2 * sizeof(std::int32_t));
    for (const double number :
         {h.share, h.pressed, h.force_x, h.force_y, h.force_z, h.moment_x, h.moment_y, h.moment_z})
      hash.add(number);
  }
  return hash.text();
}

bool varies_beyond_strengths(const Model& model, std::int32_t stated) {
  const auto base = contact::constants_of(model.materials[stated]);
  const auto differs = [&](std::int32_t other) {
    const auto law = contact::constants_of(model.materials[other]);
    return std::any_of(contact::kConstants<double>.begin() + contact::kStrengths,
                       contact::kConstants<double>.end(),
                       [&](auto number) { return law.*number != base.*number; });
  };
  for (std::int32_t i = 0; i < static_cast<std::int32_t>(model.stated_material.size()); ++i)
    if (i != stated && model.stated(i) == stated && differs(i)) return true;
  return false;
}

std::uint64_t topology_of(const Model& model) {
  Hash hash;
  for (const int count : {model.n_block, model.n_pair, model.n_face_point})
    hash.add(static_cast<double>(count));
  hash.add(static_cast<double>(model.stages.size()));
  for (const JointMaterial& m : model.materials) {
    const contact::LawChoice choice = contact::choice_of(m);
    for (const int word : {static_cast<int>(choice.softening), static_cast<int>(choice.coupling),
                           static_cast<int>(choice.unloading), static_cast<int>(choice.cap),
                           static_cast<int>(choice.rising)})
      hash.add(static_cast<double>(word));
  }
  if (geometry_of(model).dimension == 3)
    hash.add(static_cast<double>(static_cast<int>(model.solve.damping_form)));
  if (model.free.any()) hash.add(std::string_view("free contacts"));
  for (std::int32_t i = 0; i < static_cast<std::int32_t>(model.stated_material.size()); ++i)
    if (model.stated(i) == i) hash.add(varies_beyond_strengths(model, i) ? 1.0 : 0.0);
  each_model_field(model, [&](const auto& array, Entity, Shared shared, auto name, auto) {
    if (shared != Shared::kTopology) return;
    hash.add(std::string_view(name));
    hash.add(static_cast<double>(array.size()));
    add(hash, array);
  });
  return hash.value();
}

}  // namespace wythe
