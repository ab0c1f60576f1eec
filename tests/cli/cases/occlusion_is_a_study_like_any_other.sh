#!/usr/bin/env bash
# The study of occlusion as docs/occlusion.md shows it: with few trials the same scenes, occluded fractions and
# errors of the deterministic method.
page=$(cd "$(dirname "$0")/../../.." && pwd)/docs/occlusion.md
source "$(dirname "$0")/../harness.sh"

ffstudy occlusion --trials 4
expect_status 0
rows() { sed -nE 's/^([a-z_]+:[0-9.]+ +F 1-[23] .*, (-|-[0-9.]+))  .*$/\1/p' | awk '{ print $1, $3, $4, $5, $6 }'; }
rows <"$folder/stdout" >"$folder/shown"
rows <"$page" >"$folder/promised"
[ "$(wc -l <"$folder/promised")" -eq 17 ] || fail "docs/occlusion.md does not show the study"
expect_equal_files "$folder/promised" "$folder/shown"
expect_stdout "PDM: the error falls with slope "
expect_stdout "squares_blocked, F 1-2. Least error by occluded fraction, at about 8192 samples: PDM"
expect_in_file results/occlusion/report.html 'id="occlusion-squares-blocked'
expect_in_file results/occlusion/report.html '<svg class="scene"'
expect_in_file results/occlusion/report.md "Errors as the occluded fraction grows"

# A scene is explained by what is known of it, built in or in a file.
ffstudy explain squares_blocked:0.25
expect_status 0
for words in "squares_blocked:0.25 (scene)" "1: area 1" "F 1-2 = 0.169474204911786" "not closed_form: "; do
    expect_stdout "$words"
done
cat >"$folder/corner.obj" <<'END'
v 0 0 0
v 1 0 0
v 1 1 0
v 0 1 0
v 1 0 1
v 0 0 1
g floor
f 1 2 3 4
g wall
f 1 6 5 2
END
cp "$folder/corner.obj" .
ffstudy explain corner.obj
expect_stdout "F floor-wall = 0.200043776075403  closed form"
ffstudy explain squares_blocked:2
expect_status 2
expect_stderr "scene squares_blocked:2 (the edge of the square in the middle may be from 0 to 1). Try squares_blocked:0.5."
ffstudy explain missing.obj
expect_status 3

# Names of scenes stand in one column.
ffstudy list scenes
[ "$(grep -boE '^[^ ]+ +' "$folder/stdout" | sed 's/^[0-9]*://' | awk '{ print length($0) }' | sort -u | wc -l)" -eq 1 ] ||
    fail "summaries do not begin in one column"
