# The same law and step for NVIDIA graphics processors: src/dynamics/gpu.cu in place of gpu_none.cpp.
if(NOT DEFINED CMAKE_CUDA_ARCHITECTURES)
  set(CMAKE_CUDA_ARCHITECTURES 80 90)
endif()
enable_language(CUDA)
set(CMAKE_CUDA_STANDARD 20)
list(FILTER WYTHE_SOURCES EXCLUDE REGEX "gpu_none")
set_property(TARGET wythe PROPERTY SOURCES ${WYTHE_SOURCES} src/dynamics/gpu.cu
  ${CMAKE_BINARY_DIR}/generated/report_assets.cpp)
# no fused multiply-add: the bits of the other processors
target_compile_options(wythe PRIVATE
  $<$<COMPILE_LANGUAGE:CUDA>:-fmad=false --expt-relaxed-constexpr -Xcompiler=-ffp-contract=off>)
