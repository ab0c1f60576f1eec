#!/usr/bin/env bash
# Needs time: every name.
source "$(dirname "$0")/../harness.sh"

for kind in sampler estimator scene completion allocation map tracer configuration study format; do
    plural=${kind/%y/ie}s
    ffstudy list "$plural"
    expect_status 0
    expect_no_stderr
    [ -s "$folder/stdout" ] || fail "expected names on stdout"
    cut -d' ' -f1 "$folder/stdout" >"$folder/names"
    while read -r name; do
        ffstudy explain "$name"
        expect_status 0
        expect_stdout "$name ($kind)"
        expect_no_stderr
    done <"$folder/names"
done
ffstudy list controls
expect_status 0
cut -d' ' -f1 "$folder/stdout" >"$folder/names"
grep -q . "$folder/names" || fail "expected controls on stdout"
while read -r name; do
    ffstudy explain "$name"
    expect_stdout "broken on purpose"
done <"$folder/names"
ffstudy list samplers
! grep -qFf "$folder/names" "$folder/stdout" || fail "expected no control among the samplers"

# A sampler's sizes, source and whether it is random are there.
ffstudy explain faure
for words in "powers of 5; others lose the net property" "[faure1982]" "Random: yes"; do expect_stdout "$words"; done
ffstudy explain sobol_raw
expect_stdout "Random: no"
ffstudy explain lattice
expect_stdout "worst-case error"
ffstudy explain box:2x1x0.5
expect_stdout "box:AxBxC (scene)"
expect_nothing_written
