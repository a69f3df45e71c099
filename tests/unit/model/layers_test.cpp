// Layers: strands and nodes on the masonry, refusals, and the results of a run.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "contact/layer.h"
#include "scenes/scenes.h"
#include "wythe/parts/error.h"
#include "wythe/parts/io.h"
#include "wythe/parts/limit.h"
#include "wythe/parts/reading.h"
#include "wythe/parts/solve.h"

namespace wythe::layers_test {
namespace {

// 8 x 8 half units of 0.155 m x 0.11 m, a hole of 2 x 2 in the middle.
ModelSpec wall() {
  ModelSpec spec = scenes::half_units({}, scenes::paper_joint());
  LayerSpec layer;
  layer.sides = 2;
  layer.fibres.horizontal = 23e-6, layer.fibres.vertical = 46e-6;
  layer.fibres.youngs_modulus = 72e9, layer.fibres.strength = 1e9;
  layer.bond.energy = 400, layer.bond.slip = 1e-3;  // fades over 0.09 m and 0.07 m
  spec.layer = {layer};
  spec.stage = {scenes::gravity_stage()};
  return spec;
}

std::string refused(const ModelSpec& spec) {
  try {
    (void)compile(spec);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}
void expect_says(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << part << " is not in: " << text;
}

TEST(Layers, bond_energy_is_the_area_under_its_stress) {
  const contact::LayerBond bond{3.0, 2000.0};
  double area = 0, slip = 0;
  const double step = 1e-7;
  for (; slip < 8e-3; slip += step)
    area += step * contact::bond_secant(bond, slip + step / 2) * (slip + step / 2);
  EXPECT_NEAR(area, 3.0, 1e-5);
  EXPECT_NEAR(contact::bond_secant(bond, 0), 2 * 3.0 * 2000 * 2000, 1e-3);
  // the greatest force is B G / 2, at ln 2 / B
  const double peak = std::log(2.0) / 2000;
  EXPECT_NEAR(contact::bond_secant(bond, peak) * peak, 0.5 * 3.0 * 2000, 1e-9);
  // series and exponential meet
  EXPECT_NEAR(contact::mean_of_decay(0.9999999e-3), contact::mean_of_decay(1.0000001e-3), 3e-10);
  // lost and stored are all that was spent
  const double secant = contact::bond_secant(bond, 7e-4);
  EXPECT_NEAR(contact::bond_lost(bond, secant, 7e-4) + 0.5 * secant * 7e-4 * 7e-4,
              3.0 * contact::bond_spent(bond, 7e-4), 1e-12);
}

TEST(Layers, a_strand_runs_in_each_course_and_half_unit_and_ends_at_an_opening) {
  const Model m = compile(wall());
  const Layers& l = m.layers;
  // 8 courses, two of which have strands on both sides of the hole; 8 half units likewise
  EXPECT_EQ(*std::max_element(l.strand.begin(), l.strand.end()) + 1, 8 + 2 + 8 + 2);
  // between n half units n - 1 crossings: six courses of 8, two of 3 + 3; likewise upright
  EXPECT_EQ(l.cross_a.size(), 2U * (6 * 7 + 2 * (2 + 2)));
  double level = 0, upright = 0;
  for (int k = 0; k < l.n; ++k) {
    const auto i = static_cast<std::size_t>(k);
    EXPECT_EQ(l.stiffness[i] == 0, k + 1 == l.n || l.strand[i + 1] != l.strand[i]);
    if (l.crossing[i] < 0 || l.span_x[i] < 0.01) continue;
    if (std::fabs(l.x[i] - 0.155 * 0.75) < 0.04) level += l.strength[i] / 1e9;
  }
  for (std::size_t i = 0; i < l.a.size(); ++i)
    if (l.crossing[i] >= 0 && l.span_y[i] > 0.01 && l.y[i] < 0.11) upright += l.strength[i] / 1e9;
  EXPECT_NEAR(level, 2 * 23e-6 * 8 * 0.11, 1e-9);     // all level fibres over the first head joint
  EXPECT_NEAR(upright, 2 * 46e-6 * 8 * 0.155, 1e-9);  // all upright ones over the first bed
}

TEST(Layers, a_rectangle_takes_the_fibres_within_it) {
  ModelSpec spec = wall();
  spec.layer[0].fibres.horizontal = 0;
  spec.layer[0].x = 0.155, spec.layer[0].width = 0.31, spec.layer[0].y = 0.05,
  spec.layer[0].height = 0.23;
  const Layers l = compile(spec).layers;
  EXPECT_EQ(l.cross_a.size(), 2U * 2);  // two strands over the beds at 0.11 and 0.22 m
  double length = 0;
  for (const double part : l.length) length += part;
  EXPECT_NEAR(length, 2 * 0.23, 1e-12);
  EXPECT_NEAR(*std::min_element(l.x.begin(), l.x.end()), 1.5 * 0.155, 1e-12);
}

TEST(Layers, nodes_further_apart_than_the_bond_asks_for_get_more_slip) {
  ModelSpec spec = wall();
  spec.layer[0].bond.slip = 0.02e-3;  // fades over 2 mm
  const Model m = compile(spec);
  const Layers& l = m.layers;
  for (std::size_t k = 0; k < l.a.size(); ++k) {
    const double decay = std::sqrt(72e9 * (l.span_x[k] > 0 ? 23e-6 : 46e-6) / 800) / l.bond_rate[k];
    EXPECT_NEAR(decay, l.length[k] / 2, 1e-12);
  }
  bool said = false;
  for (const Message& note : m.anatomy.notes)
    said = said || text_of(note).find("its slip at the greatest bond stress is taken as") == 9;
  EXPECT_TRUE(said);
}

TEST(Layers, what_no_layer_can_be_is_refused_by_name) {
  const auto with = [](auto change) {
    ModelSpec spec = wall();
    change(spec, spec.layer[0]);
    return refused(spec);
  };
  expect_says(with([](auto&, LayerSpec& l) { l.sides = 3; }), "layer.0.sides");
  expect_says(with([](auto&, LayerSpec& l) { l.sides = 0; }), "must be 1 or 2");
  expect_says(with([](auto&, LayerSpec& l) { l.fibres.horizontal = l.fibres.vertical = 0; }),
              "has no fibres");
  expect_says(with([](auto&, LayerSpec& l) { l.fibres.youngs_modulus = kUnset; }),
              "layer.0.fibres.youngs_modulus");
  expect_says(with([](auto&, LayerSpec& l) { l.fibres.youngs_modulus = -72e9; }), "-72 GPa");
  expect_says(with([](auto&, LayerSpec& l) { l.fibres.strength = kUnset; }),
              "strain_at_rupture = 0.014");
  expect_says(with([](auto&, LayerSpec& l) { l.fibres.strain_at_rupture = 0.02; }),
              "contradicts strain_at_rupture");
  expect_says(with([](auto&, LayerSpec& l) { l.bond.energy = 0; }), "layer.0.bond.energy");
  expect_says(with([](auto&, LayerSpec& l) { l.bond.slip = kUnset; }), "layer.0.bond.slip");
  expect_says(with([](auto&, LayerSpec& l) { l.x = 3; }), "reaches out of the masonry");
  expect_says(with([](auto&, LayerSpec& l) { l.height = 3; }), "goes from 0 to 0.88 m");
  expect_says(
      with([](auto&, LayerSpec& l) { l.x = 0.01, l.y = 0.01, l.width = 0.1, l.height = 0.08; }),
      "crosses no joint");
  expect_says(with([](ModelSpec& s, LayerSpec&) {
                s.layer.push_back(s.layer[0]);
                s.layer[1].name = "1";
              }),
              "is the name of another layer");
  expect_says(with([](ModelSpec& s, LayerSpec&) { s.solve.contacts = Contacts::kFree; }),
              "does not know layers yet");
  expect_says(with([](ModelSpec& s, LayerSpec&) {
                s.material["joint"] = scenes::dry_joint(20e9, 8e9, 0.6);
              }),
              "lies on dry joints");
}

TEST(Layers, a_wall_in_space_refuses_them) {
  ModelSpec spec = scenes::in_space(
      {scenes::box("low", {0, 0, 0}, {1, 1, 1}, true), scenes::box("high", {0, 1, 0}, {1, 1, 1})},
      scenes::paper_joint());
  spec.stage = {scenes::gravity_stage()};
  spec.layer = wall().layer;
  expect_says(refused(spec), "layer");
}

TEST(Layers, limit_analysis_refuses_them_by_name) {
  ModelSpec spec = wall();
  spec.layer[0].name = "east";
  const Model model = compile(spec);
  try {
    (void)limit_load(model, {}, {});
    FAIL() << "taken";
  } catch (const InputError& error) {
    expect_says(error.what(), "east");
  }
}

TEST(Layers, a_run_says_what_they_bore) {
  const Model model = compile(scenes::layered(scenes::small_wall(0.1e-3, 0.05)));
  State state = initial_state(model);
  const Result r = solve(model, state);
  ASSERT_EQ(r.strengthening.layer_uses.size(), 2U);
  EXPECT_EQ(r.strengthening.layer_uses[0].use, 1);  // fibres break
  EXPECT_GT(r.strengthening.layer_uses[0].broken, 0);
  EXPECT_GT(r.strengthening.layer_uses[1].detached, 0);
  EXPECT_LT(r.strengthening.layer_uses[1].use, 1);
  EXPECT_EQ(r.strengthening.layer_rows.size(), 2 * r.curve.size());
  EXPECT_LT(r.energy.gap_ratio, 0.01);
  expect_says(text_of(sentence_of(r.strengthening.layer_uses[0], "both")), "layer both: ");
  EXPECT_EQ(text_of(sentence_of(LayerUse{}, "2")), "layer 2 carries nothing");
  LayerUse use;
  use.use = 0.734, use.displacement = 8.1e-3, use.detached = 0.042;
  use.where = {"place.in_wall", {{"x_m", 1.2}, {"y_m", 0.55}}};
  EXPECT_EQ(text_of(sentence_of(use, "east")),
            "layer east: use 0.73 at (1.20, 0.55) m and 8.1 mm, 4.2 % detached");
  use.breaks_at = 6e-3, use.broken = 0.25;
  EXPECT_EQ(text_of(sentence_of(use, "east")),
            "layer east: fibres break from 6.0 mm on, at (1.20, 0.55) m first; at the end 25 % of "
            "its strands are broken, 4.2 % is detached");
}

}  // namespace
}  // namespace wythe::layers_test
