#!/bin/sh
# The parts of docs/reference made from the program's descriptions and help are up to date (make docs).
set -e
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cp "$SOURCE"/docs/reference/*.md "$folder"
"$BUILD/wythe_reference" "$folder"
"$SOURCE/tools/command_line" "$WYTHE" "$folder/command_line.md"
diff -ru "$SOURCE/docs/reference" "$folder"
