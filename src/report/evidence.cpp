// Why the answer may be trusted: energy ledger, quasi-static meter, stages, provenance.
#include <fmt/format.h>

#include <cmath>

#include "report/html.h"
#include "report/sections.h"
#include "wythe/provenance.h"

namespace wythe::report {
namespace {

struct Share {
  const char* name;
  double joules;
};

// "12.3" of 100, or a dash where there is nothing to take a share of.
std::string percent(double part, double whole) {
  return whole > 0 ? quantity(100 * part / whole, "%") : "–";
}

std::string energy_bar(const std::vector<Share>& shares) {
  double sum = 0;
  for (const Share& s : shares)
    if (s.joules > 0) sum += s.joules;
  if (!(sum > 0)) return "";
  std::string out = "<div class=\"bar\">";
  for (std::size_t i = 0; i < shares.size(); ++i) {
    if (!(shares[i].joules > 0.002 * sum)) continue;
    out += fmt::format("<span class=\"e{}\" style=\"flex:{:.4f}\" title=\"{}\"></span>", i,
                       shares[i].joules / sum, shares[i].name);
  }
  return out + "</div>\n";
}

}  // namespace

std::string energy_section(const EnergyLedger& e) {
  // Loads that are lifted take work: then they are a place where the energy of the push went.
  const double input = std::fmax(e.loads, 0) + std::fmax(e.drive, 0);
  const std::vector<Share> shares = {{"friction in joints", e.friction},
                                     {"fracture (tension and shear softening)", e.fracture},
                                     {"crushing", e.crushing},
                                     {"local damping", e.damping},
                                     {"stored in joints", e.elastic},
                                     {"motion", e.kinetic},
                                     {"lifting the loads and the wall", std::fmax(-e.loads, 0)}};
  std::vector<std::vector<std::string>> rows = {{"", "J", "share"}};
  rows.push_back({"<b>put in</b> by the push", rounded(e.drive), percent(e.drive, input)});
  if (e.loads > 0)
    rows.push_back(
        {"<b>put in</b> by loads and weight", rounded(e.loads), percent(e.loads, input)});
  for (std::size_t i = 0; i < shares.size(); ++i) {
    if (i == 6 && !(e.loads < 0)) continue;
    rows.push_back({fmt::format("<span class=\"key e{}\"></span>{}", i, shares[i].name),
                    rounded(shares[i].joules), percent(shares[i].joules, input)});
  }
  rows.push_back({"not accounted for", rounded(e.gap), quantity(100 * e.gap_ratio, "%")});
  return "<h2>Where the energy went</h2>\n<p class=\"soft\">What was put in must be found again, "
         "stored "
         "or spent. The last row is what the ledger could not find, against all the work that "
         "passed "
         "through it.</p>\n" +
         energy_bar(shares) + table(rows);
}

std::string quasi_static_section(const QuasiStatic& m) {
  std::string out = "<h2>Was the push slow enough?</h2>\n";
  if (!m.verdict.empty()) out += fmt::format("<p class=\"verdict\">{}</p>\n", sentence(m.verdict));
  return out + table({{"measure", "mean", "largest", "what it says"},
                      {"unbalanced force / contact force", rounded(m.unbalance_ratio_mean),
                       rounded(m.unbalance_ratio_max), "how far the blocks are from equilibrium"},
                      {"kinetic energy / work of the push", rounded(m.kinetic_ratio_mean),
                       rounded(m.kinetic_ratio_max), "inertia; static is 0"},
                      {"|reaction − base shear| / peak", rounded(m.shear_gap), "",
                       "forces at top and base agree"},
                      {"damping work / work of the push", rounded(m.damping_share), "",
                       "what the artificial damping took"}},
                     "last");
}

std::string stages_section(const Result& result) {
  if (result.stages.empty()) return "";
  std::vector<std::vector<std::string>> rows = {
      {"stage", "time", "steps", "unbalance at the end", "settled"}};
  for (const StageReport& s : result.stages) {
    rows.push_back({escaped(s.name), quantity(s.time, "s"), std::to_string(s.steps),
                    rounded(s.unbalance_ratio), s.settled ? "yes" : "–"});
  }
  return "<h2>Stages</h2>\n" + table(rows);
}

std::string provenance_section(const Model& model, const Result& result) {
  const Provenance made = provenance();
  const auto code = [](std::string_view text) { return "<code>" + escaped(text) + "</code>"; };
  return "<h2>Provenance</h2>\n<p class=\"soft\">The same program and the same model give the same "
         "state hash, whatever the number of threads.</p>\n" +
         table({{"", ""},
                {"program", code(fmt::format("wythe {} ({})", made.version, made.commit))},
                {"compiler", code(fmt::format("{} {}", made.compiler, made.flags))},
                {"model hash", code(fmt::format("{:016x}", model.spec_hash))},
                {"state hash", code(result.state_hash)},
                {"size", fmt::format("{} blocks, {} joints, {} points", model.n_block,
                                     model.n_joint, model.n_point())},
                {"steps",
                 fmt::format("{} of {} (push), {} of computing", result.steps,
                             quantity(result.time_step, "s"), quantity(result.wall_seconds, "s"))}},
               "words bare");
}

}  // namespace wythe::report
