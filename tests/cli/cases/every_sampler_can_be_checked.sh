#!/usr/bin/env bash
# Points are written and read back, and what they have to keep is checked for every sampler.
source "$(dirname "$0")/../harness.sh"

# Out and in: the same points, in every form.
for format in npy csv dat; do
    ffstudy points sobol --n 256 --out points.$format
    expect_status 0
    ffstudy points file:points.$format --n 256 --out again.$format
    expect_status 0
    expect_equal_files points.$format again.$format
done
ffstudy points sobol --n 256 --trial 1 --out other.csv
cmp -s points.csv other.csv && fail "trials that are equal"
ffstudy points random --n 5 --out five.svg
expect_status 0
[ "$(grep -c '<circle' five.svg)" -eq 30 ] || fail "6 pairs of 5 points have 30 circles"
ffstudy points random --out points.txt
expect_status 2
expect_stderr "Use .npy, .csv, .dat or .svg."
ffstudy points gauss_legendre --n 16 --out points.csv
expect_status 2

# A net is known by its t-value; with one point moved it is no longer a net.
ffstudy points sobol --n 256 --d 2
expect_status 0
expect_stdout "t-value in base 2: 0"
ffstudy points sobol --n 256 --d 2 --out net.csv
awk -F, 'NR == 9 {print ($1 < 0.5 ? $1 + 0.5 : $1 - 0.5) "," $2; next} {print}' net.csv >moved.csv
ffstudy points file:moved.csv --n 256 --d 2
expect_status 0
expect_stdout "t-value in base 2: "
grep -Fq "t-value in base 2: 0" "$folder/stdout" && fail "a net with a point moved is no net"

# Sound ones pass: independent, a net, a set of a file with each randomisation.
for sampler in random sobol faure "file:points.csv#owen" "file:points.csv#digital_shift" "file:points.csv#lms"; do
    ffstudy check-sampler "$sampler"
    expect_status 0
    expect_stdout "same bits for the same seed"
done

# Broken ones fail, each in its way: sets that are all in one half, trials that repeat each other, no net.
awk 'BEGIN {
    x = 1
    for (s = 0; s < 2000; ++s) {
        for (i = 0; i < 16; ++i) { x = (x * 16807) % 2147483647; printf "%.12f\n", x / 2147483647 * (s % 2 ? 0.9 : 1) }
        print "#"
    }
}' >biased.txt
ffstudy check-sampler file:biased.txt
expect_status 1
expect_stdout "FAIL          coordinate 0 uniform"
expect_stdout "FAIL          mean of a smooth function"
awk 'BEGIN {
    x = 1
    for (s = 0; s < 2000; ++s) {
        for (i = 0; i < 16; ++i) { if (s % 4 == 0) { x = (x * 16807) % 2147483647; kept[i] = x / 2147483647 } printf "%.12f\n", kept[i] }
        print "#"
    }
}' >repeated.txt
ffstudy check-sampler file:repeated.txt
expect_status 1
expect_stdout "FAIL          trials independent, a smooth function"
expect_stdout "FAIL          sets differ"
# A file of half as many sets, written twice, has no serial correlation.
head -n 17000 biased.txt >half.txt
cat half.txt half.txt >twice.txt
ffstudy check-sampler file:twice.txt
expect_status 1
expect_stdout "1000 sets come back after 1000 trials"
ffstudy check-sampler same_seed
expect_stdout "same_seed"

# A promise is kept by every set, or broken at a place.
for promised in "latin_hypercube latin" "sobol latin,net:3" "stratified stratified" "lattice lattice,latin" "faure net:0"; do
    read -r sampler promises <<<"$promised"
    ffstudy check-sampler "$sampler" --promises "$promises"
    expect_status 0
    expect_stdout "pass          promise: ${promises%%,*}"
done
ffstudy check-sampler random --n 64 --promises latin,net:2
expect_status 1
expect_stdout "FAIL          promise: latin"
expect_stdout "coordinate 0: slice "
ffstudy check-sampler file:moved.csv#digital_shift --d 2 --promises net:0
expect_status 1
expect_stdout "FAIL          promise: net:0"
ffstudy check-sampler sobol --n 100 --promises net:2
expect_status 2
expect_stderr "100 points are no power of 2"
ffstudy check-sampler sobol --promises nets
expect_status 2
expect_stderr "latin, net:T with a number T, stratified or lattice"

# Without one the structure is looked for. What nearly has it is inconclusive where points are randomised, else a note.
ffstudy check-sampler random
expect_status 0
expect_stdout "of every coordinate, in 256 points"
expect_stdout "t in base 2 is "
ffstudy check-sampler sobol_raw
expect_status 0
expect_stdout "note          nearly a Latin hypercube"
ffstudy points sobol_raw --n 64 --out skipped.csv
ffstudy check-sampler file:skipped.csv#digital_shift
expect_status 4
expect_stdout "inconclusive  nearly a Latin hypercube"
expect_stdout "62 of 64 slices of coordinate"
{ echo 0,0; head -n 63 skipped.csv | cut -d, -f1,2; } >whole.csv
ffstudy check-sampler file:whole.csv#digital_shift
expect_status 0
ffstudy check-sampler file:whole.csv#shift
expect_status 4
expect_stdout "inconclusive  shifted net"
ffstudy check-sampler file:points.csv#shift
expect_status 4
expect_stdout "inconclusive  shifted slices"
awk -F, '{ printf "%.12f,%.12f\n", $1, (int(8 * $2) + 0.5) / 8 }' whole.csv >few_values.csv
ffstudy check-sampler file:few_values.csv#shift
expect_status 4
expect_stdout "coordinate 1: as few as 8 values in 64 points"

# Too few sets show nothing.
awk 'BEGIN { x = 1; for (s = 0; s < 20; ++s) { for (i = 0; i < 16; ++i) { x = (x * 16807) % 2147483647; printf "%.12f\n", x / 2147483647 } print "#" } }' >few.txt
ffstudy check-sampler file:few.txt
expect_status 4
expect_stdout "inconclusive"
ffstudy check-sampler file:few.txt --trials 21
expect_status 2
ffstudy check-sampler nosuch
expect_status 2
