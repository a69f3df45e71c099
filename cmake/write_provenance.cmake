# Script of provenance.cmake: writes OUTPUT when its content would change. Works without git: an archive of the sources
# names its commit in commit.txt, where git archive puts it.
set(commit "unknown")
file(READ ${CMAKE_CURRENT_LIST_DIR}/commit.txt archived)
if(archived MATCHES "^[0-9a-f]+")
  string(SUBSTRING "${archived}" 0 12 commit)
endif()
find_program(GIT git)
if(GIT)
  # A repository around an unpacked archive, as of a home folder, is another one.
  execute_process(COMMAND ${GIT} -C ${SOURCE_DIR} rev-parse --short=12 HEAD
    OUTPUT_VARIABLE head RESULT_VARIABLE failed OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  execute_process(COMMAND ${GIT} -C ${SOURCE_DIR} rev-parse --show-cdup
    OUTPUT_VARIABLE above OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  if(NOT failed AND above STREQUAL "")
    set(commit "${head}")
    # Tracked files, and new ones that are compiled in; a run's output folder in the tree does not make the build dirty.
    execute_process(COMMAND ${GIT} -C ${SOURCE_DIR} status --porcelain --untracked-files=no
      OUTPUT_VARIABLE changes OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
    execute_process(COMMAND ${GIT} -C ${SOURCE_DIR} ls-files --others --exclude-standard -- src include apps cmake python
      OUTPUT_VARIABLE added OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
    if(changes OR added)
      string(APPEND commit "-dirty")
    endif()
  endif()
endif()

string(REPLACE "\\" "\\\\" FLAGS "${FLAGS}")
string(REPLACE "\"" "\\\"" FLAGS "${FLAGS}")
set(content "// Written by cmake/write_provenance.cmake.
#pragma once
#define WYTHE_VERSION \"${VERSION}\"
#define WYTHE_COMMIT \"${commit}\"
#define WYTHE_COMPILER \"${COMPILER}\"
#define WYTHE_FLAGS \"${FLAGS}\"
#define WYTHE_BUILD_TYPE \"${BUILD_TYPE}\"
")
set(previous "")
if(EXISTS "${OUTPUT}")
  file(READ "${OUTPUT}" previous)
endif()
if(NOT previous STREQUAL content)
  file(WRITE "${OUTPUT}" "${content}")
endif()
