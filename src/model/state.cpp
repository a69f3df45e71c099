// The state: made from a model, and named by a hash of its bits.
#include "core/hash.h"
#include "wythe/model.h"

namespace wythe {

State initial_state(const Model& model) {
  State s;
  const auto nb = static_cast<std::size_t>(model.n_block);
  const auto np = static_cast<std::size_t>(model.n_history());
  for (auto* array : {&s.ux, &s.uy, &s.theta, &s.vx, &s.vy, &s.omega}) array->assign(nb, 0.0);
  for (auto* array :
       {&s.kappa, &s.crush, &s.plastic_slip, &s.slip, &s.shear_damage, &s.tension_set})
    array->assign(np, 0.0);
  for (auto* array : {&s.node_ux, &s.node_uy, &s.node_vx, &s.node_vy})
    array->assign(static_cast<std::size_t>(model.solids.n_node), 0.0);
  s.load_scale.assign(model.stages.size(), 0.0);
  return s;
}

std::string state_hash(const State& s) {
  Hash hash;
  for (const auto* array :
       {&s.ux, &s.uy, &s.theta, &s.vx, &s.vy, &s.omega, &s.kappa, &s.crush, &s.plastic_slip,
        &s.slip, &s.shear_damage, &s.tension_set, &s.node_ux, &s.node_uy, &s.node_vx, &s.node_vy})
    hash.add(*array);
  return hash.text();
}

}  // namespace wythe
