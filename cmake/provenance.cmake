# wythe_provenance: which source and which compiler made this build.
# Writes ${CMAKE_BINARY_DIR}/generated/wythe_provenance.h (read by src/core/provenance.cpp) on every
# build, but touches it only when a value changed: HEAD moved, the tree became dirty, other flags.
string(TOUPPER "${CMAKE_BUILD_TYPE}" wythe_config)
string(STRIP "${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${wythe_config}} -ffp-contract=off" wythe_flags)
string(REGEX REPLACE "-f[a-z]+-prefix-map=[^ ]+ *" "" wythe_flags "${wythe_flags}")  # names the folder, changes no code
set(wythe_provenance_arguments
  -DSOURCE_DIR=${CMAKE_SOURCE_DIR}
  -DOUTPUT=${CMAKE_BINARY_DIR}/generated/wythe_provenance.h
  -DVERSION=${PROJECT_VERSION}
  "-DCOMPILER=${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}"
  "-DFLAGS=${wythe_flags}"
  "-DBUILD_TYPE=${CMAKE_BUILD_TYPE}"
  -P ${CMAKE_SOURCE_DIR}/cmake/write_provenance.cmake)

execute_process(COMMAND ${CMAKE_COMMAND} ${wythe_provenance_arguments})
add_custom_target(wythe_provenance_header
  COMMAND ${CMAKE_COMMAND} ${wythe_provenance_arguments}
  BYPRODUCTS ${CMAKE_BINARY_DIR}/generated/wythe_provenance.h
  COMMENT "Provenance"
  VERBATIM)

add_library(wythe_provenance INTERFACE)
add_dependencies(wythe_provenance wythe_provenance_header)
target_include_directories(wythe_provenance INTERFACE ${CMAKE_BINARY_DIR}/generated)
