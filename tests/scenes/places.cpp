// The one file of the tests that knows absolute paths, so that a compiler cache serves the others to every checkout.
#include "scenes/places.h"

namespace wythe {

std::string source_dir() { return WYTHE_SOURCE_DIR; }
std::string fresh_dir() { return WYTHE_FRESH_DIR; }

}  // namespace wythe
