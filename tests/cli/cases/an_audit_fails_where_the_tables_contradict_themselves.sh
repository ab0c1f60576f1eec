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

# A scene file is looked for beside the tables, by `audit` and by a study that names them.
mkdir -p "$folder/scenes" "$folder/tables"
printf 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 2 0 1\nv 2 1 1\nv 0 1 1\ng a\nf 1 2 3 4\ng b\nf 8 7 6 5\n' >"$folder/scenes/plates.obj"
tables_of() {
    printf '{"source": "s", "scene": "../scenes/plates.obj", "methods": [{"name": "m", "samples": false, "completion": "direct"}],
"tables": [{"id": "t", "columns": [{"method": "m", "patches_per_face": 1}],
"rows": [{"quantity": "F a-b", "printed": ["%s"]}, {"quantity": "F b-a", "printed": ["%s"]}]}]}' "$1" "$2" >"$folder/tables/t.json"
}
tables_of 0.2859 0.1430
ffstudy audit "$folder/tables/t.json"
expect_status 0
tables_of 0.2859 0.1340
ffstudy audit "$folder/tables/t.json"
expect_status 1
expect_stdout "area of 1 "
expect_stdout "area of 2"
small_study >"$folder/study.toml"
printf '[published]\ntables = "tables/t.json"\n' >>"$folder/study.toml"
ffstudy run "$folder/study.toml" --out study --quiet
expect_status 0
expect_file study/audit.md
grep -q reciprocity study/audit.md || fail "the study does not audit tables of a scene file"
