#!/usr/bin/env bash
# Kills runs at random moments, from the first to the last thing they do, until each has come to its end all the same.
# FFSTUDY_KILLS: how often.
source "$(dirname "$0")/../harness.sh"

kills=${FFSTUDY_KILLS:-5}
# A few units for each method, and many, most of the time, for the last.
{
    small_study 60
    printf '\n[[method]]\nname = "long"\nsampler = "random"\nestimator = "ray_shooting"\nsamples_per_patch = 1000000\n'
} >"$folder/study.toml"
RANDOM=20261120

# units OUT: how many are saved there.
units() {
    /usr/bin/python3 - "$1" <<'END' 2>/dev/null || echo 0
import sqlite3, sys

print(sqlite3.connect(f"file:{sys.argv[1]}/results.sqlite?mode=ro", uri=True).execute("SELECT count(*) FROM units").fetchone()[0])
END
}

begin=$(date +%s%N)
ffstudy run "$folder/study.toml" --threads 2 --out whole
expect_status 0
microseconds=$((($(date +%s%N) - begin) / 1000))
all=$(units whole)

killed=0 attempts=0 halfway=0
while [ $killed -lt "$kills" ]; do
    attempts=$((attempts + 1))
    [ $attempts -le $((20 * kills + 20)) ] || fail "only $killed of $attempts runs were killed before their end"
    "$program" run "$folder/study.toml" --threads 2 --out out >"$folder/stdout" 2>"$folder/stderr" </dev/null &
    process=$!
    moment=$(((RANDOM * 32768 + RANDOM) % microseconds))
    sleep "$((moment / 1000000)).$(printf '%06d' $((moment % 1000000)))"
    kill -9 $process 2>/dev/null || true
    command_line="ffstudy run (killed after $moment us)" status=0
    wait $process 2>/dev/null || status=$?
    if [ $status -eq 137 ]; then
        killed=$((killed + 1))
        saved=$(units out)
        [ "$saved" -eq 0 ] || [ "$saved" -eq "$all" ] || halfway=$((halfway + 1))
        continue
    fi
    expect_status 0
    expect_same_results whole out
    rm -r out
done
# What the last kill left behind.
ffstudy run "$folder/study.toml" --threads 1 --out out
expect_status 0
expect_same_results whole out
# Kills while the store grows are what this is about.
[ $((5 * halfway)) -ge "$kills" ] || fail "only $halfway of $killed kills came while units were saved"
echo "killed $killed times in $attempts runs, $halfway times with some of $all units saved"
