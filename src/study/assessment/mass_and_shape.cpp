// What of the wall moves in an earthquake, and in which shape: m*, Gamma (docs/theory/assessment.md, A.6
// to A.8). Blocks by their weight, loads that stand on them by F / g, the mass that the file adds.
#include <algorithm>
#include <cmath>

#include "study/assessment/assessment_parts.h"
#include "wythe/reading.h"

namespace wythe {
namespace study {

// The last push: the curve is that of the last stage that has one.
const Stage* push_of(const Model& model) {
  for (std::size_t k = model.stages.size(); k-- > 0;)
    if (model.stages[k].spec.kind == StageKind::kPush) return &model.stages[k];
  return nullptr;
}

double foot_of(const Model& model) {
  double least = std::numeric_limits<double>::infinity();
  for (BlockId b = 0; b < block_count(model); ++b)
    for (const Vec3& corner : outline_of(model, b)) least = std::fmin(least, corner.y);
  return least;
}

std::vector<double> moved_at(const Model& model, const Result& result, double displacement) {
  const std::vector<const Snapshot*> states = states_by_displacement(result);
  if (states.empty() || result.snapshots.empty()) return {};
  const Snapshot& start = result.snapshots.front();  // "start" of the push
  const auto n = static_cast<std::size_t>(block_count(model));
  const auto along = [&](const Snapshot& s) {
    std::vector<double> moved(n);
    const Stage* push = push_of(model);
    for (std::size_t b = 0; b < n; ++b)
      moved[b] = push->drive_x * (read_block(model, s.state, static_cast<BlockId>(b)).moved.x -
                                  read_block(model, start.state, static_cast<BlockId>(b)).moved.x);
    return moved;
  };
  std::size_t next = 0;
  while (next < states.size() && states[next]->displacement < displacement) ++next;
  if (next == states.size()) return {};
  std::vector<double> high = along(*states[next]);
  const double d1 = states[next]->displacement;
  if (next == 0) {  // straight from the start
    for (double& u : high) u *= displacement / d1;
    return high;
  }
  const double d0 = states[next - 1]->displacement, share = (displacement - d0) / (d1 - d0);
  const std::vector<double> low = along(*states[next - 1]);
  for (std::size_t b = 0; b < n; ++b) high[b] = low[b] + share * (high[b] - low[b]);
  return high;
}

std::vector<const Snapshot*> states_by_displacement(const Result& result) {
  std::vector<const Snapshot*> states;
  for (const auto* list : {&result.snapshots, &result.readings, &result.frames})
    for (const Snapshot& s : *list)
      if (s.displacement > 0) states.push_back(&s);
  std::stable_sort(states.begin(), states.end(), [](const Snapshot* a, const Snapshot* b) {
    return a->displacement < b->displacement;
  });
  const auto same = [](const Snapshot* a, const Snapshot* b) {
    return a->displacement == b->displacement;
  };
  states.erase(std::unique(states.begin(), states.end(), same), states.end());
  return states;
}

}  // namespace study

namespace {

// Every mass that moves with the wall; `block` is whose motion it follows, -1 that of the control point.
struct Part {
  double mass = 0, height = 0;
  BlockId block = -1;
};

// The mass of a deformable block lies in its nodes.
double mass_of(const Model& model, BlockId block) {
  if (block < model.n_block) return model.heavy_mass[static_cast<std::size_t>(block)];
  const SolidBody& body = model.solids.bodies[static_cast<std::size_t>(block - model.n_block)];
  double mass = 0;
  for (int node = body.first_node; node < body.first_node + body.n_node; ++node)
    mass += model.solids.node_heavy_mass[static_cast<std::size_t>(node)];
  return mass;
}

std::vector<Part> parts_of(const AssessmentSpec& spec, const Model& model, double control,
                           MassAndShape& out) {
  std::vector<Part> parts;
  const State rest = initial_state(model);
  const double foot = study::foot_of(model);
  for (BlockId b = 0; b < block_count(model); ++b) {
    const double mass = spec.masonry_share * mass_of(model, b);
    parts.push_back({mass, read_block(model, rest, b).start.y - foot, b});
    out.blocks += mass;
  }
  const Stage* push = study::push_of(model);
  for (const Stage& stage : model.stages) {
    if (&stage == push) break;
    for (const PointLoad& load : stage.loads) {
      if (!(load.fy < 0)) continue;  // what lifts is no mass
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

void sum_up(const std::vector<MovingMass>& masses, MassAndShape& out) {
  double first = 0, second = 0;
  for (const MovingMass& m : masses) {
    first += m.mass * m.shape;
    second += m.mass * m.shape * m.shape;
  }
  out.participating = first;
  out.participation = second > 0 ? first / second : kUnset;
}

// Phi at a height between blocks: the mean of those there, weighted by their mass.
double shape_at(const Model& model, const std::vector<double>& shape, double height) {
  const double y = study::foot_of(model) + height;
  double mass = 0, sum = 0, nearest = std::numeric_limits<double>::infinity(), at_nearest = 0;
  for (BlockId b = 0; b < block_count(model); ++b) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Vec3& corner : outline_of(model, b))
      low = std::fmin(low, corner.y), high = std::fmax(high, corner.y);
    const double phi = shape[static_cast<std::size_t>(b)];
    const double off = std::fmax(0.0, std::fmax(low - y, y - high));
    if (off < nearest) nearest = off, at_nearest = phi;
    if (off > 0) continue;
    mass += mass_of(model, b);
    sum += mass_of(model, b) * phi;
  }
  return mass > 0 ? sum / mass : at_nearest;
}

}  // namespace

MassAndShape mass_and_linear_shape(const AssessmentSpec& spec, const Model& model) {
  MassAndShape out;
  out.is_linear = true;
  const Stage* push = study::push_of(model);
  if (push == nullptr || !(push->load_height > 0)) return out;
  std::vector<MovingMass> masses;
  for (const Part& part : parts_of(spec, model, push->load_height, out))
    masses.push_back({part.mass, part.height, part.height / push->load_height});
  sum_up(masses, out);
  return out;
}

MassAndShape mass_and_shape(const AssessmentSpec& spec, const Model& model, const Result& result,
                            double displacement) {
  MassAndShape out;
  const Stage* push = study::push_of(model);
  if (push == nullptr || !(displacement > 0)) return out;
  std::vector<double> shape = study::moved_at(model, result, displacement);
  if (shape.empty()) return mass_and_linear_shape(spec, model);
  for (double& phi : shape) phi /= displacement;
  out.read_at = displacement;
  std::vector<MovingMass> masses;
  for (const Part& part : parts_of(spec, model, push->load_height, out)) {
    double phi = 1;
    if (part.block >= 0)
      phi = shape[static_cast<std::size_t>(part.block)];
    else if (std::isfinite(spec.added_height))
      phi = shape_at(model, shape, part.height);
    masses.push_back({part.mass, part.height, phi});
  }
  sum_up(masses, out);
  return out;
}

}  // namespace wythe
