// The wall as it stands in one stage, where stages cut openings (docs/theory/cutting.md). Blocks that are absent, their
// joints and their links are left out, and the others get new numbers.
#include "limit/standing.h"

#include <algorithm>

#include "limit/limit_loads.h"
#include "model/fields.h"
#include "model/parts.h"
#include "wythe/parts/reading.h"

namespace wythe::limit {
namespace {

// New number of each entity, or -1 where it is left out.
template <class Stays>
std::vector<int> numbered(int count, const Stays& stays) {
  std::vector<int> number(count, -1);
  int next = 0;
  for (int i = 0; i < count; ++i)
    if (stays(i)) number[i] = next++;
  return number;
}

int kept(const std::vector<int>& number) {
  return static_cast<int>(number.size() -
                          static_cast<std::size_t>(std::count(number.begin(), number.end(), -1)));
}

template <class T>
void keep(std::vector<T>& list, const std::vector<int>& number) {
  if (list.empty()) return;
  std::size_t next = 0;
  for (std::size_t i = 0; i < number.size(); ++i)
    if (number[i] >= 0) list[next++] = list[i];
  list.erase(list.begin() + static_cast<std::ptrdiff_t>(next),
             list.begin() + static_cast<std::ptrdiff_t>(number.size()));
}

// Moves values back to the places of the whole wall; absent entities have none.
void spread(std::vector<double>& list, const std::vector<int>& number) {
  if (list.empty()) return;
  std::vector<double> all(number.size(), 0.0);
  for (std::size_t i = 0; i < number.size(); ++i)
    if (number[i] >= 0) all[i] = list[number[i]];
  list = std::move(all);
}

void keep_outlines(const std::vector<int>& block, Anatomy& a) {
  std::vector<int> begin{0};
  std::vector<double> x, y;
  for (std::size_t i = 0; i < block.size(); ++i) {
    if (block[i] < 0) continue;
    for (int k = a.outline_begin[i]; k < a.outline_begin[i + 1]; ++k) {
      x.push_back(a.outline_x[k]);
      y.push_back(a.outline_y[k]);
    }
    begin.push_back(static_cast<int>(x.size()));
  }
  a.outline_begin = std::move(begin);
  a.outline_x = std::move(x);
  a.outline_y = std::move(y);
}

}  // namespace

StandingWall::StandingWall(const Model& whole) : model(whole) {
  const Stage* grows = growing_stage(whole);
  const int stage = grows == nullptr ? static_cast<int>(whole.stages.size())
                                     : static_cast<int>(grows - whole.stages.data());
  const Standing& standing = whole.standing;
  block_ = numbered(whole.n_block, [&](int i) { return standing.holds(i, stage); });
  joint_ = numbered(whole.n_joint, [&](int j) {
    return standing.joins(whole.joint_a[j], whole.joint_b[j], stage);
  });
  link_ = numbered(whole.links.n, [&](int k) {
    return standing.joins(whole.links.a[k], whole.links.b[k], stage);
  });
  for (JointId j = 0; j < whole.n_joint; ++j) {
    const PointRange range = points_of(whole, j);
    for (PointId p = range.begin; p < range.end; ++p) stays_.push_back(joint_[j] >= 0);
  }
  point_ = numbered(static_cast<int>(stays_.size()), [&](int p) { return stays_[p]; });
  take_out();
}

void StandingWall::take_out() {
  const int blocks = model.n_block;
  std::vector<std::int32_t> point_begin{0};
  for (std::size_t j = 0; dimension_of(model) == 3 && j < joint_.size(); ++j)
    if (joint_[j] >= 0)
      point_begin.push_back(point_begin.back() + model.space.point_begin[j + 1] -
                            model.space.point_begin[j]);
  each_model_field(model, [&](auto& array, Entity entity, Shared, auto, auto) {
    if (entity == Entity::kBlock) keep(array, block_);
    if (entity == Entity::kJoint) keep(array, joint_);
    if (entity == Entity::kPoint) keep(array, point_);
    if (entity == Entity::kLink) keep(array, link_);
  });
  model.standing = {};
  keep(model.centroid_x, block_);
  keep(model.centroid_y, block_);
  keep(model.links.name, link_);
  keep(model.links.kind, link_);
  model.links.n = kept(link_);
  model.n_pair = static_cast<int>(std::count_if(joint_.begin(), joint_.begin() + model.n_pair,
                                                [](int number) { return number >= 0; }));
  model.n_block = kept(block_);
  model.n_joint = kept(joint_);

  Anatomy& a = model.anatomy;
  keep_outlines(block_, a);
  keep(a.block_id, block_);
  keep(a.block_role, block_);
  keep(a.block_course, block_);
  keep(a.block_thickness, block_);
  keep(a.joint_kind, joint_);

  // supports, and the ground of zones, have numbers after the blocks
  const auto renumber = [&](BlockId& id) {
    if (id >= 0) id = id < blocks ? block_[id] : id - blocks + model.n_block;
  };
  for (std::vector<BlockId>* ids : {&model.joint_a, &model.joint_b, &model.links.a, &model.links.b,
                                    &model.solids.contact_block, &model.space.solids.contact_block})
    for (BlockId& id : *ids) renumber(id);
  if (dimension_of(model) == 3) {
    model.space.point_begin = std::move(point_begin);
    keep(model.space.body, block_);
    keep(model.space.centroid, block_);
    keep(model.space.face, joint_);
  }
  for (Stage& stage : model.stages) {
    const auto is_gone = [&](BlockId id) { return id >= 0 && id < blocks && block_[id] < 0; };
    for (std::vector<PointLoad>* loads : {&stage.loads, &stage.carried}) {
      std::erase_if(*loads, [&](const PointLoad& load) { return is_gone(load.block); });
      for (PointLoad& load : *loads) renumber(load.block);
    }
    for (BlockId& id : stage.driven) renumber(id);
    renumber(stage.control);
  }
  list_joints_of_blocks(model);
}

void StandingWall::spread_out(LimitResult& answer) const {
  const bool of_points = dimension_of(model) == 3;
  spread(answer.point_force, point_);
  spread(answer.shear_force, of_points ? point_ : joint_);
  spread(answer.shear_force_2, point_);
  spread(answer.link_force, link_);
  for (std::vector<double>* motion :
       {&answer.vx, &answer.vy, &answer.omega, &answer.vz, &answer.omega_x, &answer.omega_y})
    spread(*motion, block_);
}

}  // namespace wythe::limit

namespace wythe {

Model with_what_stands(Model model) {
  return model.standing.any() ? limit::StandingWall(model).model : model;
}

}  // namespace wythe
