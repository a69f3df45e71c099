// compare_campaigns(): matches samples, forms pairs, compares each response and the modes, and writes sentences.
#include "wythe/parts/comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <set>

#include "campaign/store/study_rows.h"
#include "statistics/pairs.h"
#include "statistics/statistics_parts.h"
#include "wythe/parts/error.h"
#include "wythe/parts/failure_mode.h"

namespace wythe {
namespace {

using study::Column;

constexpr double kManyLost = 0.1;   // share of lost pairs that is reported before all numbers
constexpr int kFewestForSigns = 6;  // pairs that are significant if all have one sign

// --- equal samples -------------------------------------------------------------------------------

// Positions of the base's random inputs in another store's columns; -1 where it has no such name.
std::vector<int> places_in(const SampleTable& base, const SampleTable& other) {
  std::vector<int> places;
  for (const InputColumn& column : base.column) {
    if (!column.is_random) continue;
    const auto found =
        std::find_if(other.column.begin(), other.column.end(),
                     [&](const InputColumn& c) { return c.is_random && c.name == column.name; });
    places.push_back(found == other.column.end() ? -1
                                                 : static_cast<int>(found - other.column.begin()));
  }
  return places;
}

std::string names_of(const SampleTable& samples) {
  std::string names;
  for (const int i : study::random_columns(samples))
    names += (names.empty() ? "" : ", ") + samples.column[i].name;
  return names;
}

std::string with_unit(const InputColumn& column, double value) {
  const double shown = value * column.to_unit + column.offset;
  return column.unit == "1" || column.unit.empty() ? fmt::format("{:.10g}", shown)
                                                   : fmt::format("{:.10g} {}", shown, column.unit);
}

bool draws_fields(const StudySpec& study) {
  return std::any_of(study.field.begin(), study.field.end(),
                     [](const StudyField& field) { return !field.follows; });
}

// Differences of fields, which are drawn from the study's seed and not stored as inputs.
std::string other_fields(const StudySpec& base, const StudySpec& other) {
  if (base.seed == other.seed || (!draws_fields(base) && !draws_fields(other))) return "";
  return fmt::format("random fields are drawn from seed = {} in the base, {} here", base.seed,
                     other.seed);
}

void refuse_others(const std::vector<ComparedCampaign>& stores) {
  namespace fs = std::filesystem;
  std::vector<Fault> faults;
  const auto add = [&](const std::string& folder, const std::string& problem,
                       const std::string& cure) {
    faults.push_back({.file = folder, .problem = problem, .cure = cure});
  };
  if (stores.size() < 2)
    add(stores.empty() ? "wythe compare" : stores.front().folder, "has nothing to be compared with",
        "name the folders of two campaigns or more, the base first");
  for (std::size_t i = 1; i < stores.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      std::error_code error;
      if (!stores[i].folder.empty() && fs::equivalent(stores[i].folder, stores[j].folder, error))
        add(stores[i].folder, "is the same folder as " + stores[j].folder,
            "name each campaign once, the base first");
    }
    std::string why = other_inputs(stores[0].campaign.samples, stores[i].campaign.samples);
    if (why.empty()) why = other_fields(stores[0].campaign.study, stores[i].campaign.study);
    if (!why.empty())
      add(stores[i].folder,
          fmt::format("its samples are not those of {}: {}", stores[0].folder, why),
          "run both with the same variables, samples, seed and design; easiest as [[variant]] of "
          "one study");
  }
  if (!faults.empty()) throw InputError(std::move(faults));
}

// --- what differs --------------------------------------------------------------------------------

// Rows of the study that differ from the base's, in words; without folders and names.
std::vector<std::string> changes_of(const ComparedCampaign& base, const ComparedCampaign& option) {
  std::vector<std::string> out;
  const StudySpec &was = base.campaign.study, &is = option.campaign.study;
  const auto before = study::in_effect(was.settings), now = study::in_effect(is.settings);
  for (const auto& [path, value] : now) {
    const auto then = before.find(path);
    if (then == before.end() || then->second != value) out.push_back(path + "=" + value);
  }
  for (const auto& [path, value] : before)
    if (!now.contains(path)) out.push_back("without " + path + "=" + value);
  for (const Fault& fault : study::changes(was, is, option.folder, "in the base")) {
    if (fault.path == "settings" || fault.path == "model" || fault.path == "seed") continue;
    out.push_back(fault.path + " " + fault.problem);
  }
  if (was.model_text != is.model_text)
    out.push_back(was.model_file == is.model_file ? "another text of " + is.model_file
                                                  : "model " + is.model_file);
  return out;
}

// --- pairs ---------------------------------------------------------------------------------------

using Records = std::map<int, const SampleRecord*>;

Records records_of(const Campaign& campaign, int samples) {
  Records out;
  for (const SampleRecord& record : campaign.records)
    if (record.sample <= samples && !record.status.empty()) out[record.sample] = &record;
  return out;
}

struct Pair {
  int sample;
  const SampleRecord *base, *option;
  PushDoubt doubt = {};  // of either side
};

struct Pairs {
  std::vector<Pair> pair;
  std::vector<LostPair> lost;
  int not_run = 0;
};

void describe_side(const SampleRecord* record, std::string& status, Message& reason,
                   bool& answered) {
  if (record == nullptr) return;
  status = record->status;
  const Message& why = record->responses.peak_reason;
  answered = is_answered(*record);
  if (!answered) reason = why.empty() ? record->reason : why;
}

// Walls that are equal to the last bit stay equal in any push.
PushDoubt doubt_of(const ComparedCampaign& base, const ComparedCampaign& option, const Pair& pair) {
  PushDoubt out;
  if (!pair.base->state_hash.empty() && pair.base->state_hash == pair.option->state_hash)
    return out;
  for (const ComparedCampaign* side : {&base, &option}) {
    const auto found = side->doubt.find(pair.sample);
    if (found == side->doubt.end()) continue;
    if (out.displacement.empty()) out.displacement = found->second.displacement;
    out.mode = out.mode || found->second.mode;
  }
  return out;
}

Pairs pairs_of(const ComparedCampaign& base, const ComparedCampaign& option, int samples) {
  const Records of_base = records_of(base.campaign, samples);
  const Records of_option = records_of(option.campaign, samples);
  const auto at = [](const Records& records, int sample) {
    const auto found = records.find(sample);
    return found == records.end() ? nullptr : found->second;
  };
  Pairs out;
  for (int s = 1; s <= samples; ++s) {
    const SampleRecord *a = at(of_base, s), *b = at(of_option, s);
    if (a == nullptr && b == nullptr) {
      ++out.not_run;
    } else if (a != nullptr && b != nullptr && is_answered(*a) && is_answered(*b)) {
      Pair& pair = out.pair.emplace_back(Pair{.sample = s, .base = a, .option = b});
      pair.doubt = doubt_of(base, option, pair);
    } else {
      LostPair& lost = out.lost.emplace_back();
      lost.sample = s;
      describe_side(a, lost.base_status, lost.base_reason, lost.base_answered);
      describe_side(b, lost.option_status, lost.option_reason, lost.option_answered);
    }
  }
  return out;
}

bool is_slow_enough(const SampleRecord& r) {
  return r.quasi_static.judgement == "slow enough" || r.quasi_static.judgement == "no push";
}

bool is_too_fast(const SampleRecord& r) {
  return r.quasi_static.judgement == "too fast" || r.quasi_static.judgement == "unknown";
}

// A force that still rises at the end of the push is a lower bound, and so is its displacement.
Reading reading_of(const SampleRecord& record, const Quantity& quantity) {
  Reading reading = quantity.read(record.responses);
  const std::string name = quantity.name;
  if (name == "peak_reaction" || name == "displacement_at_peak")
    reading.censored = is_still_rising(record);
  return reading;
}

// --- the parts -----------------------------------------------------------------------------------

void note_doubts(const Pairs& pairs, PairedResponse& out) {
  for (const Pair& pair : pairs.pair) {
    if (pair.doubt.displacement.empty()) continue;
    if (++out.doubted == 1) out.doubt = pair.doubt.displacement;
  }
}

PairedResponse response_of(const PairedComparison& all, const Pairs& pairs,
                           const Quantity& quantity) {
  std::vector<PairValue> values;
  std::set<int> slow;
  for (const Pair& pair : pairs.pair) {
    values.push_back(
        {pair.sample, reading_of(*pair.base, quantity), reading_of(*pair.option, quantity)});
    if (is_slow_enough(*pair.base) && is_slow_enough(*pair.option)) slow.insert(pair.sample);
  }
  PairedResponse out = study::paired_response(std::move(values), quantity.can_be_censored,
                                              static_cast<int>(pairs.lost.size()));
  out.quantity = quantity.name;
  if (out.quantity == "displacement_at_80_percent") note_doubts(pairs, out);
  if (std::isnan(out.difference.value)) return out;
  const Column difference = study::differences(out);
  std::vector<PairValue> trusted;
  std::vector<Column> input(all.input.size());
  for (const PairValue& pair : out.pair) {
    if (slow.contains(pair.sample)) trusted.push_back(pair);
    if (!study::enters_means(out, pair)) continue;
    for (std::size_t k = 0; k < input.size(); ++k)
      input[k].push_back(all.value[pair.sample - 1][k]);
  }
  const PairedResponse of_slow = study::paired_response(trusted, quantity.can_be_censored, 0);
  out.slow_enough = of_slow.pairs;
  out.difference_slow_enough = of_slow.difference;
  std::vector<std::string> names;
  for (const InputColumn& column : all.input) names.push_back(column.name);
  out.gain = study::gains(input, names, difference);
  return out;
}

// Names in the order of the statistics: FM-1 ... FM-5, others, "unclear".
std::vector<std::string> modes_of_both(const Campaign& base, const Campaign& option,
                                       const std::set<std::string>& there) {
  std::vector<std::string> order;
  for (const Campaign* campaign : {&base, &option})
    for (const std::string& mode : study::answered_of(*campaign).modes)
      if (there.contains(mode) && std::find(order.begin(), order.end(), mode) == order.end())
        order.push_back(mode);
  std::stable_sort(order.begin(), order.end(), [](const std::string& a, const std::string& b) {
    const auto rank = [](const std::string& name) {
      return name == "unclear" ? 2 : (name.starts_with("FM-") ? 0 : 1);
    };
    return rank(a) != rank(b) ? rank(a) < rank(b) : rank(a) == 0 && a < b;
  });
  return order;
}

std::vector<ModeShift> groups_of(std::vector<ChangedMode> pairs, std::vector<std::string> modes) {
  const auto take = [](std::string& mode) {
    if (mode == "FM-1" || mode == "FM-2") mode = "FM-1 + FM-2";
    if (mode == "FM-3" || mode == "FM-4") mode = "FM-3 + FM-4";
  };
  for (ChangedMode& pair : pairs) take(pair.base), take(pair.option);
  std::vector<std::string> order;
  for (std::string& mode : modes) {
    take(mode);
    if (std::find(order.begin(), order.end(), mode) == order.end()) order.push_back(mode);
  }
  return study::mode_table(pairs, order).shift;
}

ModeTable modes_of(const Pairs& pairs, const Campaign& base, const Campaign& option) {
  std::vector<ChangedMode> both;
  std::set<std::string> there;
  for (const Pair& pair : pairs.pair) {
    both.push_back({pair.sample, pair.base->failure_mode.name, pair.option->failure_mode.name});
    there.insert(both.back().base);
    there.insert(both.back().option);
  }
  ModeTable table = study::mode_table(both, modes_of_both(base, option, there));
  if (there.contains("FM-1") || there.contains("FM-2") || there.contains("FM-3") ||
      there.contains("FM-4"))
    table.group_shift = groups_of(both, table.modes);
  for (const Pair& pair : pairs.pair) {
    table.doubted += pair.doubt.mode ? 1 : 0;
    const FailureMode &was = pair.base->failure_mode, &is = pair.option->failure_mode;
    const double a = std::fabs(was.read_at), b = std::fabs(is.read_at);
    if (!study::is_named(was.name) || !study::is_named(is.name)) continue;
    if (!is_read_early(std::min(a, b), std::max(a, b))) continue;
    ++table.read_apart;
    table.changed_apart += was.name != is.name ? 1 : 0;
  }
  return table;
}

// --- in words ------------------------------------------------------------------------------------

// True also without an interval, because nothing is shown then.
bool holds_one(const Interval& interval) { return !(interval.low > 1 || interval.high < 1); }

// Notes signs that disagree with the mean. With bounds among the pairs, the two use different pairs.
void note_signs(const PairedResponse& peak, std::vector<Message>& notes) {
  if (peak.bounds > 0) {
    if (peak.in_means > 0)
      notes.push_back({"compare.means_beside_bounds",
                       {{"pairs", peak.in_means}, {"all", peak.pairs}, {"bounds", peak.bounds}}});
    else
      notes.push_back({"compare.no_means", {{"bounds", peak.bounds}, {"all", peak.pairs}}});
    if (peak.undecided > 0)
      notes.push_back({"compare.signs_open", {{"open", peak.undecided}, {"all", peak.pairs}}});
    return;
  }
  if (peak.pairs < kFewestForSigns || std::isnan(peak.ratio.interval.low)) return;
  const bool sure = !holds_one(peak.ratio.interval);
  if (sure && peak.sign_test_p > 0.05 && peak.larger > 0 && peak.smaller > 0)
    notes.push_back({"compare.few_decide", {{"larger", peak.larger}, {"smaller", peak.smaller}}});
  if (!sure && peak.sign_test_p <= 0.05)
    notes.push_back({"compare.most_differ", {{"larger", peak.larger}, {"smaller", peak.smaller}}});
}

std::vector<Message> notes_of_option(const ComparedCampaign& base, const ComparedCampaign& option,
                                     const OptionComparison& found) {
  std::vector<Message> notes;
  const int lost = static_cast<int>(found.lost.size()), all = found.pairs + lost;
  if (lost > 0)
    notes.push_back({lost > kManyLost * all ? "compare.many_lost" : "compare.lost",
                     {{"lost", lost},
                      {"all", all},
                      {"base_alone", found.base_alone},
                      {"option_alone", found.option_alone}}});
  if (found.not_run > 0) notes.push_back({"compare.not_run", {{"samples", found.not_run}}});
  if (found.not_slow_enough > 0)
    notes.push_back({"compare.too_fast", {{"pairs", found.not_slow_enough}, {"all", found.pairs}}});
  if (found.rising_base + found.rising_option > 0)
    notes.push_back(
        {"compare.rising", {{"base", found.rising_base}, {"option", found.rising_option}}});
  note_signs(found.response.front(), notes);
  if (found.pairs > 0 && found.same_bits == found.pairs) notes.push_back({"compare.same_bits"});
  const Campaign &a = base.campaign, &b = option.campaign;
  const auto read_at = [](const Campaign& c) {
    return std::isnan(c.study.read_modes_at) ? kReadModesAt : c.study.read_modes_at;
  };
  if (read_at(a) != read_at(b))
    notes.push_back({"compare.modes_read_elsewhere",
                     {{"base_mm", 1e3 * read_at(a)}, {"option_mm", 1e3 * read_at(b)}}});
  else if (found.modes.read_apart > 0)
    notes.push_back({"compare.modes_read_apart",
                     {{"pairs", found.modes.read_apart},
                      {"all", found.modes.pairs - found.modes.unclear},
                      {"changed", found.modes.changed_apart}}});
  if (a.provenance != b.provenance)
    notes.push_back({"compare.other_program", {{"base", a.provenance}, {"option", b.provenance}}});
  if (a.samples.n_sample() != b.samples.n_sample())
    notes.push_back({"compare.other_size",
                     {{"base", a.samples.n_sample()},
                      {"option", b.samples.n_sample()},
                      {"common", std::min(a.samples.n_sample(), b.samples.n_sample())}}});
  return notes;
}

Message peak_in_words(const PairedResponse& peak) {
  const auto change = [](double ratio) { return 100 * (ratio - 1); };
  const double percent = change(peak.ratio.value);
  const double low = change(peak.ratio.interval.low), high = change(peak.ratio.interval.high);
  if (peak.pairs == 0) return {"compare.peak_none"};
  if (peak.bounds > 0)
    return {"compare.peak_bounds",
            {{"larger", peak.larger},
             {"smaller", peak.smaller},
             {"equal", peak.equal},
             {"open", peak.undecided},
             {"pairs", peak.pairs}}};
  if (peak.equal == peak.pairs) return {"compare.peak_same", {{"pairs", peak.pairs}}};
  if (std::isnan(peak.ratio.interval.low))
    return {"compare.peak_few", {{"percent", percent}, {"pairs", peak.pairs}}};
  if (holds_one(peak.ratio.interval))
    return {"compare.peak_unsure",
            {{"percent", percent},
             {"low", low},
             {"high", high},
             {"larger", peak.larger},
             {"smaller", peak.smaller},
             {"pairs", peak.pairs}}};
  const bool more = peak.ratio.value > 1;
  return {more ? "compare.peak_larger" : "compare.peak_smaller",
          {{"percent", percent},
           {"low", low},
           {"high", high},
           {"larger", peak.larger},
           {"smaller", peak.smaller},
           {"pairs", peak.pairs}}};
}

// How many pairs fail in another mode, where both sides have a name.
std::vector<Message> modes_in_words(const ModeTable& modes) {
  if (modes.unclear == modes.pairs) return {{"compare.modes_unclear"}};
  std::vector<Message> parts;
  if (modes.changed.empty())
    parts.push_back({"compare.modes_same"});
  else
    parts.push_back({"compare.modes_change", {{"changed", modes.changed.size()}}});
  if (modes.unclear > 0) parts.push_back({"compare.pairs_unclear", {{"pairs", modes.unclear}}});
  return parts;
}

Message headline_of(const OptionComparison& found) {
  if (found.pairs == 0)
    return {"compare.headline_none", {{"option", found.name}, {"lost", found.lost.size()}}};
  const PairedResponse& peak = found.response.front();
  const int lost = static_cast<int>(found.lost.size()), all = found.pairs + lost;
  std::vector<Message> parts = {peak_in_words(peak)};
  for (const Message& part : modes_in_words(found.modes)) parts.push_back(part);
  if (peak.bounds > 0) parts.push_back({"compare.pairs_bounds", {{"pairs", peak.bounds}}});
  if (found.too_fast > 0) parts.push_back({"compare.pairs_too_fast", {{"pairs", found.too_fast}}});
  if (lost > 0) parts.push_back({"compare.pairs_lost", {{"lost", lost}}});
  if (peak.pairs == 0)
    return {"compare.headline_no_peak", {{"option", found.name}, {"parts", parts}}};
  if (peak.without_value > 0)
    parts.push_back({"compare.pairs_no_peak", {{"pairs", peak.without_value}}});
  const int silent = lost + peak.without_value;
  if (silent <= kManyLost * all)
    return {"compare.headline", {{"option", found.name}, {"parts", parts}}};
  if (peak.without_value == 0)
    return {"compare.headline_doubtful",
            {{"option", found.name}, {"parts", parts}, {"lost", lost}, {"all", all}}};
  return {"compare.headline_silent",
          {{"option", found.name}, {"parts", parts}, {"silent", silent}, {"all", all}}};
}

OptionComparison compare_one(const PairedComparison& all, const ComparedCampaign& base,
                             const ComparedCampaign& option) {
  OptionComparison out;
  out.name = option.name, out.folder = option.folder;
  out.changes = changes_of(base, option);
  const int common = std::min(base.campaign.samples.n_sample(), option.campaign.samples.n_sample());
  Pairs pairs = pairs_of(base, option, common);
  out.pairs = static_cast<int>(pairs.pair.size());
  out.not_run = pairs.not_run;
  for (const LostPair& lost : pairs.lost) {
    out.base_alone += lost.base_answered ? 1 : 0;
    out.option_alone += lost.option_answered ? 1 : 0;
  }
  for (const Pair& pair : pairs.pair) {
    out.not_slow_enough += is_slow_enough(*pair.base) && is_slow_enough(*pair.option) ? 0 : 1;
    out.too_fast += is_too_fast(*pair.base) || is_too_fast(*pair.option) ? 1 : 0;
    out.rising_base += is_still_rising(*pair.base) ? 1 : 0;
    out.rising_option += is_still_rising(*pair.option) ? 1 : 0;
    out.steps_base += static_cast<double>(pair.base->steps) / out.pairs;
    out.steps_option += static_cast<double>(pair.option->steps) / out.pairs;
    out.same_bits += pair.base->state_hash == pair.option->state_hash ? 1 : 0;
  }
  for (const Quantity& quantity : quantities())
    out.response.push_back(response_of(all, pairs, quantity));
  out.modes = modes_of(pairs, base.campaign, option.campaign);
  out.lost = std::move(pairs.lost);
  out.notes = notes_of_option(base, option, out);
  out.headline = headline_of(out);
  return out;
}

}  // namespace

std::string other_inputs(const SampleTable& base, const SampleTable& other) {
  const std::vector<int> place = places_in(base, other);
  const std::vector<int> own = study::random_columns(base);
  for (std::size_t k = 0; k < own.size(); ++k)
    if (place[k] < 0)
      return fmt::format("{} is drawn in the base and not here ({})", base.column[own[k]].name,
                         names_of(other));
  for (const int i : study::random_columns(other))
    if (std::find(place.begin(), place.end(), i) == place.end())
      return fmt::format("{} is drawn here and not in the base ({})", other.column[i].name,
                         names_of(base));
  for (std::size_t k = 0; k < own.size(); ++k) {
    const InputColumn &a = base.column[own[k]], &b = other.column[place[k]];
    if (a.si_unit != b.si_unit)
      return fmt::format("{} is in {} in the base, in {} here", a.name, a.unit, b.unit);
  }
  for (int s = 0; s < std::min(base.n_sample(), other.n_sample()); ++s)
    for (std::size_t k = 0; k < own.size(); ++k) {
      const InputColumn &a = base.column[own[k]], &b = other.column[place[k]];
      const double was = base.value[s][own[k]], is = other.value[s][place[k]];
      if (was != is)
        return fmt::format("sample {} has {} = {} in the base, {} here", s + 1, a.name,
                           with_unit(a, was), with_unit(b, is));
    }
  return "";
}

PairedComparison compare_campaigns(const std::vector<ComparedCampaign>& stores) {
  refuse_others(stores);
  PairedComparison out;
  const ComparedCampaign& base = stores.front();
  out.study = base.campaign.study.name;
  out.provenance = base.campaign.provenance;
  out.base_name = base.name, out.base_folder = base.folder;
  out.samples = base.campaign.samples.n_sample();
  const std::vector<int> columns = study::random_columns(base.campaign.samples);
  for (const int i : columns) out.input.push_back(base.campaign.samples.column[i]);
  for (const std::vector<double>& row : base.campaign.samples.value) {
    std::vector<double>& values = out.value.emplace_back();
    for (const int i : columns) values.push_back(row[i]);
  }
  for (std::size_t i = 1; i < stores.size(); ++i)
    out.option.push_back(compare_one(out, base, stores[i]));
  return out;
}

}  // namespace wythe
