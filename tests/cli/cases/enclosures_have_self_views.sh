#!/usr/bin/env bash
# Light in round rooms and with mirrors: exact factors and solutions, rays drawn from them, and what is refused.
source "$(dirname "$0")/../harness.sh"

# The two-surface solution of a hemisphere lit by its base: m_0 = r (m_0 + m_1) / 2, m_1 = 1 + r m_0; r = 0.8 gives 5 / 7.
ffstudy enclosure cap:1x1 --reflectance 0.8 --out hemisphere
expect_status 0
expect_stdout "| cap | 6.283185307179586 | 0.5 | 0.5 |"
/usr/bin/python3 - <<'END' || fail "the hemisphere is not lit as it should be"
import re
row = [line for line in open("hemisphere/enclosure.md") if line.startswith("| 0.8 |")][0]
cap, disk = (float(x) for x in row.split("|")[2:4])
r = 0.8
m0 = (r / 2) / (1 - r / 2 - r * r / 2)
assert abs(cap - m0) < 1e-7 * m0 and abs(disk - (1 + r * m0)) < 1e-7, (cap, disk, m0)
END
[ -s hemisphere/form_factors.npy ] && [ -s hemisphere/areas.mtx ] || fail "the matrices are missing"

# A mirror for a ceiling: the floor sees itself, as the faces of a box of twice the height see each other.
ffstudy enclosure cube --mirror 6 --trials 40 --rays 200 --reflectance 0.9 --seed 3
expect_status 0
expect_stdout "40 trials of 200 rays from each surface, seed 3"
expect_stdout "| 0.9 | direct | 40 of 40 |"
expect_stdout "| 0.9 | balanced | "
cp "$folder/stdout" first
ffstudy enclosure cube --mirror 6 --trials 40 --rays 200 --reflectance 0.9 --seed 3
cmp -s first "$folder/stdout" || fail "the same seed gives other trials"

# Trials that are all equal show a bias and no interval, and a surface that is dark has no relative error.
for of in "cylinder:1x2 --trials 2" "cap:1x1 --trials 5" "cube --mirror 1 --trials 5" "cap:1x1e-3 --trials 200" \
    "cylinder:1x2 --reflectance 0 --trials 20"; do
    # shellcheck disable=SC2086
    ffstudy enclosure $of
    expect_status 0
    ! grep -Eqw 'nan|inf' "$folder/stdout" || fail "a number is none: $of"
done
expect_stdout "| 0 | direct | 20 of 20 | 0 [0, 0] | 0 % | 0 % | 0 % (base) | "

# Light that is hardly absorbed takes more iterations than are made.
ffstudy enclosure cylinder:1x2 --reflectance 0.99999
expect_status 0
expect_stdout "| too slow |"

refused() {
    ffstudy enclosure "$@" --out refused
    expect_status 2
    [ ! -e refused ] || fail "something was written for $*"
}
refused cilinder:1x2
expect_stderr "Did you mean cylinder?"
refused cube
expect_stderr "Add --mirror 6"
refused cube --mirror 9
refused cap:1x3
refused cylinder:1x2 --reflectance 1
expect_stderr "light that nothing absorbs piles up"
refused cylinder:1x2 --emission 1,2
refused cylinder:1x2 --emission=-1
for emission in 1e308 5e-324 0,1e-200,1; do
    refused cylinder:1x2 --emission "$emission"
    expect_stderr "Use another unit"
done
refused cylinder:1x2 --trials 1
refused cylinder:1x2 --trials 10 --rays 0
