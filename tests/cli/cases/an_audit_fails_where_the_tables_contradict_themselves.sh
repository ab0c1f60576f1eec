#!/usr/bin/env bash
source "$(dirname "$0")/../harness.sh"

tables=$data/../../studies/built_in/paper_tables.json
ffstudy audit "$tables"
expect_status 1
expect_stdout "contradiction"
expect_no_stderr
expect_nothing_written
ffstudy audit "$tables" --out out --quiet
expect_status 1
expect_no_stdout
expect_file out/audit.md
