// The pages after the sheet of a verdict: each wall, the end of each limit state,
// the spectra, the origin of the masonry's values, and the program that ran.
#include <algorithm>
#include <cmath>

#include "core/text.h"
#include "report/html.h"
#include "report/verdict_words.h"

namespace wythe::report {
namespace {

// Words in the origin of a value (materials/circolare.cpp) that phrases translate, longer ones first.
constexpr const char* kWordsOfWays[] = {"works add nothing beyond",
                                        "together not more than",
                                        "transverse connection",
                                        "reinforced repointing",
                                        "reinforced plaster",
                                        "artificial headers",
                                        "diagonal compression",
                                        "shear compression",
                                        "double flat jack",
                                        "joint shear",
                                        "good mortar",
                                        "poor mortar",
                                        "thick joints",
                                        "deep wedges",
                                        "not tested",
                                        "constituents",
                                        "compression",
                                        "injections",
                                        "leaf ties",
                                        "of mean",
                                        "minimum",
                                        "courses",
                                        "weight",
                                        "density",
                                        "tests",
                                        "mean"};

class Appendix {
 public:
  Appendix(const VerdictWords& words, const WallsVerdict& verdict, const Json& inputs)
      : w_(words), v_(verdict), inputs_(inputs) {}

  std::string all() const {
    return walls() + parts() + rules() + spectra() + carried() + masonry() + joints() + "<h2>" +
           w_.say("section.provenance") + "</h2>\n<p class=\"small\"><code>" + escaped(v_.program) +
           "</code></p>\n";
  }

 private:
  // A table whose cells are markup; `sides` says for each column whether it is aligned left (l) or right (r).
  [[nodiscard]] static std::string table(const std::string& title,
                                         const std::vector<std::string>& heads,
                                         const std::string& rows, const std::string& sides) {
    std::string head;
    for (std::size_t k = 0; k < heads.size(); ++k) {
      const bool left = sides[std::min(k, sides.size() - 1)] == 'l';
      head += heads[k].empty() ? "<td></td>"
                               : (left ? "<th class=\"left\">" : "<th>") + heads[k] + "</th>";
    }
    return (title.empty() ? "" : "<h2>" + title + "</h2>\n") +
           "<div class=\"wide\"><table><thead><tr>" + head + "</tr></thead>\n" + rows +
           "</table></div>\n";
  }
  [[nodiscard]] static std::string cell(const std::string& text, bool left = false) {
    return (left ? "<td class=\"left\">" : "<td>") + text + "</td>";
  }

  // --- results of the walls ----------------------------------------------------------------------------

  // A row for each wall, a column for each way it was pushed.
  [[nodiscard]] std::string walls() const {
    if (v_.ways.empty()) return "";
    std::vector<std::string> heads{w_.say("assess.wall")};
    for (const WayOfPushing& way : v_.ways) heads.push_back(w_.name_of(way));
    std::string rows;
    for (std::size_t k = 0; k < v_.ways.front().walls.size(); ++k) {
      rows += "<tr>" + cell(std::to_string(v_.ways.front().walls[k].wall), true);
      for (const WayOfPushing& way : v_.ways)
        rows += cell(k < way.walls.size() ? of_wall(way.walls[k]) : "–", true);
      rows += "</tr>\n";
    }
    return table(w_.say("assess.walls"), heads, rows, "l") + why_lost();
  }
  // Each reason once, with its pushes.
  [[nodiscard]] std::string why_lost() const {
    std::vector<std::pair<std::string, int>> reasons;
    for (const WayOfPushing& way : v_.ways)
      for (const JudgedWall& wall : way.walls) {
        if (!wall.is_lost()) continue;
        const std::string why = w_.words(wall.lost);
        const auto known = std::find_if(reasons.begin(), reasons.end(),
                                        [&](const auto& reason) { return reason.first == why; });
        if (known == reasons.end())
          reasons.emplace_back(why, 1);
        else
          ++known->second;
      }
    std::string out;
    for (const auto& [why, pushes] : reasons)
      out += "<li>" + w_.say("assess.n_lost", {{"n", std::to_string(pushes)}}) + ": " + why +
             "</li>\n";
    return out.empty() ? "" : "<ul class=\"small\">\n" + out + "</ul>\n";
  }
  [[nodiscard]] std::string of_wall(const JudgedWall& wall) const {
    if (wall.is_lost()) return w_.say("assess.lost");
    const Reading r = wall.capacity(v_.worst.state);
    std::string value = r.is_known() ? w_.fixed(r.value * kToG, "g") : "–";
    if (r.censored) value = w_.say("assess.at_least", {{"value", value}});
    switch (wall.verdict(v_.worst.state)) {
      case AssessmentVerdict::kFails:
        value = "<b class=\"fails\">" + value + ", " + w_.say("assess.not_met") + "</b>";
        break;
      case AssessmentVerdict::kNotShown: value += ", " + w_.say("assess.not_shown"); break;
      default: break;
    }
    return value + "<br><span class=\"soft\">" + escaped(w_.texts().phrase(wall.mode)) + "</span>";
  }

  // The result of each part out of plane, and its source.
  [[nodiscard]] std::string parts() const {
    if (v_.parts.checked.empty()) return "";
    const auto number = [&](double value, int digits = 3) {
      return cell(std::isfinite(value) ? w_.texts().quantity(value, "", digits) : "–");
    };
    std::string bodies, states, said;
    for (const LocalCheck& part : v_.parts.checked) {
      const LocalCapacity& c = part.capacity;
      const std::string name = w_.words(words_of_part(part));
      bodies += "<tr>" + cell(name, true) + number(part.foot) + number(part.head) +
                number(c.alpha0) + number(c.mass_share) + number(c.mass) +
                number(part.confidence_factor) + number(part.acceleration0) +
                number(1e3 * c.displacement0) + "</tr>\n";
      for (const LocalStateCheck& s : part.states)
        states += "<tr>" + cell(name, true) + cell(w_.state(s.state), true) + number(s.q_ratio) +
                  number(1e3 * s.displacement) + number(1e3 * s.displacement_demand) +
                  number(s.displacement_ratio) + number(s.acceleration * kToG) +
                  number(s.ground_demand * kToG) + "</tr>\n";
      std::vector<Message> all = part.cautions;
      all.insert(all.end(), part.notes.begin(), part.notes.end());
      if (!all.empty())
        said += "<p class=\"small\">" + w_.say("local.notes", {{"part", name}}) +
                "</p>\n<div class=\"small\">" + w_.list(all) + "</div>\n";
    }
    const auto heads = [&](std::vector<std::string> keys) {
      for (std::string& key : keys)
        if (!key.empty()) key = w_.say(key);
      return keys;
    };
    std::string out = table(
        w_.say("section.local"),
        heads({"", "local.foot_m", "local.head_m", "local.alpha0", "local.participating_mass_share",
               "local.participating_mass_kg", "local.confidence_factor",
               "local.acceleration0_m_per_s2", "local.displacement0_mm"}),
        bodies, "lr");
    if (!states.empty())
      out += table(
          "",
          heads({"", "assess.state", "local.capacity_over_demand_by_q", "local.displacement_mm",
                 "local.displacement_demand_mm", "local.capacity_over_demand_by_displacement",
                 "local.pga_capacity_g", "local.pga_demand_g"}),
          states, "llr");
    return out + "<p class=\"small\">" + w_.say("local.lead") + "</p>\n" + said;
  }

  // Rules that may end each limit state, side by side: the fall of the force, the drift of each pier, q*.
  [[nodiscard]] std::string rules() const {
    std::string rows;
    for (const StateVerdict& of : v_.limit_states) {
      std::string state = w_.state(of.state);
      for (const RuleOfWalls& rule : of.rules) {
        rows += "<tr>" + cell(state, true) + cell(w_.words(rule.words), true) +
                cell(w_.texts().quantity(1e3 * rule.displacement, "mm", 3)) +
                cell(w_.say("assess.of", {{"part", std::to_string(rule.decides)},
                                          {"all", std::to_string(of.worst.size())}})) +
                "</tr>\n";
        state.clear();
      }
    }
    if (rows.empty()) return "";
    return table(w_.say("assess.rules"),
                 {w_.say("assess.state"), w_.say("assess.rule"), w_.say("assess.rule_at"),
                  w_.say("assess.rule_decides")},
                 rows, "llrr");
  }

  // --- inputs ------------------------------------------------------------------------------------------

  // Each requested spectrum.
  [[nodiscard]] std::string spectra() const {
    std::string rows;
    for (const StateVerdict& of : v_.limit_states) {
      if (!of.is_checked) continue;
      const SpectrumSpec& given = spectrum_for(v_.spec, of.state);
      const ElasticSpectrum s = spectrum_of(given);
      const auto number = [&](double value, const char* unit) {
        return std::isnan(value) ? "–" : w_.texts().quantity(value, unit, 3);
      };
      const bool table = s.kind == SpectrumKind::kTable;
      rows += "<tr>" + cell(w_.state(of.state), true) +
              cell(number(s.ground_acceleration * kToG, "g")) +
              cell(table ? "–" : number(s.amplification, "")) +
              cell(number(given.corner_period, "s")) + cell(table ? "–" : escaped(given.ground)) +
              cell(number(s.soil * s.topography, "")) + cell(number(s.TB, "s")) +
              cell(number(s.TC, "s")) + cell(number(s.TD, "s")) + "</tr>\n";
    }
    if (rows.empty()) return "";
    return table(w_.say("assess.spectra"),
                 {w_.say("assess.state"), "ag", "F0", "TC*", w_.say("assess.ground"), "S·ST", "TB",
                  "TC", "TD"},
                 rows, "lr");
  }

  [[nodiscard]] std::string value_of(const Json& value, const Json& unit) const {
    if (value.is_number())
      return w_.texts().quantity(value.get<double>(), unit.get<std::string>(), 4);
    if (value.is_null()) return "–";
    if (value == "unlimited") return w_.say("unlimited");
    if (value.is_array())  // in every language
      return escaped(value.at(w_.texts().place()).get<std::string>());
    return escaped(w_.texts().phrase(value.is_string() ? value.get<std::string>() : value.dump()));
  }

  // Floors, ties, springs.
  [[nodiscard]] std::string carried() const {
    if (!inputs_.contains("carried")) return "";
    std::string rows;
    for (const Json& part : inputs_["carried"]) {
      std::string what;
      for (const Json& row : part["rows"])
        what += (what.empty() ? "" : "; ") + w_.say("input." + row[0].get<std::string>()) + " " +
                value_of(row[1], row[2]);
      rows += "<tr>" + cell(w_.say("input." + part["kind"].get<std::string>()), true) +
              cell(escaped(part["name"].get<std::string>()), true) +
              cell(escaped(part["where"].get<std::string>()), true) + cell(what, true) + "</tr>\n";
    }
    if (rows.empty()) return "";
    return table(w_.say("input.carried"), {"", "", w_.say("input.where"), ""}, rows, "l");
  }

  // Each number of the masonry with its origin: table, coefficient, factor, or rule.
  [[nodiscard]] std::string masonry() const {
    std::string rows;
    for (const Json& row : inputs_["masonry"])
      rows += "<tr>" + cell(w_.say("input." + row[0].get<std::string>()), true) +
              cell(value_of(row[1], row[2])) +
              cell(way_of("masonry", row[0].get<std::string>()), true) + "</tr>\n";
    if (rows.empty()) return "";
    return table(w_.say("assess.masonry"), {w_.say("origin.value"), "", w_.say("origin.how")}, rows,
                 "lrl") +
           sources();
  }
  // The origin of a value: given, a formula of other values, or a table value with its factors.
  [[nodiscard]] std::string way_of(const std::string& table, const std::string& key) const {
    for (const Json& row : inputs_["origins"]) {
      if (row[0] != table || row[1] != key) continue;
      const auto text = [&](int k) { return row[k].get<std::string>(); };
      std::string out = w_.say("origin." + text(3));
      if (text(3) == "derived") out += ": " + in_words(text(6).substr(0, end_of_formula(text(6))));
      if (text(3) == "typical" && !text(5).empty()) out += ": " + in_words(text(5));
      return out;
    }
    return w_.say("origin.given");
  }
  // The part before the words that explain its symbols.
  [[nodiscard]] static std::size_t end_of_formula(const std::string& formula) {
    return std::min(formula.find(" in MPa"), formula.find(", "));
  }
  // The words of an origin in the page's language: "mean 3.45 MPa x 1.3 (transverse_connection) / 1.20".
  [[nodiscard]] std::string in_words(std::string way) const {
    std::replace(way.begin(), way.end(), '_', ' ');
    for (const char* word : kWordsOfWays) {
      const std::string said = w_.texts().phrase(word);
      for (std::size_t at = way.find(word); at != std::string::npos && said != word;
           at = way.find(word, at + said.size()))
        way.replace(at, std::string(word).size(), said);
    }
    const std::string sign = w_.texts().localised(".");
    for (std::size_t k = 1; k + 1 < way.size(); ++k)
      if (way[k] == '.' && is_digit(way[k - 1]) && is_digit(way[k + 1])) way.replace(k, 1, sign);
    return escaped(way);
  }
  // Typologies whose values were used, with their sources, each once.
  [[nodiscard]] std::string sources() const {
    std::vector<std::string> said;
    for (const Json& row : inputs_["origins"]) {
      if (row[3] != "typical") continue;
      const auto text = [&](int k) { return row[k].get<std::string>(); };
      std::string source = w_.texts().phrase(text(6)) + ": " + w_.texts().phrase(text(7));
      if (std::find(said.begin(), said.end(), source) == said.end())
        said.push_back(std::move(source));
    }
    std::string out;
    for (const std::string& source : said)
      out +=
          "<p class=\"small soft\">" + w_.say("origin.typical") + ": " + escaped(source) + "</p>\n";
    return out;
  }

  // The law of joints and of units.
  [[nodiscard]] std::string joints() const {
    const Json& materials = inputs_["materials"];
    std::vector<std::string> heads{""};
    for (const Json& name : materials["names"])
      heads.push_back(escaped(w_.texts().phrase(name.get<std::string>())));
    std::string rows;
    for (const Json& row : materials["rows"]) {
      const std::string unit = row[1].get<std::string>();
      rows += "<tr>" + cell(w_.say("input." + row[0].get<std::string>()) +
                                (unit.empty() ? "" : " [" + escaped(unit) + "]"),
                            true);
      for (const Json& value : row[2]) rows += cell(value_of(value, ""));
      rows += "</tr>\n";
    }
    if (rows.empty()) return "";
    return table(w_.say("input.materials"), heads, rows, "lr");
  }

  const VerdictWords& w_;
  const WallsVerdict& v_;
  const Json& inputs_;
};

}  // namespace

std::string verdict_appendix(const VerdictWords& words, const WallsVerdict& verdict,
                             const Json& inputs) {
  return Appendix(words, verdict, inputs).all();
}

}  // namespace wythe::report
