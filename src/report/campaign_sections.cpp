// What the campaign answers: headline, key numbers, table by failure mode, shares, drift capacity.
#include "report/campaign_sections.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "report/campaign_charts.h"
#include "report/html.h"

namespace wythe::report {
namespace {

using Rows = std::vector<std::vector<std::string>>;

constexpr std::size_t kPeak = 0, kAt80 = 2;  // places in quantities()

std::string percent(double share, int digits = 2) { return quantity(share * 100, "%", digits); }
std::string from_to(const Interval& i, double scale, const char* unit) {
  return rounded(i.low * scale) + " to " + quantity(i.high * scale, unit);
}

// Half the interval against the mean; "" when there is none.
std::string sure_of(const Estimate& e) {
  if (!std::isfinite(e.interval.low)) return "";
  return fmt::format(" (this mean is known to ±{})",
                     percent(e.interval.width() / 2 / std::fabs(e.value)));
}

// A peak at the end of the push is what was asked of the wall, not what it resists.
std::string how_strong(const Summary& peak, int still_rising) {
  const char* bound = 2 * still_rising > peak.n ? "at least " : "";
  if (peak.n == 1)
    return fmt::format("One sample answered: the wall resists <b>{}{}</b>.", bound,
                       quantity(peak.mean.value * 1e-3, "kN"));
  return fmt::format(
      "In {} samples the wall resists <b>{}{}</b> on average, nine times in ten between "
      "<b>{}</b> and <b>{}</b>{}.",
      peak.n, bound, quantity(peak.mean.value * 1e-3, "kN"), rounded(peak.percentile_5 * 1e-3),
      quantity(peak.percentile_95 * 1e-3, "kN"), sure_of(peak.mean));
}

std::string how_far(const Statistics& s, const Summary& at80) {
  // a lower bound is what most of the samples gave: say so
  if (2 * at80.censored > at80.n)
    return fmt::format(
        " Most samples still hold 80\u202f% of their peak where the push ended, at "
        "<b>{}</b>.",
        quantity(at80.max * 1e3, "mm"));
  const Estimate& mean = at80.survival_mean;
  std::string out = fmt::format(" It keeps 80\u202f% of that up to <b>{}</b>{}",
                                quantity(mean.value * 1e3, "mm"), at80.n > 1 ? " on average" : "");
  if (s.load_height > 0)
    out += fmt::format(" ({} drift at {})", quantity(mean.value / s.load_height * 100, "%"),
                       quantity(s.load_height, "m"));
  if (at80.n < 2) return out + ".";
  if (std::isinf(at80.percentile_95))
    return out + fmt::format(
                     "; one sample in twenty falls short of {}, {} of {} still hold it where "
                     "the push ended.",
                     quantity(at80.percentile_5 * 1e3, "mm"), at80.censored, at80.n);
  return out + fmt::format(", nine times in ten between {} and {}.",
                           rounded(at80.percentile_5 * 1e3),
                           quantity(at80.percentile_95 * 1e3, "mm"));
}

std::string how_it_fails(const Statistics& s) {
  std::vector<Share> shares;
  for (const Share& share : s.share)
    if (share.modes.size() == 1 && share.count > 0) shares.push_back(share);
  std::stable_sort(shares.begin(), shares.end(),
                   [](const Share& a, const Share& b) { return a.count > b.count; });
  if (shares.empty()) return "";
  if (s.answered == 1) return fmt::format(" It fails by <b>{}</b>.", escaped(shares[0].name));
  std::string out = " It fails by ";
  for (std::size_t i = 0; i < std::min<std::size_t>(3, shares.size()); ++i) {
    out += fmt::format("{}<b>{}</b> in {}", i == 0 ? "" : ", ", escaped(shares[i].name),
                       percent(shares[i].share.value));
    if (i == 0)
      out += fmt::format(" of the samples ({})", from_to(shares[i].share.interval, 100, "%"));
  }
  return out + ".";
}

std::string card(const std::string& value, const std::string& name, const std::string& means) {
  return fmt::format(
      "<div class=\"number\"><div class=\"value\">{}</div><div class=\"name\">{}</div>"
      "<div class=\"means\">{}</div></div>\n",
      value, name, means);
}

std::string capital(std::string words) {
  words[0] = static_cast<char>(words[0] - 'a' + 'A');
  return words;
}

std::string counted(const Summary& cell) {
  return cell.censored > 0
             ? fmt::format("{} <span class=\"pm\">({} censored)</span>", cell.n, cell.censored)
             : std::to_string(cell.n);
}

std::string range_of(const Summary& cell, double unit) {
  if (std::isinf(cell.percentile_95))
    return rounded(cell.percentile_5 * unit) + " to beyond the push";
  return rounded(cell.percentile_5 * unit) + " to " + rounded(cell.percentile_95 * unit);
}

std::vector<std::string> cells_of(const Summary& cell, const Quantity& what) {
  const double unit = what.to_unit;
  if (cell.censored == cell.n)  // nothing but lower bounds
    return {"beyond",          "–", "–", rounded(cell.min * unit), rounded(cell.max * unit),
            "beyond the push", "–"};
  std::vector<std::string> cells = {with_interval(cell.mean, unit),   with_interval(cell.cov, 1, 2),
                                    with_interval(cell.median, unit), rounded(cell.min * unit),
                                    rounded(cell.max * unit),         range_of(cell, unit)};
  if (what.can_be_censored) cells.push_back(with_interval(cell.survival_mean, unit));
  return cells;
}

Rows rows_of(const Statistics& s, std::size_t q) {
  const Quantity& what = quantities()[q];
  Rows rows = {{"", "samples", "mean", "CoV", "median", "smallest", "largest", "5 to 95 %"}};
  if (what.can_be_censored) rows[0].emplace_back("mean, lower bounds as such");
  for (const GroupSummary& group : s.group) {
    const Summary& cell = group.quantity.at(q);
    if (cell.n == 0) continue;
    rows.push_back({"<b>" + escaped(group.name) + "</b>", counted(cell)});
    for (std::string& text : cells_of(cell, what)) rows.back().push_back(std::move(text));
  }
  return rows;
}

}  // namespace

std::string with_interval(const Estimate& e, double scale, int digits) {
  std::string out = std::isinf(e.value) ? "beyond" : rounded(e.value * scale, digits);
  if (!std::isfinite(e.interval.low)) return out;
  const std::string high =
      std::isinf(e.interval.high) ? "beyond" : rounded(e.interval.high * scale, digits);
  return out + fmt::format("<br><span class=\"pm\">{} … {}</span>",
                           rounded(e.interval.low * scale, digits), high);
}

std::string campaign_headline(const Statistics& s) {
  if (s.run == 0)
    return "<p class=\"headline\">No sample has run yet: there is nothing to say.</p>\n";
  if (s.answered == 0)
    return fmt::format(
        "<p class=\"headline\">None of the {} samples that ran gave an answer; why "
        "is listed below.</p>\n",
        s.run);
  const std::vector<Summary>& all = s.group.front().quantity;
  return "<p class=\"headline\">" + how_strong(all[kPeak], s.still_rising) +
         how_far(s, all[kAt80]) + how_it_fails(s) + "</p>\n";
}

std::string campaign_warning(const Statistics& s) {
  std::string words;
  if (s.answered < s.run)
    words += fmt::format(
        "{} of {} samples gave no answer and are in none of the numbers; they are "
        "listed with their causes below. ",
        s.run - s.answered, s.run);
  if (s.still_rising > 0)
    words += fmt::format(
        "In {} of {} samples the force was still rising where the push ended: their peaks are "
        "lower "
        "bounds. ",
        s.still_rising, s.answered);
  if (s.named_earlier > 0)
    words += fmt::format("{} of {} pushes ended before {}; their modes are named at their end. ",
                         s.named_earlier, s.answered, quantity(s.read_modes_at * 1e3, "mm"));
  if (s.run < s.asked)
    words += fmt::format("{} of {} samples have not run. ", s.asked - s.run, s.asked);
  if (s.answered > 0 && s.answered < kFewestSamples)
    words +=
        fmt::format("{} few: intervals are wide, and what is missing needs more. ",
                    s.answered == 1 ? "one sample is" : fmt::format("{} samples are", s.answered));
  return words.empty() ? "" : "<div class=\"warning\"><b>Mind:</b> " + words + "</div>\n";
}

std::string campaign_cards(const Statistics& s) {
  if (s.answered == 0) return "";
  const std::vector<Summary>& all = s.group.front().quantity;
  const Summary &peak = all[kPeak], &at80 = all[kAt80];
  std::string out = "<section class=\"numbers\">\n";
  const auto interval = [](const Estimate& e, double scale, const char* unit) {
    return std::isfinite(e.interval.low) ? "95\u202f% interval " + from_to(e.interval, scale, unit)
                                         : std::string("too few samples for an interval");
  };
  out += card(quantity(peak.mean.value * 1e-3, "kN"), "mean peak force",
              interval(peak.mean, 1e-3, "kN") + "; CoV " + rounded(peak.cov.value, 2));
  if (s.answered >= kFewestSamples)
    out += card(quantity(peak.percentile_5 * 1e-3, "kN"), "5\u202f% of the samples are weaker",
                "the lower twentieth of the peak forces");
  out += card(quantity(at80.survival_mean.value * 1e3, "mm"), "mean displacement at 80\u202f%",
              interval(at80.survival_mean, 1e3, "mm") +
                  (at80.censored > 0
                       ? fmt::format("; {} samples reach farther than the push", at80.censored)
                       : ""));
  out += card(fmt::format("{} of {}", s.answered, s.asked), "samples answered",
              escaped(s.design) + ", seed " + std::to_string(s.seed));
  return out + "</section>\n";
}

std::string table_section(const Statistics& s) {
  if (s.answered == 0) return "";
  std::string out =
      "<h2>By failure mode</h2>\n<p class=\"soft\">Small print: 95\u202f% bootstrap intervals. A "
      "displacement is censored where the push ended before the force had fallen so far: it is "
      "then a lower bound. “Mean” takes it as recorded; “mean, lower bounds as such” lets it count "
      "as "
      "“at least”, up to the largest recorded value (Kaplan-Meier).</p>\n";
  for (std::size_t q = 0; q < quantities().size(); ++q) {
    const Quantity& what = quantities()[q];
    const std::string title = fmt::format("{} [{}]", capital(what.words), what.unit);
    const std::string body = table(rows_of(s, q));
    out += q == kPeak || what.can_be_censored
               ? fmt::format("<h3>{}</h3>\n{}", title, body)
               : fmt::format("<details><summary>{}</summary>\n{}</details>\n", title, body);
  }
  return out;
}

std::string shares_section(const Statistics& s) {
  if (s.share.empty()) return "";
  std::string read_at;
  if (std::isfinite(s.read_modes_at))
    read_at = fmt::format(" Modes are named at {}.", quantity(s.read_modes_at * 1e3, "mm"));
  return "<h2>How it fails</h2>\n<figure>" + shares_svg(s) +
         "<figcaption>Share of the samples that failed by each mode, with Wilson's 95\u202f% "
         "interval; modes taken together in grey." +
         read_at + "</figcaption></figure>\n";
}

std::string capacity_section(const Statistics& s) {
  if (s.answered < 2) return "";
  std::string out = "<h2>Force and drift that are exceeded</h2>\n<div class=\"pair\">\n";
  for (const Exceedance& e : s.exceedance) {
    const std::string svg = exceedance_svg(s, e);
    if (svg.empty()) continue;
    const bool force = e.quantity == "peak_reaction";
    out += fmt::format(
        "<figure>{}<figcaption>Share of samples that go beyond; band: 95\u202f%. Dashed: "
        "lognormal, "
        "median {}, β {}; largest gap to the samples {}.{}</figcaption></figure>\n",
        svg, quantity(e.median.value * (force ? 1e-3 : 1e3), force ? "kN" : "mm"),
        rounded(e.beta.value, 2), rounded(e.misfit, 2),
        e.censored > 0 ? fmt::format(" {} of {} are censored.", e.censored, e.n) : "");
  }
  out += "</div>\n";
  if (s.drift_limit.empty()) return out;
  Rows rows = {{"drift limit of the code", "for", "samples below it", "share below it"}};
  for (const DriftLimit& d : s.drift_limit)
    rows.push_back(
        {quantity(d.limit * 100, "%", 4),
         fmt::format("{}, {}, {}", d.element, d.mechanism, d.state),
         d.unknown > 0
             ? fmt::format("{} <span class=\"pm\">({} unknown)</span>", d.below, d.unknown)
             : std::to_string(d.below),
         (d.is_lower_bound && d.share.value > 0 ? "at least " : "") + with_interval(d.share, 100)});
  return out +
         fmt::format("<h3>Drift at 80\u202f% of the peak against {}</h3>\n",
                     escaped(s.drift_limit.front().clause)) +
         table(rows, "second") +
         fmt::format(
             "<p class=\"soft\">Drift here is the displacement of the load point over its "
             "height, {}; the code's limits are for the drift of single elements, so the "
             "comparison is one of size, not a check. Shares in %.</p>\n",
             quantity(s.load_height, "m"));
}

}  // namespace wythe::report
