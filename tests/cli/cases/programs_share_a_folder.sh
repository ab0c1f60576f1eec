#!/usr/bin/env bash
# Several programs at one --out at once, some of them killed: every file is there whole or not at all, at any moment.
# FFSTUDY_KILLS: how many rounds.
source "$(dirname "$0")/../harness.sh"

small_study 60 >"$folder/study.toml"
ffstudy run "$folder/study.toml" --out whole
expect_status 0

# patient ARGUMENTS...: runs the program again where it was refused, as others had the folder for too long.
patient() {
    local status=0
    "$program" "$@" </dev/null >"$folder/stdout.$BASHPID" 2>"$folder/stderr.$BASHPID" || status=$?
    if [ $status -eq 3 ] && grep -q ": in use (" "$folder/stderr.$BASHPID"; then patient "$@"; else return $status; fi
}

# After ten seconds, a program that waits for the folder in vain is told which one has it. It waits while the rest runs,
# and the one that has it does nothing more.
long_study >"$folder/long.toml"
begin run "$folder/long.toml" --threads 1 --out taken
wait_until test -s taken/results.sqlite-wal
kill -STOP "$process"
"$program" run "$folder/long.toml" --threads 1 --out taken >"$folder/refused" 2>&1 </dev/null &
refused=$!

# Two runs that begin one store together: one after the other, to the same results.
for round in 1 2 3; do
    command_line="two times ffstudy run (round $round)" status=0
    patient run "$folder/study.toml" --threads 1 --out twice &
    other=$!
    patient run "$folder/study.toml" --threads 1 --out twice || status=$?
    expect_status 0
    wait $other || status=$?
    expect_status 0
    expect_same_results whole twice
    rm -r twice
done

# Reports in one folder, two of three killed, while others read them.
cp -r whole out
read_all() {
    local file
    while [ -e "$folder/reading" ]; do
        for file in trials.csv summary.csv results.json report.md; do
            cmp -s "out/$file" "whole/$file" || echo "$file" >>"$folder/torn"
        done
    done
}
touch "$folder/reading"
read_all &
reader=$!
RANDOM=17
for ((round = 0; round < ${FFSTUDY_KILLS:-5}; ++round)); do
    killed=()
    for _ in 1 2; do
        "$program" report out --quiet >/dev/null 2>&1 </dev/null &
        killed+=($!)
    done
    patient report out --quiet &
    other=$!
    for one in "${killed[@]}"; do
        sleep "0.$(printf '%03d' $((RANDOM % 200)))"
        kill -9 "$one" 2>/dev/null || true
        wait "$one" 2>/dev/null || true
    done
    command_line="ffstudy report out (round $round, others killed)" status=0
    wait $other || status=$?
    expect_status 0
    expect_same_results whole out
done
rm "$folder/reading"
wait $reader
# The last to be killed may have had the folder after the last to end: what it left goes with the next one.
ffstudy report out
expect_status 0
[ ! -e "$folder/torn" ] || fail "files were read in part: $(sort "$folder/torn" | uniq -c | tr '\n' ' ')"
[ -z "$(find out -name '.ffstudy-part*')" ] || fail "expected nothing left of what was on its way"

# A merge that is killed leaves nothing in the way of the next one.
for part in 1 2; do
    ffstudy run "$folder/study.toml" --shard $part/2 --out part$part
    expect_status 0
done
for ((round = 0; round < ${FFSTUDY_KILLS:-5}; ++round)); do
    "$program" merge part1 part2 --out merged --quiet >/dev/null 2>&1 </dev/null &
    killed=$!
    sleep "0.$(printf '%03d' $((RANDOM % 200)))"
    kill -9 $killed 2>/dev/null || true
    wait $killed 2>/dev/null || true
done
ffstudy merge part1 part2 --out merged
expect_status 0
expect_same_results whole merged
found=$(cd merged && find . -name '.*' -type f | sort | tr '\n' ' ')
[ "$found" = "./.ffstudy.files " ] || fail "expected nothing left of killed merges, found $found"

command_line="ffstudy run (at a folder that is taken)" status=0
wait $refused || status=$?
cp "$folder/refused" "$folder/stderr"
expect_status 3
expect_stderr "taken: in use (process $process on $(uname -n) since "
expect_stderr "run $folder/long.toml --threads 1 --out taken). Wait until it has ended, or choose another --out."
# The lock is forgotten with its process.
kill -9 "$process"
finish
ffstudy report taken
expect_status 0
[ -z "$(find . -name .ffstudy.lock)" ] || fail "expected no lock to be left"
