#!/bin/sh
# The committed reference page of all keys is what the program's own descriptions say (make docs).
set -e
page=$(mktemp)
trap 'rm -f "$page"' EXIT
"$BUILD/wythe_reference" "$page"
diff -u "$SOURCE/docs/reference/model.md" "$page"
