// Elastic spectra against numbers by hand, N2 and its inverse.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "wythe/parts/assessment.h"

namespace wythe::spectrum_test {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kRound = 1e-12;  // relative: a few operations in double

SpectrumSpec en(const std::string& ground, const std::string& shape, double ag) {
  SpectrumSpec spec;
  spec.kind = SpectrumKind::kEn1998;
  spec.ground_acceleration = ag, spec.ground = ground, spec.shape = shape;
  return spec;
}

// --- spectra

constexpr const char* kGrounds[] = {"A", "B", "C", "D", "E"};

TEST(Spectrum, of_en_1998_type_1_on_ground_b_has_its_values_at_the_corners) {
  const ElasticSpectrum s = spectrum_of(en("B", "1", 2.0));
  EXPECT_DOUBLE_EQ(s.peak_ground_acceleration(), 2.4);
  EXPECT_DOUBLE_EQ(s.acceleration(0), 2.4);
  EXPECT_NEAR(s.acceleration(0.075), 0.5 * (2.4 + 6.0), 6 * kRound);  // half way to TB
  EXPECT_NEAR(s.acceleration(0.15), 6.0, 6 * kRound);
  EXPECT_NEAR(s.acceleration(0.5), 6.0, 6 * kRound);
  EXPECT_NEAR(s.acceleration(1.0), 3.0, 6 * kRound);
  EXPECT_NEAR(s.acceleration(2.0), 1.5, 6 * kRound);
  EXPECT_NEAR(s.acceleration(4.0), 6.0 * 0.5 * 2.0 / 16, 6 * kRound);
  EXPECT_NEAR(s.displacement(1.0), 3.0 / (4 * kPi * kPi), kRound);
}

TEST(Spectrum, of_en_1998_has_the_corners_and_soil_factors_of_both_types) {
  const double kS[2][5] = {{1.0, 1.2, 1.15, 1.35, 1.4}, {1.0, 1.35, 1.5, 1.8, 1.6}};
  const double kTC[2][5] = {{0.4, 0.5, 0.6, 0.8, 0.5}, {0.25, 0.25, 0.25, 0.3, 0.25}};
  for (int type = 1; type <= 2; ++type)
    for (int g = 0; g < 5; ++g) {
      const ElasticSpectrum s = spectrum_of(en(kGrounds[g], std::to_string(type), 1));
      EXPECT_EQ(s.soil, kS[type - 1][g]);
      EXPECT_EQ(s.TC, kTC[type - 1][g]);
      EXPECT_EQ(s.TD, type == 1 ? 2.0 : 1.2);
      EXPECT_LT(s.TB, s.TC);
    }
}

TEST(Spectrum, is_continuous_at_its_corners_and_lower_with_damping) {
  for (const SpectrumKind kind : {SpectrumKind::kEn1998, SpectrumKind::kNtc2018}) {
    SpectrumSpec spec = en("D", "1", 1.3);
    spec.kind = kind, spec.amplification = 2.5, spec.corner_period = 0.35, spec.damping = 0.1;
    const ElasticSpectrum s = spectrum_of(spec);
    EXPECT_NEAR(s.eta, std::sqrt(10.0 / 15), kRound);
    for (const double corner : {s.TB, s.TC, s.TD})
      EXPECT_NEAR(s.acceleration(corner * (1 - 1e-9)), s.acceleration(corner * (1 + 1e-9)), 1e-7);
    spec.damping = 0.5;
    EXPECT_DOUBLE_EQ(spectrum_of(spec).eta, 0.55);
  }
}

// Numbers by hand: F0 ag/g = 0.49; SS = 1.70 - 0.6 0.49 = 1.406; CC = 1.05 0.32^-0.33.
TEST(Spectrum, of_ntc_2018_on_subsoil_c_is_that_by_hand) {
  SpectrumSpec spec = en("C", "1", 0.2 * kStandardGravity);
  spec.kind = SpectrumKind::kNtc2018;
  spec.amplification = 2.45, spec.corner_period = 0.32;
  const ElasticSpectrum s = spectrum_of(spec);
  EXPECT_NEAR(s.soil, 1.406, kRound);
  EXPECT_NEAR(s.TC, 1.05 * std::exp(0.33 * 1.1394342831883648) * 0.32, 1e-12);
  EXPECT_NEAR(s.TB, s.TC / 3, kRound);
  EXPECT_NEAR(s.TD, 2.4, kRound);
  EXPECT_NEAR(s.acceleration(s.TB), 0.2 * kStandardGravity * 1.406 * 2.45, 1e-11);
  spec.topography = 1.2;
  EXPECT_NEAR(spectrum_of(spec).peak_ground_acceleration(), 0.2 * kStandardGravity * 1.406 * 1.2,
              1e-11);
}

TEST(Spectrum, of_ntc_2018_keeps_the_bounds_of_its_soil_factors) {
  SpectrumSpec spec;
  spec.kind = SpectrumKind::kNtc2018;
  spec.amplification = 2.5, spec.corner_period = 0.3;
  const double kLow[] = {1, 1, 1, 0.9, 1}, kHigh[] = {1, 1.2, 1.5, 1.8, 1.6};
  for (int g = 0; g < 5; ++g) {
    spec.ground = kGrounds[g];
    spec.ground_acceleration = 0.01;
    EXPECT_EQ(spectrum_of(spec).soil, kHigh[g]);
    spec.ground_acceleration = 20;
    EXPECT_EQ(spectrum_of(spec).soil, kLow[g]);
  }
}

TEST(Spectrum, of_a_table_is_straight_between_its_periods_and_unknown_beyond) {
  const ElasticSpectrum s = spectrum_of({.kind = SpectrumKind::kTable,
                                         .corner_period = 0.5,
                                         .periods = {0, 0.2, 1.0},
                                         .accelerations = {2, 5, 1}});
  EXPECT_EQ(s.peak_ground_acceleration(), 2);
  EXPECT_DOUBLE_EQ(s.acceleration(0.1), 3.5);
  EXPECT_DOUBLE_EQ(s.acceleration(0.6), 3.0);
  EXPECT_EQ(s.acceleration(1.0), 1);
  EXPECT_TRUE(std::isnan(s.acceleration(1.0001)));
}

// --- one degree of freedom

// T* = 0.2 s, so in front of TC = 0.5; or 1 s, beyond it. Fy* = 2 m*.
EquivalentSystem system_of(double period) {
  EquivalentSystem s{.mass = 1000, .participation = 1.3};
  s.stiffness = s.mass * std::pow(2 * kPi / period, 2);
  s.force = 2.0 * s.mass;
  return s;
}

TEST(N2, of_a_long_period_keeps_the_elastic_displacement) {
  const ElasticSpectrum spectrum = spectrum_of(en("B", "1", 2.0));
  const SpectralDemand d = demand_of(system_of(1.0), spectrum);
  EXPECT_NEAR(d.elastic, 3.0 / (4 * kPi * kPi), kRound);
  EXPECT_NEAR(d.q, 1.5, 1e-11);
  EXPECT_EQ(d.displacement, d.elastic);
}

TEST(N2, of_a_short_period_goes_farther_once_it_yields) {
  const ElasticSpectrum spectrum = spectrum_of(en("B", "1", 2.0));
  const EquivalentSystem s = system_of(0.2);
  const SpectralDemand d = demand_of(s, spectrum);
  EXPECT_NEAR(d.q, 3.0, 1e-11);
  EXPECT_NEAR(d.displacement, d.elastic / 3 * (1 + 2 * 0.5 / 0.2), 1e-11);
  const SpectralDemand small = demand_of(s, spectrum, 0.3);
  EXPECT_NEAR(small.q, 0.9, 1e-11);
  EXPECT_EQ(small.displacement, small.elastic);
}

TEST(N2, at_the_scale_for_a_displacement_asks_for_that_displacement) {
  for (const double period : {0.1, 0.2, 0.49, 0.5, 1.0, 3.0}) {
    const EquivalentSystem s = system_of(period);
    const ElasticSpectrum spectrum = spectrum_of(en("B", "1", 2.0));
    double before = 0;
    for (const double ductility : {0.2, 1.0, 1.7, 5.0, 20.0}) {
      const double capacity = ductility * s.yield();
      const double scale = scale_for(s, spectrum, capacity);
      EXPECT_GT(scale, before);
      EXPECT_NEAR(demand_of(s, spectrum, scale).displacement / capacity, 1, 1e-9);
      before = scale;
    }
    EXPECT_NEAR(demand_of(s, spectrum, scale_for_q(s, spectrum, 4)).q, 4, 1e-9);
  }
}

}  // namespace
}  // namespace wythe::spectrum_test
