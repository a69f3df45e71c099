// The only file of the tests with absolute paths, so that a compiler cache can serve the other files in every checkout.
#include "scenes/places.h"

namespace wythe {

std::string source_dir() { return WYTHE_SOURCE_DIR; }
std::string fresh_dir() { return WYTHE_FRESH_DIR; }

}  // namespace wythe
