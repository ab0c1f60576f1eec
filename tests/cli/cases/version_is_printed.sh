#!/usr/bin/env bash
source "$(dirname "$0")/../harness.sh"

ffstudy --version
expect_status 0
expect_stdout "ffstudy "
expect_no_stderr
expect_nothing_written
