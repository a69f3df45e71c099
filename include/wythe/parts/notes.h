// Summarises notes of one kind in one line: a facade of twenty openings has forty sizes that were fitted to its courses.
#pragma once

#include <vector>

#include "wythe/parts/message.h"

namespace wythe {

struct NoteGroup {
  Message line;                       // the note, or one line for all of `members`
  std::vector<Message> members = {};  // empty where `line` is a note alone
};

// Groups in the order of their first note. Up to three notes of a kind stay single.
[[nodiscard]] std::vector<NoteGroup> grouped(const std::vector<Message>& notes);

}  // namespace wythe
