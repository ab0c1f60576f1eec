#!/usr/bin/env bash
# docs/results.schema.json describes what the program writes, and tells other files apart. The queries of docs/results.md
# run, those that need nothing but Python; the others: tests/cli/examples_for_pandas_and_r.
here=$(cd "$(dirname "$0")/.." && pwd)
root=$(cd "$here/../.." && pwd)
source "$(dirname "$0")/../harness.sh"

validate() { /usr/bin/python3 "$here/validate_results" "$1" >"$folder/stdout" 2>"$folder/stderr"; }
expect_valid() { validate "$1" || fail "expected $1 to follow the schema"; }
expect_invalid() { ! validate "$1" || fail "expected $1 to break the schema: $2"; }

small_study 40 >"$folder/study.toml"
ffstudy run "$folder/study.toml" --out small
expect_status 0
expect_valid small/results.json
ffstudy sr_vs_pdm --trials 2 --out paper
expect_status 0
expect_valid paper/results.json
# Faces that see themselves, and a method that claims its errors.
cat >"$folder/other.toml" <<END
[study]
name = "other"
scene = ["hemisphere", "cube"]
trials = 20
seed = 1
inapplicable = "skip"

[[method]]
name = "rays"
sampler = "sobol"
estimator = "ray_shooting"
samples_per_patch = [16, 64, 256]

[[method]]
name = "adaptive"
estimator = "adaptive_contour"
samples_per_patch = [60, 90]
END
ffstudy run "$folder/other.toml" --out other
expect_status 0
expect_valid other/results.json
# A shard that lacks whole cells.
ffstudy run "$folder/study.toml" --shard 1/7 --out part
ffstudy report part
expect_valid part/results.json

# change PYTHON: the results of the small study with one thing changed.
change() {
    /usr/bin/python3 -c "import json; r = json.load(open('small/results.json')); cell = r['cells'][0]; $1
json.dump(r, open('changed.json', 'w'))"
}
for change in "r['more'] = 1" "del r['seed']" "r['schema'] = 'ffstudy.results/2'" "cell['trials'] = -1" \
    "cell['summaries'][0]['mean'] = 'much'" "del cell['bias_test']['alpha']" "cell['trials'] = 1.5" \
    "cell['summaries'][0]['bias_interval']['low'] = None" "cell['summaries'][0]['mean'] = float('nan')" \
    "cell['summaries'][0]['mean'] = float('inf')" "r['contests'][0]['equal'] = 'processor_time'" \
    "r['contests'][0]['ratios'][0]['ratio'] = 0.5" "del r['claimed_errors'][0]['held']"; do
    change "$change"
    expect_invalid changed.json "$change"
done
change ""
expect_valid changed.json

blocks sql "$root/docs/results.md" 1 >query.sql
/usr/bin/python3 -c "import sqlite3
rows = sqlite3.connect('paper/results.sqlite').execute(open('query.sql').read()).fetchall()
assert [row[:2] for row in rows] == [(face, 2) for face in range(2, 7)], rows
assert all(abs(row[2] - 0.2) < 0.01 for row in rows), rows"
blocks python "$root/docs/results.md" 2 >"$folder/example.py"
(cd paper && /usr/bin/python3 "$folder/example.py") >"$folder/stdout"
grep -Eq "^patch 0 of face 1 to face 2: 0\.0[56]" "$folder/stdout" || fail "the example of patch sums gives something else"
