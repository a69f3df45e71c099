// Why and how sure: influence of the inputs, precision, the study, samples without an answer, replay.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "report/campaign_charts.h"
#include "report/campaign_sections.h"
#include "report/html.h"

namespace wythe::report {
namespace {

using Rows = std::vector<std::vector<std::string>>;

constexpr std::size_t kPeak = 0, kAt80 = 2;
constexpr std::size_t kShown = 3;           // scatter plots
constexpr std::size_t kRowsOfFailed = 200;  // of the list of samples without an answer

const CorrelationTable* table_of(const Statistics& s, const std::string& group, std::size_t q) {
  for (const CorrelationTable& t : s.correlation)
    if (t.group == group && t.quantity == quantities()[q].name) return &t;
  return nullptr;
}

int column_named(const Campaign& campaign, const std::string& name) {
  for (std::size_t k = 0; k < campaign.samples.column.size(); ++k)
    if (campaign.samples.column[k].name == name) return static_cast<int>(k);
  return -1;
}

// Scatter plots of the inputs that go most with peak force and with displacement at 80 %.
std::string scatters(const Campaign& campaign, const Statistics& s) {
  std::vector<std::pair<double, std::pair<std::string, std::size_t>>> strongest;
  for (std::size_t q : {kPeak, kAt80}) {
    const CorrelationTable* t = table_of(s, "all", q);
    if (t == nullptr) continue;
    for (const Correlation& c : t->input)
      if (std::isfinite(c.spearman.value))
        strongest.push_back({std::fabs(c.spearman.value), {c.input, q}});
  }
  std::stable_sort(strongest.begin(), strongest.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  strongest.resize(std::min(kShown, strongest.size()));
  std::string out;
  for (const auto& [strength, pair] : strongest) {
    const int k = column_named(campaign, pair.first);
    if (k < 0) continue;
    out += "<figure>" + scatter_svg(campaign, s, k, pair.second) + "</figure>\n";
  }
  return out.empty() ? "" : "<div class=\"three\">\n" + out + "</div>\n";
}

std::string first_order_cell(const Statistics& s, const std::string& input, std::size_t q) {
  for (const FirstOrderIndex& f : s.first_order)
    if (f.input == input && f.quantity == quantities()[q].name) return with_interval(f.index, 1, 2);
  return "–";
}

std::string influence_table(const Statistics& s, std::size_t q) {
  const CorrelationTable* t = table_of(s, "all", q);
  if (t == nullptr) return "";
  Rows rows = {{"input", "Pearson", "Spearman", "partial rank", "first-order index"}};
  for (const Correlation& c : t->input)
    rows.push_back({escaped(c.input), with_interval(c.pearson, 1, 2),
                    with_interval(c.spearman, 1, 2), with_interval(c.partial_rank, 1, 2),
                    first_order_cell(s, c.input, q)});
  return table(rows);
}

// Spearman inside each mode, peak force.
std::string inside_modes(const Statistics& s) {
  Rows rows = {{"peak force, Spearman"}};
  const CorrelationTable* all = table_of(s, "all", kPeak);
  if (all == nullptr) return "";
  for (const Correlation& c : all->input) rows[0].push_back(escaped(c.input));
  for (const std::string& mode : s.modes) {
    const CorrelationTable* t = table_of(s, mode, kPeak);
    if (t == nullptr) continue;
    rows.push_back({"<b>" + escaped(mode) + "</b>"});
    for (const Correlation& c : t->input) rows.back().push_back(with_interval(c.spearman, 1, 2));
  }
  if (rows.size() < 2) return "";
  return "<h3>Inside each mode</h3>\n<p class=\"soft\">Read with care: the inputs helped to decide "
         "which mode a sample falls into. Within a mode they are no longer independent, and a "
         "correlation there can appear, vanish or change its sign without any cause behind "
         "it.</p>\n" +
         table(rows);
}

std::string correlation_figures(const Statistics& s) {
  std::string out = "<div class=\"pair\">\n";
  for (std::size_t q : {kPeak, kAt80}) {
    const CorrelationTable* t = table_of(s, "all", q);
    if (t == nullptr || t->input.empty()) continue;
    out += fmt::format("<figure>{}<figcaption><b>{}</b>{}</figcaption></figure>\n",
                       correlation_svg(*t), sentence(quantities()[q].words),
                       t->censored > 0 ? fmt::format(" {} of {} values are censored and count as "
                                                     "recorded.",
                                                     t->censored, s.answered)
                                       : "");
  }
  return out + "</div>\n";
}

std::string modes_figures(const Statistics& s) {
  if (s.modes.size() < 2 || s.mode_against_input.empty()) return "";
  std::string out =
      "<h3>Modes against each input</h3>\n" + mode_legend(s) + "<div class=\"three\">\n";
  for (const ModeAgainstInput& against : s.mode_against_input)
    out += "<figure>" + mode_bins_svg(s, against) + "</figure>\n";
  return out +
         "</div>\n<p class=\"soft\">Bins hold equally many samples. Pointing at a box shows "
         "its share with Wilson's interval.</p>\n";
}

std::string size_text(const Precision& p) {
  if (p.held_from > 0) return fmt::format("from {} samples on", p.held_from);
  if (p.expected > 0) return fmt::format("not yet; about {} samples", p.expected);
  return "–";
}

}  // namespace

std::string influence_section(const Campaign& campaign, const Statistics& s) {
  const CorrelationTable* t = table_of(s, "all", kPeak);
  if (s.answered < 5 || t == nullptr || t->input.empty()) return "";
  std::string out = "<h2>What decides it</h2>\n" + correlation_figures(s);
  out += "<h3>Strongest pairs</h3>\n" + mode_legend(s) + scatters(campaign, s);
  out += modes_figures(s);
  for (std::size_t q : {kPeak, kAt80})
    out += fmt::format("<details><summary>All measures: {}</summary>\n{}</details>\n",
                       quantities()[q].words, influence_table(s, q));
  for (const InputCorrelation& c : s.input_correlation)
    if (std::fabs(c.rank) > kEntangled)
      out += fmt::format(
          "<p>Mind: {} and {} were drawn with a rank correlation of {}; an index of either holds a "
          "part of the other’s influence.</p>\n",
          escaped(c.a), escaped(c.b), rounded(c.rank, 2));
  out +=
      "<p class=\"soft\">The first-order index is the part of the variance that the input "
      "explains alone; estimated from bins, it scatters around 0 for an input without influence, "
      "below it too.</p>\n";
  return out + inside_modes(s);
}

std::string precision_section(const Campaign& campaign, const Statistics& s) {
  if (s.answered < 5) return "";
  std::string out = "<h2>How sure</h2>\n<div class=\"pair\">\n";
  for (std::size_t q : {kPeak, kAt80})
    out += "<figure>" + running_svg(s, q) +
           "<figcaption>Mean of the first n samples and its 95\u202f% Student "
           "interval.</figcaption></figure>\n";
  Rows rows = {{"what", "asked", "now", "met"}};
  for (const Precision& p : s.precision) {
    std::string words = "widest share of a mode";
    for (const Quantity& q : quantities())
      if (p.what == q.name) words = std::string("mean ") + q.words;
    const bool share = p.what == "share";
    rows.push_back({words, share ? "±" + rounded(p.target) : "±" + quantity(p.target * 100, "%"),
                    share ? "±" + rounded(p.now, 2) : "±" + quantity(p.now * 100, "%", 2),
                    size_text(p)});
  }
  out += "</div>\n<details open><summary>Samples needed for a stated precision</summary>\n" +
         table(rows) + "</details>\n";
  if (!campaign.study.until.empty()) {
    std::string measures;
    const bool met = precise_enough(campaign.study.until, campaign, &measures);
    out += fmt::format("<p>Stop rule <code>{}</code>: {}; {}.</p>\n", escaped(campaign.study.until),
                       met ? "met" : "not met", escaped(measures));
  }
  return out +
         "<p class=\"soft\">A campaign that is stopped when its interval happens to be narrow "
         "has looked many times: such intervals are a little too narrow. Latin hypercube "
         "samples fill the space more evenly than chance, so for means their intervals are "
         "rather too wide.</p>\n";
}

std::string study_section(const Campaign& campaign, const Statistics& s) {
  if (s.input.empty()) return "";
  std::string out = "<h2>What went in</h2>\n<div class=\"three\">\n";
  Rows rows = {{"input", "unit", "mean", "CoV", "smallest", "largest", "kind"}};
  for (std::size_t k = 0; k < s.input.size(); ++k) {
    const InputSummary& in = s.input[k];
    if (in.is_random) {
      const std::string svg = histogram_svg(campaign, static_cast<int>(k));
      if (!svg.empty()) out += "<figure>" + svg + "</figure>\n";
    }
    rows.push_back({escaped(in.name), in.unit == "1" ? "" : escaped(in.unit), rounded(in.mean, 4),
                    rounded(in.cov, 3), rounded(in.min), rounded(in.max),
                    in.is_random ? "random" : "from a formula"});
  }
  out += "</div>\n<p></p>" + table(rows);
  return out + fmt::format(
                   "<p class=\"soft\">{} design of {} samples, seed {}. Dashed: density of "
                   "the study file, where it is normal or lognormal.</p>\n",
                   escaped(s.design), s.asked, s.seed);
}

std::string unanswered_section(const Statistics& s) {
  if (s.unanswered.empty()) return "";
  Rows rows = {{"sample", "status", "cause"}};
  for (const Unanswered& u : s.unanswered) {
    if (rows.size() > kRowsOfFailed) break;
    rows.push_back(
        {std::to_string(u.sample), escaped(u.status), u.reason.empty() ? "–" : sentence(u.reason)});
  }
  std::string more;
  if (s.unanswered.size() > kRowsOfFailed)
    more = fmt::format("<p class=\"soft\">The first {} of {}; all are in statistics.json.</p>\n",
                       kRowsOfFailed, s.unanswered.size());
  return "<h2>Samples without an answer</h2>\n" + table(rows, "words") + more;
}

std::string replay_section(const Campaign& campaign, const Statistics& s) {
  int sample = s.unanswered.empty() ? 1 : s.unanswered.front().sample;
  for (const SampleRecord& record : campaign.records)
    if (is_answered(record)) {
      sample = record.sample;
      break;
    }
  std::string out = fmt::format(
      "<h2>Look at one sample</h2>\n<p>Any sample can be run alone, with the same bits as here and "
      "all its pictures:</p>\n<pre>wythe replay DIR --sample {} --out sample_{}</pre>\n"
      "<p class=\"soft\">DIR is the folder of this page; numbers of samples are in samples.csv, "
      "and "
      "pointing at a curve above shows its.</p>\n",
      sample, sample);
  if (!campaign.provenance.empty())
    out += "<h2>Provenance</h2>\n<p><code>" + escaped(campaign.provenance) + "</code></p>\n";
  return out;
}

}  // namespace wythe::report
