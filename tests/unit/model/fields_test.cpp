// The table of fields gives every array to all code that copies, saves, hashes or
// compares it. A new line of the table is covered here without a line of its own.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>

#include "campaign/store/record_rows.h"
#include "contact/law.h"
#include "dynamics/executors/processor.h"
#include "model/fields.h"
#include "scenes/scenes.h"
#include "scenes/zones.h"
#include "wythe/parts/solve.h"
#include "wythe/parts/study.h"

namespace wythe::fields_test {
namespace {

// With a law that remembers all there is to remember, a link, and a frame.
ModelSpec capped_wall_with_zones() {
  ModelSpec spec = scenes::lintel_wall(LintelModel::kZones);
  for (auto& [name, material] : spec.material)
    if (std::isfinite(material.compressive_strength)) {
      material.compression_cap = 9;
      material.cohesion = std::fmin(material.cohesion, 0.2 * material.compressive_strength);
    }
  SpringSpec across;
  across.at.x = across.at.y = 0.05;
  across.stiffness = 1e6;
  spec.spring = {across};
  return scenes::framed(std::move(spec));
}

Model wall_with_zones() { return compile(capped_wall_with_zones()); }

// Whether a wall has it in space alone.
bool is_of_space(const StateField& field) {
  return field.entity == Entity::kBody || field.entity == Entity::kFacePoint ||
         field.entity == Entity::kSupport || field.entity == Entity::kSpaceNode ||
         field.entity == Entity::kFrameSetInSpace || field.entity == Entity::kReleaseInSpace;
}

// Whether a wall has it with free contacts, Maxwell elements or openings that a stage cuts alone.
bool is_of_free(const StateField& field) {
  return field.entity == Entity::kHandedOver || field.entity == Entity::kMaxwell ||
         field.entity == Entity::kMaxwellInSpace || field.entity == Entity::kFrameSet ||
         field.entity == Entity::kRelease;
}

// Every number of every array its own.
State all_different(const Model& model) {
  State state = initial_state(model);
  double next = 1e-9;
  for (const StateField& field : kStateFields)
    for (double& number : state.*field.array) number = next += 1e-9;
  return state;
}

TEST(Fields, each_array_of_a_state_is_named_once_and_as_long_as_its_entity) {
  const Model model = wall_with_zones();
  const State state = initial_state(model);
  for (const StateField& field : kStateFields) {
    EXPECT_EQ((state.*field.array).size(), count_of(model, field)) << field.name;
    const bool is_elsewhere =
        is_of_space(field) || is_of_free(field) || field.entity == Entity::kLayerNode;
    EXPECT_EQ(count_of(model, field) == 0, is_elsewhere) << field.name;
    EXPECT_EQ(count_of(model, field), count_of(model, field.entity)) << field.name;
    int same = 0;
    for (const StateField& other : kStateFields)
      same += other.array == field.array || other.name == field.name;
    EXPECT_EQ(same, 1) << field.name;
  }
}

TEST(Fields, the_history_of_the_law_has_its_arrays_in_the_same_order) {
  // History{1, 2, ...} member by member against the rows of the arrays
  contact::History<double> h{};
  for (std::size_t k = 0; k < contact::kHistory<double>.size(); ++k)
    h.*contact::kHistory<double>[k] = static_cast<double>(k);
  EXPECT_EQ(h.kappa, row_of(&State::kappa));
  EXPECT_EQ(h.crush, row_of(&State::crush));
  EXPECT_EQ(h.plastic_slip, row_of(&State::plastic_slip));
  EXPECT_EQ(h.slip, row_of(&State::slip));
  EXPECT_EQ(h.shear_damage, row_of(&State::shear_damage));
  EXPECT_EQ(h.tension_set, row_of(&State::tension_set));
  EXPECT_EQ(h.crush_path, row_of(&State::crush_path));
  EXPECT_EQ(sizeof h, contact::kHistory<double>.size() * sizeof(double));  // none forgotten
}

TEST(Fields, what_only_a_cap_remembers_is_empty_without_one) {
  const State state = initial_state(compile(scenes::lintel_wall(LintelModel::kZones)));
  EXPECT_TRUE(state.crush_path.empty());
  EXPECT_FALSE(state.tension_set.empty());
}

TEST(Fields, the_hash_sees_every_array) {
  const Model model = wall_with_zones();
  const State state = all_different(model);
  for (const StateField& field : kStateFields) {
    if (is_of_space(field)) continue;
    State other = state;
    if ((other.*field.array).empty())  // what no wall has at the start
      (other.*field.array).push_back(1);
    else
      (other.*field.array).back() += 1e-12;
    EXPECT_NE(state_hash(other), state_hash(state)) << field.name;
  }
}

TEST(Fields, a_wall_that_takes_a_lane_and_leaves_it_keeps_every_number) {
  ModelSpec spec = capped_wall_with_zones();
  for (auto& [name, material] : spec.material) {
    material.unloading = Unloading::kElastic;
    material.dilatancy_angle = 0.1 * material.residual_friction_angle;  // all remember all
  }
  const Model model = compile(spec);
  const State state = all_different(model);
  for (const int lanes : {1, 2, 4, 8})
    for (int lane = 0; lane < lanes; ++lane) {
      dynamics::Processor processor(model, lanes);
      State kept = state, back = initial_state(model);
      processor.load_wall(lane, model, kept);
      processor.access(lane)->store_state(back);
      for (const StateField& field : kStateFields)
        EXPECT_EQ(back.*field.array, state.*field.array)
            << field.name << ", lane " << lane << " of " << lanes;
      processor.unload_wall(lane);
    }
}

TEST(Fields, the_store_keeps_what_the_table_says) {
  const Model model = wall_with_zones();
  const State state = all_different(model);
  const State back = study::state_at_rest(study::state_arrays(state), initial_state(model));
  for (const StateField& field : kStateFields) {
    if (field.in_store)
      EXPECT_EQ(back.*field.array, state.*field.array) << field.name;
    else
      EXPECT_EQ(back.*field.array, std::vector<double>((state.*field.array).size(), 0.0))
          << field.name;
  }
}

// Changes the last number of an array; false where it is empty.
bool change(std::vector<double>& array) {
  if (!array.empty()) array.back() += 0.5;
  return !array.empty();
}
bool change(std::vector<std::int32_t>& array) {
  if (!array.empty()) array.back() += 1;
  return !array.empty();
}
bool change(std::vector<Vec3>& array) {
  if (!array.empty()) array.back().z += 0.5;
  return !array.empty();
}
bool change(std::vector<ZoneShape>& array) {
  if (!array.empty()) array.back().stiffness[7][7] += 1;
  return !array.empty();
}

TEST(Fields, a_topology_is_named_by_what_walls_share_and_by_nothing_else) {
  const Model model = wall_with_zones();
  ASSERT_EQ(model.topology, topology_of(model));
  Model other = model;
  int changed = 0;
  each_model_field(other, [&](auto& array, Entity, Shared shared, auto name, auto) {
    const auto before = array;
    if (change(array)) {
      ++changed;
      EXPECT_EQ(topology_of(other) != model.topology, shared == Shared::kTopology) << name;
    }
    array = before;
  });
  EXPECT_GT(changed, 40);
  other.materials.front().softening = Softening::kExponential;
  EXPECT_NE(topology_of(other), model.topology);
  other = model;
  other.materials.front().tensile_strength *= 2;
  EXPECT_EQ(topology_of(other), model.topology);
}

// Walls whose fields vary strengths alone keep the other numbers of the law once; so they and walls whose fields
// vary stiffness too cannot be stepped side by side. Each kind keeps its own numbers, joint by joint.
TEST(Fields, a_topology_tells_whether_fields_vary_more_than_strengths) {
  const auto model_with = [](bool stiffness) {
    ModelSpec spec = scenes::with_fields(scenes::plain_wall(6, 6, 1e-4, 0.02), 3);
    if (!stiffness) {
      spec.field.erase("kn");
      draw_fields(spec);
    }
    return compile(spec);
  };
  const Model strengths = model_with(false), both = model_with(true);
  EXPECT_NE(strengths.topology, both.topology);
  for (const auto& [model, varies] : {std::pair(&strengths, false), {&both, true}}) {
    int fields = 0;
    for (int i = 0; i < static_cast<int>(model->materials.size()); ++i)
      if (model->stated(i) == i && varies_beyond_strengths(*model, i)) ++fields;
    EXPECT_EQ(fields > 0, varies);
    Model apart = *model;  // as if each joint had been given a material of its own
    apart.stated_material.clear();
    State one = initial_state(*model), other = one;
    EXPECT_EQ(solve(*model, one, {}).state_hash, solve(apart, other, {}).state_hash);
  }
}

}  // namespace
}  // namespace wythe::fields_test
