# The same law and step for NVIDIA graphics processors: src/dynamics/executors/gpu.cu in place of gpu_none.cpp.
if(NOT DEFINED CMAKE_CUDA_ARCHITECTURES)
  set(CMAKE_CUDA_ARCHITECTURES 80 90)
endif()
enable_language(CUDA)
# CMake 3.25 does not know how nvcc 13 is asked for C++20
if(NOT CMAKE_CUDA20_STANDARD_COMPILE_OPTION)
  set(CMAKE_CUDA20_STANDARD_COMPILE_OPTION -std=c++20)
endif()
list(FILTER WYTHE_SOURCES EXCLUDE REGEX "gpu_none")
set_property(TARGET wythe PROPERTY SOURCES ${WYTHE_SOURCES} src/dynamics/executors/gpu.cu
  ${CMAKE_BINARY_DIR}/generated/assets.cpp)
# -fmad=false: no fused multiply-add, the bits of the other processors
set_target_properties(wythe PROPERTIES CUDA_STANDARD 20)
target_compile_options(wythe PRIVATE
  "$<$<COMPILE_LANGUAGE:CUDA>:-fmad=false;--expt-relaxed-constexpr;-diag-suppress=1675;-Xcompiler=-ffp-contract=off>")
