// With surrogate.cpp the only file that sees OpenTURNS; see sampling.h.
//
// Its random generator and its settings are global: used under one mutex (OpenTurnsAsDelivered).
// Every column is drawn from a seed of its own, made of the study's seed, the batch, the design and
// the variable's name, so that a variable added to a study leaves the others' samples as they were.
#include "campaign/draws/sampling.h"

#include <openturns/Beta.hxx>
#include <openturns/DistFunc.hxx>
#include <openturns/LHSExperiment.hxx>
#include <openturns/LogNormal.hxx>
#include <openturns/Normal.hxx>
#include <openturns/NormalCopula.hxx>
#include <openturns/RandomGenerator.hxx>
#include <openturns/ResourceMap.hxx>
#include <openturns/SobolSequence.hxx>
#include <openturns/Triangular.hxx>
#include <openturns/Uniform.hxx>
#include <openturns/WeibullMin.hxx>
#include <openturns/WeibullMinMuSigma.hxx>

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <numeric>
#include <utility>

#include "campaign/draws/distribution.h"
#include "core/check.h"
#include "core/elementary.h"
#include "core/hash.h"

namespace wythe {
namespace {

// Of nearest_positive_definite(), times n: rounding every entry to three digits, ranks or not, moves
// an eigenvalue by at most 5.3e-4 (n - 1).
constexpr double kLeastEigenvalue = 6e-4;
constexpr std::size_t kFewestPerColumn = 3;  // samples that make_uncorrelated() needs for each
constexpr double kLeast = 0x1p-54;  // u lies in [kLeast, 1 - kLeast]: quantiles stay finite

std::mutex& openturns_mutex() {
  static std::mutex mutex;
  return mutex;
}

// Those of OpenTURNS 1.20 that a trial of all its 590 settings found to change a number asked for here, with its
// defaults. SobolSequence-InitialSeed is a whole number.
constexpr const char* kFirstSobolPoint = "SobolSequence-InitialSeed";
constexpr std::pair<const char*, double> kSettings[] = {
    {kFirstSobolPoint, 1},
    {"Distribution-DefaultQuantileEpsilon", 1e-12},  // a Weibull of given mean and spread
    {"DualLinearCombinationEvaluation-SmallCoefficient", 0},
    {"LeastSquaresMetaModelSelection-ErrorThreshold", 0},
    {"LeastSquaresMetaModelSelection-MaximumError", 0.5},
    {"LeastSquaresMetaModelSelection-MaximumErrorFactor", 2}};

double setting(const std::string& key) {
  return key == kFirstSobolPoint ? static_cast<double>(OT::ResourceMap::GetAsUnsignedInteger(key))
                                 : OT::ResourceMap::GetAsScalar(key);
}

void set(const std::string& key, double value) {
  if (key == kFirstSobolPoint)
    OT::ResourceMap::SetAsUnsignedInteger(key, static_cast<OT::UnsignedInteger>(value));
  else
    OT::ResourceMap::SetAsScalar(key, value);
}

double inside(double u) { return std::clamp(u, kLeast, 1 - 0x1p-53); }

bool is_set(double value) { return !std::isnan(value); }

// --- distributions -------------------------------------------------------------------------------

struct Moments {
  double mean, deviation;
};

Moments moments_of(const VariableSpec& s) {
  return {s.mean, is_set(s.cov) ? s.cov * std::fabs(s.mean) : s.standard_deviation};
}

OT::Distribution make_lognormal(const VariableSpec& s) {
  if (is_set(s.median))
    return OT::LogNormal(elementary::log(s.median), s.log_standard_deviation, 0.0);
  const auto [mean, deviation] = moments_of(s);
  const double ratio = deviation / mean;
  const double spread = std::sqrt(elementary::log1p(ratio * ratio));
  return OT::LogNormal(elementary::log(mean) - 0.5 * spread * spread, spread, 0.0);
}

OT::Distribution make_uniform(const VariableSpec& s) {
  if (is_set(s.low)) return OT::Uniform(s.low, s.high);
  const auto [mean, deviation] = moments_of(s);
  return OT::Uniform(mean - std::sqrt(3.0) * deviation, mean + std::sqrt(3.0) * deviation);
}

OT::Distribution make_triangular(const VariableSpec& s) {
  if (is_set(s.low)) return OT::Triangular(s.low, s.mode, s.high);
  const auto [mean, deviation] = moments_of(s);
  const double half = std::sqrt(6.0) * deviation;
  return OT::Triangular(mean - half, mean, mean + half);
}

// alpha + beta from the variance: with x = (mean - low) / (high - low), s2 = variance / (high - low)^2
// is x (1 - x) / (alpha + beta + 1).
OT::Distribution make_beta(const VariableSpec& s) {
  if (is_set(s.alpha)) return OT::Beta(s.alpha, s.beta, s.low, s.high);
  const auto [mean, deviation] = moments_of(s);
  const double width = s.high - s.low, x = (mean - s.low) / width;
  const double sum = x * (1 - x) * width * width / (deviation * deviation) - 1;
  return OT::Beta(x * sum, (1 - x) * sum, s.low, s.high);
}

OT::Distribution make_weibull(const VariableSpec& s) {
  const double location = is_set(s.location) ? s.location : 0.0;
  if (is_set(s.shape)) return OT::WeibullMin(s.scale, s.shape, location);
  const auto [mean, deviation] = moments_of(s);
  const OT::Point p = OT::WeibullMinMuSigma(mean, deviation, location).evaluate();
  return OT::WeibullMin(p[0], p[1], p[2]);
}

OT::Distribution make_normal(const VariableSpec& s) {
  const auto [mean, deviation] = moments_of(s);
  return OT::Normal(mean, deviation);
}

// Each kind: what it takes, and how it is made; measured values are no distribution of OpenTURNS.
struct Kind {
  DistributionKind kind;
  study::DistributionForms takes;
  OT::Distribution (*make)(const VariableSpec&);
};

const Kind& kind_of(DistributionKind kind) {
  using D = DistributionKind;
  static const std::vector<Kind> kKinds = {
      {D::kNormal, {"a normal", {{"mean", "spread"}}}, make_normal},
      {D::kLognormal,
       {"a lognormal", {{"mean", "spread"}, {"median", "log_standard_deviation"}}},
       make_lognormal},
      {D::kUniform, {"a uniform", {{"low", "high"}, {"mean", "spread"}}}, make_uniform},
      {D::kTriangular,
       {"a triangular", {{"low", "mode", "high"}, {"mean", "spread"}}},
       make_triangular},
      {D::kBeta,
       {"a beta", {{"alpha", "beta", "low", "high"}, {"mean", "spread", "low", "high"}}},
       make_beta},
      {D::kWeibull,
       {"a Weibull", {{"shape", "scale"}, {"mean", "spread"}}, {"location"}},
       make_weibull},
      {D::kEmpirical, {"an empirical", {{}}}, nullptr}};
  const auto found =
      std::find_if(kKinds.begin(), kKinds.end(), [&](const Kind& k) { return k.kind == kind; });
  WYTHE_ASSERT(found != kKinds.end(), "a kind of distribution without its line");
  return *found;
}

}  // namespace

OpenTurnsAsDelivered::OpenTurnsAsDelivered() : lock_(openturns_mutex()) {
  for (const auto& [key, value] : kSettings) {
    if (!OT::ResourceMap::HasKey(key) || setting(key) == value) continue;
    before_.emplace_back(key, setting(key));
    set(key, value);
  }
}

OpenTurnsAsDelivered::~OpenTurnsAsDelivered() {
  for (const auto& [key, value] : before_) set(key, value);
}

const study::DistributionForms& study::forms_of(DistributionKind kind) {
  return kind_of(kind).takes;
}

struct Margin::Whole {
  OT::Distribution distribution;
  std::vector<double> values;  // empirical: those inside the truncation, in order
};

Margin::Margin(const VariableSpec& spec)
    : whole_(std::make_unique<Whole>()),
      lower_(is_set(spec.lower) ? spec.lower : -kInfinity),
      upper_(is_set(spec.upper) ? spec.upper : kInfinity) {
  if (spec.distribution == DistributionKind::kEmpirical) {
    const double share = 1.0 / static_cast<double>(spec.values.size());
    for (const double value : spec.values) {
      if (value < lower_)
        below_ += share;
      else if (value > upper_)
        above_ += share;
      else
        whole_->values.push_back(value);
    }
    std::sort(whole_->values.begin(), whole_->values.end());
    return;
  }
  const OpenTurnsAsDelivered held;
  whole_->distribution = kind_of(spec.distribution).make(spec);
  if (lower_ > -kInfinity) below_ = whole_->distribution.computeCDF(lower_);
  if (upper_ < kInfinity) above_ = whole_->distribution.computeComplementaryCDF(upper_);
}

double Margin::density(double x) const {
  if (!whole_->values.empty() || x < lower_ || x > upper_ || !(kept() > 0)) return 0;
  return whole_->distribution.computePDF(x) / kept();
}

Margin::~Margin() = default;
Margin::Margin(Margin&&) noexcept = default;
Margin& Margin::operator=(Margin&&) noexcept = default;

double Margin::kept() const { return std::max(0.0, 1 - below_ - above_); }

double Margin::quantile(double u) const {
  if (const std::vector<double>& values = whole_->values; !values.empty()) {
    const auto count = static_cast<double>(values.size());
    return values[std::min(values.size() - 1, static_cast<std::size_t>(u * count))];
  }
  const double p = inside(below_ + u * kept());
  return std::clamp(whole_->distribution.computeScalarQuantile(p), lower_, upper_);
}

// --- designs -------------------------------------------------------------------------------------

namespace {

// The generator takes 32 bits.
OT::UnsignedInteger folded(const Hash& hash) {
  return static_cast<OT::UnsignedInteger>((hash.value() ^ (hash.value() >> 32)) & 0xffffffffU);
}

OT::UnsignedInteger seed_of(const DesignRequest& request, const std::string& name) {
  Hash hash;
  const auto batch = static_cast<std::uint64_t>(request.batch);
  const auto design = static_cast<std::uint64_t>(request.design);
  for (const std::uint64_t part : {request.seed, batch, design}) hash.add(&part, sizeof part);
  hash.add(name);
  return folded(hash);
}

std::vector<double> stratified(std::size_t samples) {
  const OT::Sample drawn = OT::LHSExperiment(samples, true, true).generateStandard();
  std::vector<double> u(samples);
  for (std::size_t i = 0; i < samples; ++i) u[i] = inside(drawn(i, 0));
  return u;
}

std::vector<double> independent(std::size_t samples) {
  const OT::Point drawn = OT::RandomGenerator::Generate(samples);
  std::vector<double> u(samples);
  for (std::size_t i = 0; i < samples; ++i) u[i] = inside(drawn[i]);
  return u;
}

// Exclusive or of the leading 52 binary digits with those of a random number: the digital shift keeps
// the points of a net one in each elementary box, which a shift modulo 1 would not.
std::vector<double> shifted(std::vector<double> points) {
  const auto digits = [](double u) { return static_cast<std::uint64_t>(u * 0x1p52); };
  const std::uint64_t mask = digits(OT::RandomGenerator::Generate());
  for (double& u : points) u = (static_cast<double>(digits(u) ^ mask) + 0.5) * 0x1p-52;
  return points;
}

// The sequence from its first point, the origin, which OpenTURNS leaves out.
Columns sobol_points(std::size_t variables, std::size_t samples) {
  OT::SobolSequence sequence(variables);
  Columns points(variables, std::vector<double>(samples, 0.0));
  const OT::Sample drawn = sequence.generate(samples - 1);
  for (std::size_t j = 0; j < variables; ++j)
    for (std::size_t i = 1; i < samples; ++i) points[j][i] = drawn(i - 1, j);
  return points;
}

}  // namespace

int most_sobol_variables() { return static_cast<int>(OT::SobolSequence::MaximumDimension); }

Columns unit_design(const DesignRequest& request, const std::vector<std::string>& names) {
  const OpenTurnsAsDelivered held;
  const auto samples = static_cast<std::size_t>(request.samples);
  Columns points;
  if (request.design == Design::kSobol) points = sobol_points(names.size(), samples);
  points.resize(names.size());
  for (std::size_t j = 0; j < names.size(); ++j) {
    OT::RandomGenerator::SetSeed(seed_of(request, names[j]));
    switch (request.design) {
      case Design::kLatinHypercube: points[j] = stratified(samples); break;
      case Design::kMonteCarlo: points[j] = independent(samples); break;
      case Design::kSobol: points[j] = shifted(std::move(points[j])); break;
    }
  }
  return points;
}

std::vector<double> normal_numbers(int seed, const std::string& name, std::size_t count) {
  const OpenTurnsAsDelivered held;
  Hash hash;
  hash.add("field");
  hash.add(&seed, sizeof seed);
  hash.add(name);
  OT::RandomGenerator::SetSeed(folded(hash));
  std::vector<double> numbers;
  for (const double u : independent(count)) numbers.push_back(OT::DistFunc::qNormal(u));
  return numbers;
}

namespace {

// The mixer of SplitMix64: neighbouring places have nothing in common.
std::uint64_t mixed(std::uint64_t x) {
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9U;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebU;
  return x ^ (x >> 31);
}

}  // namespace

std::vector<double> normal_numbers_at(int seed, const std::string& name,
                                      const std::vector<PlaceKey>& places) {
  Hash start;
  start.add("field in place");
  start.add(&seed, sizeof seed);
  start.add(name);
  std::vector<double> numbers;
  for (const PlaceKey& place : places) {
    std::uint64_t x = mixed(start.value());
    for (const std::int64_t part : place)
      x = mixed(x + 0x9e3779b97f4a7c15U + static_cast<std::uint64_t>(part));
    numbers.push_back(OT::DistFunc::qNormal((static_cast<double>(x >> 12) + 0.5) * 0x1p-52));
  }
  return numbers;
}

double normal_share(double z) { return inside(OT::DistFunc::pNormal(z)); }

// --- correlation ---------------------------------------------------------------------------------

namespace {

OT::CorrelationMatrix foreign(const CorrelationMatrix& matrix) {
  OT::CorrelationMatrix out(matrix.n);
  for (std::size_t i = 0; i < matrix.n; ++i)
    for (std::size_t j = 0; j < i; ++j) out(i, j) = matrix.at(i, j);
  return out;
}

// The nearest symmetric matrix whose eigenvalues are at least `least`.
CorrelationMatrix with_eigenvalues_raised(const CorrelationMatrix& matrix, double least) {
  OT::SymmetricMatrix symmetric(matrix.n);
  for (std::size_t i = 0; i < matrix.n; ++i)
    for (std::size_t j = 0; j <= i; ++j) symmetric(i, j) = matrix.at(i, j);
  OT::SquareMatrix vectors;
  const OT::Point values = symmetric.computeEV(vectors);
  CorrelationMatrix out(matrix.n);
  for (std::size_t i = 0; i < matrix.n; ++i)
    for (std::size_t j = 0; j < matrix.n; ++j) {
      double sum = 0;
      for (std::size_t k = 0; k < matrix.n; ++k)
        sum += vectors(i, k) * std::max(values[k], least) * vectors(j, k);
      out.at(i, j) = sum;
    }
  return out;
}

// Rank of each value, 0 for the smallest; equal values keep their order.
std::vector<std::size_t> order_of(const std::vector<double>& values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  return order;
}

// The values of `column`, put where `scores` has the same ranks.
std::vector<double> arranged(std::vector<double> column, const std::vector<double>& scores) {
  std::sort(column.begin(), column.end());
  const std::vector<std::size_t> order = order_of(scores);
  std::vector<double> out(column.size());
  for (std::size_t k = 0; k < column.size(); ++k) out[order[k]] = column[k];
  return out;
}

// Each column less its projections on those before it, with mean 0 and mean square 1.
void make_uncorrelated(Columns& z) {
  const auto n = static_cast<double>(z.front().size());
  const auto product = [&](const std::vector<double>& a, const std::vector<double>& b) {
    return std::inner_product(a.begin(), a.end(), b.begin(), 0.0) / n;
  };
  for (std::size_t j = 0; j < z.size(); ++j) {
    const double mean = std::accumulate(z[j].begin(), z[j].end(), 0.0) / n;
    for (double& value : z[j]) value -= mean;
    for (std::size_t k = 0; k < j; ++k) {
      const double share = product(z[j], z[k]);
      for (std::size_t i = 0; i < z[j].size(); ++i) z[j][i] -= share * z[k][i];
    }
    const double size = std::sqrt(product(z[j], z[j]));
    for (double& value : z[j]) value /= size;
  }
}

// Puts the values of each column in the order of the uncorrelated ones; three times, which leaves rank
// correlations of at most 0.004 in 250 samples.
void remove_chance_correlations(Columns& u) {
  for (int round = 0; round < 3; ++round) {
    Columns order = u;
    make_uncorrelated(order);
    for (std::size_t j = 0; j < u.size(); ++j) u[j] = arranged(std::move(u[j]), order[j]);
  }
}

}  // namespace

CorrelationMatrix::CorrelationMatrix(std::size_t size) : n(size), value(size * size, 0.0) {
  for (std::size_t i = 0; i < n; ++i) at(i, i) = 1;
}

bool is_positive_definite(const CorrelationMatrix& matrix) {
  return foreign(matrix).isPositiveDefinite();
}

// Dykstra's correction is needed on the first set only: the second is a plane (Higham 2002, alg. 3.3).
CorrelationMatrix nearest_positive_definite(const CorrelationMatrix& matrix) {
  const double least = kLeastEigenvalue * static_cast<double>(matrix.n);
  CorrelationMatrix y = matrix, correction = matrix;
  std::fill(correction.value.begin(), correction.value.end(), 0.0);
  for (int round = 0; round < 500; ++round) {
    CorrelationMatrix r = y;
    for (std::size_t k = 0; k < r.value.size(); ++k) r.value[k] -= correction.value[k];
    const CorrelationMatrix x = with_eigenvalues_raised(r, least);
    double change = 0;
    for (std::size_t k = 0; k < r.value.size(); ++k) {
      correction.value[k] = x.value[k] - r.value[k];
      change = std::max(change, std::fabs(x.value[k] - y.value[k]));
    }
    y = x;
    for (std::size_t i = 0; i < y.n; ++i) y.at(i, i) = 1;
    if (change < 1e-7) break;
  }
  return y;
}

void impose_correlation(Columns& u, const CorrelationMatrix& matrix, Design design) {
  if (u.empty()) return;
  const std::size_t n = u.front().size();
  if (design == Design::kLatinHypercube && n >= kFewestPerColumn * u.size())
    remove_chance_correlations(u);
  OT::Sample scores(n, u.size());
  for (std::size_t j = 0; j < u.size(); ++j)
    for (std::size_t i = 0; i < n; ++i) scores(i, j) = OT::DistFunc::qNormal(u[j][i]);
  const OT::NormalCopula copula(foreign(matrix));
  const auto transform = copula.getInverseIsoProbabilisticTransformation();
  for (std::size_t i = 0; i < n; ++i) {
    const OT::Point x = transform(OT::Point(scores[i]));
    for (std::size_t j = 0; j < u.size(); ++j) scores(i, j) = inside(x[j]);
  }
  for (std::size_t j = 0; j < u.size(); ++j) {
    std::vector<double> tied(n);
    for (std::size_t i = 0; i < n; ++i) tied[i] = scores(i, j);
    u[j] = design == Design::kLatinHypercube ? arranged(std::move(u[j]), tied) : tied;
  }
}

}  // namespace wythe
