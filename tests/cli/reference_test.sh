#!/bin/sh
# What docs/reference takes from the program's own descriptions is what they say (make docs).
set -e
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cp "$SOURCE"/docs/reference/*.md "$folder"
"$BUILD/wythe_reference" "$folder"
diff -ru "$SOURCE/docs/reference" "$folder"
