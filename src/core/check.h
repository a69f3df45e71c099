// WYTHE_ASSERT(condition, what) finds programming errors. It is active in the builds dev, audit, asan and fuzz alone.
#pragma once

#include <cstdio>
#include <cstdlib>

#ifdef WYTHE_ASSERTIONS
#define WYTHE_ASSERT(condition, what)                                                           \
  do {                                                                                          \
    if (!(condition)) {                                                                         \
      std::fprintf(stderr, "%s:%d: assertion failed: %s: %s\n", __FILE__, __LINE__, #condition, \
                   what);                                                                       \
      std::abort();                                                                             \
    }                                                                                           \
  } while (false)
#else
#define WYTHE_ASSERT(condition, what) static_cast<void>(0)
#endif
