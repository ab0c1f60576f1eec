#!/usr/bin/env bash
source "$(dirname "$0")/../harness.sh"

small_study 400 >"$folder/study.toml"
ffstudy run "$folder/study.toml" --out whole
expect_status 0
all=$(saved units whole)

# moved: the folder of a run is moved away when its first unit is saved. The run may be faster, and save all of them.
moved() {
    rm -rf moved elsewhere
    begin run "$folder/study.toml" --threads 1 --out moved
    wait_until is_over_or a_unit_is_saved moved
    mv moved elsewhere
    finish
    [ "$(saved units elsewhere)" -lt "$all" ]
}
until moved; do try_again "the study was over before its folder could be moved"; done
expect_status 3
expect_stderr "moved/results.sqlite: moved or removed while the study ran"
ffstudy run "$folder/study.toml" --out elsewhere
expect_status 0
expect_same_results whole elsewhere

long_study >"$folder/long.toml"
begin run "$folder/long.toml" --threads 1 --out removed
wait_until a_unit_is_saved removed
rm -r removed
finish
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
