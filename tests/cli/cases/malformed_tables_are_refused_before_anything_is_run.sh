#!/usr/bin/env bash
source "$(dirname "$0")/../harness.sh"

small_study >"$folder/study.toml"
printf '[published]\ntables = "tables.json"\n' >>"$folder/study.toml"

ffstudy run "$folder/study.toml" --out out
expect_refused 3 "tables.json: cannot be read"
: >"$folder/tables.json"
ffstudy run "$folder/study.toml" --out out
expect_refused 2 "tables.json: is empty"
ffstudy audit "$folder/tables.json"
expect_refused 2 "tables.json: is empty"
printf '{"source": "someone",\n"scene": "\xffcube"}' >"$folder/tables.json"
ffstudy audit "$folder/tables.json"
expect_refused 2 "tables.json:2:11: the byte 0xff is not UTF-8"
sed 's/"F 1-6"/"F 1-7"/' "$(dirname "$0")/../../../studies/built_in/paper_tables.json" >"$folder/tables.json"
ffstudy run "$folder/study.toml" --out out
expect_refused 2 "face \"7\" is not in the scene"
expect_stderr "tables.json:"
echo '{"source": "s",' >"$folder/tables.json"
ffstudy run "$folder/study.toml" --out out
expect_refused 2 "tables.json:"
ffstudy audit "$folder/tables.json" --out out
expect_refused 2 "tables.json:"
