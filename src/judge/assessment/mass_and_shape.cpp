// The masses that move in an earthquake and their shape: m*, Gamma (docs/theory/assessment.md, A.6
// to A.8). Blocks count by their weight, loads on them by F / g, and the mass that the file adds.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "judge/assessment/assessment_parts.h"
#include "wythe/parts/reading.h"

namespace wythe {
namespace study {

// The last push, because the curve belongs to the last stage that has one.
const Stage* push_of(const Model& model) {
  for (std::size_t k = model.stages.size(); k-- > 0;)
    if (model.stages[k].push() != nullptr) return &model.stages[k];
  return nullptr;
}

std::vector<BlockId> moving_blocks(const Model& model) {
  std::vector<BlockId> blocks;
  const int supports = model.space.n_support;
  for (BlockId b = 0; b < model.n_block; ++b) blocks.push_back(b);
  const auto bodies = model.solids.bodies.size() + model.space.solids.bodies.size();
  for (std::size_t k = 0; k < bodies; ++k)
    blocks.push_back(model.n_block + supports + static_cast<BlockId>(k));
  return blocks;
}

Extent extent_of(const Model& model, BlockId block) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  Extent extent{kFar, -kFar};
  for (const Vec3& corner : corners_of(model, block))
    extent.low = std::fmin(extent.low, corner.y), extent.high = std::fmax(extent.high, corner.y);
  return extent;
}

double foot_of(const Model& model) {
  double least = std::numeric_limits<double>::infinity();
  for (const BlockId b : moving_blocks(model)) least = std::fmin(least, extent_of(model, b).low);
  return least;
}

std::vector<double> moved_at(const Model& model, const Result& result, const Snapshot& state) {
  const Stage* push = push_of(model);
  const Vec3 along{push->drive_x, push->drive_y, push->drive_z};
  const Snapshot& start = result.states.snapshots.front();  // "start" of the push
  const std::vector<BlockId> blocks = moving_blocks(model);
  std::vector<double> moved(blocks.empty() ? 0 : static_cast<std::size_t>(blocks.back()) + 1, 0.0);
  for (const BlockId b : blocks)
    moved[b] = dot(
        along, read_block(model, state.state, b).moved - read_block(model, start.state, b).moved);
  return moved;
}

// A control point that a wall carries along swings by less at the end of its push.
static constexpr double kNearlyFarthest = 0.999;

// The farthest displacement that the push has reached.
static double farthest_of(const Result& result) {
  double farthest = 0;
  for (const CurveRow& row : result.curve) farthest = std::fmax(farthest, row.displacement);
  for (const MovedBlocks& shape : result.states.rise_shapes)
    farthest = std::fmax(farthest, shape.displacement);
  return farthest;
}

std::vector<const Snapshot*> states_by_displacement(const Result& result) {
  std::vector<const Snapshot*> states;
  if (result.states.snapshots.empty()) return states;
  double farthest = 0;
  const auto take = [&](const Snapshot& s) {
    if (s.displacement <= farthest) return;
    states.push_back(&s);
    farthest = s.displacement;
  };
  const auto is_of_push = [reached = kNearlyFarthest * farthest_of(result)](const Snapshot& s) {
    return s.displacement > 0 && (s.label != "end" || s.displacement >= reached);
  };
  const std::vector<Snapshot>& readings = result.states.readings;
  const auto first = std::find_if(readings.begin(), readings.end(), is_of_push);
  const auto take_peak = [&](double after, double before) {
    for (const Snapshot& s : result.states.snapshots)
      if (s.label == "peak" && s.state.time > after && s.state.time < before) take(s);
  };
  constexpr double kEver = std::numeric_limits<double>::infinity();
  take_peak(-kEver, first == readings.end() ? kEver : first->state.time);
  for (const Snapshot& s : readings)
    if (is_of_push(s)) take(s);
  if (!states.empty()) take_peak(states.back()->state.time, kEver);
  return states;
}

std::vector<MovedBlocks> shapes_of(const Model& model, const Result& result) {
  std::vector<MovedBlocks> shapes = result.states.rise_shapes;
  for (const Snapshot* state : states_by_displacement(result))
    shapes.push_back({state->displacement, moved_at(model, result, *state)});
  std::stable_sort(shapes.begin(), shapes.end(), [](const MovedBlocks& a, const MovedBlocks& b) {
    return a.displacement < b.displacement;
  });
  const auto same = [](const MovedBlocks& a, const MovedBlocks& b) {
    return a.displacement == b.displacement;
  };
  shapes.erase(std::unique(shapes.begin(), shapes.end(), same), shapes.end());
  return shapes;
}

}  // namespace study

namespace {

// Every mass that moves with the wall. `block` is the block it moves with, -1 for the control point.
struct MovingMass {
  double mass = 0, height = 0;
  BlockId block = -1;
};

// The mass of a deformable block lies in its nodes.
double mass_of(const Model& model, BlockId block) {
  if (block < model.n_block) {
    return model.anatomy.block_role[block] == BlockRole::kCutOut ? 0.0 : model.gravity_mass[block];
  }
  const std::size_t number = block - model.n_block - model.space.n_support;
  const auto of_nodes = [&](const auto& solids) {  // nodes in the plane or in space
    const auto first = solids.node_gravity_mass.begin() + solids.bodies[number].first_node;
    return std::accumulate(first, first + solids.bodies[number].n_node, 0.0);
  };
  return model.solids.bodies.empty() ? of_nodes(model.space.solids) : of_nodes(model.solids);
}

// Whether masonry_share applies. Frames, slabs, ring beams, beams and plates move with the wall as a whole.
bool is_masonry(const Model& model, BlockId block) {
  if (block >= model.n_block) return true;  // deformable blocks
  switch (model.anatomy.block_role[block]) {
    case BlockRole::kPlate:
    case BlockRole::kBeam:
    case BlockRole::kRingBeam:
    case BlockRole::kSlab:
    case BlockRole::kFrame: return false;
    default: return true;
  }
}

std::vector<MovingMass> moving_masses(const AssessmentSpec& spec, const Model& model,
                                      double control, MassAndShape& out) {
  std::vector<MovingMass> parts;
  const State rest = initial_state(model);
  const double foot = study::foot_of(model);
  for (const BlockId b : study::moving_blocks(model)) {
    const double mass = (is_masonry(model, b) ? spec.masonry_share : 1) * mass_of(model, b);
    parts.push_back({mass, read_block(model, rest, b).start.y - foot, b});
    out.blocks += mass;
  }
  const Stage* push = study::push_of(model);
  for (const Stage& stage : model.stages) {
    if (&stage == push) break;
    for (const PointLoad& load : stage.loads) {
      if (!(load.fy < 0)) continue;  // an upward load has no mass
      const double mass = -load.fy / model.solve.gravity;
      parts.push_back(
          {mass, read_block(model, rest, load.block).start.y + load.arm_y - foot, load.block});
      out.loads += mass;
    }
  }
  if (spec.added_mass > 0)
    parts.push_back(
        {spec.added_mass, std::isnan(spec.added_height) ? control : spec.added_height, -1});
  out.added = spec.added_mass;
  return parts;
}

// Displacement of the wall at a height between blocks: the mean of the blocks there, weighted by mass.
double moved_at_height(const Model& model, const std::vector<double>& moved, double height) {
  const double y = study::foot_of(model) + height;
  double mass = 0, sum = 0, nearest = std::numeric_limits<double>::infinity(), at_nearest = 0;
  for (const BlockId b : study::moving_blocks(model)) {
    const auto [low, high] = study::extent_of(model, b);
    const double u = moved[b];
    const double off = std::fmax(0.0, std::fmax(low - y, y - high));
    if (off < nearest) nearest = off, at_nearest = u;
    if (off > 0) continue;
    mass += mass_of(model, b);
    sum += mass_of(model, b) * u;
  }
  return mass > 0 ? sum / mass : at_nearest;
}

}  // namespace

MassAndShape mass_and_linear_shape(const AssessmentSpec& spec, const Model& model) {
  MassAndShape out;
  out.is_linear = true;
  const Stage* push = study::push_of(model);
  if (push == nullptr || !(push->load_height > 0)) return out;
  double first = 0, second = 0;
  for (const MovingMass& part : moving_masses(spec, model, push->load_height, out)) {
    const double phi = part.height / push->load_height;
    first += part.mass * phi;
    second += part.mass * phi * phi;
  }
  out.participating = first;
  out.participation = second > 0 ? first / second : kUnset;
  return out;
}

std::vector<MovedMass> study::moved_masses(const AssessmentSpec& spec, const Model& model,
                                           const Result& result, MassAndShape& masses) {
  const Stage* push = push_of(model);
  const std::vector<MovingMass> parts = moving_masses(spec, model, push->load_height, masses);
  std::vector<MovedMass> out;
  std::vector<double> before(parts.size(), 0.0);
  for (const auto& [displacement, moved] : shapes_of(model, result)) {
    MovedMass& sum = out.emplace_back();
    sum.displacement = displacement;
    for (std::size_t k = 0; k < parts.size(); ++k) {
      const MovingMass& part = parts[k];
      double u = displacement;  // moves with the control point
      if (part.block >= 0)
        u = moved[part.block];
      else if (std::isfinite(spec.added_height))
        u = moved_at_height(model, moved, part.height);
      sum.first += part.mass * u;
      sum.second += part.mass * u * u;
      sum.mixed += part.mass * u * before[k];
      before[k] = u;
    }
  }
  return out;
}

// Between two states every mass moves in a straight line, so the sums follow from those of both.
MassAndShape mass_and_shape(const PushedWall& wall, double displacement) {
  MassAndShape out;
  out.blocks = wall.blocks, out.loads = wall.loads, out.added = wall.added;
  MovedMass before;
  for (const MovedMass& now : wall.moved) {
    if (now.displacement < displacement) {
      before = now;
      continue;
    }
    if (!(displacement > 0)) break;
    const double t =
        (displacement - before.displacement) / (now.displacement - before.displacement);
    const double first = before.first + t * (now.first - before.first);
    const double second =
        (1 - t) * (1 - t) * before.second + 2 * t * (1 - t) * now.mixed + t * t * now.second;
    out.read_at = displacement;
    out.participating = first / displacement;
    out.participation = second > 0 ? first * displacement / second : kUnset;
    break;
  }
  return out;
}

}  // namespace wythe
