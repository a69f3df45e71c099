#!/bin/sh
# Installs build/<preset> to a throw-away prefix, builds the programs of docs/howto/cpp.md against it, runs them.
set -e
here=$(cd "$(dirname "$0")" && pwd)
root=$here/../..
build=${BUILD:-$root/build/release}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
shown() { "$@" >"$work/log" 2>&1 || { cat "$work/log"; exit 1; }; }
mkdir -p "$work/build/programs"
awk -v folder="$work/build/programs" '/^```cpp$/ {file = folder "/program_" ++n ".cpp"; next} /^```$/ {file = ""} file {print > file}' \
  "$root/docs/howto/cpp.md"
shown cmake --install "$build" --prefix "$work/prefix"
shown cmake -S "$here" -B "$work/build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_PREFIX_PATH="$work/prefix"
shown cmake --build "$work/build"
cp "$root/examples/brick_pier/model.toml" "$work/model.toml"
cd "$work"
# what a program says, and what it has to say
says() {
  found=$("$1")
  echo "$found" | grep -Eq "$2" || { echo "$1 says \"$found\", and not \"$2\""; exit 1; }
}
says build/program_1 '^[0-9.]+ kN at [0-9.]+ mm, '
says build/program_2 '^[0-9]+ blocks weigh 6780\.7 N$'   # 1.6 x 1.2 x 0.2 x 1800 x 9.81
says build/program_3 '^[0-9]+ bodies weigh 52422 N$'  # (2.875 + 1.875) x 2.5 x 0.25 x 1800 x 9.81
prefix/bin/wythe --version >/dev/null
