// In place of gpu.cu where the program is built without WYTHE_CUDA.
#include "dynamics/executors/gpu.h"
#include "wythe/error.h"

namespace wythe::dynamics {
namespace {

[[noreturn]] void refuse() {
  throw InputError({{.file = "--device",
                     .path = "",
                     .value = "gpu",
                     .problem = "is not in this program: it was built for this processor only",
                     .cure = "build with -DWYTHE_CUDA=ON (docs/howto/gpu.md), or leave it out"}});
}

}  // namespace

const char* gpu_build() { return ""; }
int gpu_walls(const Model&, int) { refuse(); }
std::unique_ptr<Executor> gpu_stepper(const Model&, int) { refuse(); }

}  // namespace wythe::dynamics
