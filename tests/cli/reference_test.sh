#!/bin/sh
# The parts of docs/reference and web/src/headers made from the program's descriptions and help are up to date (make docs).
set -e
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
mkdir "$folder/reference" "$folder/headers"
cp "$SOURCE"/docs/reference/*.md "$folder/reference"
"$BUILD/wythe_reference" "$folder/reference" "$folder/headers"
"$SOURCE/tools/command_line" "$WYTHE" "$folder/reference/command_line.md"
diff -ru "$SOURCE/docs/reference" "$folder/reference"
diff -u "$SOURCE/web/src/headers/responses.ts" "$folder/headers/responses.ts"
