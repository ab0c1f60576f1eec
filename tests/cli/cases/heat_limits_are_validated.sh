#!/usr/bin/env bash
# docs/validation.md has the rows that the program prints of the limits of flows, and says that all claims hold. Rates
# differ: here there are few seeds, at a larger tolerance.
root=$(cd "$(dirname "$0")/../../.." && pwd)
source "$(dirname "$0")/../harness.sh"

rows() { grep -E '^(###|\|)' | sed -E 's/^\| *([^|]*[^| ]) *\|.*/\1/'; }

ffstudy heat_selftest --seeds 2 --tolerance 0.02 --out .
expect_status 0
expect_no_stderr
expect_equal_files "$folder/stdout" selftest.md
rows <"$folder/stdout" >"$folder/printed"
page=$(sed -n '/^<!-- heat -->$/,/^<!-- end of heat -->$/p' "$root/docs/validation.md")
rows <<<"$page" >"$folder/documented"
[ "$(wc -l <"$folder/printed")" -gt 20 ] || fail "expected more than 20 rows"
expect_equal_files "$folder/printed" "$folder/documented"
grep -Fq '**All claims hold.**' <<<"$page" || fail "docs/validation.md does not say that all claims hold"
