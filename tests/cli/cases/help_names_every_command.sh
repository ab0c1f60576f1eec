#!/usr/bin/env bash
source "$(dirname "$0")/../harness.sh"

ffstudy --help
expect_status 0
expect_stdout sr_vs_pdm
expect_stdout run
expect_stdout audit
expect_no_stderr
expect_nothing_written
