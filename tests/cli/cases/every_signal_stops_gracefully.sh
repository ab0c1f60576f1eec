#!/usr/bin/env bash
source "$(dirname "$0")/../harness.sh"

small_study 400 >"$folder/study.toml"
ffstudy run "$folder/study.toml" --threads 1 --out whole
expect_status 0
all=$(saved units whole)

# stopped SIGNAL: a run that gets this signal when its first unit is saved. It may be faster, and lack no unit all the same.
stopped() {
    rm -rf "$1"
    begin run "$folder/study.toml" --threads 2 --out "$1"
    wait_until is_over_or test -s "$1/results.sqlite-wal"
    kill -"$1" "$process" 2>/dev/null || true
    finish
    [ "$(saved units "$1")" -lt "$all" ]
}
for signal in INT TERM USR1; do
    until stopped $signal; do try_again "the study was over before it could be stopped"; done
    expect_status 130
    expect_stderr "stopping: finishing 2 work units (two seconds at most); Ctrl-C again to drop them"
    expect_stderr "Run the same command again to resume."
    expect_in_file $signal/report.md "Partial result"
    ffstudy run "$folder/study.toml" --threads 2 --out $signal
    expect_status 0
    expect_same_results whole $signal
done

# slow OUT: begins a study of one unit that is saved when this returns, and of others that would take minutes.
cat >"$folder/slow.toml" <<'STUDY'
[study]
name = "slow"
scene = "cube"
trials = 2
seed = 1

[[method]]
name = "exact"
estimator = "closed_form"

[[method]]
name = "slow"
sampler = "sobol"
estimator = "ray_shooting"
tracer = "embree"
samples_per_patch = 1073741824
STUDY
slow() {
    begin run "$folder/slow.toml" --threads 2 --out "$1"
    wait_until test -s "$1/results.sqlite-wal"
}

# They are not waited for.
slow dropped
kill -INT "$process"
finish
expect_status 130
expect_in_file dropped/report.md "Partial result"
[ "$(saved units dropped)" -eq 1 ] || fail "expected the units in progress to be dropped"

# A second signal waits neither for the units in hand nor for reports. (Signals are met in the order of their numbers:
# these two before the alarm that drops units, however late that is.)
slow at_once
kill -STOP "$process"  # so that it meets both signals at once
kill -INT "$process"
kill -USR1 "$process"
kill -CONT "$process"
finish
expect_status 130
[ ! -e at_once/report.md ] || fail "expected no report after a second signal"
