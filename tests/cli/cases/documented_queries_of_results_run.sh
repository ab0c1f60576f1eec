#!/usr/bin/env bash
# The queries of docs/results.md that need nothing but Python run. (The others: tests/cli/examples_for_pandas_and_r.)
root=$(cd "$(dirname "$0")/../../.." && pwd)
source "$(dirname "$0")/../harness.sh"

ffstudy sr_vs_pdm --trials 2 --out paper
expect_status 0
blocks sql "$root/docs/results.md" 1 >query.sql
/usr/bin/python3 -c "import sqlite3
rows = sqlite3.connect('paper/results.sqlite').execute(open('query.sql').read()).fetchall()
assert [row[:2] for row in rows] == [(face, 2) for face in range(2, 7)], rows
assert all(abs(row[2] - 0.2) < 0.01 for row in rows), rows"
blocks python "$root/docs/results.md" 2 >"$folder/example.py"
(cd paper && /usr/bin/python3 "$folder/example.py") >"$folder/stdout"
grep -Eq "^patch 0 of face 1 to face 2: 0\.0[56]" "$folder/stdout" || fail "the example of patch sums gives something else"
