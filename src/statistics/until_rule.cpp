// The stop rule of a campaign: "relative_interval(peak_reaction) < 1 % and interval(share) < 0.1".
//
//   rule    clause ["and" clause]...
//   clause  relative_interval(QUANTITY) "<" NUMBER ["%"]    half the Student interval over the mean
//           interval(share)             "<" NUMBER ["%"]    widest Wilson interval of any mode
//
// check_rule() is for reading a study, precise_enough() for the runner, after every sample.
#include <fmt/format.h>

#include <cmath>
#include <map>

#include "core/ascii.h"
#include "core/number.h"
#include "core/text.h"
#include "statistics/intervals.h"
#include "wythe/parts/statistics.h"

namespace wythe {
namespace {

constexpr const char* kExampleOfRule =
    "write e.g. relative_interval(peak_reaction) < 1 % and interval(share) < 0.1";

struct Clause {
  std::string function, argument;
  double limit = 0;
};

std::string without_blanks(std::string_view text) {
  std::string out;
  for (char c : text)
    if (!is_ascii_space(c)) out += c;
  return out;
}

// Splits at the word "and".
std::vector<std::string> clauses_of(const std::string& rule) {
  std::vector<std::string> clauses;
  std::string padded = " " + rule + " ";
  for (char& c : padded)
    if (is_ascii_space(c)) c = ' ';
  std::size_t start = 0;
  for (std::size_t at = padded.find(" and "); at != std::string::npos;
       at = padded.find(" and ", start)) {
    clauses.push_back(padded.substr(start, at - start));
    start = at + 4;  // the blank after it may begin the next word
  }
  clauses.push_back(padded.substr(start));
  return clauses;
}

struct RuleReader {
  const std::string& rule;
  FaultList& faults;

  void fault(const std::string& problem, const std::string& cure = kExampleOfRule) const {
    faults.add({.path = "until", .value = "\"" + rule + "\"", .problem = problem, .cure = cure});
  }
  static constexpr double kWidest = 1e6;
  double limit_of(const std::string& clause, const std::string& text) const {
    const LeadingNumber<double> number =
        leading_number(text).value_or(LeadingNumber<double>{0, "?"});
    const auto [value, unit] = number;
    if (!unit.empty() && unit != "%") {
      fault(fmt::format("\"{}\": after < stands a number, with or without %", clause));
    } else if (!(value > 0) || !std::isfinite(value)) {
      fault(fmt::format("\"{}\": never met, the limit must be positive", clause));
    } else if (value > kWidest) {
      fault(fmt::format("\"{}\": asks for nothing, the limit is more than {:g}", clause, kWidest));
    }
    return unit.empty() ? value : value / 100;
  }
  void check_names(const Clause& clause) const {
    std::vector<std::string> names;
    for (const Quantity& q : quantities()) names.emplace_back(q.name);
    if (clause.function == "relative_interval") {
      for (const Quantity& q : quantities())
        if (clause.argument == q.name || clause.argument == key_of(q)) return;
      fault(fmt::format("relative_interval does not know \"{}\"", clause.argument),
            name_advice(clause.argument, names));
    } else if (clause.function != "interval") {
      fault(fmt::format("no measure \"{}\"", clause.function),
            name_advice(clause.function, {"relative_interval", "interval"}));
    } else if (clause.argument != "share") {
      fault(fmt::format("interval does not know \"{}\"", clause.argument),
            "write interval(share), or relative_interval(" + clause.argument + ")");
    }
  }
  Clause clause_of(std::string_view text) const {
    const std::string shown(trimmed(text)), packed = without_blanks(text);
    const std::size_t open = packed.find('('), close = packed.find(")<");
    if (packed.empty()) {
      fault("a clause is missing");
    } else if (open == std::string::npos || close == std::string::npos || close < open) {
      fault(fmt::format("\"{}\" is not measure(what) < limit", shown));
    } else {
      Clause clause{packed.substr(0, open), packed.substr(open + 1, close - open - 1), 0};
      check_names(clause);
      clause.limit = limit_of(shown, packed.substr(close + 2));
      return clause;
    }
    return {};
  }
};

std::vector<Clause> parsed(const std::string& rule) {
  FaultList faults;
  std::vector<Clause> clauses;
  const RuleReader reader{rule, faults};
  for (const std::string& text : clauses_of(rule)) clauses.push_back(reader.clause_of(text));
  faults.throw_if_any();
  return clauses;
}

// NaN below five samples, and where all are censored, because lower bounds alone show nothing. With some bounds
// it belongs to the mean up to the end of the push (docs/theory/statistics.md, 7.6), and the text says so.
struct HalfWidth {
  double relative = kUnset;
  int bounds = 0;
};
HalfWidth half_width_of(const std::string& name, const Campaign& campaign) {
  study::Moments moments;
  int bounds = 0;
  for (const Quantity& q : quantities()) {
    if (name != q.name && name != key_of(q)) continue;
    for (const SampleRecord& record : campaign.records) {
      if (!is_answered(record)) continue;
      const Reading reading = q.read(record.responses);
      if (!reading.is_known()) continue;
      moments.add(reading.value);
      bounds += reading.censored || (name == "peak_reaction" && is_still_rising(record)) ? 1 : 0;
    }
  }
  if (bounds == moments.n()) return {};
  const Estimate mean = moments.student();
  return {mean.interval.width() / 2 / std::fabs(mean.value), bounds};
}

double widest_share(const Campaign& campaign) {
  std::map<std::string, int> count;
  int n = 0;
  for (const SampleRecord& record : campaign.records)
    if (is_answered(record)) ++count[record.failure_mode.name], ++n;
  double widest = n > 0 ? 0 : 1;
  for (const auto& [name, of_mode] : count)
    widest = std::fmax(widest, study::share_estimate(of_mode, n).interval.width());
  return widest;
}

// "peak_reaction ±1.24 % (asked 1 %)"
Message words(const Clause& clause, double measure, int bounds) {
  if (clause.function == "interval")
    return {"until.share", {{"width", measure}, {"asked", clause.limit}}};
  Message quantity = as_text(clause.argument);
  for (const Quantity& q : quantities())
    if (clause.argument == q.name || clause.argument == key_of(q)) quantity = {q.code};
  Message words{std::isnan(measure) ? "until.not_known"
                : bounds > 0        ? "until.mean_of_bounds"
                                    : "until.mean",
                {{"quantity", quantity}, {"asked_percent", clause.limit * 100}}};
  if (!std::isnan(measure)) words.arguments.emplace_back("half_percent", measure * 100);
  if (!std::isnan(measure) && bounds > 0) words.arguments.emplace_back("bounds", bounds);
  return words;
}

}  // namespace

void check_rule(const std::string& rule) {
  if (!rule.empty()) (void)parsed(rule);
}

bool precise_enough(const std::string& rule, const Campaign& campaign, Message* measures) {
  if (measures) *measures = {};
  if (rule.empty()) return false;
  int n = 0;
  for (const SampleRecord& record : campaign.records) n += is_answered(record) ? 1 : 0;
  std::vector<Message> said = {{"until.samples", {{"samples", n}}}};
  bool met = n >= kFewestSamples;
  if (!met) said.push_back({"until.needed", {{"samples", kFewestSamples}}});
  for (const Clause& clause : parsed(rule)) {
    const HalfWidth half = clause.function == "interval" ? HalfWidth{widest_share(campaign), 0}
                                                         : half_width_of(clause.argument, campaign);
    met = met && half.relative < clause.limit;
    said.push_back(words(clause, half.relative, half.bounds));
  }
  if (measures) *measures = {"until.measures", {{"list", std::move(said)}}};
  return met;
}

}  // namespace wythe
