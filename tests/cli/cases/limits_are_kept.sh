#!/usr/bin/env bash
source "$(dirname "$0")/../harness.sh"

small_study 20 >"$folder/study.toml"
ffstudy run "$folder/study.toml" --out whole
expect_status 0

# Much work, stopped after a moment, is resumed later; here with the time of a shorter study.
long_study >"$folder/long.toml"
begin run "$folder/long.toml" --max-time 0.1 --threads 1 --out long
finish
expect_status 130
expect_stderr "Run the same command again to resume."
expect_in_file long/report.md "Partial result"
ffstudy run "$folder/study.toml" --max-time 1d --out enough
expect_status 0
expect_same_results whole enough
rm -r enough long

# A run that grows beyond what was expected stops gracefully: here with 200 MiB that no plan knows of.
cat >"$folder/ballast.cpp" <<'END'
#include <cstdlib>
#include <cstring>
static const void* ballast = std::memset(std::malloc(200 << 20), 1, 200 << 20);
END
"${CXX:-c++}" -shared -fPIC -o "$folder/ballast.so" "$folder/ballast.cpp"
# The library of a sanitizer wants to be first.
ballast="$(ldd "$program" | grep -oE '/[^ ]*/lib[at]san[^ ]*' || true) $folder/ballast.so"
LD_PRELOAD=$ballast begin run "$folder/long.toml" --max-memory 150M --threads 1 --out grown
finish
expect_status 130
expect_stderr "of memory are in use, more than --max-memory."
expect_in_file grown/report.md "Partial result"
LD_PRELOAD=$ballast ffstudy run "$folder/study.toml" --max-memory 16G --threads 1 --out within
expect_status 0
expect_same_results whole within
rm -r whole grown within

# A limit of memory costs threads, then it is refused.
sed 's/^trials = 20/trials = 20000/' "$folder/study.toml" >"$folder/large.toml"
ffstudy run "$folder/large.toml" --dry-run --threads 64
expect_stdout "on 64 threads"
memory=$(sed -n 's/^about \([0-9]*\) MiB of memory.*/\1/p' "$folder/stdout")
[ "$memory" -gt 1 ] || fail "expected the memory in MiB"
ffstudy run "$folder/large.toml" --dry-run --threads 64 --max-memory $((memory - 1))M
expect_status 0
! grep -q "on 64 threads" "$folder/stdout" || fail "expected fewer threads"
ffstudy run "$folder/study.toml" --max-memory 2M
expect_refused 2 "--max-memory 2 MiB: too little for 'small' (about "

for value in 0 -1 x 5x 5mm 1e3 "" nan inf 1e-400; do
    ffstudy run "$folder/study.toml" "--max-time=$value"
    expect_refused 2 "--max-time"
    ffstudy run "$folder/study.toml" "--max-memory=$value"
    expect_refused 2 "--max-memory"
done

# A store that no disk has room for is refused before the run; a run that may end earlier is begun, with a note.
cat >"$folder/vast.toml" <<'END'
[study]
name = "vast"
scene = "cube"
trials = 2000000000
seed = 1

[[method]]
name = "SR"
sampler = "random"
estimator = "ray_shooting"
samples_per_patch = [1, 2, 3, 4]
END
ffstudy run "$folder/vast.toml" --out vast
expect_refused 2 "will be written, and "
ffstudy run "$folder/vast.toml" --max-time 0.1 --threads 1 --out begun
expect_status 130
expect_stderr "note: begun: about "
