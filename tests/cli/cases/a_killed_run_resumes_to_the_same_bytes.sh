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

ffstudy run "$folder/study.toml" --threads 2 --out whole
expect_status 0
all=$(saved units whole)

# Moments are told by what is saved, from what was there before to all, and by a little time. One that begins with all of
# it comes to its end. Kills while the store grows are what this is about.
reached() { [ "$1" != never ] && [ "$(saved units out)" -ge "$1" ]; }
killed=0 attempts=0 halfway=0
until [ $killed -ge "$kills" ] && [ $((5 * halfway)) -ge "$kills" ]; do
    attempts=$((attempts + 1))
    [ $attempts -le $((20 * kills + 50)) ] || fail "of $attempts runs $killed were killed, $halfway while units were saved"
    saved=$(saved units out)
    [ "$saved" -lt "$all" ] && moment=$((saved + RANDOM % (all - saved + 1))) || moment=never
    begin run "$folder/study.toml" --threads 2 --out out
    wait_until is_over_or reached $moment
    sleep "0.0$((RANDOM % 10))"
    kill -9 "$process" 2>/dev/null || true
    finish
    if [ $status -eq 137 ]; then
        killed=$((killed + 1))
        saved=$(saved units out)
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
echo "killed $killed times in $attempts runs, $halfway times with some of $all units saved"
