// The memory and threads of a device, as DeviceExecutor uses them:
//   T* allocate<T>(n)  release(p)  upload(to, from, n)  download(to, from, n)
//   run(n, walls, kernel)   kernel.on(i, wall) for all i < n and all walls, in any order
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdlib>

#include "dynamics/passes/tables.h"

namespace wythe::dynamics {

// This processor in the place of a device, for the tests: its memory is apart from the host's, so that
// what is not sent is not there.
struct HostDevice {
  bool backwards = false;  // threads come in any order
  template <class T>
  T* allocate(std::size_t n) {
    return static_cast<T*>(std::calloc(n, sizeof(T)));
  }
  template <class T>
  void release(T* there) {
    std::free(there);
  }
  template <class T>
  void upload(T* to, const T* from, std::size_t n) {
    std::copy_n(from, n, to);
  }
  template <class T>
  void download(T* to, const T* from, std::size_t n) {
    std::copy_n(from, n, to);
  }
  template <class Kernel>
  void run(std::size_t n, int walls, const Kernel& kernel) {
    for (std::size_t i = 0; i < n; ++i)
      for (int wall = 0; wall < walls; ++wall)
        backwards ? kernel.on(n - 1 - i, walls - 1 - wall) : kernel.on(i, wall);
  }
};

// An array on a device, and its copy here (none where nobody reads it).
template <class Device, class T>
class Shared {
 public:
  Shared(Device& device, std::size_t n, bool copied = true)
      : device_(device), here(copied ? n : 0) {
    there = device_.template allocate<T>(n);
  }
  ~Shared() { device_.release(there); }
  Shared(const Shared&) = delete;
  Shared& operator=(const Shared&) = delete;
  void send() { device_.upload(there, here.data(), here.size()); }
  void fetch() { device_.download(here.data(), there, here.size()); }

 private:
  Device& device_;

 public:
  Lines<T> here;
  T* there = nullptr;
};

}  // namespace wythe::dynamics
