// Layers of fibres against closed forms (docs/theory/layers.md). The positions of a column of
// blocks are prescribed, the nodes find their balance, and the force of the fibres is read.
//
//     |  b19 |  up by w       fibres run upwards on one face, breadth 0.1 m
//     |  ... |
//     +======+  the crack
//     |  ... |
//     |  b0  |  at rest
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "contact/layer.h"
#include "scenes/rig.h"
#include "scenes/scenes.h"
#include "verification/record.h"
#include "wythe/parts/reading.h"
#include "wythe/parts/solve.h"

namespace wythe::verification::layers_test {
namespace {

constexpr double kBreadth = 0.1, kThick = 0.1;                 // of the column [m]
constexpr double kArea = 46e-6, kE = 72e9, kStrong = 2e9;      // of the fibres [m^2/m], [Pa], [Pa]
constexpr double kEnergy = 400, kSlip = 0.2e-3;                // of the bond [N/m], [m]
const double kRate = std::log(2.0) / kSlip;                    // B [1/m]
const double kDetaches = std::sqrt(2 * kE * kArea * kEnergy);  // P1 [N/m]
const double kDecay = std::sqrt(kE * kArea / (2 * kEnergy)) / kRate;  // l [m]

LayerSpec layer_on_one_face() {
  LayerSpec layer;
  layer.name = "east";
  layer.sides = 1;
  layer.fibres.vertical = kArea;
  layer.fibres.youngs_modulus = kE;
  layer.fibres.strength = kStrong;
  layer.bond.energy = kEnergy;
  layer.bond.slip = kSlip;
  return layer;
}

ModelSpec column(int blocks, double height) {
  ModelSpec spec =
      scenes::stack(blocks, kBreadth, height, scenes::elastic_joint(2e10, 1e10), kThick, 2000);
  spec.solve.gravity = 0;
  spec.solve.collapse_displacement = 10;
  spec.layer = {layer_on_one_face()};
  spec.stage = {
      scenes::push_stage("b" + std::to_string(blocks - 1), Direction::kPlusY, 1e-3, 1e-3)};
  return spec;
}

// A column whose blocks are put where `up` says; nothing else moves them.
class Held {
 public:
  explicit Held(const ModelSpec& spec) : rig_(hold_all(compile(spec))) { rig_.drive(0, 0); }

  // In steps so small that the nodes follow.
  void move(const std::function<double(int)>& up, int steps = 60) {
    const std::vector<double> from = rig_.state.uy;
    for (int k = 1; k <= steps; ++k) {
      for (std::size_t i = 0; i < from.size(); ++i)
        rig_.state.uy[i] = from[i] + (up(static_cast<int>(i)) - from[i]) * k / steps;
      rig_.run(100 * rig_.controls.dt);
      peak_ = std::max(peak_, force());
    }
    rig_.run(3000 * rig_.controls.dt);
  }
  // A crack above block `below`.
  void open(int below, double w, int steps = 60) {
    below_ = below;
    move([&](int i) { return i > below ? w : 0.0; }, steps);
  }

  [[nodiscard]] std::vector<LayerReading> read() const {
    return read_layers(rig_.model, rig_.state);
  }
  // Force of all fibres from block `below` to the next one [N/m].
  [[nodiscard]] double force(int below) const {
    const Layers& l = rig_.model.layers;
    const std::vector<LayerReading> nodes = read();
    double sum = 0;
    for (std::size_t k = 0; k < nodes.size(); ++k)
      if (l.crossing[k] >= 0 && l.a[k] == below) sum += nodes[k].force;
    return sum / kBreadth;
  }
  [[nodiscard]] double force() const { return force(below_); }
  [[nodiscard]] double peak() const { return peak_; }
  // Along one strand [m].
  [[nodiscard]] double detached() const {
    const std::vector<LayerReading> nodes = read();
    double length = 0;
    for (std::size_t k = 0; k < nodes.size(); ++k)
      if (rig_.model.layers.strand[k] == 0 && nodes[k].spent > 0.95)
        length += rig_.model.layers.length[k];
    return length;
  }
  [[nodiscard]] double stored() const {
    double sum = 0;
    for (const LayerReading& node : read()) sum += node.stored;
    return sum;
  }
  [[nodiscard]] double lost() const { return rig_.state.energy.dissipated_fracture; }
  [[nodiscard]] const Model& model() const { return rig_.model; }

 private:
  static Model hold_all(Model model) {
    Stage& stage = model.stages[0];
    stage.driven.clear();
    for (BlockId i = 0; i < model.n_block; ++i) stage.driven.push_back(i);
    stage.driven_share.assign(stage.driven.size(), 1.0);
    stage.spec.action = PushStage{.as = Manner::kEach};
    return model;
  }

  scenes::Rig rig_;
  int below_ = 0;
  double peak_ = 0;
};

// Lost for good in both sides of a crack: the bond's share of the profile exp(B s) - 1 = C exp(-x/l) [J].
double lost_at(double w) {
  const double steepness = std::expm1(kRate * w / 2), step = kDecay / 100;
  const contact::LayerBond bond{kEnergy * kBreadth * step, kRate};
  double lost = 0;
  for (int k = 0; k < 4000; ++k) {
    const double slip = std::log1p(steepness * std::exp(-(k + 0.5) * step / kDecay)) / kRate;
    lost += 2 * contact::bond_lost(bond, contact::bond_secant(bond, slip), slip);
  }
  return lost;
}

double one_crack(double w) { return kDetaches * (1 - std::exp(-kRate * w / 2)); }

TEST(Layers, one_crack_in_a_long_layer_pulls_as_the_bond_law_says) {
  Held held(column(20, kBreadth));  // 4 nodes a block, 1.3 l apart
  for (const double w : {0.3e-3, 0.6e-3, 1.2e-3, 2.4e-3}) {
    held.open(9, w);
    verify({"layer", "one crack of " + fmt::format("{:.1f} mm: force", 1e3 * w), "N/m",
            one_crack(w), w < 0.5e-3 ? 0.09 : 0.03,
            "fibres between the two nodes at the crack stretch too: 7 % at 1/B, 1 % at 4/B"},
           held.force());
  }
}

TEST(Layers, a_crack_detaches_as_far_as_its_width_asks_for) {
  Held held(column(20, kBreadth));
  const double w = 4e-3;
  held.open(9, w, 300);
  // exp(B s) - 1 falls by exp(-x/l) from the crack on; 95 % of the energy is spent where s = s95
  const double s95 = -std::log(1 - std::sqrt(0.95)) / kRate;
  const double length = 2 * kDecay * std::log(std::expm1(kRate * w / 2) / std::expm1(kRate * s95));
  verify({"layer", "one crack of 4 mm: detached length", "m", length, 0.05,
          "two nodes of 25 mm, one on each side", true},
         held.detached());
  verify({"layer", "one crack: force that detaches", "N/m", kDetaches, 5e-3,
          "nodes come off one after the other: 0.2 %"},
         held.peak());
  const double work = kDetaches * (w - 2 / kRate * (1 - std::exp(-kRate * w / 2))) * kBreadth;
  verify({"layer", "one crack of 4 mm: energy lost and stored", "J", work, 0.02,
          "what the nodes' way to balance takes, 0.5 %, and the nodes at the crack"},
         held.lost() + held.stored());
  verify({"layer", "one crack of 4 mm: energy lost", "J", lost_at(w), 0.03,
          "a node of 25 mm has one slip where the bond has many"},
         held.lost());
}

// Cracks at the distance h with a bond that is elastic still: P = E A w / (2 l) coth(h / 2 l).
double many_cracks(double w, double decay) {
  return kE * kArea * w / (2 * decay) / std::tanh(kBreadth / (2 * decay));
}

TEST(Layers, many_cracks_side_by_side_share_their_bond) {
  ModelSpec spec = column(20, kBreadth);
  spec.layer[0].bond.slip = 4 * kSlip;  // l = 74 mm, two nodes a block
  Held held(spec);
  const double w = 0.01e-3;
  held.move([&](int i) { return i * w; });
  verify({"layer", "cracks of 0.01 mm in every joint, l = 74 mm: force", "N/m",
          many_cracks(w, 4 * kDecay), 0.04,
          "nodes 0.7 l apart: 2 %; the bond is elastic to B w/2: 0.5 %"},
         held.force(9));
}

TEST(Layers, many_cracks_close_together_stretch_the_fibres_between_them) {
  ModelSpec spec = column(40, kBreadth);
  spec.layer[0].bond.slip = 10 * kSlip;  // l = 0.19 m, a node a block
  Held held(spec);
  const double w = 1.3e-3;  // one crack of this width has a quarter of this force
  held.move([&](int i) { return i * w; });
  verify({"layer", "cracks of 1.3 mm in every joint, l = 0.19 m: force", "N/m",
          kE * kArea * w / kBreadth, 0.02, "the ends of the column are 10 l away"},
         held.force(19));
}

TEST(Layers, fibres_break_at_their_strength_and_release_what_they_stored) {
  ModelSpec spec = column(20, kBreadth);
  spec.layer[0].fibres.strength = 0.5 * kDetaches / kArea;
  Held held(spec);
  held.open(9, 1.5e-3, 800);
  verify({"layer", "one crack, weak fibres: largest force", "N/m", 0.5 * kDetaches, 0.01,
          "the force is read every 2 um of the crack"},
         held.peak());
  EXPECT_EQ(held.force(), 0);
  const std::vector<LayerReading> nodes = held.read();
  int broken = 0;
  for (const LayerReading& node : nodes) broken += node.broken ? 1 : 0;
  EXPECT_EQ(broken, 2);  // one place in each of two strands
  // the bond goes back to rest: what was stored in it is gone
  EXPECT_LT(held.stored(), 1e-3 * held.lost());
}

TEST(Layers, strain_at_rupture_is_strength_over_youngs_modulus) {
  ModelSpec spec = column(2, kBreadth);
  spec.layer[0].fibres.strength = kUnset;
  spec.layer[0].fibres.strain_at_rupture = 0.01;
  EXPECT_DOUBLE_EQ(compile(spec).layers.strength[0], 0.01 * kE * kArea * kBreadth / 2);
}

TEST(Layers, a_layer_shorter_than_its_bond_asks_for_slides_off_at_its_bond_strength) {
  ModelSpec spec = column(2, kBreadth);
  spec.layer[0].bond.slip = 10e-3;  // l = 0.93 m, ten times a block
  Held held(spec);
  held.open(0, 0.06, 300);
  const double strength = std::log(2.0) / 10e-3 * kEnergy / 2;  // B G / 2
  verify({"layer", "a layer of 0.1 m on each side: largest force", "N/m", strength * kBreadth, 0.01,
          "slip differs along the bond by (L/l)^2/2 of itself: 0.6 %"},
         held.peak());
  EXPECT_LT(held.force(), 0.5 * held.peak());
}

TEST(Layers, closing_and_opening_again_costs_nothing_and_comes_back_to_the_same_force) {
  Held held(column(20, kBreadth));
  held.open(9, 1e-3);
  const double force = held.force(), lost = held.lost();
  held.open(9, 0.8e-3);
  EXPECT_LT(held.force(), 0.95 * force);
  held.open(9, 0);
  EXPECT_NEAR(held.force(), 0, 1e-6 * force);
  EXPECT_LT(held.stored(), 1e-9 * lost);
  held.open(9, 1e-3);
  EXPECT_NEAR(held.force(), force, 1e-3 * force);
  EXPECT_NEAR(held.lost(), lost, 1e-3 * lost);
}

TEST(Layers, two_faces_are_twice_one) {
  ModelSpec spec = column(20, kBreadth);
  Held one(spec);
  spec.layer[0].sides = 2;
  Held two(spec);
  for (Held* held : {&one, &two}) held->open(9, 0.7e-3);
  EXPECT_DOUBLE_EQ(two.force(), 2 * one.force());
  EXPECT_NEAR(two.lost(), 2 * one.lost(), 1e-12 * two.lost());  // sums of many steps
}

// The whole run: the column is pulled in two by its uppermost block.
TEST(Layers, a_column_that_is_pulled_apart_keeps_its_ledger) {
  ModelSpec spec = column(20, kBreadth);
  for (int k = 10; k < 20; ++k) spec.block[k].material = "upper";
  JointMaterial weak = scenes::dry_joint(2e10, 1e10, 0.5);
  spec.material["weak"] = weak;
  spec.contact = {{{"masonry", "upper"}, "weak"}};
  StageSpec pull = scenes::push_stage("b19", Direction::kPlusY, 4e-3, 4e-3);
  pull.damping = 0.3;
  spec.stage = {scenes::gravity_stage(), pull};
  const Model model = compile(spec);
  State state = initial_state(model);
  const Result r = solve(model, state);
  ASSERT_EQ(r.status, SolveStatus::kCompleted);
  EXPECT_LT(r.energy.gap_ratio, 0.01);
  double most = 0;
  for (const CurveRow& row : r.curve) most = std::max(most, row.reaction);
  verify({"layer", "a column pulled apart at a dry joint: largest force", "N", kDetaches * kBreadth,
          0.02, "nodes follow the pull of 4 mm/s by some hundred steps"},
         most);
  const double give = most / (kThick * kBreadth * 2e10) * 19, w = 4e-3 - give;  // elastic joints
  const double work = kDetaches * (w - 2 / kRate * (1 - std::exp(-kRate * w / 2))) * kBreadth;
  EXPECT_NEAR(r.energy.drive, work + 0.5 * most * give, 0.03 * r.energy.drive);
  EXPECT_NEAR(r.energy.fracture, lost_at(w), 0.04 * lost_at(w));
  ASSERT_EQ(r.strengthening.layer_uses.size(), 1U);
  EXPECT_NEAR(r.strengthening.layer_uses[0].use, kDetaches / (kStrong * kArea), 0.02);
  // s' = P1/(E A) (1 - exp(-B s)) along the strand, so exp(B s) - 1 fades over l; off is where 95 % of G is spent
  const double off = -std::log(1 - std::sqrt(0.95));                                   // B s there
  const double each = kDecay * std::log(std::expm1(kRate * w / 2) / std::expm1(off));  // side
  const double node = kBreadth / 4, length = 20 * kBreadth;
  EXPECT_NEAR(r.strengthening.layer_uses[0].detached, 2 * each / length, 2 * node / length);
  EXPECT_GT(r.strengthening.layer_uses[0].detached, 2 * node / length);
}

}  // namespace
}  // namespace wythe::verification::layers_test
