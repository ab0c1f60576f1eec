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
expect_refused 3 "missing.json: cannot be read (No such file or directory)"
ffstudy audit "$folder"
expect_refused 3 "a folder, not a file"

# A folder in the way of any file of the results is noticed before anything is run.
ffstudy run "$folder/study.toml" --out "$folder/whole"
expect_status 0
for file in $(ls -I results.sqlite "$folder/whole"); do
    mkdir -p "$folder/blocked/$file"
    ffstudy run "$folder/study.toml" --out "$folder/blocked"
    expect_refused 3 "blocked/$file: cannot be written (a folder is in the way)"
    [ "$(ls "$folder/blocked")" = "$file" ] || fail "expected nothing beside $file"
    rmdir "$folder/blocked/$file"
done

mkdir "$folder/out"
echo "neither SQLite nor anything else that can be used" >"$folder/out/results.sqlite"
ffstudy run "$folder/study.toml" --out "$folder/out"
expect_refused 2 "not a result store"
ffstudy report "$folder/out"
expect_refused 2 "not a result store"
ffstudy report "$folder/study.toml"
expect_refused 2 "study.toml: a study file (expected a result store). Run 'ffstudy run $folder/study.toml'."
: >"$folder/out/results.sqlite"
ffstudy report "$folder/out"
expect_refused 2 "not a result store"
