// Checks the pairs of a study one by one, then whether their matrix is positive definite. A refusal names
// the nearest matrix that is. A given rank correlation is converted to the linear correlation of the normal
// variables behind it. If values of a variable repeat, few_values.h says which rank correlation is possible.
#include "campaign/draws/copula.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <utility>

#include "campaign/draws/few_values.h"
#include "campaign/draws/study_check.h"
#include "core/elementary.h"
#include "core/text.h"

namespace wythe {
namespace {

std::size_t variable_named(const StudySpec& study, const std::string& name) {
  const auto found = std::find_if(study.variable.begin(), study.variable.end(),
                                  [&](const VariableSpec& v) { return v.name == name; });
  return static_cast<std::size_t>(found - study.variable.begin());
}

// The correlation of the normal variables behind a pair with a given rank correlation.
RankReached correlation_behind(const StudySpec& study, const CorrelationSpec& pair) {
  return gaussian_of_rank(pair.value,
                          shares_of_values(study.variable[variable_named(study, pair.a)]),
                          shares_of_values(study.variable[variable_named(study, pair.b)]));
}

class PairCheck {
 public:
  PairCheck(const StudySpec& study, FaultList& faults) : study_(study), faults_(faults) {}

  // True when every pair is valid for the matrix.
  bool run() {
    for (std::size_t i = 0; i < study_.correlation.size(); ++i) check(i);
    return good_;
  }

 private:
  void check(std::size_t i) {
    const CorrelationSpec& pair = study_.correlation[i];
    const std::string between = fmt::format("correlation.{}.between", i);
    bool known = true;
    for (const std::string& name : {pair.a, pair.b}) known &= check_name(between, name);
    if (known && pair.a == pair.b)
      refuse(between, pair.a, "names one variable twice", "name two variables");
    const bool is_new = seen_.insert(std::minmax(pair.a, pair.b)).second;
    if (known && pair.a != pair.b && !is_new)
      refuse(between, pair.a + ", " + pair.b, "this pair has a correlation already",
             "leave one of the two");
    if (!(std::fabs(pair.value) < 1))
      refuse(fmt::format("correlation.{}.{}", i, pair.rank ? "rank" : "gaussian"),
             fmt::format("{:g}", pair.value), "must be more than -1 and less than 1",
             "write e.g. rank = 0.3");
    else if (known && pair.rank)
      check_reach(i, pair);
  }

  // With few values, not every rank correlation is possible.
  void check_reach(std::size_t i, const CorrelationSpec& pair) {
    const double within = correlation_behind(study_, pair).within;
    if (std::fabs(within) >= std::fabs(pair.value)) return;
    const double share = std::floor(100 * std::fabs(within)) / 100;
    refuse(
        fmt::format("correlation.{}.rank", i), fmt::format("{:g}", pair.value),
        fmt::format("is beyond {:.3f}, the {} that {} and {} can have: equal values share a rank",
                    within, within < 0 ? "least" : "most", pair.a, pair.b),
        fmt::format("write rank = {:g}, or closer to 0", std::copysign(share, within)));
  }

  bool check_name(const std::string& path, const std::string& name) {
    if (variable_named(study_, name) < study_.variable.size()) return true;
    std::vector<std::string> names;
    for (const VariableSpec& variable : study_.variable) names.push_back(variable.name);
    const bool dependent = std::any_of(study_.dependent.begin(), study_.dependent.end(),
                                       [&](const DependentSpec& d) { return d.name == name; });
    refuse(path, name, dependent ? "is a dependent, it follows its formula" : "is not a variable",
           dependent ? "correlate the variables it follows from" : name_advice(name, names));
    return false;
  }

  void refuse(const std::string& path, const std::string& value, const std::string& problem,
              const std::string& cure) {
    good_ = false;
    faults_.add(
        {.file = study_.file, .path = path, .value = value, .problem = problem, .cure = cure});
  }

  const StudySpec& study_;
  FaultList& faults_;
  std::set<std::pair<std::string, std::string>> seen_;
  bool good_ = true;
};

const CorrelationSpec* pair_of(const StudySpec& study, const std::string& a, const std::string& b) {
  for (const CorrelationSpec& pair : study.correlation)
    if ((pair.a == a && pair.b == b) || (pair.a == b && pair.b == a)) return &pair;
  return nullptr;
}

// The rank correlation of two variables, from the correlation `rho` of the normal variables behind them.
double rank_given_by(const StudySpec& study, const std::string& a, const std::string& b,
                     double rho) {
  return rank_of_gaussian(rho, shares_of_values(study.variable[variable_named(study, a)]),
                          shares_of_values(study.variable[variable_named(study, b)]));
}

// "ft_j and fc rank 0.873, ft_j and phi gaussian 0.112"
std::string pairs_text(const StudySpec& study, const Copula& copula) {
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < copula.variable.size(); ++i)
    for (std::size_t j = i + 1; j < copula.variable.size(); ++j) {
      const std::string& a = study.variable[copula.variable[i]].name;
      const std::string& b = study.variable[copula.variable[j]].name;
      const CorrelationSpec* stated = pair_of(study, a, b);
      const bool rank = stated ? stated->rank : study.correlation.front().rank;
      const double rho = copula.matrix.at(i, j);
      texts.push_back(fmt::format("{} and {} {} = {:.3f}", a, b, rank ? "rank" : "gaussian",
                                  rank ? rank_given_by(study, a, b, rho) : rho));
    }
  return joined(texts, ", ");
}

}  // namespace

double gaussian_of_rank(double rank) { return 2 * elementary::sin(std::numbers::pi * rank / 6); }

Copula copula_of(const StudySpec& study, bool all) {
  Copula out;
  std::vector<std::size_t> place(study.variable.size(), study.variable.size());
  for (std::size_t v = 0; v < study.variable.size(); ++v) {
    const std::string& name = study.variable[v].name;
    const bool tied =
        all || std::any_of(study.correlation.begin(), study.correlation.end(),
                           [&](const CorrelationSpec& c) { return c.a == name || c.b == name; });
    if (!tied) continue;
    place[v] = out.variable.size();
    out.variable.push_back(v);
  }
  out.matrix = CorrelationMatrix(out.variable.size());
  for (const CorrelationSpec& pair : study.correlation) {
    const std::size_t i = place[variable_named(study, pair.a)];
    const std::size_t j = place[variable_named(study, pair.b)];
    const double rho = pair.rank ? correlation_behind(study, pair).rho : pair.value;
    out.matrix.at(i, j) = out.matrix.at(j, i) = rho;
  }
  return out;
}

void check_correlation(const StudySpec& study, FaultList& faults) {
  if (study.correlation.empty() || !PairCheck(study, faults).run()) return;
  Copula copula = copula_of(study);
  if (is_positive_definite(copula.matrix)) return;
  copula.matrix = nearest_positive_definite(copula.matrix);
  faults.add({.file = study.file,
              .path = "correlation",
              .problem = "the pairs together are not a correlation matrix (not positive definite)",
              .cure = "the nearest that is one: " + pairs_text(study, copula)});
}

}  // namespace wythe
