// ns per contact-point update: the law alone, bare hand-written kernels, the engine's whole step, on
// the tuff wall cracked by a push of 6 mm; and what the machine's units and caches can do.
//
//   build/release/benchmarks/wythe_bench      (make bench: tools/bench run)
//
// Bare kernels are first checked against the engine. Every figure stands beside the hash of the state
// it was measured on; walls side by side are equal ones, so that all lanes take the same branches.
#include <benchmark/benchmark.h>
#include <fmt/core.h>

#include <cstdio>
#include <cstring>
#include <exception>
#include <memory>
#include <string>
#include <vector>

#include "contact/law.h"
#include "contact/parameters.h"
#include "cracked.h"
#include "dynamics/executors/processor.h"
#include "dynamics/space/executor.h"
#include "space_wall.h"
#include "wythe/parts/reading.h"
#include "wythe/parts/solve.h"

namespace {

using namespace wythe;
using namespace wythe::bench;

// Rates are of all threads together, by processor time where there is one, else by the clock.
void report(benchmark::State& bench, std::int64_t points) {
  const auto done = static_cast<double>(points) * static_cast<double>(bench.iterations());
  bench.counters["points_per_second"] = benchmark::Counter(done, benchmark::Counter::kIsRate);
  bench.SetLabel("state " + cracked().hash);
}
void report(benchmark::State& bench, std::int64_t points, const Cost& cost) {
  report(bench, points);
  if (bench.thread_index() != 0) return;
  bench.counters["arithmetic_per_point"] = cost.arithmetic;
  bench.counters["other_per_point"] = cost.other;
  bench.counters["bytes_per_point"] = cost.bytes;
}

// The law on every point of the cracked wall, openings and slips replayed with a small swing.
void law_alone(benchmark::State& bench) {
  const Cracked& wall = cracked();
  const std::vector<PointReading> at = read_points(wall.model, wall.state);
  State s = wall.state;
  const auto per = static_cast<std::size_t>(wall.model.n_face_point);
  double swing = 1e-9;
  for (auto _ : bench) {
    swing = -swing;
    double sum = 0;
    for (std::size_t p = 0; p < static_cast<std::size_t>(wall.model.n_point()); ++p) {
      contact::History<double> h{s.kappa[p], s.crush[p],        s.plastic_slip[p],
                                 s.slip[p],  s.shear_damage[p], s.tension_set[p],
                                 0};
      const auto& law = wall.law[wall.model.joint_material[p / per]];
      const auto now =
          contact::update<contact::PaperVariant>(law, at[p].opening + swing, at[p].slip + swing, h);
      s.kappa[p] = h.kappa;
      s.crush[p] = h.crush;
      s.plastic_slip[p] = h.plastic_slip;
      s.slip[p] = h.slip;
      s.shear_damage[p] = h.shear_damage;
      sum += now.sigma + now.tau;
    }
    benchmark::DoNotOptimize(sum);
  }
  report(bench, wall.model.n_point());
}

void bare_walls(benchmark::State& bench, const BareKernels& kernels) {
  BareWallsRun run(cracked().bare(), kernels);
  for (auto _ : bench) run.step();
  Cost cost = bare_cost();
  cost.bytes = run.bytes_per_point();
  report(bench, static_cast<std::int64_t>(kernels.lanes) * cracked().model.n_point(), cost);
}

void bare_joints(benchmark::State& bench, const BareKernels& kernels) {
  BareJointsRun run(cracked().bare(), kernels);
  for (auto _ : bench) run.step();
  Cost cost = bare_cost();
  cost.bytes = run.bytes_per_point();
  report(bench, cracked().model.n_point(), cost);
}

dynamics::Controls push_controls(const Cracked& wall) {
  dynamics::Controls controls;
  controls.dt = wall.dt;
  controls.damping = 0.2;
  controls.push = &wall.push();
  return controls;
}

void engine_joints(benchmark::State& bench, int threads, const dynamics::Kernels& kernels,
                   const Cracked& wall = cracked()) {
  State s = wall.state;
  dynamics::Processor processor(wall.model, 1, threads, kernels);
  processor.load_wall(0, wall.model, s);
  processor.access(0)->choose_driven(wall.push().driven);
  processor.set(0, push_controls(wall));
  for (auto _ : bench) processor.step();
  report(bench, wall.model.n_point(), engine_cost(1));
}

// Walls side by side: the same wall in every lane; where there are several sets, in turn.
void engine_walls(benchmark::State& bench, int lanes, std::size_t sets,
                  const Cracked& wall = cracked()) {
  std::vector<State> states(sets * static_cast<std::size_t>(lanes), wall.state);
  std::vector<std::unique_ptr<dynamics::Processor>> processors;
  for (std::size_t set = 0; set < sets; ++set) {
    auto& processor =
        *processors.emplace_back(std::make_unique<dynamics::Processor>(wall.model, lanes));
    for (int lane = 0; lane < lanes; ++lane) {
      processor.load_wall(
          lane, wall.model,
          states[set * static_cast<std::size_t>(lanes) + static_cast<std::size_t>(lane)]);
      processor.access(lane)->choose_driven(wall.push().driven);
      processor.set(lane, push_controls(wall));
    }
  }
  for (auto _ : bench)
    for (const auto& processor : processors) processor->step();
  report(bench, static_cast<std::int64_t>(states.size()) * wall.model.n_point(),
         engine_cost(lanes));
}

// --- walls in space

// Bytes that a step moves: what a wall has for itself, read and where it is written written; what all share.
double engine_space_bytes(const Model& m, int walls) {
  const auto np = static_cast<double>(m.space.point_r1.size());
  const double nj = m.n_joint, nb = m.n_block;
  const int history = contact::history_size(contact::choice_of(m.materials.front())) + 1;
  constexpr int kPoint = dynamics::space::kPointRows, kFace = dynamics::space::kFaceRows + 1,
                kBlock = dynamics::space::kAxisRows + 4;
  const double own = history * np + 2 * 12 * nj + (2 * (8 + 6) + 12) * nb;
  const double shared = kPoint * np + kFace * nj + kBlock * nb;
  return 8 * (own + shared / walls) / np;
}

void report_space(benchmark::State& bench, const SpaceWall& wall, int walls) {
  const auto done =
      static_cast<double>(wall.points()) * walls * static_cast<double>(bench.iterations());
  bench.counters["points_per_second"] = benchmark::Counter(done, benchmark::Counter::kIsRate);
  bench.SetLabel("state " + wall.hash);
}

void bare_space(benchmark::State& bench, const SpaceWall& wall, const SpaceKernels& kernels,
                bool many) {
  BareSpaceRun run(wall, kernels, many);
  for (auto _ : bench) run.step();
  report_space(bench, wall, many ? kernels.lanes : 1);
  bench.counters["bytes_per_point"] = run.bytes_per_point();
}

void engine_space(benchmark::State& bench, const SpaceWall& wall, int lanes,
                  const dynamics::space::KernelSet& kernels) {
  std::vector<State> states(static_cast<std::size_t>(lanes), wall.state);
  dynamics::space::SpaceProcessor processor(wall.model, lanes, 1, kernels);
  dynamics::Controls controls;
  controls.dt = wall.dt;
  controls.damping = 0.8;
  controls.push = &wall.push();
  for (int lane = 0; lane < lanes; ++lane) {
    processor.load_wall(lane, wall.model, states[lane]);
    processor.access(lane)->choose_driven(wall.push().driven);
    processor.set(lane, controls);
  }
  for (auto _ : bench) processor.step();
  report_space(bench, wall, lanes);
  bench.counters["bytes_per_point"] = engine_space_bytes(wall.model, lanes);
}

// One multiplication and one addition a round and chain.
void flops(benchmark::State& bench, const BareKernels& kernels, double (*run)(std::int64_t)) {
  constexpr std::int64_t rounds = 100000;
  for (auto _ : bench) benchmark::DoNotOptimize(run(rounds));
  bench.counters["flops"] = benchmark::Counter(
      static_cast<double>(2 * kChains * rounds * kernels.lanes * bench.iterations()),
      benchmark::Counter::kIsRate);
}

// Copies half of `kib` onto the other half.
void copy(benchmark::State& bench, int kib) {
  const std::size_t half = static_cast<std::size_t>(kib) * 512;
  std::vector<char> memory(2 * half, 1);
  for (auto _ : bench) {
    std::memcpy(memory.data() + half, memory.data(), half);
    benchmark::ClobberMemory();
  }
  bench.counters["bytes_per_second"] =
      benchmark::Counter(2.0 * static_cast<double>(half) * static_cast<double>(bench.iterations()),
                         benchmark::Counter::kIsRate);
}

template <class Run>
benchmark::internal::Benchmark* add(const std::string& name, const Run& run) {
  return benchmark::RegisterBenchmark(name.c_str(), run);
}

void add_all() {
  add("law/scalar", law_alone);
  for (const BareKernels* set : bare_here()) {
    const std::string name = set->name;
    add("bare_walls/" + name, [set](auto& b) { bare_walls(b, *set); });
    if (set->lanes > 1) add("bare_joints/" + name, [set](auto& b) { bare_joints(b, *set); });
    add("multiply_add/" + name, [set](auto& b) { flops(b, *set, set->multiply_add); });
    if (set->fused != nullptr) add("fused/" + name, [set](auto& b) { flops(b, *set, set->fused); });
  }
  for (const dynamics::Kernels* set : dynamics::kernels_here())
    add("engine_joints/" + std::string(set->name), [set](auto& b) { engine_joints(b, 1, *set); });
  for (const int lanes : {2, 4, 8})
    add("engine_walls/" + std::to_string(lanes), [lanes](auto& b) { engine_walls(b, lanes, 1); });
  add("engine_walls/4_and_4", [](auto& b) { engine_walls(b, 4, 2); });
  for (const SpaceKernels* set : bare_space_here())
    for (const bool many : {false, true})
      if (!many || set->lanes > 1)
        add(std::string(many ? "bare_space_walls/" : "bare_space_joints/") + set->name,
            [set, many](auto& b) { bare_space(b, space_wall(), *set, many); });
  for (const auto* set : dynamics::space::kernels_here()) {
    add("engine_space_joints/" + std::string(set->name),
        [set](auto& b) { engine_space(b, space_wall(), 1, *set); });
    if (set->width > 1)
      add("engine_space_walls/" + std::string(set->name),
          [set](auto& b) { engine_space(b, space_wall(), set->width, *set); });
  }
  // whole, within the cache and beyond it
  using Build = const SpaceWall& (*)();
  const auto engine_on = [](Build wall) {
    return [wall](benchmark::State& b) {
      engine_space(b, wall(), 1, *dynamics::space::kernels_here().back());
    };
  };
  const auto bare_on = [](Build wall) {
    return [wall](benchmark::State& b) { bare_space(b, wall(), *bare_space_here().back(), false); };
  };
  add("engine_space_still", engine_on(still_wall));
  add("engine_space_large", engine_on(large_wall));
  add("bare_space_still", bare_on(still_wall));
  add("bare_space_large", bare_on(large_wall));
  // each joint with a law of its own
  add("graded_joints", [](auto& b) { engine_joints(b, 1, dynamics::kernels_in_use(), graded()); });
  add("graded_walls/4", [](auto& b) { engine_walls(b, 4, 1, graded()); });
  // two threads: within a wall; each its own walls
  const BareKernels* widest = bare_here().back();
  const int lanes = dynamics::kernels_in_use().width;
  add("engine_joints_two_threads", [](auto& b) {
    engine_joints(b, 2, dynamics::kernels_in_use());
  })->UseRealTime();
  add("engine_walls_two_threads", [lanes](auto& b) { engine_walls(b, lanes, 1); })
      ->Threads(2)
      ->UseRealTime();
  add("bare_walls_two_threads", [widest](auto& b) { bare_walls(b, *widest); })
      ->Threads(2)
      ->UseRealTime();
  for (const int kib : {16, 256, 4096, 24576, 262144})
    add("copy/" + std::to_string(kib) + "_KiB", [kib](auto& b) { copy(b, kib); });
}

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  try {
    check_bare_kernels();
    check_bare_space();
  } catch (const std::exception& e) {
    fmt::print(stderr, "wythe_bench: {}\n", e.what());
    return 1;
  }
  add_all();
  benchmark::RunSpecifiedBenchmarks();
}
