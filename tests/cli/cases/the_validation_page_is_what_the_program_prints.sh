#!/usr/bin/env bash
# docs/validation.md has the headings and rows that the program prints, and says that all claims hold. Rates differ: here
# there are few repetitions.
root=$(cd "$(dirname "$0")/../../.." && pwd)
source "$(dirname "$0")/../harness.sh"

# rows: headings, and what each row of a table is about.
rows() { grep -E '^(###|\|)' | sed -E 's/^\| *([^|]*[^| ]) *\|.*/\1/'; }

ffstudy gates_selftest --seeds 3 --repetitions 40 --out .
expect_no_stderr
expect_equal_files "$folder/stdout" selftest.md
rows <"$folder/stdout" >"$folder/printed"
sed -n '/^<!-- selftest -->$/,/^<!-- end of selftest -->$/p' "$root/docs/validation.md" | rows >"$folder/documented"
[ "$(wc -l <"$folder/printed")" -gt 80 ] || fail "expected more than 80 rows"
expect_equal_files "$folder/printed" "$folder/documented"
expect_in_file "$root/docs/validation.md" "**All claims hold.**"
