#!/usr/bin/env bash
source "$(dirname "$0")/../harness.sh"

small_study >"$folder/study.toml"
printf '[published]\ntables = "tables.json"\n' >>"$folder/study.toml"

ffstudy run "$folder/study.toml" --out out
expect_refused 3 "tables.json: cannot be read"
echo '{"source": "s",' >"$folder/tables.json"
ffstudy run "$folder/study.toml" --out out
expect_refused 2 "tables.json:"
ffstudy audit "$folder/tables.json" --out out
expect_refused 2 "tables.json:"
