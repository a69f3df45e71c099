#include "scenes/sample_campaign.h"

#include <cmath>

#include "statistics/bootstrap.h"
#include "statistics/intervals.h"

namespace wythe::scenes {
namespace {

constexpr double kLoadHeight = 3.12;

double normal(study::RandomBits& bits) { return study::normal_quantile(bits.uniform()); }

VariableSpec variable(const std::string& name, DistributionKind kind, double mean, double cov,
                      const std::string& unit) {
  VariableSpec v;
  v.name = name, v.distribution = kind, v.mean = mean, v.cov = cov;
  v.si_unit = unit == "1" ? "1" : (unit == "deg" ? "rad" : "Pa"), v.unit = unit;
  return v;
}

InputColumn column_of(const VariableSpec& v) {
  const double to_unit = v.unit == "1" ? 1 : (v.unit == "deg" ? 180 / 3.14159265358979 : 1e-6);
  return {v.name, v.path, v.si_unit, v.unit, to_unit, 0, true};
}

std::string mode_of(double piers, double spandrel) {
  if (spandrel > 0.15) return piers > 0.6 ? "FM-3" : "FM-4";
  if (piers > 0.9) return "FM-2";
  if (piers > -0.4) return "FM-1";
  return piers > -0.7 ? "unclear" : "FM-5";
}

std::vector<CurveRow> curve_of(double peak, double at, double softening, double drop_at) {
  std::vector<CurveRow> curve;
  for (int i = 0; i <= 500; ++i) {
    const double d = 50e-3 * i / 500, x = d / at;
    double force = peak * 2 * x / (1 + x * x);
    if (x > 1) force = peak * (1 - softening * (x - 1) / (x + 3));
    if (d > drop_at) force *= 1 - 0.3 * (1 - std::exp(-(d - drop_at) / 1e-3));
    force *= 1 + 0.01 * std::sin(700 * d + 3 * x);
    curve.push_back({.time = d * 100,
                     .displacement = d,
                     .drift = d / kLoadHeight,
                     .reaction = force,
                     .base_shear = force});
  }
  return curve;
}

SampleRecord record_of(int sample, const std::vector<double>& z, study::RandomBits& bits) {
  SampleRecord record;
  record.sample = sample, record.status = "completed";
  const double spandrel = 0.5 * z[3] - z[1] + 0.3 * normal(bits);
  const std::string mode = mode_of(0.4 - z[2] + 0.3 * normal(bits), spandrel);
  const double peak = 163e3 * (1 + 0.05 * z[1] + 0.02 * z[0] + 0.012 * normal(bits));
  const bool ductile = mode == "FM-3" || mode == "FM-4" || mode == "FM-5";
  record.curve = curve_of(peak, 6e-3 * (1 + 0.1 * normal(bits)), 0.12 + 0.03 * normal(bits),
                          (ductile ? 38e-3 : 17e-3) * std::exp(0.25 * normal(bits)));
  record.responses = read_responses(record.curve);
  record.failure_mode.name = mode;
  record.failure_mode.read_at = 40e-3;
  return record;
}

}  // namespace

Campaign sample_campaign(int n, std::uint64_t seed) {
  Campaign campaign;
  campaign.study.name = "made-up wall <script>alert(1)</script>";
  campaign.study.read_modes_at = 40e-3;
  campaign.study.seed = seed;
  campaign.study.variable = {variable("fc", DistributionKind::kNormal, 3.96e6, 0.125, "MPa"),
                             variable("ft_j", DistributionKind::kLognormal, 0.15e6, 0.3, "MPa"),
                             variable("ft_u", DistributionKind::kLognormal, 0.23e6, 0.22, "MPa"),
                             variable("phi", DistributionKind::kNormal, 0.279, 0.2, "deg"),
                             variable("ratio", DistributionKind::kNormal, 0.5, 0.2, "1")};
  for (const VariableSpec& v : campaign.study.variable)
    campaign.samples.column.push_back(column_of(v));
  campaign.load_height = kLoadHeight;
  campaign.provenance = "wythe, made up";
  study::RandomBits bits(seed);
  for (int i = 0; i < n; ++i) {
    std::vector<double> z, value;
    for (const VariableSpec& v : campaign.study.variable) {
      z.push_back(normal(bits));
      const double s2 = std::log(1 + v.cov * v.cov);
      value.push_back(v.distribution == DistributionKind::kNormal
                          ? v.mean * (1 + v.cov * z.back())
                          : v.mean * std::exp(std::sqrt(s2) * z.back() - s2 / 2));
    }
    campaign.samples.value.push_back(value);
    campaign.records.push_back(record_of(i + 1, z, bits));
    campaign.records.back().inputs = value;
  }
  return campaign;
}

SampleRecord sample_record(int sample, double peak, const std::string& mode) {
  SampleRecord record;
  record.sample = sample, record.status = "completed";
  for (int i = 0; i <= 50; ++i) {
    const double d = 1e-3 * i;
    const double force = i <= 10 ? peak * i / 10 : peak * (1 - 0.5 * (i - 10) / 40);
    record.curve.push_back(
        {.displacement = d, .drift = d / kLoadHeight, .reaction = force, .base_shear = force});
  }
  record.responses = read_responses(record.curve);
  record.failure_mode.name = mode;
  record.failure_mode.read_at = 40e-3;
  return record;
}

}  // namespace wythe::scenes
