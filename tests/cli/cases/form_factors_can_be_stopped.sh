#!/usr/bin/env bash
# A signal ends form_factors in order: what is known is written, and holds. A second one ends it at once.
source "$(dirname "$0")/../harness.sh"

# Of this scene F 1-2 is known; hours would pass before it is found to within the tolerance. The level is such that an
# interval misses it once in a million runs.
exact=$("$program" list configurations | awk '$1 == "discs_blocked" {print; exit}' | grep -oE '0\.[0-9]{12,}')

# start OUT: runs it in the background and returns when it has taken its folder.
start() {
    command_line="ffstudy form_factors (to be stopped)" status=0
    "$program" form_factors discs_blocked --tolerance 1e-6 --level 0.999999 --max-samples 1000000000000 --threads 2 \
        --out "$1" >"$folder/stdout" 2>"$folder/stderr" </dev/null &
    process=$!
    until [ -e "$1/.ffstudy.lock" ]; do
        kill -0 $process || fail "it was over before it could be stopped"
        sleep 0.01
    done
}

for wait in 0.1 0.3 1.5; do
    start stopped_$wait
    sleep $wait
    kill -INT $process
    wait $process || status=$?
    expect_status 130
    expect_no_stderr
    expect_stdout " of 3 pairs of faces is NOT within 1e-06: 1-"
    expect_stdout "Stopped before the sampling was done"
    for file in matrix.csv form_factors.npy half_widths.mtx areas.npy form_factors.json form_factors.sqlite context.json; do
        expect_file stopped_$wait/$file
    done
    awk -F, -v exact="$exact" '$1 == 1 && $2 == 2 {found = $4 <= exact && exact <= $5 && $11 == 0} END {exit !found}' \
        stopped_$wait/matrix.csv || fail "the interval does not hold $exact: $(cat stopped_$wait/matrix.csv)"
    cp "$folder/stdout" "$folder/stopped"
    ffstudy form_factors --load stopped_$wait
    expect_status 4
    expect_equal_files "$folder/stopped" "$folder/stdout"
done
[ "$wait" = 1.5 ] && expect_in_file stopped_1.5/matrix.csv ",rays,"

# Both signals at once: nothing is written.
start at_once
sleep 0.2
kill -STOP $process
kill -INT $process
kill -TERM $process
kill -CONT $process
wait $process || status=$?
expect_status 130
expect_no_stdout
[ -z "$(ls -A at_once)" ] || fail "expected no files after a second signal"

# Time that is over is no interruption.
ffstudy form_factors discs_blocked --tolerance 1e-6 --max-samples 1000000000000 --max-time 0.5 --out in_time
expect_status 4
expect_stdout "Stopped before the sampling was done"
expect_file in_time/form_factors.sqlite
