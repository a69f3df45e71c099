// Only this file includes the generated header, so that a new commit recompiles one small file.
#include "wythe/parts/provenance.h"

#include "wythe_provenance.h"

namespace wythe {

Provenance provenance() {
  return {.version = WYTHE_VERSION,
          .commit = WYTHE_COMMIT,
          .compiler = WYTHE_COMPILER,
          .flags = WYTHE_FLAGS,
          .build_type = WYTHE_BUILD_TYPE};
}

}  // namespace wythe
