#!/usr/bin/env bash
# ffstudy check: verdicts, exit codes, files; JUnit against the schema, also while gates are still running.
root=$(cd "$(dirname "$0")/../../.." && pwd)
source "$(dirname "$0")/../harness.sh"

# gate NAME KIND LINES...: one [[gate]] on rays in the cube.
gate() {
    printf '[[gate]]\nname = "%s"\nkind = "%s"\nscene = "cube"\nestimator = "ray_shooting"\nsamples_per_patch = 64\n' \
        "$1" "$2"
    shift 2
    printf '%s\n' "$@"
}
pass() { gate "${1:-right & proper}" bias 'sampler = "random"' 'band = 0.02'; }
fail_gate() { gate wrong bias 'sampler = "patch_centres"' 'band = 0.01'; }
undecided() { gate open bias 'sampler = "random"' 'trials = 4' 'band = 0.001'; }

valid_junit() { xmllint --noout --schema "$data/junit.xsd" "$1" 2>"$folder/stderr" || fail "$1 is no valid JUnit file"; }
# test_cases FILE XPATH: how many there are.
test_cases() { xmllint --xpath "count(//testcase$2)" "$1"; }

pass >pass.toml
ffstudy check pass.toml
expect_status 0
expect_no_stderr
expect_stdout "1 passed, 0 failed, 0 inconclusive."
valid_junit results/pass/junit.xml
ffstudy check pass.toml --json
expect_status 0
expect_equal_files "$folder/stdout" results/pass/verdicts.json
for file in verdicts.csv verdicts.json junit.xml summary.md summary.html context.json; do expect_file results/pass/$file; done
[ "$(wc -l <results/pass/verdicts.csv)" -eq 31 ] || fail "expected a row for each of 30 pairs"
expect_in_file results/pass/verdicts.csv "gate,scene,method,patches_per_face,samples_per_patch,from_face,to_face,quantity,value,ci_low,ci_high,band_low,band_high,verdict,minimum_detectable,alpha,power"

{ pass; fail_gate; undecided; } >all.toml
ffstudy check all.toml --out all
expect_status 1  # a failure goes before an undecided gate
expect_stdout "1 passed, 1 failed, 1 inconclusive."
valid_junit all/junit.xml
[ "$(test_cases all/junit.xml '')" -eq 3 ] || fail "expected a test case a gate"
[ "$(test_cases all/junit.xml '/failure')" -eq 1 ] || fail "expected one failure"
[ "$(test_cases all/junit.xml '/error')" -eq 1 ] || fail "expected one error"
{ grep -q "$(printf '\033')" "$folder/stdout" && fail "colours without a terminal"; } || true

{ pass; undecided; } >open.toml
ffstudy check open.toml
expect_status 4
valid_junit results/open/junit.xml

# Equal bytes for any number of threads; the seed decides.
ffstudy check all.toml --out again --threads 3 --quiet
expect_no_stdout
expect_equal_files all/verdicts.csv again/verdicts.csv
expect_equal_files all/verdicts.json again/verdicts.json
ffstudy check pass.toml --fresh-seed --out fresh
seed=$(sed -n 's/^fresh seed [0-9]*; again with --seed //p' "$folder/stdout")
[ -n "$seed" ] || fail "expected the fresh seed"
ffstudy check pass.toml --seed "$seed" --out replayed
expect_equal_files fresh/verdicts.csv replayed/verdicts.csv

# Written as gates finish: stopped before the last one, the file is valid, and red.
{ pass; gate slow bias 'sampler = "random"' 'trials = 200000' 'band = 1e-9' | sed 's/= 64$/= 65536/'; } >slow.toml
begin check slow.toml --out slow --threads 1
wait_until grep -qs 'errors="1"' slow/junit.xml
valid_junit slow/junit.xml
kill -INT "$process"
finish
expect_status 130
valid_junit slow/junit.xml
[ "$(test_cases slow/junit.xml '')" -eq 2 ] || fail "expected both gates"
[ "$(test_cases slow/junit.xml "[error/@type='not run']")" -eq 1 ] || fail "expected one gate that did not run"

# What is planned is shown, and nothing is written.
rm -rf results
ffstudy check all.toml --dry-run
expect_status 0
expect_stdout "about "
expect_stdout "bias"
[ ! -e results ] || fail "expected no results"

# Over many seeds: each a check of its own.
ffstudy check all.toml --seed-sweep 3 --out sweep
expect_status 1
expect_in_file sweep/seed_sweep.csv "right & proper,3,0,0,"
expect_in_file sweep/seed_sweep.csv "wrong,3,3,1,"
ffstudy check all.toml --seed-sweep 3 --threads 2 --out again
expect_equal_files sweep/seed_sweep.csv again/seed_sweep.csv

# Every column and key is explained.
explained() { grep -Fq "\`$1\`" "$root/docs/gates.md" || fail "docs/gates.md does not explain $1"; }
for column in $(head -qn 1 all/verdicts.csv sweep/seed_sweep.csv | tr , ' '); do explained "$column"; done
for key in $(grep -oE '"[a-z_0-9]+":' all/verdicts.json | cut -d'"' -f2 | sort -u); do explained "$key"; done
