// ns per contact-point update: the law alone, the engine's whole step, and a bare hand-written
// kernel of the same arithmetic, on the tuff wall cracked by a push of 6 mm, one thread.
//
//   build/release/benchmarks/wythe_bench      (make bench)
//
// Every figure stands beside the hash of the state it was measured on.
#include <benchmark/benchmark.h>

#include "bare_kernel.h"
#include "contact/parameters.h"
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

void step_engine(benchmark::State& bench, int threads) {
  Cracked& wall = cracked();
  State s = wall.state;
  dynamics::Stepper stepper(wall.model, threads);
  stepper.refresh(s);
  stepper.choose_driven(wall.model.stages.back().driven);
  dynamics::Controls controls;
  controls.dt = wall.dt;
  controls.damping = 0.8;
  controls.push = &wall.model.stages.back();
  for (auto _ : bench) stepper.step(s, controls);
  report(bench, wall.model.n_point());
}

void engine_step(benchmark::State& bench) { step_engine(bench, 1); }
BENCHMARK(engine_step);

void engine_step_two_threads(benchmark::State& bench) { step_engine(bench, 2); }
BENCHMARK(engine_step_two_threads)->UseRealTime();

}  // namespace

BENCHMARK_MAIN();
