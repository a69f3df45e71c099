// The memory and threads of a device, as DeviceStepper uses them:
//   T* allocate<T>(n)  release(p)  upload(to, from, n)  download(to, from, n)
//   run(n, walls, kernel)   kernel.on(i, wall) for all i < n and all walls, in any order
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <map>
#include <type_traits>
#include <vector>

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

// The device's copies of host arrays, found by the host's address, also from within an array.
template <class Device>
class Mirror {
 public:
  explicit Mirror(Device& device) : device_(device) {}
  ~Mirror() {
    for (const auto& [host, copy] : copies_) device_.release(copy.there);
  }
  Mirror(const Mirror&) = delete;
  Mirror& operator=(const Mirror&) = delete;

  template <class T>
  void add(const T* host, std::size_t n) {
    static_assert(std::is_trivially_copyable_v<T>);
    if (n == 0) return;
    T* there = device_.template allocate<T>(n);
    device_.upload(there, host, n);
    copies_[reinterpret_cast<const char*>(host)] = {reinterpret_cast<char*>(there), n * sizeof(T)};
  }
  template <class T>
  void add(const std::vector<T>& host) {
    add(host.data(), host.size());
  }
  // Turns host addresses into the device's; of empty arrays none.
  template <class... T>
  void turn(T*&... pointer) const {
    ((pointer = there(pointer)), ...);
  }
  template <class T>
  [[nodiscard]] T* there(T* host) const {
    const char* const at = reinterpret_cast<const char*>(host);
    auto found = copies_.upper_bound(at);
    if (found == copies_.begin()) return nullptr;
    --found;
    const std::size_t from_start = static_cast<std::size_t>(at - found->first);
    if (from_start >= found->second.bytes) return nullptr;
    return reinterpret_cast<T*>(found->second.there + from_start);
  }

 private:
  struct Copy {
    char* there;
    std::size_t bytes;
  };
  Device& device_;
  std::map<const char*, Copy> copies_;
};

}  // namespace wythe::dynamics
