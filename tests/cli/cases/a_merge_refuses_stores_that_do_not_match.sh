#!/usr/bin/env bash
source "$(dirname "$0")/../harness.sh"

small_study >"$folder/study.toml"
mkdir "$folder/parts"
for i in 1 2; do ffstudy run "$folder/study.toml" --shard $i/2 --out "$folder/parts/$i"; done
ffstudy run "$folder/study.toml" --shard 2/2 --seed 2 --out "$folder/parts/other"
expect_status 0

ffstudy merge "$folder/parts/1" "$folder/parts/other" --out merged
expect_status 2
expect_stderr "parts/other/results.sqlite: holds another study (differs in [study]: 'seed = 2' there, 'seed = 1' here)"
rm -r merged

ffstudy merge "$folder/parts/1" "$folder/parts/2" --out "$folder/parts/1"
expect_refused 2 "one of the stores to be merged lies there"
ffstudy merge "$folder/parts/1" missing --out merged
expect_status 3
expect_stderr "missing: no such file"
rm -r merged
ffstudy merge missing "$folder/parts/1" --out merged
expect_refused 3 "missing: no such file"
ffstudy merge --out merged
expect_refused 2 "RESULTS is missing"
ffstudy form-factors cube --shard 1/1 --out "$folder/parts/rows"
for kinds in "1 rows" "rows 1"; do
    read -r first second <<<"$kinds"
    ffstudy merge "$folder/parts/$first" "$folder/parts/$second" --out merged
    expect_refused 2 "parts/rows is a shard of a matrix, and $folder/parts/1 is not. Merge what belongs together."
done
ffstudy merge "$folder/parts/1" --randomisations --out merged
expect_refused 2 "--randomisations: $folder/parts/1 is no shard of a matrix. Leave it out."
for shard in 0/2 3/2 2 /2 1/ a/b 1/2/3 -1/2 1.0/2; do
    ffstudy run "$folder/study.toml" --shard=$shard
    expect_refused 2 "--shard $shard: not a share (i/n with 1 <= i <= n is one). For the second of four write 2/4."
done
