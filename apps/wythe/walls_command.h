// wythe run --walls N: walls of one model that differ by its scatter.
#pragma once

#include "commands.h"

namespace wythe::app {

// A campaign without variables: its store and files, and the ensemble on the console.
int run_walls(const RunArguments& arguments);

}  // namespace wythe::app
