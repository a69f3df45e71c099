// DeviceExecutor on an NVIDIA graphics processor. Compiled with -fmad=false: the bits are those of the
// other processors (docs/architecture.md).
#include <cuda_runtime.h>

#include <algorithm>
#include <string>

#include "dynamics/executors/device_step.h"
#include "dynamics/executors/gpu.h"
#include "wythe/error.h"

namespace wythe::dynamics {
namespace {

[[noreturn]] void refuse(const std::string& problem, const std::string& cure) {
  throw InputError(
      {{.file = "--device", .path = "", .value = "gpu", .problem = problem, .cure = cure}});
}

void check(cudaError_t code) {
  if (code == cudaSuccess) return;
  throw IoError(
      std::string("the graphics processor failed: ") + cudaGetErrorString(code) +
      "; what is stored is whole: go on with --resume, without --device if it fails again");
}

// Threads of a block stand side by side in walls: they read neighbouring numbers.
template <class Kernel>
__global__ void each(const Kernel kernel, std::size_t n, int walls) {
  const int wall = static_cast<int>(blockIdx.x * blockDim.x + threadIdx.x);
  const std::size_t i = static_cast<std::size_t>(blockIdx.y) * blockDim.y + threadIdx.y;
  if (wall < walls && i < n) kernel.on(i, wall);
}

// All on the default stream: a download waits for what was launched before it.
struct CudaDevice {
  template <class T>
  T* allocate(std::size_t n) {
    void* there = nullptr;
    check(cudaMalloc(&there, n * sizeof(T)));
    check(cudaMemset(there, 0, n * sizeof(T)));
    return static_cast<T*>(there);
  }
  template <class T>
  void release(T* there) {
    cudaFree(there);
  }
  template <class T>
  void upload(T* to, const T* from, std::size_t n) {
    check(cudaMemcpy(to, from, n * sizeof(T), cudaMemcpyHostToDevice));
  }
  template <class T>
  void download(T* to, const T* from, std::size_t n) {
    check(cudaMemcpy(to, from, n * sizeof(T), cudaMemcpyDeviceToHost));
  }
  template <class Kernel>
  void run(std::size_t n, int walls, const Kernel& kernel) {
    if (n == 0) return;
    const dim3 block = walls > 1 ? dim3(32, 4) : dim3(1, 128);
    const dim3 grid((static_cast<unsigned>(walls) + block.x - 1) / block.x,
                    (static_cast<unsigned>(n) + block.y - 1) / block.y);
    each<<<grid, block>>>(kernel, n, walls);
    check(cudaGetLastError());
  }
};

// Device memory of one wall, a little more than it takes [bytes].
std::size_t bytes_of(const Model& m) {
  const auto blocks = static_cast<std::size_t>(m.n_block + m.solids.n_node);
  const auto joints = static_cast<std::size_t>(m.n_joint + m.solids.n_contact);
  const auto zones = static_cast<std::size_t>(m.solids.n_zone);
  const auto points = static_cast<std::size_t>(m.n_history());
  return sizeof(double) *
         (40 * blocks + 16 * joints + 6 * points + 8 * zones + 32 * m.materials.size() + 64);
}

}  // namespace

const char* gpu_build() { return ", gpu"; }

int gpu_walls(const Model& model, int most) {
  int devices = 0;
  if (cudaGetDeviceCount(&devices) != cudaSuccess || devices == 0)
    refuse("is not in this machine, or its driver does not answer", "leave --device out");
  cudaFuncAttributes compiled;
  if (cudaFuncGetAttributes(&compiled, each<device::PlaceLoads>) != cudaSuccess)
    refuse("is of a kind this program was not compiled for",
           "build with its CMAKE_CUDA_ARCHITECTURES (docs/howto/gpu.md), or leave --device out");
  std::size_t free = 0, total = 0;
  check(cudaMemGetInfo(&free, &total));
  const std::size_t fit = free / 10 * 9 / bytes_of(model);
  if (fit < 2)
    refuse("is too small: its free memory of " + std::to_string(free >> 20) +
               " MiB holds fewer than two walls of " + std::to_string(bytes_of(model) >> 10) +
               " KiB",
           "leave --device out");
  constexpr int kEnough = 1024, kWarp = 32;
  const int wanted = (std::clamp(most, 2, kEnough) + kWarp - 1) / kWarp * kWarp;
  return static_cast<int>(std::min<std::size_t>(fit, static_cast<std::size_t>(wanted)));
}

std::unique_ptr<Executor> gpu_stepper(const Model& model, int walls) {
  return std::make_unique<DeviceExecutor<CudaDevice>>(model, walls);
}

}  // namespace wythe::dynamics
