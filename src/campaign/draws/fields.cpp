// draw_fields: checks of [field.*], then for each group of correlated fields
//
//   independent normal numbers w (one stream a field) ──F──► correlated over the wall ──R──► and between
//   fields ──Phi──► u ──quantile──► a factor at each place; formulas last
//
// Theory: docs/theory/fields.md.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <numeric>
#include <optional>
#include <set>

#include "campaign/draws/correlation.h"
#include "campaign/draws/field_factor.h"
#include "campaign/draws/formula.h"
#include "campaign/draws/generator.h"
#include "campaign/draws/margin.h"
#include "campaign/draws/scatter.h"
#include "core/elementary.h"
#include "core/normal.h"
#include "core/text.h"
#include "geometry/shape.h"
#include "model/field_places.h"
#include "model/size.h"
#include "model/space/space.h"
#include "units/dimension.h"
#include "units/quantity_error.h"
#include "wythe/parts/field_notes.h"
#include "wythe/parts/study.h"

namespace wythe {
namespace {

using geometry::Assembly;

constexpr double kSame = 1e-6;       // places nearer than this are one [m]
constexpr double kMostWork = 4e9;    // operations to draw: some seconds
constexpr double kShortest = 0.2;    // of a half unit: there the correlation is exp(-5)
constexpr double kMostScatter = 10;  // cov
constexpr double kFarthest = 100;    // times the wall: its ends are correlated by 0.99

struct Field {
  std::string name;
  FieldSpec* spec = nullptr;
  FieldTarget target;
  double mean = kUnset;  // [SI]
  std::vector<FieldPlace> places;
  [[nodiscard]] bool follows() const { return !spec->formula.empty(); }
};

// The size of a wall that a field needs, in its plane or in space.
struct FieldWall {
  double half_unit = kUnset,
         course = kUnset;  // [m]; in space the side of a cube of the usual block's volume
  std::function<std::vector<FieldPlace>(const FieldTarget&)> places;
};

FieldGrid grid_of(const std::vector<FieldPlace>& places) {
  std::vector<double> x, y, z;
  for (const FieldPlace& p : places) x.push_back(p.x), y.push_back(p.y), z.push_back(p.z);
  const bool is_plane =
      std::all_of(z.begin(), z.end(), [&](double one) { return one == z.front(); });
  return is_plane ? FieldGrid(x, y, kSame) : FieldGrid(x, z, y, kSame);
}

class Checker {
 public:
  Checker(const ModelSpec& spec, const FieldWall& wall, FaultList& faults)
      : spec_(spec), wall_(wall), faults_(faults) {}

  void check(std::vector<Field>& fields) {
    for (Field& field : fields) {
      check_path(field);
      field.follows() ? check_formula(field) : check_scatter(field);
    }
    if (!faults_.empty()) return;
    for (Field& field : fields) {
      if (field.follows()) continue;
      check_extent(field);
      check_ties(field, fields);
    }
  }

 private:
  void refuse(const Field& field, const std::string& key, const std::string& value,
              const std::string& problem, const std::string& cure) {
    faults_.add({"", fmt::format("field.{}{}{}", field.name, key.empty() ? "" : ".", key), value,
                 problem, cure, 0});
  }

  void check_path(Field& field) {
    const std::string& path = field.spec->path;
    if (path.empty())
      return refuse(field, "path", "", "is missing",
                    "write e.g. path = \"material.joint.cohesion\"");
    const auto target = field_target(path);
    if (!target) {
      std::vector<std::string> names;
      for (const FieldKey& key : field_keys()) names.emplace_back(key.name);
      return refuse(field, "path", path, "has no place in the wall to differ from place to place",
                    fmt::format("write material.NAME.KEY with one of {}, or wall.unit.density",
                                joined(names, ", ")));
    }
    field.target = *target;
    field.mean = mean_of(spec_, *target);
    field.places = wall_.places(*target);
    if (!paths_.insert(path).second)
      refuse(field, "path", path, "has a field already", "leave one of the two");
    if (!target->material.empty() && !spec_.material.contains(target->material)) {
      std::vector<std::string> names;
      for (const auto& [name, material] : spec_.material) names.push_back(name);
      return refuse(field, "path", path, "names no material of the model",
                    name_advice(target->material, names));
    }
    if (field.places.empty())
      return refuse(field, "path", path,
                    target->is_density() ? "is the density of no rigid block of this wall"
                                         : "is of a material that no joint of this wall has",
                    "name a material that the wall uses");
    if (std::isnan(field.mean))
      return refuse(field, "path", path, "has no value in the model, and a field multiplies it",
                    "give it a value");
    if (!field.follows() && !(field.mean > 0 && std::isfinite(field.mean)))
      refuse(field, "path", path,
             std::isfinite(field.mean) ? "is 0 in the model, and a field multiplies it"
                                       : "is unlimited in the model: a field changes nothing",
             "give it a value above 0, or leave the field out");
  }

  void check_formula(const Field& field) {
    const FieldSpec& s = *field.spec;
    if (is_set(s.cov) || is_set(s.along) || is_set(s.across) || is_set(s.lower) ||
        is_set(s.upper) || !s.correlation.empty())
      refuse(field, "formula", s.formula, "and a scatter of its own are both given",
             "leave one out: what follows a formula varies as the fields in it");
    // its names are checked when it is evaluated, together with the fields that it may use
  }

  void check_scatter(const Field& field) {
    const FieldSpec& s = *field.spec;
    if (!is_set(s.cov))
      refuse(field, "cov", "", "is missing", "write e.g. cov = 0.3, or a formula to follow");
    if (s.distribution == DistributionKind::kEmpirical)
      refuse(field, "distribution", "empirical", "measured values are no distribution of a field",
             "fit a lognormal, Weibull or beta to them");
    const bool beta = s.distribution == DistributionKind::kBeta;
    if (beta != (is_set(s.low) && is_set(s.high)) || (!beta && (is_set(s.low) || is_set(s.high))))
      refuse(
          field, beta ? "distribution" : (is_set(s.low) ? "low" : "high"), beta ? "beta" : "",
          beta ? "needs low and high, as multiples of the mean" : "belongs to a beta distribution",
          beta ? "write e.g. low = 0.4 and high = 2" : "write lower and upper to cut off");
    const auto around = [&](double low, double high, const char* key) {
      if ((is_set(low) && !(low < 1)) || (is_set(high) && !(high > 1)))
        refuse(field, key, fmt::format("{:g}", is_set(low) && !(low < 1) ? low : high),
               "leaves out the mean, which is 1 here", "write multiples of the mean around 1");
    };
    around(s.low, s.high, is_set(s.low) && !(s.low < 1) ? "low" : "high");
    around(s.lower, s.upper, is_set(s.lower) && !(s.lower < 1) ? "lower" : "upper");
    if (beta && is_set(s.cov) && s.low < 1 && s.high > 1 &&
        s.cov * s.cov >= (1 - s.low) * (s.high - 1))
      refuse(field, "cov", fmt::format("{:g}", s.cov), "is more than low and high leave room for",
             fmt::format("write less than {:.3f}", std::sqrt((1 - s.low) * (s.high - 1))));
    if (s.cov > kMostScatter)
      refuse(field, "cov", fmt::format("{:g}", s.cov),
             fmt::format("is more than {:g}, a deviation of {:g} times the mean", kMostScatter,
                         kMostScatter),
             "write a share of the mean, e.g. cov = 0.3 for 30 %");
    check_lengths(field);
  }

  void check_lengths(const Field& field) {
    const FieldSpec& s = *field.spec;
    const bool by_place = s.by == FieldBy::kPlace;
    if (by_place && s.in_place)
      refuse(field, "in_place", "true",
             "has no meaning beside by = \"place\", whose places are correlated",
             "leave it out, or write by = \"unit\"");
    for (const auto& [key, length] : {std::pair{"along", s.along}, std::pair{"across", s.across}})
      if (by_place != is_set(length))
        refuse(field, key, "", by_place ? "is missing" : "has no meaning beside by",
               by_place ? "write the correlation length, e.g. \"0.5 m\", or by = \"joint\""
                        : "leave it out, or by");
    if (!by_place && field.target.key != nullptr && field.target.is_density() &&
        s.by == FieldBy::kJoint)
      refuse(field, "by", "joint", "a density belongs to units, not to joints",
             "write by = \"unit\"");
  }

  void check_extent(const Field& field) {
    const FieldSpec& s = *field.spec;
    if (s.by == FieldBy::kCourse && std::any_of(field.places.begin(), field.places.end(),
                                                [](const FieldPlace& p) { return p.course < 0; }))
      refuse(field, "by", "course", "some of its joints belong to no course",
             "write along and across, or by = \"joint\"");
    if (s.by != FieldBy::kPlace) return;
    const FieldGrid grid = grid_of(field.places);
    const double unit = wall_.half_unit, course = wall_.course;
    if (s.along < kShortest * unit && s.across < kShortest * course)
      refuse(
          field, "along", fmt::format("{:g} mm, across = {:g} mm", 1e3 * s.along, 1e3 * s.across),
          fmt::format("is so short, against a half unit of {:g} mm and a course of {:g} mm, that "
                      "joints are independent",
                      1e3 * unit, 1e3 * course),
          "write by = \"joint\", which says so");
    const double wide = grid.width(), high = grid.height();
    if (s.along > kFarthest * wide && s.across > kFarthest * high && field.places.size() > 1)
      refuse(
          field, "along", fmt::format("{:g} m, across = {:g} m", s.along, s.across),
          fmt::format("is so long, against the wall's {:g} x {:g} m, that all of it has one value",
                      wide, high),
          "leave the field out: a variable of the study varies the whole wall");
    if (grid.cost() > kMostWork)
      refuse(field, "", fmt::format("{} places", field.places.size()),
             fmt::format("are too many: they lie on {} columns and {} rows, which takes {:.1e} "
                         "operations, at most {:.0e} are done",
                         grid.columns(), grid.rows(), grid.cost(), kMostWork),
             "write by = \"unit\" or \"joint\"");
  }

  void check_ties(const Field& field, const std::vector<Field>& fields) {
    for (const auto& [name, tie] : field.spec->correlation) {
      const std::string key = "correlation." + name;
      const auto other =
          std::find_if(fields.begin(), fields.end(),
                       [&wanted = name](const Field& f) { return f.name == wanted; });
      if (other == fields.end() || other->name == field.name || other->follows()) {
        std::vector<std::string> names;
        for (const Field& f : fields)
          if (!f.follows() && f.name != field.name) names.push_back(f.name);
        refuse(field, key, "",
               other == fields.end()       ? "names no field"
               : other->name == field.name ? "names the field itself"
                                           : "names a field that follows a formula",
               names.empty() ? "leave it out" : name_advice(name, names));
        continue;
      }
      if (!(std::fabs(tie.gaussian) < 1))
        refuse(field, key + ".gaussian",
               is_set(tie.gaussian) ? fmt::format("{:g}", tie.gaussian) : "",
               "must be more than -1 and less than 1", "write e.g. { gaussian = 0.5 }");
      if (const auto back = other->spec->correlation.find(field.name);
          back != other->spec->correlation.end())
        refuse(field, key, "", "is given at both fields", "leave one of the two");
      const FieldSpec &a = *field.spec, &b = *other->spec;
      const bool lengths = a.by != FieldBy::kPlace ||
                           (a.along == b.along && a.across == b.across && a.kernel == b.kernel);
      if (a.in_place != b.in_place)
        refuse(field, key, "", "one of the two fields is drawn in place, the other is not",
               "write the same in_place in both");
      if (a.by != b.by || !lengths)
        refuse(field, key, "", "the two fields do not vary over the same lengths",
               "give both the same by, kernel, along and across");
    }
  }

  const ModelSpec& spec_;
  const FieldWall& wall_;
  FaultList& faults_;
  std::set<std::string> paths_;
};

// Groups of fields that are correlated, directly or through others, in the order of their names.
std::vector<std::vector<Field*>> groups_of(std::vector<Field>& fields) {
  std::vector<std::size_t> group(fields.size());
  std::iota(group.begin(), group.end(), std::size_t{0});
  const auto join = [&](std::size_t a, std::size_t b) {
    const std::size_t from = std::max(group[a], group[b]), to = std::min(group[a], group[b]);
    std::replace(group.begin(), group.end(), from, to);
  };
  for (std::size_t i = 0; i < fields.size(); ++i)
    for (const auto& [name, tie] : fields[i].spec->correlation)
      for (std::size_t k = 0; k < fields.size(); ++k)
        if (fields[k].name == name) join(i, k);
  std::vector<std::vector<Field*>> groups(fields.size());
  for (std::size_t i = 0; i < fields.size(); ++i)
    if (!fields[i].follows()) groups[group[i]].push_back(&fields[i]);
  std::erase_if(groups, [](const auto& g) { return g.empty(); });
  return groups;
}

CorrelationMatrix matrix_of(const std::vector<Field*>& group) {
  CorrelationMatrix matrix(group.size());
  for (std::size_t i = 0; i < group.size(); ++i)
    for (std::size_t k = 0; k < group.size(); ++k) {
      const auto tie = group[i]->spec->correlation.find(group[k]->name);
      if (tie != group[i]->spec->correlation.end())
        matrix.at(i, k) = matrix.at(k, i) = tie->second.gaussian;
    }
  return matrix;
}

void refuse_matrix(const std::vector<Field*>& group, const CorrelationMatrix& matrix,
                   FaultList& faults) {
  const CorrelationMatrix nearest = nearest_positive_definite(matrix);
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < group.size(); ++i)
    for (std::size_t k = i + 1; k < group.size(); ++k)
      texts.push_back(fmt::format("{} and {} gaussian = {:.3f}", group[i]->name, group[k]->name,
                                  nearest.at(i, k)));
  faults.add({"", fmt::format("field.{}.correlation", group.front()->name), "",
              "the correlations of these fields together are not positive definite",
              "the nearest that are: " + joined(texts, ", "), 0});
}

// Standard normal numbers at the places of the fields of a group, correlated over the wall.
class Waves {
 public:
  explicit Waves(const std::vector<Field*>& group) : spec_(*group.front()->spec) {
    std::vector<FieldPlace> places;
    for (const Field* field : group)
      for (const FieldPlace& p : field->places) {
        places.push_back(p);
        label_.push_back(label_of(p));
      }
    if (spec_.by == FieldBy::kPlace) {
      grid_ = grid_of(places);
      grid_->correlate(spec_.kernel, spec_.along, spec_.across);
      return;
    }
    std::vector<int> labels = label_;
    std::sort(labels.begin(), labels.end());
    labels.erase(std::unique(labels.begin(), labels.end()), labels.end());
    numbers_ = labels.size();
    for (int& label : label_)
      label =
          static_cast<int>(std::lower_bound(labels.begin(), labels.end(), label) - labels.begin());
    if (spec_.in_place) place_ = keys_of(places);
  }

  // The numbers at the places of all fields, one field after the other.
  [[nodiscard]] std::vector<double> draw(int seed, const std::string& name) const {
    if (grid_) return grid_->draw(normal_numbers(seed, name, grid_->numbers()));
    const std::vector<double> w = spec_.in_place ? normal_numbers_at(seed, name, place_)
                                                 : normal_numbers(seed, name, numbers_);
    std::vector<double> z;
    for (const int label : label_) z.push_back(w[label]);
    return z;
  }

 private:
  [[nodiscard]] int label_of(const FieldPlace& p) const {
    if (spec_.by == FieldBy::kCourse) return p.course;
    return spec_.by == FieldBy::kUnit ? p.unit : p.entity;
  }
  // A key for each label: the number of a course, else the lowest and
  // then leftmost of its joints or blocks, in hundredths of a millimetre.
  [[nodiscard]] std::vector<PlaceKey> keys_of(const std::vector<FieldPlace>& places) const {
    constexpr double kStep = 1e-5;  // [m]
    constexpr std::int64_t kNone = std::numeric_limits<std::int64_t>::max();
    const auto steps = [](double x) { return static_cast<std::int64_t>(std::llround(x / kStep)); };
    std::vector<PlaceKey> keys(numbers_, PlaceKey{kNone, kNone, kNone});
    for (std::size_t p = 0; p < places.size(); ++p) {
      PlaceKey& key = keys[label_[p]];
      const FieldPlace& at = places[p];
      key = std::min(key, spec_.by == FieldBy::kCourse
                              ? PlaceKey{at.course, 0, 0}
                              : PlaceKey{steps(at.y), steps(at.x), steps(at.z)});
    }
    return keys;
  }
  const FieldSpec& spec_;
  std::vector<PlaceKey> place_;  // of each label, where fields draw by place
  std::vector<int> label_;
  std::size_t numbers_ = 0;
  std::optional<FieldGrid> grid_;
};

VariableSpec margin_of(const FieldSpec& field, double mean) {
  VariableSpec v;
  v.distribution = field.distribution;
  v.mean = mean;
  v.cov = field.cov;
  v.low = field.low, v.high = field.high;
  v.lower = field.lower, v.upper = field.upper;
  return v;
}

// Nodes of the trapezoidal rule over the standard normal: the share below each, and its weight.
struct NormalNodes {
  std::vector<double> share, weight;
  double weights = 0;
  NormalNodes() {
    constexpr double kStep = 0.0625, kEnd = 8.25;
    for (double z = -kEnd; z <= kEnd; z += kStep) {
      share.push_back(inside(normal_share(z)));
      weight.push_back(elementary::exp(-0.5 * z * z));
      weights += weight.back();
    }
  }
};

// Mean of the p-th power of a distribution by the trapezoidal rule over the standard normal, exact to
// rounding for smooth ones.
double mean_of(const Margin& margin, int power = 1) {
  static const NormalNodes kNodes;
  double sum = 0;
  for (std::size_t k = 0; k < kNodes.share.size(); ++k) {
    const double value = margin.quantile(kNodes.share[k]);
    sum += kNodes.weight[k] * (power == 1 ? value : value * value);
  }
  return sum / kNodes.weights;
}

// The field's distribution with mean 1. Truncation would shift the mean, so the distribution
// before truncation gets another mean, the root of `miss`. The bounds stay where they are.
Margin unit_margin(const Field& field, FaultList& faults) {
  const FieldSpec& s = *field.spec;
  Margin margin(margin_of(s, 1));
  if (!is_set(s.lower) && !is_set(s.upper)) return margin;
  constexpr double kLeastKept = 1e-4, kStep = 1.02;
  const auto miss = [&](double mean) {
    try {
      margin = Margin(margin_of(s, mean));
      return margin.kept() > kLeastKept ? mean_of(margin) - 1 : kUnset;
    } catch (const std::exception&) {  // no such distribution has this mean: a beta near its end
      return kUnset;
    }
  };
  double near = 1, far = 1, far_miss = miss(1);
  const bool grows = far_miss < 0;
  while ((far_miss < 0) == grows) {
    near = far;
    far *= grows ? kStep : 1 / kStep;
    far_miss = miss(far);
    if (std::isnan(far_miss)) {
      faults.add({"", "field." + field.name + (is_set(s.upper) ? ".upper" : ".lower"), "",
                  "cuts off so much that no distribution of this kind keeps the mean",
                  "write bounds further apart", 0});
      return margin;
    }
  }
  return Margin(margin_of(s, root_between(miss, std::min(near, far), std::max(near, far))));
}

void draw_group(const std::vector<Field*>& group, FaultList& faults) {
  const CorrelationMatrix matrix = matrix_of(group);
  if (!is_positive_definite(matrix)) return refuse_matrix(group, matrix, faults);
  // rows of the group's matrix: the share of each earlier field's stream
  std::vector<std::vector<double>> share(group.size(), std::vector<double>(group.size(), 0.0));
  for (std::size_t i = 0; i < group.size(); ++i)
    for (std::size_t k = 0; k <= i; ++k) {
      double rest = matrix.at(i, k);
      for (std::size_t m = 0; m < k; ++m) rest -= share[i][m] * share[k][m];
      share[i][k] = k == i ? std::sqrt(rest) : rest / share[k][k];
    }
  const Waves waves(group);
  std::vector<std::vector<double>> wave;
  for (const Field* field : group) wave.push_back(waves.draw(field->spec->seed, field->name));
  std::size_t first = 0;
  for (std::size_t i = 0; i < group.size(); ++i) {
    const Field& field = *group[i];
    FieldSpec& spec = *field.spec;
    spec.drawn.assign(field.places.size(), 1.0);
    if (spec.cov > 0) try {
        const Margin margin = unit_margin(field, faults);
        for (std::size_t p = 0; p < field.places.size(); ++p) {
          double z = 0;
          for (std::size_t k = 0; k <= i; ++k) z += share[i][k] * wave[k][first + p];
          spec.drawn[p] = margin.quantile(inside(normal_share(z)));
        }
      } catch (const std::exception&) {
        faults.add({"", "field." + field.name + ".cov", fmt::format("{:g}", spec.cov),
                    "leaves no distribution of this kind that can be computed",
                    "write a smaller cov, bounds further apart, or another distribution", 0});
      }
    first += field.places.size();
  }
}

void follow(const Field& field, const std::vector<Field>& fields, FaultList& faults) {
  const auto refuse = [&](const std::string& problem, const std::string& cure) {
    faults.add({"", "field." + field.name + ".formula", field.spec->formula, problem, cure, 0});
  };
  std::vector<std::string> names;
  for (const Field& other : fields)
    if (!other.follows() && other.target.material == field.target.material &&
        other.target.is_density() == field.target.is_density())
      names.push_back(other.name);
  try {
    const Formula formula(field.spec->formula, names);
    std::vector<const Field*> of;
    std::map<std::string, Dimension> known;
    for (const Field& other : fields) known[other.name] = dimension_of(other.target.key->si_unit);
    for (const std::string& name : formula.inputs())
      of.push_back(&*std::find_if(fields.begin(), fields.end(),
                                  [&wanted = name](const Field& f) { return f.name == wanted; }));
    if (of.empty())
      return refuse("names no field, so that nothing varies", "name one: " + joined(names, ", "));
    const Dimension found = formula.dimension(known);
    if (found != dimension_of(field.target.key->si_unit))
      return refuse(fmt::format("gives {}, but {} is in {}", found.words(), field.spec->path,
                                field.target.key->si_unit),
                    fmt::format("make it a formula in {}", field.target.key->si_unit));
    field.spec->drawn.clear();
    std::vector<double> inputs(of.size());
    for (std::size_t p = 0; p < field.places.size(); ++p) {
      for (std::size_t k = 0; k < of.size(); ++k) inputs[k] = of[k]->mean * of[k]->spec->drawn[p];
      field.spec->drawn.push_back(formula.value(inputs));
    }
  } catch (const FormulaError& error) {
    refuse(error.what(), error.cure());
  } catch (const QuantityError& error) {
    refuse(error.problem(), error.cure());
  }
}

std::optional<FieldWall> plane_wall(const ModelSpec& spec) {
  FaultList faults;
  const auto assembly = std::make_shared<const Assembly>(geometry::build_assembly(spec, faults));
  if (!faults.empty()) return std::nullopt;
  return FieldWall{
      assembly->report.half_unit, assembly->report.course,
      [&spec, assembly](const FieldTarget& of) { return field_places(spec, *assembly, of); }};
}

std::optional<FieldWall> space_wall(const ModelSpec& spec) {
  FaultList faults;
  const auto assembly =
      std::make_shared<const geometry::SpaceAssembly>(assemble_space(spec, faults));
  if (!faults.empty()) return std::nullopt;
  std::vector<double> volume;
  for (std::size_t k = 0; k < assembly->body.size(); ++k)
    if (!assembly->body[k].fixed) volume.push_back(assembly->moments[k].volume);
  if (volume.empty()) return std::nullopt;
  const auto middle = volume.begin() + static_cast<std::ptrdiff_t>(volume.size() / 2);
  std::nth_element(volume.begin(), middle, volume.end());
  const double side = elementary::cbrt(*middle);
  return FieldWall{side, side, [&spec, assembly](const FieldTarget& of) {
                     return field_places(spec, *assembly, of);
                   }};
}

}  // namespace

void draw_fields(ModelSpec& spec) {
  if (spec.field.empty() && !spec.scatter.is_asked()) return;
  FaultList elsewhere;
  check_size(spec, elsewhere);
  if (!elsewhere.empty()) return;
  const std::optional<FieldWall> wall = spec.body.empty() ? plane_wall(spec) : space_wall(spec);
  if (!wall) return;  // reported when the model is compiled
  FaultList faults;
  study::add_scatter(
      spec,
      [&](const std::string& path) {
        const auto target = field_target(path);
        return target && !wall->places(*target).empty();
      },
      faults);
  faults.throw_if_any();
  std::vector<Field> fields;
  for (auto& [name, field] : spec.field) fields.push_back({name, &field, {}, kUnset, {}});
  Checker(spec, *wall, faults).check(fields);
  faults.throw_if_any();
  for (const std::vector<Field*>& group : groups_of(fields)) draw_group(group, faults);
  faults.throw_if_any();
  for (const Field& field : fields)
    if (field.follows()) follow(field, fields, faults);
  faults.throw_if_any();
  const std::uint64_t shape = geometry::shape_key(spec);
  for (auto& [name, field] : spec.field) field.drawn_for = shape;
}

std::vector<Message> notes_of_fields(const ModelSpec& spec) {
  constexpr double kTold = 0.01;  // of the cov that was asked for
  std::vector<Message> notes;
  for (const auto& [name, field] : spec.field) {
    const double cov = cov_of(field);
    if (field.cov > 0 && std::fabs(cov - field.cov) > kTold * field.cov)
      notes.push_back(
          {"field.cut",
           {{"field", name}, {"cov_percent", 100 * cov}, {"asked_percent", 100 * field.cov}}});
  }
  for (Message& note : study::notes_of_scatter(spec)) notes.push_back(std::move(note));
  return notes;
}

double cov_of(const FieldSpec& field) {
  if (!field.formula.empty() || !(field.cov > 0)) return field.formula.empty() ? 0 : kUnset;
  if (!is_set(field.lower) && !is_set(field.upper)) return field.cov;
  FieldSpec copy = field;
  FaultList faults;
  const Margin margin = unit_margin(Field{"", &copy, {}, kUnset, {}}, faults);
  const double mean = mean_of(margin);
  return faults.empty() ? std::sqrt(std::max(0.0, mean_of(margin, 2) - mean * mean)) / mean
                        : kUnset;
}

}  // namespace wythe
