// Before and after: compares each change of a model with the model before, for each way of pushing, and with limits.
//
// A change is the geometric mean of after / before over pairs of walls. It is within its limits
// if its whole interval is. With bounds, lost pairs or too few pairs there is no answer, nor for a displacement that a slower
// push may change. A change after which a wall falls before it resists is not within them.
// Called by write_models (api); theory: docs/theory/statistics.md, "Before and after".
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "judge/modes/mode_names.h"
#include "statistics/intervals.h"
#include "wythe/parts/comparison.h"
#include "wythe/parts/result.h"

namespace wythe {
namespace {

constexpr double kSameTo = 1e-6;  // a smaller relative difference is none

// --- one change ------------------------------------------------------------------------------------

int severity(ChangeAnswer answer) {
  switch (answer) {
    case ChangeAnswer::kYes: return 0;
    case ChangeAnswer::kNotShown: return 1;
    case ChangeAnswer::kNotKnown: return 2;
    case ChangeAnswer::kNo: return 3;
  }
  return 2;
}

// Possible ratios of a change: its interval, without an end where the change itself is a bound.
Interval reach_of(const Change& change) {
  const bool has_interval = !std::isnan(change.ratio.interval.low);
  const double low = has_interval ? change.ratio.interval.low : change.ratio.value;
  const double high = has_interval ? change.ratio.interval.high : change.ratio.value;
  return {change.at_most ? 0 : low, change.at_least ? kInfinity : high};
}

ChangeAnswer answer_of(const Change& change, double least, double most) {
  const Interval reach = reach_of(change);
  const double low = least * (1 - kSameTo);
  const double high = std::isnan(most) ? kInfinity : most * (1 + kSameTo);
  if (reach.low >= low && reach.high <= high) return ChangeAnswer::kYes;
  if (reach.high < low || reach.low > high) return ChangeAnswer::kNo;
  return ChangeAnswer::kNotShown;
}

// Distance of a change from its nearest limit, as a logarithm; negative beyond the limit.
double room_of(const Change& change, const CheckedChange& of) {
  const double below = std::log(change.ratio.value / of.least);
  return std::isnan(of.most) ? below : std::min(below, std::log(of.most / change.ratio.value));
}

// --- in words ---------------------------------------------------------------------------------------

double percent(double ratio) { return 100 * (ratio - 1); }

Message words_of_quantity(const std::string& quantity) {
  if (quantity == "initial_stiffness") return {"compare.of_stiffness"};
  return {quantity == "peak_reaction" ? "compare.of_strength" : "compare.of_displacement"};
}

Message words_of_limit(const CheckedChange& of) {
  const double share = 100 * (1 - of.least);
  if (!std::isnan(of.most)) return {"compare.limit_both", {{"percent", share}}};
  if (share == 0) return {"compare.limit_none"};
  return {"compare.limit_fall", {{"percent", share}}};
}

Message words_of_answer(ChangeAnswer answer) {
  switch (answer) {
    case ChangeAnswer::kYes: return {"compare.answer_yes"};
    case ChangeAnswer::kNo: return {"compare.answer_no"};
    case ChangeAnswer::kNotShown: return {"compare.answer_not_shown"};
    case ChangeAnswer::kNotKnown: break;
  }
  return {"compare.answer_not_known"};
}

CheckedChange check_of(const PairedComparison& all, const std::vector<std::size_t>& options,
                       const char* quantity, std::pair<double, double> limits, bool is_default) {
  CheckedChange out{.quantity = quantity, .least = limits.first, .most = limits.second};
  out.is_default = is_default;
  for (const std::size_t k : options) {
    const OptionComparison& option = all.option[k];
    const auto response = std::find_if(option.response.begin(), option.response.end(),
                                       [&](const auto& r) { return r.quantity == quantity; });
    const int lost = static_cast<int>(option.lost.size()) + option.not_run;
    Change change = change_of(*response, lost, out.least, out.most);
    // The wall before answers and the changed one falls before it resists: a strength of nothing, not an unknown one.
    const auto falls = std::count_if(option.lost.begin(), option.lost.end(), [](const LostPair& p) {
      return p.base_answered && !p.option_answered &&
             p.option_status == word_of(kSolveStatusWords, SolveStatus::kCollapsed);
    });
    if (falls > 0)
      change.answer = ChangeAnswer::kNo,
      change.why = {"compare.change_falls",
                    {{"what", words_of_quantity(quantity)},
                     {"direction", option.push.words()},
                     {"n", static_cast<int>(falls)},
                     {"all", response->pairs + response->without_value + lost}}};
    change.push = option.push;
    out.way.push_back(std::move(change));
  }
  const auto is_worse = [&](const Change& a, const Change& b) {
    if (a.answer != b.answer) return severity(a.answer) > severity(b.answer);
    return a.why.empty() && b.why.empty() && room_of(a, out) < room_of(b, out);
  };
  for (std::size_t k = 1; k < out.way.size(); ++k)
    if (is_worse(out.way[k], out.way[out.worst])) out.worst = k;
  out.answer = out.way[out.worst].answer;
  out.what = words_of_quantity(quantity), out.said = words_of_answer(out.answer);
  return out;
}

Message words_of_change(const CheckedChange& of) {
  const Change& change = of.way[of.worst];
  const Message direction = change.push.words();
  const Message what = words_of_quantity(of.quantity);
  const bool all_same =
      std::all_of(of.way.begin(), of.way.end(), [](const Change& way) { return way.is_same; });
  if (all_same) return {"compare.change_none", {{"what", what}}};
  if (change.why.code == "compare.change_falls") return change.why;
  if (!change.why.empty())
    return {"compare.change_unknown",
            {{"what", what}, {"direction", direction}, {"why", change.why}}};
  const Interval& interval = change.ratio.interval;
  const char* code = "compare.change";
  if (std::isnan(interval.low))
    code = change.at_least  ? "compare.change_one_at_least"
           : change.at_most ? "compare.change_one_at_most"
                            : "compare.change_one";
  else if (change.at_least)
    code = "compare.change_at_least";
  else if (change.at_most)
    code = "compare.change_at_most";
  return {code,
          {{"what", what},
           {"percent", percent(change.ratio.value)},
           {"low", percent(interval.low)},
           {"high", percent(interval.high)},
           {"direction", direction}}};
}

// "FM-1 in 6, unclear in 2", the most frequent first, for all ways of pushing together.
std::vector<Message> counts_of(const PairedComparison& all, const std::vector<std::size_t>& options,
                               int ModeShift::*side) {
  std::map<std::string, int> count;
  for (const std::size_t k : options)
    for (const ModeShift& shift : all.option[k].modes.shift)
      if (shift.*side > 0) count[shift.mode] += shift.*side;
  std::vector<std::pair<std::string, int>> order(count.begin(), count.end());
  std::stable_sort(order.begin(), order.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  std::vector<Message> out;
  for (const auto& [mode, n] : order)
    out.push_back({"compare.mode_count", {{"mode", study::words_of_mode(mode)}, {"n", n}}});
  return out;
}

Message words_of_modes(const PairedComparison& all, const std::vector<std::size_t>& options) {
  int pairs = 0;
  for (const std::size_t k : options) pairs += all.option[k].modes.pairs;
  if (pairs == 0) return {};
  std::vector<Message> before = counts_of(all, options, &ModeShift::base);
  std::vector<Message> after = counts_of(all, options, &ModeShift::option);
  if (before == after) return {"compare.modes_kept", {{"pairs", pairs}, {"modes", before}}};
  return {"compare.modes_moved", {{"pairs", pairs}, {"before", before}, {"after", after}}};
}

Message words_of_capacity(const ModelCapacity& capacity) {
  constexpr double kToG = 1 / kStandardGravity;
  const Interval& interval = capacity.pga.interval;
  const char* code = capacity.at_least           ? "compare.pga_at_least"
                     : std::isnan(interval.low)  ? "compare.pga_alone"
                     : std::isinf(interval.high) ? "compare.pga_open"
                                                 : "compare.pga";
  return {code,
          {{"median_g", capacity.pga.value * kToG},
           {"low_g", interval.low * kToG},
           {"high_g", interval.high * kToG}}};
}

const char* code_of(ChangeAnswer answer) {
  switch (answer) {
    case ChangeAnswer::kYes: return "compare.models_yes";
    case ChangeAnswer::kNo: return "compare.models_no";
    case ChangeAnswer::kNotShown: return "compare.models_not_shown";
    case ChangeAnswer::kNotKnown: break;
  }
  return "compare.models_not_known";
}

// How many of these pairs have a push that does not tell the failure mode; empty: none.
Message words_of_doubted_modes(const PairedComparison& all,
                               const std::vector<std::size_t>& options) {
  int doubted = 0;
  for (const std::size_t k : options) doubted += all.option[k].modes.doubted;
  return doubted > 0 ? Message{"compare.modes_doubt", {{"n", doubted}}} : Message{};
}

// Reasons for lost pairs, each once: walls that failed, fell or were refused.
void note_lost(const OptionComparison& option, const std::string& base, Intervention& out) {
  for (const LostPair& lost : option.lost)
    for (const auto& [model, reason, status] :
         {std::tuple(base, lost.base_reason, lost.base_status),
          {out.name, lost.option_reason, lost.option_status}}) {
      if (reason.empty()) continue;
      const Message note{"compare.lost_wall",
                         {{"model", model},
                          {"direction", option.push.words()},
                          {"wall", lost.sample},
                          {"status", status},
                          {"why", reason}}};
      const auto says_same = [&](const Message& known) {
        return known.code == note.code && known.arguments.front() == note.arguments.front();
      };
      if (std::none_of(out.notes.begin(), out.notes.end(), says_same)) out.notes.push_back(note);
    }
}

void put_in_words(const PairedComparison& all, Intervention& out) {
  int too_fast = 0, pairs = 0;
  bool is_same = true, is_one = true;
  for (const std::size_t k : out.option) {
    const OptionComparison& option = all.option[k];
    too_fast += option.too_fast, pairs += option.pairs;
    is_same =
        is_same && option.pairs > 0 && option.same_bits == option.pairs && option.lost.empty();
    is_one = is_one && option.pairs == 1;
    note_lost(option, all.base_name, out);
  }
  if (too_fast > 0)
    out.cautions.push_back({"compare.caution_fast", {{"pairs", too_fast}, {"all", pairs}}});
  std::vector<Message> parts;
  if (is_same) parts.push_back({"compare.models_same"});
  for (const CheckedChange& change : out.change)
    parts.push_back({"compare.models_part",
                     {{"change", words_of_change(change)},
                      {"limit", words_of_limit(change)},
                      {"answer", change.said}}});
  for (Message& modes :
       std::array{words_of_modes(all, out.option), words_of_doubted_modes(all, out.option)})
    if (!modes.empty()) parts.push_back(std::move(modes));
  if (!std::isnan(out.before.pga.value) || !std::isnan(out.after.pga.value))
    parts.push_back(
        {"compare.pga_both",
         {{"before", words_of_capacity(out.before)}, {"after", words_of_capacity(out.after)}}});
  Message said{code_of(out.answer),
               {{"option", out.name}, {"base", all.base_name}, {"parts", parts}}};
  out.sentence = out.cautions.empty() ? said
                                      : Message{"compare.models_doubtful",
                                                {{"cautions", out.cautions}, {"said", said}}};
  if (is_one) out.notes.push_back({"compare.note_one"});
  std::vector<Message> defaults;
  for (const CheckedChange& change : out.change)
    if (change.is_default) defaults.push_back(change.what);
  if (!defaults.empty()) out.notes.push_back({"compare.note_limits", {{"what", defaults}}});
}

// Keys in which the files differ, so that a slip in one of them is seen. Many follow from one: the first stand for all.
Message words_of_differences(const std::vector<std::string>& keys) {
  constexpr std::size_t kMost = 12;
  std::vector<Message> what;
  for (std::size_t k = 0; k < keys.size() && k < kMost; ++k) what.push_back(as_text(keys[k]));
  if (keys.size() > kMost)
    what.push_back({"compare.more_differences", {{"n", keys.size() - kMost}}});
  return {"compare.note_differences", {{"what", what}}};
}

Intervention intervention_of(const PairedComparison& all, const ComparedModels& models,
                             std::size_t model) {
  Intervention out{.name = models.name[model]};
  const std::size_t options = models.way.front().stores.size() - 1;
  for (std::size_t way = 0; way < models.way.size(); ++way)
    out.option.push_back(way * options + model - 1);
  const auto add = [&](const char* quantity, double asked, double usual, bool both) {
    const double share = std::isnan(asked) ? usual : asked;
    out.change.push_back(check_of(all, out.option, quantity, {1 - share, both ? 1 + share : kUnset},
                                  std::isnan(asked)));
  };
  add("initial_stiffness", models.limits.stiffness, kUsualLimits.stiffness, true);
  add("peak_reaction", models.limits.strength, kUsualLimits.strength, false);
  add("displacement_at_80_percent", models.limits.displacement, kUsualLimits.displacement, false);
  out.answer = ChangeAnswer::kYes;
  for (const CheckedChange& change : out.change)
    if (severity(change.answer) > severity(out.answer)) out.answer = change.answer;
  if (!models.capacity.empty())
    out.before = models.capacity.front(), out.after = models.capacity[model];
  put_in_words(all, out);
  if (model < models.differences.size() && !models.differences[model].empty())
    out.notes.insert(out.notes.begin(), words_of_differences(models.differences[model]));
  const auto& apart = models.other_draws;
  if (std::find(apart.begin(), apart.end(), static_cast<int>(model)) != apart.end())
    out.notes.push_back({"compare.note_draws"});
  return out;
}

}  // namespace

Change change_of(const PairedResponse& r, int lost, double least, double most) {
  Change out;
  out.pairs = r.pairs;
  const int all = r.pairs + r.without_value + lost;
  int base = 0, option = 0, same = 0;
  study::Moments logs;
  for (const PairValue& pair : r.pair) {
    base += pair.base.censored ? 1 : 0, option += pair.option.censored ? 1 : 0;
    const double a = pair.base.value, b = pair.option.value;
    if (a > 0 && b > 0) logs.add(std::log(b / a));
    same += std::fabs(b - a) <= kSameTo * std::max(std::fabs(a), std::fabs(b)) ? 1 : 0;
  }
  const int silent = all - logs.n();
  if (silent > 0 || all == 0) {
    out.why = {lost > 0 || all == 0 ? "compare.why_lost" : "compare.why_no_value",
               {{"n", silent}, {"all", all}}};
    return out;
  }
  if (base > 0 && option > 0) {
    out.why = {"compare.why_bounds", {{"before", base}, {"after", option}, {"all", all}}};
    return out;
  }
  if (r.doubted > 0) {
    out.why = {"compare.why_doubt", {{"n", r.doubted}, {"all", all}, {"why", r.doubt}}};
    return out;
  }
  out.at_least = option > 0, out.at_most = base > 0;
  out.is_same = same == all && base + option == 0;
  const Estimate mean = logs.student();
  out.ratio = {std::exp(mean.value), {std::exp(mean.interval.low), std::exp(mean.interval.high)}};
  if (out.is_same) out.ratio = {1, {1, 1}};
  if (std::isnan(out.ratio.interval.low) && all > 1) {
    out.why = {"compare.why_few", {{"pairs", all}, {"least", study::kFewestForInterval}}};
    return out;
  }
  out.answer = answer_of(out, least, most);
  return out;
}

PairedComparison compare_models(const ComparedModels& models) {
  PairedComparison all;
  for (const ComparedWay& way : models.way) {
    PairedComparison one = compare_campaigns(way.stores);
    for (OptionComparison& option : one.option) {
      option.push = way.push;
      option.base_folder = one.base_folder;
    }
    if (all.option.empty()) {
      all = std::move(one);
      continue;
    }
    for (OptionComparison& option : one.option) all.option.push_back(std::move(option));
  }
  all.base_name = models.name.front();
  for (std::size_t model = 1; model < models.way.front().stores.size(); ++model)
    all.intervention.push_back(intervention_of(all, models, model));
  return all;
}

}  // namespace wythe
