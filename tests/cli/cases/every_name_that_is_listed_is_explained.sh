#!/usr/bin/env bash
source "$(dirname "$0")/../harness.sh"

for kind in sampler estimator scene study; do
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

ffstudy list formats
expect_status 0
expect_stdout markdown
expect_nothing_written
