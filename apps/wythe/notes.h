// Notes on the console: those of one kind as one line.
#pragma once

#include <vector>

#include "wythe/error.h"
#include "wythe/model.h"
#include "wythe/solve.h"

namespace wythe::app {

// The first line of a run: a WARNING where its force may be wrong, a note where its force holds and its drift does not; none else.
void print_doubt(const Model& model, const Result& result);

// `with_tables`: what a line stands for too, an opening a row; of notes that say the same of many things, the things.
void print_notes(const std::vector<Message>& notes, bool with_tables);

}  // namespace wythe::app
