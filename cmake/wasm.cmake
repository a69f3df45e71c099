# The engine as WebAssembly (cmake --preset wasm): the C interface for a page or Node, without campaigns, their store and HDF5. Results
# have the bits of the native program. Header-only libraries are those of the machine that builds; the sysroot has none of them.
foreach(header fmt/format.h toml++/toml.h nlohmann/json.hpp xsimd/xsimd.hpp fast_float/fast_float.h boost/version.hpp Eigen/Dense)
  get_filename_component(name ${header} DIRECTORY)
  find_path(place ${header} PATHS /usr/include PATH_SUFFIXES eigen3 REQUIRED NO_CACHE NO_CMAKE_FIND_ROOT_PATH)
  file(MAKE_DIRECTORY ${CMAKE_BINARY_DIR}/headers)
  file(CREATE_LINK ${place}/${name} ${CMAKE_BINARY_DIR}/headers/${name} SYMBOLIC)
  unset(place)
endforeach()

file(GLOB_RECURSE sources CONFIGURE_DEPENDS src/*.cpp)
list(FILTER sources EXCLUDE REGEX
  "/src/(campaign/(store|runner)|statistics|io/export|io/study)/|/src/wasm/|/api/(batch|campaign_folders|study_tasks)[.]cpp$")
list(FILTER sources EXCLUDE REGEX "/(hdf5_tables|deflate|campaign_data)[.]cpp$|kernels_avx[0-9]+[.]cpp$")
# What the task assess takes of the rooms that are left out.
foreach(source campaign/runner/handed_sample campaign/runner/sample_run campaign/runner/shakes campaign/store/record_rows
    io/study/assess_study io/study/shaking_file io/study/study_file io/study/variants
    statistics/ensemble statistics/fragility statistics/intervals statistics/one_push statistics/pga_fragility statistics/scatter
    statistics/statistics statistics/until_rule statistics/verdict)
  list(APPEND sources ${CMAKE_SOURCE_DIR}/src/${source}.cpp)
endforeach()
# What runs in each step is optimised most; the rest is compiled ten sources of a folder at a time, which takes a third of the time.
set(warm ${sources})
list(FILTER warm INCLUDE REGEX "/src/(dynamics|contact|solids|core|limit)/")
set_source_files_properties(${warm} PROPERTIES COMPILE_OPTIONS -O3)
include(cmake/batches.cmake)
set(WYTHE_WATCHED "/(convex_parts|mesh_cut|pieces)[.]cpp$")
wythe_batches("${sources}")
file(GLOB_RECURSE kernels src/dynamics/*.cpp)
set_source_files_properties(${kernels} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
add_library(wythe_engine OBJECT ${sources} ${CMAKE_BINARY_DIR}/generated/assets.cpp)
target_include_directories(wythe_engine PUBLIC include src ${CMAKE_BINARY_DIR}/generated)
target_include_directories(wythe_engine SYSTEM PUBLIC ${CMAKE_BINARY_DIR}/headers)
target_compile_definitions(wythe_engine PUBLIC EIGEN_DONT_VECTORIZE FMT_HEADER_ONLY WYTHE_SSE2_KERNELS)
target_compile_options(wythe_engine PUBLIC -O1 -fwasm-exceptions -msse2 -msimd128 -ffp-contract=off)
target_link_libraries(wythe_engine PUBLIC wythe_provenance)
set_target_properties(wythe_engine PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)

add_executable(wythe_wasm src/wasm/engine.cpp src/wasm/stored.cpp)
target_link_libraries(wythe_wasm PRIVATE wythe_engine)
set_target_properties(wythe_wasm PROPERTIES OUTPUT_NAME wythe RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR})
# Eight megabytes of stack as a program has; memory grows as a wall needs it. Files are in memory; Node sees the machine's too.
target_link_options(wythe_wasm PRIVATE -O2 -fwasm-exceptions --no-entry -lnodefs.js
  -sMODULARIZE -sEXPORT_NAME=wytheEngine -sENVIRONMENT=web,worker,node -sALLOW_MEMORY_GROWTH -sMAXIMUM_MEMORY=4GB -sTOTAL_STACK=8MB
  -sEXPORTED_FUNCTIONS=_malloc,_free,_wythe_version,_wythe_new,_wythe_free,_wythe_set_text,_wythe_set_number,_wythe_set_column,_wythe_do_here,_wythe_text,_wythe_column
  -sEXPORTED_RUNTIME_METHODS=UTF8ToString,stringToUTF8,lengthBytesUTF8,FS,NODEFS,HEAPF64,HEAPU8)

# build/wasm/package: what npm packs; `make studio` adds the page to draw walls on, and a new engine removes that of the one before, as does a new
# script of the worker (kEngine in apps/wasm/page.mjs).
configure_file(apps/wasm/package.json.in package/package.json @ONLY)
set(package ${CMAKE_BINARY_DIR}/package)
add_custom_command(TARGET wythe_wasm POST_BUILD
  COMMAND ${CMAKE_COMMAND} -E copy ${CMAKE_BINARY_DIR}/wythe.js ${package}/wythe.cjs
  COMMAND ${CMAKE_COMMAND} -E copy ${CMAKE_BINARY_DIR}/wythe.wasm ${package}/wythe.wasm
  COMMAND ${CMAKE_COMMAND} -E rm -f ${package}/studio_page.html VERBATIM)
file(GLOB scripts RELATIVE ${CMAKE_SOURCE_DIR} CONFIGURE_DEPENDS apps/wasm/*.mjs apps/wasm/*.js)
foreach(file ${scripts} apps/wasm/README.md LICENSE)
  configure_file(${file} ${package} COPYONLY)
endforeach()
foreach(file worker.js job.mjs)
  if(${CMAKE_SOURCE_DIR}/apps/wasm/${file} IS_NEWER_THAN ${package}/studio_page.html)
    file(REMOVE ${package}/studio_page.html)
  endif()
endforeach()
