// Rows of a state: nodes are numbered strand by strand. A length is detached where 95 % of the
// bond's energy is spent. A strand is broken when one of its nodes is broken. Results of a run:
// the largest use over all rows, and the detached length and broken strands of the last row.
#include "dynamics/meters/layer_uses.h"

#include <cmath>

#include "wythe/parts/reading.h"

namespace wythe {

Message sentence_of(const LayerUse& use, const std::string& layer) {
  if (use.where.code.empty()) return {"layer.unused", {{"layer", layer}}};
  if (std::isnan(use.breaks_at))
    return {"layer.used",
            {{"layer", layer},
             {"use", use.use},
             {"at_mm", 1e3 * use.displacement},
             {"where", use.where},
             {"detached_percent", 100 * use.detached}}};
  return {"layer.breaks",
          {{"layer", layer},
           {"at_mm", 1e3 * use.breaks_at},
           {"where", use.where},
           {"broken_percent", 100 * use.broken},
           {"detached_percent", 100 * use.detached}}};
}

namespace dynamics {

std::vector<LayerRow> evaluate_layer_rows(const Model& model, const State& state) {
  constexpr double kDetached = 0.95;  // of the bond's energy is spent
  const Layers& l = model.layers;
  std::vector<LayerRow> rows(l.name.size());
  std::vector<double> length(rows.size(), 0.0);
  std::vector<int> strands(rows.size(), 0), broken(rows.size(), 0);
  const std::vector<LayerReading> nodes = read_layers(model, state);
  int last_broken = -1;  // the last strand of this layer counted as broken
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const std::size_t layer = l.layer[k];
    LayerRow& row = rows[layer];
    if (k > 0 && l.layer[k] != l.layer[k - 1]) last_broken = -1;
    length[layer] += l.length[k];
    if (nodes[k].spent > kDetached) row.detached += l.length[k];
    strands[layer] = l.strand[k] + 1;
    if (nodes[k].broken && l.strand[k] != last_broken) ++broken[layer], last_broken = l.strand[k];
    if (!(nodes[k].use > row.use)) continue;
    row.use = nodes[k].use;
    row.x = 0.5 * (l.x[k] + l.x[k + 1]);
    row.y = 0.5 * (l.y[k] + l.y[k + 1]);
  }
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i].detached /= length[i];
    rows[i].broken = static_cast<double>(broken[i]) / strands[i];
  }
  return rows;
}

Message place_in_layer(const LayerRow& row) {
  return {"place.in_wall", {{"x_m", row.x}, {"y_m", row.y}}};
}

std::vector<LayerUse> evaluate_layer_uses(const Model& model, const Result& result) {
  std::vector<LayerUse> uses(model.layers.name.size());
  const std::size_t n = uses.size();
  for (std::size_t row = 0; n > 0 && (row + 1) * n <= result.strengthening.layer_rows.size(); ++row)
    for (std::size_t k = 0; k < n; ++k) {
      const LayerRow& now = result.strengthening.layer_rows[row * n + k];
      LayerUse& use = uses[k];
      use.detached = now.detached;
      use.broken = now.broken;
      if (now.broken > 0 && std::isnan(use.breaks_at))
        use.breaks_at = result.curve[row].displacement;
      if (!(now.use > use.use)) continue;
      use.use = now.use;
      use.displacement = result.curve[row].displacement;
      use.where = place_in_layer(now);
    }
  return uses;
}

}  // namespace dynamics
}  // namespace wythe
