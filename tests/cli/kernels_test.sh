#!/bin/sh
# Code compiled for newer processors shares no function with the rest: every function of the AVX2 and
# AVX-512 kernels must carry the instruction set in its name, or the linker could hand it to older
# machines.
status=77
for set in avx2 avx512; do
  objects=$(find "$BUILD" -name "*kernels_$set.cpp.o" -not -path "*/watched/*")
  [ -n "$objects" ] || { echo "no $set kernels in this build"; continue; }
  [ $status = 77 ] && status=0
  shared=$(echo "$objects" | xargs nm -C --defined-only | grep -E ' [WVu] ' | grep -v -e "$set" -e personality)
  [ -z "$shared" ] && continue
  echo "functions of the $set kernels that other files could be given:"
  echo "$shared"
  status=1
done
exit $status
