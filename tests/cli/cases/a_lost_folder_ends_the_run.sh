#!/usr/bin/env bash
source "$(dirname "$0")/../harness.sh"

small_study 400 >"$folder/study.toml"
ffstudy run "$folder/study.toml" --out whole
expect_status 0

# start OUT: runs the study in the background and returns when its first unit is saved.
start() {
    command_line="ffstudy run (its folder will be lost)" status=0
    "$program" run "$folder/study.toml" --threads 1 --out "$1" >"$folder/stdout" 2>"$folder/stderr" </dev/null &
    process=$!
    until [ -n "$(find "$1" -name results.sqlite-wal -size +64k 2>/dev/null)" ]; do
        kill -0 $process || fail "the study was over before its folder could be taken away"
        sleep 0.01
    done
}

start moved
mv moved elsewhere
wait $process || status=$?
expect_status 3
expect_stderr "moved/results.sqlite: moved or removed while the study ran"
ffstudy run "$folder/study.toml" --out elsewhere
expect_status 0
expect_same_results whole elsewhere

start removed
rm -r removed
wait $process || status=$?
expect_status 3
expect_stderr "removed/results.sqlite: moved or removed while the study ran"
[ ! -e removed ] || fail "expected the folder to stay away"

# A folder that cannot be written; the store of a finished study can still be read there. Root may write anywhere, but
# for the capability that lets it.
bound=()
[ "$(id -u)" -ne 0 ] || bound=(setpriv --inh-caps=-all --bounding-set=-dac_override,-dac_read_search)
chmod -R a-w whole
command_line="ffstudy run (into a read-only folder)" status=0
"${bound[@]}" "$program" run "$folder/study.toml" --out whole >"$folder/stdout" 2>"$folder/stderr" || status=$?
expect_status 3
expect_stderr "whole"
command_line="ffstudy report (from a read-only folder)" status=0
"${bound[@]}" "$program" report whole --out reports >"$folder/stdout" 2>"$folder/stderr" || status=$?
expect_status 0
expect_equal_files whole/results.json reports/results.json
chmod -R u+w whole
