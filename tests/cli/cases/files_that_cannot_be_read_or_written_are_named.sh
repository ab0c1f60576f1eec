#!/usr/bin/env bash
source "$(dirname "$0")/../harness.sh"

small_study >"$folder/study.toml"

ffstudy run missing.toml
expect_refused 3 "missing.toml: cannot be read"
ffstudy run "$folder/study.toml" --out /proc/ffstudy
expect_refused 3 "/proc/ffstudy: cannot be made"
echo in the way >"$folder/file"
ffstudy run "$folder/study.toml" --out "$folder/file"
expect_refused 3 "file: cannot be made"
ffstudy run "$folder/study.toml" --out "$folder/file/below"
expect_refused 3 "below: cannot be made"
ffstudy report missing
expect_refused 3 "missing: no such file"
ffstudy audit missing.json
expect_refused 3 "missing.json: cannot be read"

mkdir "$folder/out"
echo "neither SQLite nor anything else that can be used" >"$folder/out/results.sqlite"
ffstudy run "$folder/study.toml" --out "$folder/out"
expect_refused 3 "not a database"
ffstudy report "$folder/out"
expect_refused 3 "not a database"
: >"$folder/out/results.sqlite"
ffstudy report "$folder/out"
expect_refused 2 "not a result store"
