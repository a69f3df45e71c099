// Forces of fibres and bond of layers in a state.
#include <algorithm>

#include "contact/layer.h"
#include "contact/link.h"
#include "core/rotation.h"
#include "reading/frames.h"
#include "wythe/parts/reading.h"

namespace wythe {
namespace {

using reading::end_in;

// Elongation of the fibres from node k to the next one.
double stretch_in(const Layers& l, const State& s, std::size_t k) {
  const double slips = s.layer_slip[k + 1] - s.layer_slip[k];
  if (l.crossing[k] < 0) return slips;
  return slips + contact::link_line(l.span_x[k], l.span_y[k], true,
                                    end_in(s, l.a[k], l.arm_a_x[k], l.arm_a_y[k]),
                                    end_in(s, l.b[k], l.arm_b_x[k], l.arm_b_y[k]))
                     .elongation;
}

}  // namespace

std::vector<LayerReading> read_layers(const Model& m, const State& s) {
  const Layers& l = m.layers;
  std::vector<LayerReading> read(l.a.size());
  for (std::size_t k = 0; k < read.size(); ++k) {
    LayerReading& now = read[k];
    const contact::LayerBond bond{l.bond_energy[k], l.bond_rate[k]};
    if (!m.standing.holds(l.a[k], s.stage)) continue;  // cut out with its masonry
    now.slip = s.layer_slip[k];
    now.spent = contact::bond_spent(bond, s.layer_reached[k]);
    now.stored = 0.5 * contact::bond_secant(bond, s.layer_reached[k]) * now.slip * now.slip;
    if (!(l.stiffness[k] > 0) || !m.standing.holds(l.b[k], s.stage)) continue;
    now.broken = s.layer_broken[k] > 0;
    const double stretch = now.broken ? 0.0 : stretch_in(l, s, k);
    now.force = contact::fibres_pull(l.stiffness[k], stretch);
    now.stored += contact::fibres_store(l.stiffness[k], stretch);
    // blocks have moved since the last step, so an excess over the strength breaks the fibres only in the next step
    now.use = now.broken ? 1.0 : std::min(1.0, now.force / l.strength[k]);
  }
  return read;
}

}  // namespace wythe
