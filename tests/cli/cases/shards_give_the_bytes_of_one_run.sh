#!/usr/bin/env bash
source "$(dirname "$0")/../harness.sh"

small_study 50 >"$folder/study.toml"
ffstudy run "$folder/study.toml" --threads 1 --out whole
expect_status 0
for i in 1 2 3; do
    ffstudy run "$folder/study.toml" --shard $i/3 --threads $i --out part$i
    expect_status 0
    expect_stdout "shard $i/3 is complete: part$i/results.sqlite"
    [ "$(ls part$i)" = results.sqlite ] || fail "expected a shard to leave its store only"
done

ffstudy merge part2 part3/results.sqlite part1 --out merged
expect_status 0
expect_no_stderr
expect_same_results whole merged
expect_in_file merged/context.json '"threads": "2; 3; 1"'

# Shards that follow each other in one folder are a whole run.
for i in 3 1 2; do ffstudy run "$folder/study.toml" --shard $i/3 --out together; done
expect_same_results whole together

# A merge can be interrupted: what is there is there, and merging again adds the rest.
ffstudy merge part1 part3 --out late
expect_status 4
expect_stderr "are missing: 1, 4, 7, "
expect_stderr "Merge again with the shards that hold them"
expect_in_file late/report.md "Partial result"
cp -r late gone_on
ffstudy merge part1 part2 part3 --out late
expect_status 0
expect_same_results whole late
ffstudy run "$folder/study.toml" --out gone_on
expect_status 0
expect_same_results whole gone_on

ffstudy merge part1 part2 part1 part3 --out doubled
expect_status 0
expect_stderr "are in more than one store: 0, 3, 6, "
expect_same_results whole doubled

# What an interrupted shard reported is gone when it is complete.
sed 's/^trials = 50/trials = 400/' "$folder/study.toml" >"$folder/longer.toml"
while
    ffstudy run "$folder/longer.toml" --shard 1/2 --threads 1 --max-time 0.001 --out stopped
    [ $status -eq 0 ]
do rm -r stopped && try_again "the shard was complete before its time was over"; done
expect_status 130
expect_in_file stopped/report.md "Partial result"
ffstudy run "$folder/longer.toml" --shard 1/2 --out stopped
expect_status 0
[ "$(ls stopped)" = results.sqlite ] || fail "expected no reports of a part"
