#!/usr/bin/env bash
source "$(dirname "$0")/../harness.sh"

ffstudy --no-such-option
expect_refused 2 "--no-such-option"
