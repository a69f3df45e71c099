// ns per contact-point update: the law alone, the engine's whole step, and a bare hand-written
// kernel of the same arithmetic, on the tuff wall cracked by a push of 6 mm, one thread.
//
//   build/release/benchmarks/wythe_bench      (make bench)
//
// Every figure stands beside the hash of the state it was measured on.
#include <benchmark/benchmark.h>

#include <string>
#include <vector>

#include "bare_kernel.h"
#include "contact/parameters.h"
#include "dynamics/lane_step.h"
#include "dynamics/step.h"
#include "wythe/io.h"
#include "wythe/solve.h"

namespace {

using namespace wythe;

struct Cracked {
  Model model = compile(
      read_model(WYTHE_SOURCE_DIR "/examples/tuff_wall/model.toml", {"stage.push.until=6 mm"}));
  State state = initial_state(model);
  std::vector<contact::LawConstants<double>> law;
  std::string hash;
  double dt = 0;

  Cracked() {
    const Result result = solve(model, state);
    hash = result.state_hash;
    dt = result.time_step;
    for (const JointMaterial& m : model.materials) law.push_back(contact::constants_of(m));
  }
};

Cracked& cracked() {
  static Cracked wall;
  return wall;
}

void report(benchmark::State& bench, std::int64_t points) {
  bench.SetItemsProcessed(points * bench.iterations());
  bench.counters["ns_per_point"] = benchmark::Counter(
      static_cast<double>(points) * static_cast<double>(bench.iterations()) * 1e-9,
      benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  bench.SetLabel("state " + cracked().hash);
}

// The law on every point of the cracked wall, openings and slips replayed with a small swing.
void law_alone(benchmark::State& bench) {
  Cracked& wall = cracked();
  const std::vector<PointStress> at = point_stresses(wall.model, wall.state);
  State s = wall.state;
  const auto per = static_cast<std::size_t>(wall.model.n_face_point);
  double swing = 1e-9;
  for (auto _ : bench) {
    swing = -swing;
    double sum = 0;
    for (std::size_t p = 0; p < at.size(); ++p) {
      contact::History<double> h{s.kappa[p], s.crush[p],        s.plastic_slip[p],
                                 s.slip[p],  s.shear_damage[p], s.tension_set[p]};
      const auto& law = wall.law[static_cast<std::size_t>(wall.model.joint_material[p / per])];
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
BENCHMARK(law_alone);

void bare_kernel(benchmark::State& bench) {
  Cracked& wall = cracked();
  bench::BareWall bare(wall.model, wall.state, wall.law);
  for (auto _ : bench) bare.step(wall.dt, 0.8, -wall.model.solve.gravity);
  benchmark::DoNotOptimize(bare.fracture);
  report(bench, wall.model.n_point());
}
BENCHMARK(bare_kernel);

dynamics::Controls push_controls(const Cracked& wall) {
  dynamics::Controls controls;
  controls.dt = wall.dt;
  controls.damping = 0.2;
  controls.push = &wall.model.stages.back();
  return controls;
}

void step_engine(benchmark::State& bench, int threads, const dynamics::Kernels& kernels) {
  Cracked& wall = cracked();
  State s = wall.state;
  dynamics::Stepper stepper(wall.model, threads, kernels);
  stepper.refresh(s);
  stepper.choose_driven(wall.model.stages.back().driven);
  const dynamics::Controls controls = push_controls(wall);
  for (auto _ : bench) stepper.step(s, controls);
  report(bench, wall.model.n_point());
}

// Walls side by side: the same wall in every lane.
void step_lanes(benchmark::State& bench, int lanes) {
  Cracked& wall = cracked();
  std::vector<State> states(static_cast<std::size_t>(lanes), wall.state);
  dynamics::LaneStepper stepper(wall.model, lanes);
  for (int lane = 0; lane < lanes; ++lane) {
    stepper.put(lane, wall.model, states[static_cast<std::size_t>(lane)]);
    dynamics::choose_driven(wall.model, stepper.place(lane).view, wall.model.stages.back().driven);
    stepper.set(lane, push_controls(wall));
  }
  for (auto _ : bench) stepper.step();
  report(bench, static_cast<std::int64_t>(lanes) * wall.model.n_point());
}

void add_engines() {
  for (const dynamics::Kernels* set : dynamics::kernels_here())
    benchmark::RegisterBenchmark((std::string("engine_step/") + set->name).c_str(),
                                 [set](benchmark::State& bench) { step_engine(bench, 1, *set); });
  for (const int lanes : {2, 4, 8})
    benchmark::RegisterBenchmark(("engine_walls_side_by_side/" + std::to_string(lanes)).c_str(),
                                 [lanes](benchmark::State& bench) { step_lanes(bench, lanes); });
  benchmark::RegisterBenchmark("engine_step_two_threads", [](benchmark::State& bench) {
    step_engine(bench, 2, dynamics::kernels_in_use());
  })->UseRealTime();
}

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  add_engines();
  benchmark::RunSpecifiedBenchmarks();
}
