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

# So is a pipe that nobody reads any more.
mkfifo "$folder/pipe"
true <"$folder/pipe" &
exec {pipe}>"$folder/pipe"
wait $!
for arguments in "list samplers" "run $folder/study.toml --out a"; do
    command_line="ffstudy $arguments | true" status=0
    # shellcheck disable=SC2086
    "$program" $arguments >&$pipe 2>"$folder/stderr" </dev/null || status=$?
    expect_status 3
    expect_stderr "Check the disk"
done

# Progress and notes are no results: a run does not end for them.
command_line="ffstudy run 2>/dev/full" status=0
"$program" run "$folder/study.toml" --out b >"$folder/stdout" 2>/dev/full </dev/null || status=$?
expect_status 0
expect_same_results a b

command_line="ffstudy run 2>&1 >c.txt | true" status=0
"$program" run "$folder/study.toml" --out c >c.txt 2>&$pipe </dev/null || status=$?
expect_status 0
expect_same_results a c
