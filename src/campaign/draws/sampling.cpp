// Every column has its own seed, made from the study's seed, the batch, the design and the
// variable's name. So a variable added to a study does not change the samples of the others.
#include "campaign/draws/sampling.h"

#include <boost/random/sobol.hpp>
#include <numeric>
#include <utility>

#include "campaign/draws/generator.h"
#include "core/hash.h"

namespace wythe {
namespace {

Generator generator_of(const DesignRequest& request, const std::string& name) {
  Hash hash;
  const auto batch = static_cast<std::uint64_t>(request.batch);
  const auto design = static_cast<std::uint64_t>(request.design);
  for (const std::uint64_t part : {request.seed, batch, design}) hash.add(&part, sizeof part);
  hash.add(name);
  return Generator(folded(hash));
}

// Strata in random order, with a random place in each.
std::vector<double> stratified(std::size_t samples, Generator generator) {
  std::vector<std::size_t> stratum(samples);
  std::iota(stratum.begin(), stratum.end(), std::size_t{0});
  for (std::size_t i = 0; i + 1 < samples; ++i)
    std::swap(stratum[i], stratum[i + generator.below(samples - i)]);
  std::vector<double> u(samples);
  for (std::size_t i = 0; i < samples; ++i)
    u[i] = inside((static_cast<double>(stratum[i]) + generator.uniform()) *
                  (1 / static_cast<double>(samples)));
  return u;
}

std::vector<double> independent(std::size_t samples, Generator generator) {
  std::vector<double> u(samples);
  for (double& value : u) value = inside(generator.uniform());
  return u;
}

// Exclusive or of the leading 52 binary digits with those of a random number. This digital
// shift keeps one point of a net in each elementary box, which a shift modulo 1 would not.
std::vector<double> shifted(const std::vector<std::uint64_t>& points, Generator generator) {
  const auto mask = static_cast<std::uint64_t>(generator.uniform() * 0x1p52);
  std::vector<double> u;
  for (const std::uint64_t digits : points)
    u.push_back((static_cast<double>(digits ^ mask) + 0.5) * 0x1p-52);
  return u;
}

// (n_variable, n_sample): 52 digits of the sequence of Joe and
// Kuo (2008), starting with the origin, which Boost leaves out.
std::vector<std::vector<std::uint64_t>> sobol_points(std::size_t variables, std::size_t samples) {
  std::vector<std::vector<std::uint64_t>> points(variables, std::vector<std::uint64_t>(samples, 0));
  boost::random::sobol sequence(variables);
  for (std::size_t i = 1; i < samples; ++i)
    for (std::size_t j = 0; j < variables; ++j) points[j][i] = sequence() >> 12;
  return points;
}

}  // namespace

int most_sobol_variables() {
  return static_cast<int>(boost::random::default_sobol_table::max_dimension);
}

Columns unit_design(const DesignRequest& request, const std::vector<std::string>& names) {
  const std::size_t samples = request.samples;
  std::vector<std::vector<std::uint64_t>> points;
  if (request.design == Design::kSobol) points = sobol_points(names.size(), samples);
  Columns u(names.size());
  for (std::size_t j = 0; j < names.size(); ++j) {
    Generator generator = generator_of(request, names[j]);
    switch (request.design) {
      case Design::kLatinHypercube: u[j] = stratified(samples, std::move(generator)); break;
      case Design::kMonteCarlo: u[j] = independent(samples, std::move(generator)); break;
      case Design::kSobol: u[j] = shifted(points[j], std::move(generator)); break;
    }
  }
  return u;
}

}  // namespace wythe
