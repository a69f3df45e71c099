#!/bin/sh
# What docs/reference takes from the program's own descriptions and help is what they say (make docs).
set -e
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cp "$SOURCE"/docs/reference/*.md "$folder"
"$BUILD/wythe_reference" "$folder"
"$SOURCE/tools/command_line" "$WYTHE" "$folder/command_line.md"
diff -ru "$SOURCE/docs/reference" "$folder"
