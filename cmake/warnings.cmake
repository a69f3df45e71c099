# wythe_warnings: the warnings every target of this repository is built with, as errors.
# Third-party headers come through imported targets, which CMake passes as SYSTEM: no warnings there.
option(WYTHE_WERROR "treat warnings as errors" ON)

add_library(wythe_warnings INTERFACE)
set(WYTHE_WARNINGS
  -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wnon-virtual-dtor -Wold-style-cast
  -Wcast-align -Woverloaded-virtual -Wnull-dereference -Wdouble-promotion -Wimplicit-fallthrough
  # int indices into std::vector are the house style (BlockId, JointId); g++ leaves this out of
  # -Wconversion, clang does not
  -Wno-sign-conversion
  $<$<BOOL:${WYTHE_WERROR}>:-Werror>
  $<$<CXX_COMPILER_ID:GNU>:-Wduplicated-cond>
  $<$<CXX_COMPILER_ID:GNU>:-Wlogical-op>)
# g++ 12 reports false -Wnull-dereference, -Wmaybe-uninitialized and -Wrestrict positives inside
# inlined library code under sanitizers and -O3 (GCC bugs 105562, 105651).
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  list(APPEND WYTHE_WARNINGS
    -Wno-null-dereference -Wno-restrict -Wno-maybe-uninitialized -Wno-array-bounds
    -Wno-stringop-overflow -Wno-stringop-overread)
endif()
target_compile_options(wythe_warnings INTERFACE "$<$<COMPILE_LANGUAGE:CXX>:${WYTHE_WARNINGS}>")
