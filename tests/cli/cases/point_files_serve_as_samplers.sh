#!/usr/bin/env bash
# Points that somebody else has made, as docs/study-files.md describes them.
source "$(dirname "$0")/../harness.sh"

# points N D SETS: text, the same for every awk.
points() {
    awk -v n="$1" -v d="$2" -v sets="$3" 'BEGIN {
        for (s = 0; s < sets; ++s) {
            for (i = 0; i < n; ++i) {
                for (j = 0; j < d; ++j) { x = (x * 1103515245 + 12345 + s) % 2147483648; printf "%.12f ", x / 2147483648 }
                print ""
            }
            print "#"
        }
    }'
}

# study NAME FILE TRIALS SAMPLES [LINE]
study() {
    cat >"$1.toml" <<END
[study]
name = "$1"
scene = "cube"
trials = $3
seed = 1
[[method]]
name = "mine"
sampler = "file:$2"
estimator = "ray_shooting"
samples_per_patch = $4
${5-}
END
}

points 64 4 1 >one.txt
points 64 4 20 >twenty.txt

# One set, randomised: any number of trials, the same bytes on any number of threads, and without the file.
study randomised one.txt 40 64 'randomise = "owen"'
ffstudy run randomised.toml --threads 1 --out a
expect_status 0
expect_stdout "none found"
ffstudy run randomised.toml --threads 2 --out b
expect_status 0
expect_equal_files a/trials.csv b/trials.csv
cp a/summary.csv before.csv
mv one.txt elsewhere.txt
ffstudy report a
expect_status 0
expect_equal_files a/summary.csv before.csv
ffstudy run randomised.toml --out c
expect_status 3
expect_stderr "one.txt: cannot be read"
# The folder has all that its study needs, also for more trials.
ffstudy run a --trials 60
expect_status 0
expect_stderr "40 of 60 trials are there already"
mv elsewhere.txt one.txt
ffstudy run randomised.toml --trials 60 --out c
expect_equal_files a/trials.csv c/trials.csv

# Other content is another study.
points 65 4 1 | tail -n 65 >one.txt
ffstudy run randomised.toml --out a
expect_status 2
expect_stderr "holds another study"
points 64 4 1 >one.txt

# As they are: a set for each trial, and one set alone is deterministic.
study sets twenty.txt 20 64
ffstudy run sets.toml --quiet
expect_status 0
study sets twenty.txt 21 64
ffstudy run sets.toml --quiet --out d
expect_status 2
expect_stderr "has 20 sets of points, and each serves one trial"
study alone one.txt 20 64
ffstudy run alone.toml
expect_status 0
expect_stdout "  deterministic"

# A ladder of files.
for n in 16 64 256; do points $n 4 1 >set_$n.txt; done
study ladder 'set_{n}.txt' 20 '"2^4..2^7"' 'randomise = "shift"'
ffstudy run ladder.toml --dry-run
expect_status 0
expect_stdout "1 × 64 rays"
grep -Fq "1 × 32 rays" "$folder/stdout" && fail "a size that no file has"

# refuse SAMPLES TEXT: points on stdin, refused with TEXT.
refuse() {
    cat >bad.txt
    study bad bad.txt 20 "$1"
    ffstudy run bad.toml --out e
    expect_status 2
    expect_stderr "$2"
    [ ! -e e ] || fail "something was written"
}
refuse 1 "bad.txt: set 0, point 1, coordinate 2 is 1 (counted from 0; not in [0, 1))" <<<$'0 0 0 0\n0 0 1 0'
refuse 1 "coordinate 0 is nan" <<<"nan 0 0 0"
refuse 1 "coordinate 3 is -0.5" <<<"0 0 0 -0.5"
refuse 1 'bad.txt:1: "x" (not a number)' <<<"0 0 x 0"
refuse 1 "bad.txt:2: 3 numbers (the points before have 4)" <<<$'0 0 0 0\n0 0 0'
refuse 1 "bad.txt: set 1 has 2 points (set 0 has 1)" <<<$'0 0 0 0\n#\n0 0 0 0\n0 0 0 0'
refuse 1 "points of 4 coordinates" <<<"0 0"
refuse 2 "2 points (file:bad.txt#none#" <<<"0 0 0 0"
refuse 1 "no points" <<<"#"
refuse 1 "component 3 of the generating vector missing" <<<$'# lattice\n4\n8\n1 3 5'
refuse 1 "base = 3 (2 to 2 are read)" <<<$'# dnet\n3\n4\n3\n31'

study how one.txt 20 64 'randomise = "shake"'
ffstudy run how.toml
expect_status 2
expect_stderr 'randomise = "shake" (unknown). Choose one of none, shift'
sed -i 's/file:one.txt/sobol/; s/shake/shift/' how.toml
ffstudy run how.toml
expect_status 2
expect_stderr "only points of a file have it"

# A large file is not copied into the store: reports do not need it, more trials do.
/usr/bin/python3 - <<'END'
import random, struct
n = 1 << 20
draw = random.Random(1).random
with open("large.raw", "wb") as file:
    file.write(b"FFPOINTS" + struct.pack("<QQ", n, 4))
    for _ in range(64):
        file.write(struct.pack(f"<{n // 16}d", *(draw() for _ in range(n // 16))))
END
study large large.raw 10 64 'randomise = "shift"'
ffstudy run large.toml --out large
expect_status 0
[ "$(stat --format %s large/results.sqlite)" -lt 1000000 ] || fail "the store holds the points"
cp large/summary.csv before.csv
mv large.raw elsewhere.raw
ffstudy report large
expect_status 0
expect_equal_files large/summary.csv before.csv
ffstudy run large --trials 20
expect_status 2
expect_stderr "only its results are here, not what makes its points). Run the study's file"
mv elsewhere.raw large.raw
ffstudy run large.toml --trials 20 --out large
expect_status 0
expect_stderr "10 of 20 trials are there already"
