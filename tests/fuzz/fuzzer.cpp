// libFuzzer feeds the target that WYTHE_FUZZ_TARGET names (tools/fuzz).
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "fuzz/targets.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const wythe::fuzz::Target* const kTarget = [] {
    const char* name = std::getenv("WYTHE_FUZZ_TARGET");
    for (const wythe::fuzz::Target& target : wythe::fuzz::targets())
      if (name != nullptr && std::string_view(name) == target.name) return &target;
    std::fprintf(stderr, "WYTHE_FUZZ_TARGET names no target:");
    for (const wythe::fuzz::Target& target : wythe::fuzz::targets())
      std::fprintf(stderr, " %s", target.name);
    std::fprintf(stderr, "\n");
    std::exit(2);
  }();
  wythe::fuzz::feed(*kTarget, std::string(reinterpret_cast<const char*>(data), size));
  return 0;
}
