// Computes the use of every section in each row of the curve (docs/theory/frames.md, 20.8) and keeps
// the largest of each frame. The event that the recorder wrote says where a frame first yielded.
#include "dynamics/meters/frame_uses.h"

#include <cmath>

#include "wythe/parts/reading.h"

namespace wythe {

Message sentence_of(const FrameUse& use, const std::string& frame) {
  if (use.where.code.empty()) return {"frame.unused", {{"frame", frame}}};
  if (std::isnan(use.yields_at))
    return {"frame.used", {{"frame", frame}, {"use", use.use}, {"where", use.where}}};
  return {"frame.yields",
          {{"frame", frame},
           {"use", use.use},
           {"at_mm", 1e3 * use.yields_at},
           {"where", use.yields_where}}};
}

namespace dynamics {

Message place_in_frame(const Model& model, std::size_t section) {
  constexpr double kEnd = 1e-9;  // of the length
  const Frames& f = model.frames;
  const FrameMember& m = f.members[f.member[section]];
  const double at = f.place[section];
  const bool first = at<kEnd * m.length, last = at>(1 - kEnd) * m.length;
  if (!first && !last) return {"place.along_member", {{"member", m.words}, {"at_m", at}}};
  const char* code = "place.right_end";
  if (std::fabs(m.direction_y) > std::fabs(m.direction_x))
    code = (m.direction_y > 0) == last ? "place.top" : "place.foot";
  else if ((m.direction_x > 0) != last)
    code = "place.left_end";
  return {code, {{"member", m.words}}};
}

std::vector<FrameUse> evaluate_frame_uses(const Model& model, const Result& result) {
  const Frames& f = model.frames;
  std::vector<FrameUse> uses(f.name.size());
  const std::size_t n = f.a.size();
  for (std::size_t row = 0; n > 0 && (row + 1) * n <= result.strengthening.frame_rows.size(); ++row)
    for (std::size_t k = 0; k < n; ++k) {
      const FrameMember& member = f.members[f.member[k]];
      const FrameRow& now = result.strengthening.frame_rows[row * n + k];
      FrameUse& use = uses[member.frame];
      const double here = section_use(member, now.normal, now.shear, now.moment);
      if (!(here > use.use)) continue;
      use.use = here;
      use.displacement = result.curve[row].displacement;
      use.where = place_in_frame(model, k);
    }
  for (const Event& event : result.events) {
    if (event.name.code != "event.frame_yields") continue;
    for (std::size_t k = 0; k < uses.size(); ++k)
      if (event.name == Message{"event.frame_yields", {{"frame", f.name[k]}}})
        uses[k].yields_at = event.displacement, uses[k].yields_where = event.where;
  }
  return uses;
}

}  // namespace dynamics
}  // namespace wythe
