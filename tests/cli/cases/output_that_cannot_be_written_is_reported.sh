#!/usr/bin/env bash
source "$(dirname "$0")/../harness.sh"

small_study >"$folder/study.toml"
# The device /dev/full is a disk that is always full.
for arguments in "list samplers" "--help" "--version" "run $folder/study.toml --out a"; do
    command_line="ffstudy $arguments >/dev/full" status=0
    # shellcheck disable=SC2086
    "$program" $arguments >/dev/full 2>"$folder/stderr" </dev/null || status=$?
    expect_status 3
    expect_stderr "Check the disk"
done

# Readers of a pipe may leave when they have seen enough; the exit code stays what it is.
mkfifo "$folder/pipe"
true <"$folder/pipe" &
exec {pipe}>"$folder/pipe"
wait $!
for arguments in "list samplers" "run $folder/study.toml --out a"; do
    command_line="ffstudy $arguments | true" status=0
    # shellcheck disable=SC2086
    "$program" $arguments >&$pipe 2>"$folder/stderr" </dev/null || status=$?
    expect_status 0
    ! grep -q "standard output" "$folder/stderr" || fail "a closed pipe is no error"
done
printf 'trial,quantity,estimate\n' >"$folder/estimates.csv"
for trial in {0..19}; do echo "$trial,x,0.5$((trial * 7 % 20))1"; done >>"$folder/estimates.csv"
printf '[gates]\nalpha = 0.01\n[[gate]]\nname = "x"\nkind = "bias"\nquantity = "x"\nreference = 9\nband = 0.1\n' >"$folder/bands.toml"
command_line="ffstudy check bands.toml | true" status=0
"$program" check "$folder/bands.toml" --estimates "$folder/estimates.csv" >&$pipe 2>"$folder/stderr" </dev/null || status=$?
expect_status 1

# Progress and notes are no results: a run does not end for them.
command_line="ffstudy run 2>/dev/full" status=0
"$program" run "$folder/study.toml" --out b >"$folder/stdout" 2>/dev/full </dev/null || status=$?
expect_status 0
expect_same_results a b

command_line="ffstudy run 2>&1 >c.txt | true" status=0
"$program" run "$folder/study.toml" --out c >c.txt 2>&$pipe </dev/null || status=$?
expect_status 0
expect_same_results a c
