#!/usr/bin/env bash
# A signal ends form_factors in order: what is known is written, and holds. A second one ends it at once.
source "$(dirname "$0")/../harness.sh"

# F 1-2 of this scene is known; finding it to within the tolerance would take hours. The level is such that an interval
# misses it once in a million runs.
exact=$("$program" list configurations | awk '$1 == "discs_blocked" {print; exit}' | grep -oE '0\.[0-9]{12,}')

# start OUT WORK: begins it, and returns when it has used so much processor time, in hundredths of a second.
start() {
    begin form_factors discs_blocked --tolerance 1e-6 --level 0.999999 --max-samples 1000000000000 --threads 2 --out "$1"
    wait_until takes_signals
    wait_until has_used "$2"
}

# Stopped ever later, from before there is anything to write to when rays have been sampled.
for work in 1 2 4 8 16 32 64 128 256 512 1024 2048 4096; do
    start stopped $work
    kill -INT "$process"
    finish
    expect_status 130
    expect_no_stderr
    if [ ! -s "$folder/stdout" ]; then
        # The lock may be left where the signal comes when it is taken.
        [ -z "$(find . -type f ! -name .ffstudy.lock)" ] || fail "expected no files, found: $(find . -type f)"
        continue
    fi
    expect_stdout "NOT within 1e-06: 1-"
    expect_stdout "Stopped before the sampling was done"
    for file in matrix.csv form_factors.npy half_widths.mtx areas.npy form_factors.json form_factors.sqlite context.json; do
        expect_file stopped/$file
    done
    awk -F, -v exact="$exact" '$1 == 1 && $2 == 2 {found = $4 <= exact && exact <= $5 && $11 == 0} END {exit !found}' \
        stopped/matrix.csv || fail "the interval does not hold $exact: $(cat stopped/matrix.csv)"
    cp "$folder/stdout" "$folder/stopped"
    ffstudy form-factors --load stopped
    expect_status 4
    expect_equal_files "$folder/stopped" "$folder/stdout"
    ! grep -q ",rays," stopped/matrix.csv || break
    rm -r stopped
done
expect_in_file stopped/matrix.csv ",rays,"

# Both signals at once: nothing is written. (What the first one asks for may be done before the second one is met.)
stopped_at_once() {
    rm -rf at_once
    start at_once $work
    kill -STOP "$process"
    kill -INT "$process"
    kill -TERM "$process"
    kill -CONT "$process"
    finish
    [ ! -s "$folder/stdout" ] && [ ! -e at_once ]
}
if ! runs_with_tsan; then
    until stopped_at_once; do try_again "expected nothing to be left by a second signal"; done
    expect_status 130
fi

# Running out of time is not an interruption.
ffstudy form-factors discs_blocked --tolerance 1e-6 --max-samples 1000000000000 --max-time 0.1 --out in_time
expect_status 4
expect_stdout "Stopped before the sampling was done"
expect_file in_time/form_factors.sqlite
