// OpenTURNS reads its settings while it is loaded, before main: from variables, and from a file in the caller's
// home. A variable that is no number or a damaged file ended the program there, and a changed one drew other samples
// from the same study. So both are out of its sight until it is loaded: the entries of .preinit_array are called
// before any library starts, with the environment as an argument. No function of a library may be called there,
// and no sanitizer is ready.
#include "environment.h"

namespace wythe::app {
namespace {

char* hidden_home = nullptr;  // the entry HOME=..., whose first letter is another

#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define WYTHE_IS_SANITIZED
#endif
#elif defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define WYTHE_IS_SANITIZED
#endif
#ifndef WYTHE_IS_SANITIZED

bool begins_with(const char* entry, const char* name) {
  for (; *name != '\0'; ++name, ++entry)
    if (*entry != *name) return false;
  return true;
}

void hide_settings(int /*count*/, char** /*arguments*/, char** environment) {
  char** kept = environment;
  for (char** entry = environment; *entry != nullptr; ++entry) {
    if (begins_with(*entry, "OPENTURNS_")) continue;
    if (begins_with(*entry, "HOME=")) {
      hidden_home = *entry;
      hidden_home[0] = '_';
    }
    *kept++ = *entry;
  }
  *kept = nullptr;
}

using Early = void (*)(int, char**, char**);
[[gnu::section(".preinit_array"), gnu::used]] const Early kFirst = hide_settings;

#endif

}  // namespace

void show_home_again() {
  if (hidden_home != nullptr) hidden_home[0] = 'H';
}

}  // namespace wythe::app
