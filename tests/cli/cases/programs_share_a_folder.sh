#!/usr/bin/env bash
# Several programs at one --out at once, some of them killed: every file is there whole or not at all, at any moment.
# FFSTUDY_KILLS: how many rounds.
source "$(dirname "$0")/../harness.sh"

small_study 60 >"$folder/study.toml"
ffstudy run "$folder/study.toml" --out whole
expect_status 0

# Two runs that begin one store together: one after the other, to the same results.
for round in 1 2 3; do
    command_line="two times ffstudy run (round $round)" status=0
    "$program" run "$folder/study.toml" --threads 1 --out twice >"$folder/stdout" 2>"$folder/stderr" </dev/null &
    process=$!
    "$program" run "$folder/study.toml" --threads 1 --out twice >/dev/null 2>"$folder/other" </dev/null || status=$?
    expect_status 0
    wait $process || status=$?
    expect_status 0
    expect_same_results whole twice
    rm -r twice
done

# Reports in one folder, two of three killed, while others read them.
cp -r whole out
read_all() {
    local file
    while [ ! -e "$folder/over" ]; do
        for file in trials.csv summary.csv results.json report.md; do
            cmp -s "out/$file" "whole/$file" || echo "$file" >>"$folder/torn"
        done
    done
}
read_all &
reader=$!
RANDOM=17
for ((round = 0; round < ${FFSTUDY_KILLS:-5}; ++round)); do
    processes=()
    for _ in 1 2 3; do
        "$program" report out --quiet >/dev/null 2>>"$folder/stderr" </dev/null &
        processes+=($!)
    done
    for process in "${processes[@]:0:2}"; do
        sleep "0.$(printf '%03d' $((RANDOM % 300)))"
        kill -9 "$process" 2>/dev/null || true
        wait "$process" 2>/dev/null || true
    done
    command_line="ffstudy report out (round $round, others killed)" status=0
    wait "${processes[2]}" || status=$?
    expect_status 0
    expect_same_results whole out
done
touch "$folder/over"
wait $reader
# The last to be killed may have had the folder after the last to end: what it left goes with the next one.
ffstudy report out
expect_status 0
[ ! -e "$folder/torn" ] || fail "files were read in part: $(sort "$folder/torn" | uniq -c | tr '\n' ' ')"
[ -z "$(find out -name '.ffstudy-part*')" ] || fail "expected nothing left of what was on its way"

# Who has the folder is said, and is forgotten with its process.
sed 's/^trials = 60/trials = 6000000/' "$folder/study.toml" >"$folder/long.toml"
"$program" run "$folder/long.toml" --threads 1 --out taken >/dev/null 2>&1 </dev/null &
process=$!
until [ -e taken/results.sqlite ]; do sleep 0.01; done
ffstudy run "$folder/long.toml" --threads 1 --out taken
expect_status 3
expect_stderr "taken: in use (process $process on $(uname -n) since "
expect_stderr "run $folder/long.toml --threads 1 --out taken). Wait until it has ended, or choose another --out."
kill -9 $process
wait $process 2>/dev/null || true
ffstudy run "$folder/long.toml" --threads 1 --max-time 0.2 --out taken
expect_status 130
[ -z "$(find . -name .ffstudy.lock)" ] || fail "expected no lock to be left"

# A merge that is killed leaves nothing in the way of the next one.
for part in 1 2; do
    ffstudy run "$folder/study.toml" --shard $part/2 --out part$part
    expect_status 0
done
for ((round = 0; round < ${FFSTUDY_KILLS:-5}; ++round)); do
    "$program" merge part1 part2 --out merged --quiet >/dev/null 2>&1 </dev/null &
    process=$!
    sleep "0.$(printf '%03d' $((RANDOM % 200)))"
    kill -9 $process 2>/dev/null || true
    wait $process 2>/dev/null || true
done
ffstudy merge part1 part2 --out merged
expect_status 0
expect_same_results whole merged
found=$(cd merged && find . -name '.*' -type f | sort | tr '\n' ' ')
[ "$found" = "./.ffstudy.files " ] || fail "expected nothing left of killed merges, found $found"
