// Notes about a changed size of openings form one group, likewise those of lintels and of sills; the line of such a group
// names the largest change. Other notes are grouped by their code; a note without a code stays alone.
#include "wythe/parts/notes.h"

#include <cmath>
#include <string>

namespace wythe {
namespace {

constexpr std::size_t kAlone = 3;  // notes of one kind that still get a line each

// How much a size was changed to fit the courses [m]; NaN where a note has no sizes.
double change_of(const Message& note) {
  const double m = note.number("to_m") - note.number("from_m");
  const double mm = note.number("to_mm") - note.number("from_mm");
  return std::fabs(std::isnan(m) ? 1e-3 * mm : m);
}

// "opening" for "opening.height_changed" and "opening.head_moved"; the code itself for a note without sizes.
std::string kind_of(const Message& note) {
  const std::string part = note.code.substr(0, note.code.find('.'));
  const bool is_part = part == "opening" || part == "lintel" || part == "sill";
  return is_part && !std::isnan(change_of(note)) ? part : note.code;
}

Message line_of(const std::string& kind, const std::vector<Message>& members) {
  const Message* most = &members.front();
  for (const Message& member : members)
    if (change_of(member) > change_of(*most)) most = &member;
  const double mm = 1e3 * change_of(*most);
  const std::size_t n = members.size();
  if (kind == "opening")
    return {"notes.openings", {{"count", n}, {"most_mm", mm}, {"most", *most}}};
  if (kind == "lintel") return {"notes.lintels", {{"count", n}, {"most_mm", mm}, {"most", *most}}};
  if (kind == "sill") return {"notes.sills", {{"count", n}, {"most_mm", mm}, {"most", *most}}};
  return {"notes.alike", {{"first", members.front()}, {"more", members.size() - 1}}};
}

}  // namespace

std::vector<NoteGroup> grouped(const std::vector<Message>& notes) {
  std::vector<NoteGroup> groups;
  std::vector<std::string> kinds;
  for (const Message& note : notes) {
    const std::string kind = kind_of(note);
    std::size_t at = 0;
    while (at < kinds.size() && (kinds[at] != kind || kind.empty())) ++at;
    if (at == kinds.size()) {
      kinds.push_back(kind);
      groups.emplace_back();
    }
    groups[at].members.push_back(note);
  }
  std::vector<NoteGroup> out;
  for (std::size_t k = 0; k < groups.size(); ++k) {
    if (groups[k].members.size() > kAlone)
      out.push_back({line_of(kinds[k], groups[k].members), std::move(groups[k].members)});
    else
      for (Message& note : groups[k].members) out.push_back({std::move(note)});
  }
  return out;
}

}  // namespace wythe
