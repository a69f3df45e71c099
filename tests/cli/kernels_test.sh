#!/bin/sh
# Code compiled for newer processors shares no function with the rest: every function of the AVX2
# kernels must carry the instruction set in its name, or the linker could hand it to older machines.
object=$(find "$BUILD" -name 'kernels_avx2.cpp.o' | head -n 1)
[ -n "$object" ] || { echo "no AVX2 kernels in this build"; exit 77; }
shared=$(nm -C --defined-only "$object" | grep -E ' [WVu] ' | grep -v -e avx2 -e personality)
[ -z "$shared" ] && exit 0
echo "functions of the AVX2 kernels that other files could be given:"
echo "$shared"
exit 1
