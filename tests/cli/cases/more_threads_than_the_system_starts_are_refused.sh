#!/usr/bin/env bash
source "$(dirname "$0")/../harness.sh"

small_study >"$folder/study.toml"

# No more threads are started than there are work units.
ffstudy run "$folder/study.toml" --threads 4096 --out "$folder/out"
expect_status 0

# Threads with stacks of 64 TiB (in KiB) are more than any system gives, and than ThreadSanitizer can begin with.
! runs_with_tsan || exit 0
(
    ulimit -s $((1 << 36))
    ffstudy run "$folder/study.toml" --threads 3 --out "$folder/other"
    expect_refused 2 "ffstudy: 3 threads (the system started 0 of them: "
    expect_stderr "Take fewer with --threads."
    ffstudy form-factors nested_cubes --threads 3
    expect_refused 2 "ffstudy: 3 threads (the system started 0 of them: "
)
ffstudy run "$folder/study.toml" --threads 3 --out "$folder/other"
expect_status 0
