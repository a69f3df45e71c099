// Notes of one kind as one line: a facade of twenty openings has forty sizes that were fitted to its courses.
#pragma once

#include <vector>

#include "wythe/parts/message.h"

namespace wythe {

struct NoteGroup {
  Message line;                       // the note, or one line for all of `members`
  std::vector<Message> members = {};  // empty where `line` is a note alone
};

// In the order of the first of each kind; up to three of a kind stay as they are.
[[nodiscard]] std::vector<NoteGroup> grouped(const std::vector<Message>& notes);

}  // namespace wythe
