#!/usr/bin/env bash
source "$(dirname "$0")/../harness.sh"

# start STUDY OUT: runs it in the background and returns when its first unit is saved.
start() {
    command_line="ffstudy run (to be stopped)" status=0
    "$program" run "$1" --threads 2 --out "$2" >"$folder/stdout" 2>"$folder/stderr" </dev/null &
    process=$!
    until [ -n "$(find "$2" -name results.sqlite-wal -size +0 2>/dev/null)" ]; do
        kill -0 $process || fail "the study was over before it could be stopped"
        sleep 0.01
    done
}

small_study 400 >"$folder/study.toml"
ffstudy run "$folder/study.toml" --out whole
expect_status 0
for signal in INT TERM USR1; do
    start "$folder/study.toml" $signal
    kill -$signal $process
    wait $process || status=$?
    expect_status 130
    expect_stderr "stopping: finishing the work units in progress"
    expect_stderr "Run the same command again to resume."
    expect_in_file $signal/report.md "Partial result"
    ffstudy run "$folder/study.toml" --out $signal
    expect_status 0
    expect_same_results whole $signal
done

# Units that would take minutes are not waited for.
sed 's/^samples_per_patch = 64/samples_per_patch = 64000000/' "$folder/study.toml" >"$folder/slow.toml"
start "$folder/slow.toml" hours
kill -INT $process
wait $process || status=$?
expect_status 130
expect_in_file hours/report.md "Partial result"

# A second signal does not wait for the units in hand nor for reports.
start "$folder/slow.toml" slow
kill -STOP $process  # so that it meets both signals at once
kill -INT $process
kill -TERM $process
kill -CONT $process
wait $process || status=$?
expect_status 130
[ ! -e slow/report.md ] || fail "expected no report after a second signal"
