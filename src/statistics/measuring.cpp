// The input to measure next, and Sobol indices where a surrogate predicts the
// response. Neither is given where more than one value in twenty is a lower bound.
//
// Both estimate how much of a response's variance an input explains. The first uses the samples directly, by a
// cubic of the input's ranks; an input that is correlated with others includes their share. The second needs
// independent inputs and a polynomial that predicts samples it has not seen. Equations (7.19) to (7.23) of
// docs/theory/statistics.md. References: Saltelli et al., Global Sensitivity Analysis (2008); Sudret, Reliab.
// Eng. Syst. Saf. 93 (2008); Blatman and Sudret, J. Comput. Phys. 230 (2011); Ezekiel's correction of R^2
// (1930).
#include <algorithm>
#include <cmath>
#include <set>

#include "statistics/bootstrap.h"
#include "statistics/correlation.h"
#include "statistics/intervals.h"
#include "statistics/statistics_parts.h"
#include "statistics/surrogate.h"

namespace wythe::study {
namespace {

constexpr int kHighestDegree = 9, kFolds = 5, kFewestForSurrogate = 40;
constexpr double kFewCensored = 0.05;

// Middles of n equal strata; equal values share one.
Column places_of(const Column& values) {
  Column places = ranks(values);
  for (double& r : places) r = (r - 0.5) / static_cast<double>(values.size());
  return places;
}

// Least squares on columns of terms, each sample taken count times: solves the
// normal equations by Cholesky factorisation. Empty where they are singular.
class LeastSquares {
 public:
  LeastSquares(std::vector<Column> terms, Column response)
      : term_(std::move(terms)), y_(std::move(response)) {}

  [[nodiscard]] std::vector<double> solve(const Counts& count) const {
    const std::size_t p = term_.size();
    std::vector<double> m(p * p, 0), b(p, 0), weighted(y_.size());
    for (std::size_t r = 0; r < p; ++r) {
      for (std::size_t i = 0; i < y_.size(); ++i) weighted[i] = count[i] * term_[r][i];
      for (std::size_t c = 0; c <= r; ++c)
        for (std::size_t i = 0; i < y_.size(); ++i) m[r * p + c] += weighted[i] * term_[c][i];
      for (std::size_t i = 0; i < y_.size(); ++i) b[r] += weighted[i] * y_[i];
    }
    for (std::size_t r = 0; r < p; ++r) {
      for (std::size_t c = 0; c <= r; ++c) {
        double sum = m[r * p + c];
        for (std::size_t k = 0; k < c; ++k) sum -= m[r * p + k] * m[c * p + k];
        if (r == c && !(sum > 1e-10 * m[r * p + r])) return {};
        m[r * p + c] = r == c ? std::sqrt(sum) : sum / m[c * p + c];
      }
      for (std::size_t k = 0; k < r; ++k) b[r] -= m[r * p + k] * b[k];
      b[r] /= m[r * p + r];
    }
    for (std::size_t r = p; r-- > 0;) {
      for (std::size_t k = r + 1; k < p; ++k) b[r] -= m[k * p + r] * b[k];
      b[r] /= m[r * p + r];
    }
    return b;
  }
  // Share of the variance that the terms explain; NaN where it is not defined.
  [[nodiscard]] double explained(const Counts& count) const {
    const std::vector<double> b = solve(count);
    if (b.empty()) return kUnset;
    double n = 0, sum = 0, left = 0, whole = 0;
    for (std::size_t i = 0; i < y_.size(); ++i) n += count[i], sum += count[i] * y_[i];
    for (std::size_t i = 0; i < y_.size(); ++i) {
      double error = y_[i];
      for (std::size_t r = 0; r < term_.size(); ++r) error -= b[r] * term_[r][i];
      left += count[i] * error * error;
      whole += count[i] * (y_[i] - sum / n) * (y_[i] - sum / n);
    }
    return whole > 0 ? 1 - left / whole : kUnset;
  }
  [[nodiscard]] std::size_t size() const { return term_.size(); }

 private:
  std::vector<Column> term_;
  Column y_;
};

Columns parts_of(const Resampled& part, const Columns& columns) {
  Columns taken;
  for (const Column& column : columns) taken.push_back(part.of(column));
  return taken;
}

// The explained share without the part of chance (Ezekiel).
double corrected(double explained, int n, std::size_t terms) {
  return 1 - (1 - explained) * (n - 1) / (n - static_cast<double>(terms));
}

int distinct(const Column& values) {
  return static_cast<int>(std::set<double>(values.begin(), values.end()).size());
}

LeastSquares cubic_of(const Column& input, const Column& response) {
  std::vector<Term> terms;
  for (int degree = 0; degree <= std::min(3, distinct(input) - 1); ++degree)
    terms.push_back({degree});
  return {legendre_products(terms, {places_of(input)}), response};
}

double width_of(double variance) { return 1 - std::sqrt(1 - std::clamp(variance, 0.0, 1.0)); }

void take_response(const Answered& samples, const Quantity& quantity, std::vector<Measuring>& all) {
  const Group known = with_value(all_of(samples), quantity);
  const std::vector<Reading> readings = readings_of(known, quantity);
  const Column response = values_of(readings);
  const int n = static_cast<int>(response.size());
  if (n < kFewestSamples || all_censored(known, quantity)) return;
  const int censored = bounds_in(known, quantity);
  std::vector<Measuring> made;
  std::vector<std::vector<double>> replicate;
  for (const int k : random_columns(samples.campaign.samples)) {
    const Column input = input_of(known.record, k);
    if (distinct(input) < 2) continue;
    Measuring m;
    m.quantity = key_of(quantity), m.input = samples.campaign.samples.column[k].name;
    m.n = n, m.censored = censored;
    if (!is_censored(censored, response.size())) {
      std::vector<double> values;
      m.variance = variance_taken(input, response, values);
      if (std::isnan(m.variance.value)) continue;
      replicate.push_back(std::move(values));
      m.width = {width_of(m.variance.value),
                 {width_of(m.variance.interval.low), width_of(m.variance.interval.high)}};
    }
    made.push_back(std::move(m));
  }
  for (std::size_t r = 0; !replicate.empty() && r < replicate.front().size(); ++r) {
    std::size_t best = 0;
    for (std::size_t k = 1; k < made.size(); ++k)
      if (!(replicate[k][r] <= replicate[best][r])) best = k;
    for (std::size_t k = 0; k < made.size(); ++k)
      made[k].is_best = (std::isnan(made[k].is_best) ? 0 : made[k].is_best) +
                        (k == best ? 1.0 / static_cast<double>(replicate.front().size()) : 0);
  }
  std::stable_sort(made.begin(), made.end(), [](const Measuring& a, const Measuring& b) {
    return a.variance.value > b.variance.value;
  });
  all.insert(all.end(), made.begin(), made.end());
}

// --- surrogate -------------------------------------------------------------------------------------

int degree_for(std::size_t inputs, int n) {
  double terms = 1;
  int degree = 0;
  while (degree < kHighestDegree) {
    const double next = terms * (static_cast<double>(inputs) + degree + 1) / (degree + 1);
    if (next > 0.5 * n) break;
    terms = next, ++degree;
  }
  return std::max(degree, 1);
}

// Share of the variance predicted by cross-validation: each fifth of the
// samples in turn is left out of the choice of terms and of their fit.
double predicted_share(const Columns& u, const Column& y, int degree) {
  double error = 0, whole = 0;
  const auto n = static_cast<int>(y.size());
  for (int fold = 0; fold < kFolds; ++fold) {
    Columns kept(u.size());
    Column response;
    Counts count(n, 0);
    for (int i = 0; i < n; ++i) {
      if (i % kFolds == fold) continue;
      for (std::size_t k = 0; k < u.size(); ++k) kept[k].push_back(u[k][i]);
      response.push_back(y[i]), count[i] = 1;
    }
    const std::vector<Column> terms = legendre_products(chosen_terms(kept, response, degree), u);
    const std::vector<double> b = LeastSquares(terms, y).solve(count);
    if (b.empty()) return kUnset;
    double mean = 0;
    for (const double v : response) mean += v / static_cast<double>(response.size());
    for (int i = fold; i < n; i += kFolds) {
      double left = y[i];
      for (std::size_t r = 0; r < terms.size(); ++r) left -= b[r] * terms[r][i];
      error += left * left, whole += (y[i] - mean) * (y[i] - mean);
    }
  }
  return whole > 0 ? 1 - error / whole : kUnset;
}

// First-order and total share of each input: sums of squares of the terms with this input alone, and with this input.
std::vector<std::pair<double, double>> shares_of(const std::vector<Term>& terms,
                                                 const std::vector<double>& b) {
  std::vector<std::pair<double, double>> shares(terms.front().size(), {0, 0});
  double whole = 0;
  for (std::size_t r = 1; r < terms.size(); ++r) {
    whole += b[r] * b[r];
    const auto held = std::count_if(terms[r].begin(), terms[r].end(), [](int d) { return d > 0; });
    for (std::size_t k = 0; k < shares.size(); ++k) {
      if (terms[r][k] == 0) continue;
      shares[k].second += b[r] * b[r];
      if (held == 1) shares[k].first += b[r] * b[r];
    }
  }
  for (auto& [first, total] : shares) first /= whole, total /= whole;
  return shares;
}

// The variance that the surrogate does not predict may belong to any input, so the interval includes it on both sides.
Estimate widened(double value, std::vector<double> replicates, double q2) {
  std::sort(replicates.begin(), replicates.end());
  const double left = 1 - q2;
  return {value,
          {std::max(0.0, q2 * quantile_of(replicates, 0.025) - left),
           std::min(1.0, q2 * quantile_of(replicates, 0.975) + left)}};
}

void tell_indices(const Columns& u, const Column& y, int degree, SurrogateIndices& out) {
  const std::vector<Term> terms = chosen_terms(u, y, degree);
  const LeastSquares fit(legendre_products(terms, u), y);
  const int n = static_cast<int>(y.size());
  const std::vector<double> b = fit.solve(Counts(n, 1));
  out.terms = static_cast<int>(terms.size());
  if (b.empty() || terms.size() < 2) {
    out.verdict = IndexVerdict::kUnexplained;
    return;
  }
  std::vector<std::vector<double>> first(u.size()), total(u.size());
  const Resampled part(y.size());
  const LeastSquares few =
      part.is_all() ? fit : LeastSquares(legendre_products(terms, parts_of(part, u)), part.of(y));
  const std::vector<double> b_of_few = part.is_all() ? b : few.solve(Counts(part.size(), 1));
  const auto shares = shares_of(terms, b);
  if (!b_of_few.empty()) {
    const auto centre = shares_of(terms, b_of_few);
    each_replicate(part.size(), [&](const Counts& count) {
      const std::vector<double> again = few.solve(count);
      if (again.empty()) return;
      const auto of_few = shares_of(terms, again);
      for (std::size_t k = 0; k < shares.size(); ++k) {
        first[k].push_back(part.of_all(of_few[k].first, centre[k].first, shares[k].first));
        total[k].push_back(part.of_all(of_few[k].second, centre[k].second, shares[k].second));
      }
    });
  }
  for (std::size_t k = 0; k < shares.size(); ++k) {
    out.input[k].first_order = widened(shares[k].first, first[k], out.q2);
    out.input[k].total = widened(shares[k].second, total[k], out.q2);
  }
}

}  // namespace

int bounds_in(const Group& known, const Quantity& quantity) {
  int n = 0;
  for (const SampleRecord* record : known.record)
    n += quantity.read(record->responses).censored ||
                 (std::string(quantity.name) == "peak_reaction" && is_still_rising(*record))
             ? 1
             : 0;
  return n;
}

bool is_censored(int bounds, std::size_t n) {
  return bounds > kFewCensored * static_cast<double>(n);
}

Estimate variance_taken(const std::vector<double>& input, const std::vector<double>& response,
                        std::vector<double>& replicate) {
  const LeastSquares fit = cubic_of(input, response);
  const int n = static_cast<int>(response.size());
  const double raw = fit.explained(Counts(n, 1));
  if (std::isnan(raw)) return {};
  const double value = corrected(raw, n, fit.size());
  const Resampled part(response.size());
  const int m = part.size();
  const LeastSquares few = part.is_all() ? fit : cubic_of(part.of(input), part.of(response));
  const double centre = part.is_all() ? raw : few.explained(Counts(m, 1));
  each_replicate(m, [&](const Counts& count) {
    const double again = corrected(few.explained(count), m, few.size());
    replicate.push_back(part.of_all(again, centre, raw));
  });
  if (n < kFewestForBootstrap) return {value, {}};
  std::vector<double> ascending = replicate;
  std::erase_if(ascending, [](double v) { return std::isnan(v); });
  std::sort(ascending.begin(), ascending.end());
  // for a replicate the samples are the truth, with chance included, as in (7.10)
  return {value,
          {value - (quantile_of(ascending, 0.975) - raw),
           value - (quantile_of(ascending, 0.025) - raw)}};
}

std::vector<Measuring> measurings(const Answered& whole) {
  const Answered samples = for_fits(whole);
  std::vector<Measuring> all;
  for (const char* name : {"peak_reaction", "displacement_at_80_percent", "initial_stiffness"})
    take_response(samples, quantity_named(name), all);
  return all;
}

SurrogateIndices indices_of(const Columns& inputs, const Column& response) {
  SurrogateIndices out;
  out.n = static_cast<int>(response.size());
  out.input.resize(inputs.size());
  Columns u;
  for (const Column& input : inputs) {
    u.push_back(places_of(input));
    if (2 * distinct(input) < out.n) out.verdict = IndexVerdict::kDiscrete;
  }
  if (out.n < kFewestForSurrogate) out.verdict = IndexVerdict::kFewSamples;
  if (out.verdict != IndexVerdict::kTold) return out;
  const int degree = degree_for(inputs.size(), out.n);
  out.q2 = predicted_share(u, response, degree);
  if (!(out.q2 >= kLeastQ2)) {
    out.verdict = IndexVerdict::kUnexplained;
    return out;
  }
  tell_indices(u, response, degree, out);
  return out;
}

std::vector<SurrogateIndices> surrogate_indices(const Answered& whole) {
  const Answered samples = for_fits(whole);
  std::vector<SurrogateIndices> all;
  const SampleTable& table = samples.campaign.samples;
  const auto& pairs = samples.campaign.study.correlation;
  const bool correlated = std::any_of(pairs.begin(), pairs.end(),
                                      [](const CorrelationSpec& c) { return c.value != 0; });
  for (const char* name : {"peak_reaction", "displacement_at_80_percent", "initial_stiffness"}) {
    const Quantity& quantity = quantity_named(name);
    const Group known = with_value(all_of(samples), quantity);
    const std::vector<Reading> readings = readings_of(known, quantity);
    Columns inputs;
    std::vector<std::string> names;
    for (const int k : random_columns(table)) {
      Column input = input_of(known.record, k);
      if (distinct(input) < 2) continue;
      inputs.push_back(std::move(input)), names.push_back(table.column[k].name);
    }
    if (inputs.empty() || readings.empty()) continue;
    const int censored = bounds_in(known, quantity);
    SurrogateIndices out;
    if (correlated)
      out.verdict = IndexVerdict::kCorrelated;
    else if (is_censored(censored, readings.size()))
      out.verdict = IndexVerdict::kCensored;
    else
      out = indices_of(inputs, values_of(readings));
    out.n = static_cast<int>(readings.size());
    out.quantity = key_of(quantity);
    out.input.resize(names.size());
    for (std::size_t k = 0; k < names.size(); ++k) out.input[k].input = names[k];
    all.push_back(std::move(out));
  }
  return all;
}

}  // namespace wythe::study
