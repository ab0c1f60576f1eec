#!/usr/bin/env bash
# The ways of docs/adding-a-sampler.md that need no compiler of C++ are followed word by word.
source "$(dirname "$0")/../harness.sh"

document=$data/../../docs/adding-a-sampler.md
mkdir bin
ln -s "$program" bin/ffstudy
ln -s /usr/bin/python3 bin/python3 # NumPy is Debian's
export PATH=$PWD/bin:$PATH CPATH=$data/../../include

# say NUMBER: runs the document's block of commands of this number; code 4 is a check that wants more trials.
say() {
    command_line=$(blocks sh "$document" "$1")
    [ -n "$command_line" ] || fail "the document has no block $1"
    rm -rf results
    status=0
    while IFS= read -r line; do
        [ $status -ne 0 ] || bash -c "$line" >"$folder/stdout" 2>"$folder/stderr" </dev/null || status=$?
        [[ $status -ne 4 || $line != *" --trials 200" ]] || status=0
    done <<<"$command_line"
    expect_status 0
}

ffstudy points sobol --n 1024 --out points.npy
say 1
expect_stdout "file:points.npy#owen"
blocks python "$document" >mine.py
say 2
expect_stdout "pass          same bits for the same seed"
grep -q FAIL "$folder/stdout" && fail "the program's points fail the check"
blocks c "$document" >golden.c
cc -std=c99 -Wall -Wextra -Wpedantic -Werror -fsyntax-only golden.c
say 3
expect_stdout "golden"
