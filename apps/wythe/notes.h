// Notes on the console: those of one kind as one line.
#pragma once

#include <vector>

#include "wythe/message.h"

namespace wythe::app {

// `with_tables`: what a line stands for too, an opening a row; of notes that say the same of many things, the things.
void print_notes(const std::vector<Message>& notes, bool with_tables);

}  // namespace wythe::app
