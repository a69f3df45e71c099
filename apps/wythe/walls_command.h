// wythe run --walls N: walls of one model that differ by what scatters within them.
#pragma once

#include "commands.h"

namespace wythe::app {

// A campaign without variables: the store and the files of one, and the ensemble on the console.
int run_walls(const RunArguments& arguments);

}  // namespace wythe::app
