#!/usr/bin/env bash
# Programs that show manuals find no fault with the pages except that they have no date: the same program, the same bytes.
# Needs mandoc.
source "$(dirname "$0")/../harness.sh"

ffstudy man_pages manual
expect_status 0
for page in manual/*.1; do
    mandoc -Tlint -W warning "$page" >"$folder/stdout" || true
    ! grep -v 'missing date' "$folder/stdout" || fail "$page has faults"
done
