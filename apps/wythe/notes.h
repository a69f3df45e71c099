// Notes on the console: one line for each kind.
#pragma once

#include <vector>

#include "wythe/error.h"
#include "wythe/model.h"
#include "wythe/solve.h"

namespace wythe::app {

// The first line of a run: a WARNING if its force may be wrong, a note if its force is right but its drift may not be; else nothing.
void print_doubt(const Model& model, const Result& result);

// `with_tables` also prints the details of a line: one opening in each row, or the things that share a note.
void print_notes(const std::vector<Message>& notes, bool with_tables);

}  // namespace wythe::app
