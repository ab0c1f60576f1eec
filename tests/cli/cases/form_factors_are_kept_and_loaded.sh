#!/usr/bin/env bash
# What `form_factors --out` keeps comes back to the byte; other files, other versions and damage are refused.
root=$(cd "$(dirname "$0")/../../.." && pwd)
source "$(dirname "$0")/../harness.sh"

blocks obj "$root/docs/scenes.md" >furnace.obj
ffstudy form-factors furnace.obj --tolerance 1e-3 --out plain
expect_status 0
cp "$folder/stdout" "$folder/plain"
ffstudy form-factors furnace.obj --tolerance 1e-3 --repair --out repaired
expect_status 0
cp "$folder/stdout" "$folder/repaired"
rm furnace.obj

# expect_same FOLDER FOLDER: all files are equal but for what the context says, of the store every row.
expect_same() {
    [ "$(ls "$1")" = "$(ls "$2")" ] || fail "expected the same files in $1 and $2"
    for file in $(ls -I form_factors.sqlite -I context.json "$1"); do expect_equal_files "$1/$file" "$2/$file"; done
    rows "$1/form_factors.sqlite" >"$folder/a"
    rows "$2/form_factors.sqlite" >"$folder/b"
    expect_equal_files "$folder/a" "$folder/b"
}

for run in plain repaired; do
    ffstudy form-factors --load $run --out again_$run
    expect_status 0
    expect_no_stderr
    expect_equal_files "$folder/$run" "$folder/stdout"
    expect_same $run again_$run
    expect_equal_files $run/context.json again_$run/context.json
    ffstudy form-factors --load $run/form_factors.sqlite
    expect_status 0
    expect_equal_files "$folder/$run" "$folder/stdout"
done

# A matrix is repaired later as it would have been at once.
ffstudy form-factors --load plain --repair --out later
expect_status 0
expect_equal_files "$folder/repaired" "$folder/stdout"
expect_same repaired later

# It can be repaired in its own folder; a file that a killed run left there does not prevent it.
: >plain/.ffstudy-part-0
ffstudy form-factors --load plain --repair --out plain --quiet
expect_status 0
expect_no_stdout
expect_same later plain
[ ! -e plain/.ffstudy-part-0 ] || fail "expected what a killed run has left to be removed"

# What is not within the tolerance is not when it is loaded either.
ffstudy form-factors discs_blocked --max-samples 1000000 --out missed
expect_status 4
cp "$folder/stdout" "$folder/missed"
ffstudy form-factors --load missed
expect_status 4
expect_equal_files "$folder/missed" "$folder/stdout"
ffstudy form-factors --load missed --repair
expect_status 2
expect_stderr "is not said to be closed"

# The queries of the document answer.
blocks sql "$root/docs/form-factors.md" >"$folder/query.sql"
[ -s "$folder/query.sql" ] || fail "docs/form-factors.md has no query"
mkdir results && mv repaired results/furnace
/usr/bin/python3 - "$folder/query.sql" <<'PYTHON' || fail "the query does not answer as it should"
import csv, sqlite3, sys
store = sqlite3.connect("results/furnace/form_factors.sqlite")
rows = store.execute(open(sys.argv[1]).read()).fetchall()
assert len(rows) == 5, rows
table = {(r["from"], r["to"]): r for r in csv.DictReader(open("results/furnace/matrix.csv"))}
view = store.execute('SELECT "from", "to", factor, low, high, half_width, method, reason, samples FROM form_factors').fetchall()
assert len(view) == len(table) == 42
for a, b, *rest in view:
    row = table[a, b]
    assert [float(row[k]) for k in ("factor", "low", "high", "half_width")] == rest[:4]
    assert [row["method"], row["reason"], row["samples"]] == [rest[4], rest[5], str(rest[6])]
PYTHON
for table in $(grep -oE 'CREATE (TABLE|VIEW) [a-z_]+' "$root/studies/form_factors/store/store.cpp" | cut -d' ' -f3); do
    grep -Fq "\`$table\`" "$root/docs/form-factors.md" || fail "docs/form-factors.md does not explain $table"
done

# Where the disk is full nothing is left that looks like a file.
(
    ulimit -f 12  # KiB
    ffstudy form-factors cube --out full
    expect_status 3
    expect_stderr "form_factors.sqlite"
    [ -z "$(ls full)" ] || fail "expected no files, found: $(ls full)"
)

# What is something else.
cp results/furnace/form_factors.sqlite "$folder/store.sqlite"
head -c 9000 missed/form_factors.sqlite >"$folder/half"
mkdir "$folder/refused" && cd "$folder/refused"
ffstudy form-factors --load missing
expect_refused 3 "missing: no such file"
echo "neither SQLite nor anything else" >"$folder/text"
ffstudy form-factors --load "$folder/text"
expect_refused 2 "no SQLite file"
/usr/bin/python3 -c "
import sqlite3, sys
sqlite3.connect('$folder/store.sqlite').executescript('UPDATE about SET value = 99 WHERE key = \'schema_version\'')"
ffstudy form-factors --load "$folder/store.sqlite" --out out
expect_refused 2 "schema version 99 (this program reads 1 to 4)"
ffstudy form-factors --load "$folder/half" --out out
expect_refused 3 "half"
ffstudy form-factors --load "$folder/store.sqlite" cube
expect_refused 2 "SCENE"
for option in "--tolerance 1e-3" "--level 0.9" --simultaneous "--seed 2" "--threads 2" "--max-time 1m" "--max-samples 5"; do
    # shellcheck disable=SC2086  # two words
    ffstudy form-factors --load "$folder/store.sqlite" $option
    expect_refused 2 "${option%% *}"
done
ffstudy form-factors
expect_refused 2 "SCENE is missing"
