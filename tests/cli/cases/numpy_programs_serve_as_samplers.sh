#!/usr/bin/env bash
# The program of docs/adding-a-sampler.md that prints points is checked as that page says, word by word.
# Needs NumPy.
source "$(dirname "$0")/../harness.sh"

document=$data/../../docs/adding-a-sampler.md
mkdir bin
ln -s "$program" bin/ffstudy
ln -s /usr/bin/python3 bin/python3  # NumPy is Debian's

blocks python "$document" >mine.py
command_line=$(blocks sh "$document" 2) status=0
PATH=$PWD/bin:$PATH bash -c "$command_line" >"$folder/stdout" 2>"$folder/stderr" </dev/null || status=$?
expect_status 4  # so few trials are too few for some of the checks
expect_stdout "pass          same bits for the same seed"
! grep -q FAIL "$folder/stdout" || fail "the program's points fail the check"
