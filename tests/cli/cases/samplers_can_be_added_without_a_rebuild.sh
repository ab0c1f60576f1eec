#!/usr/bin/env bash
# A file of points and a plug-in are added as docs/adding-a-sampler.md says, word by word. (A program that prints points:
# numpy_programs_serve_as_samplers.sh.)
source "$(dirname "$0")/../harness.sh"

document=$data/../../docs/adding-a-sampler.md
mkdir bin
ln -s "$program" bin/ffstudy
export PATH=$PWD/bin:$PATH CPATH=$data/../../include

# say NUMBER: runs the document's block of commands of this number.
say() {
    command_line=$(blocks sh "$document" "$1")
    [ -n "$command_line" ] || fail "the document has no block $1"
    rm -rf results
    status=0
    bash -ec "$command_line" >"$folder/stdout" 2>"$folder/stderr" </dev/null || status=$?
    expect_status 0
}

ffstudy points sobol --n 1024 --out points.npy
say 1
expect_stdout "file:points.npy#owen"
blocks c "$document" >golden.c
cc -std=c99 -Wall -Wextra -Wpedantic -Werror -fsyntax-only golden.c
say 3
expect_stdout "golden"
