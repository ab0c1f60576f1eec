#!/usr/bin/env bash
# scripts/slurm_array and the GNU parallel line of docs/scaling.md, in the roles that a cluster plays.
root=$(cd "$(dirname "$0")/../../.." && pwd)
source "$(dirname "$0")/../harness.sh"

small_study >"$folder/study.toml"
ffstudy run "$folder/study.toml" --out whole
expect_status 0

export FFSTUDY=$program SLURM_ARRAY_TASK_COUNT=3
for task in 1 2 3; do
    SLURM_ARRAY_TASK_ID=$task bash "$root/scripts/slurm_array" "$folder/study.toml" cluster >/dev/null 2>&1
done
bash "$root/scripts/slurm_array" --merge cluster >/dev/null
expect_same_results whole cluster/merged

# A shell plays GNU parallel: {} is the argument.
line=$(sed -n 's/^parallel .*'\''\(ffstudy run .*\)'\'' ::: .*/\1/p' "$root/docs/scaling.md")
[ -n "$line" ] || fail "no GNU parallel line in docs/scaling.md"
cp "$folder/study.toml" study.toml
for i in 1 2 3 4; do
    command=${line//\{\}/$i}
    ffstudy ${command#ffstudy }
    expect_status 0
done
merge=$(sed -n '/^ffstudy merge /{s/^ffstudy //p;q}' "$root/docs/scaling.md")
ffstudy $(eval echo "$merge")
expect_status 0
expect_same_results whole results/study
