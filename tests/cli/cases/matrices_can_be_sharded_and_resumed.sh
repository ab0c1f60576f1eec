#!/usr/bin/env bash
# A matrix of many faces: shards and killed runs come to the bytes of one run.
source "$(dirname "$0")/../harness.sh"

# Two walls of six by six tiles, every tile a face of its own, and a disc between them.
awk 'function tile(x, y, z, flip) {
    printf "[[surface]]\nface = \"f%d\"\nshape = \"parallelogram\"\ncorner = [%d, %d, %d]\n", ++faces, x, y, z
    print "edge_u = [1, 0, 0]\nedge_v = [0, 1, 0]\nflip = " flip
}
BEGIN {
    for (i = 0; i < 6; ++i) for (j = 0; j < 6; ++j) { tile(i, j, 0, "false"); tile(i, j, 4, "true") }
    print "[[surface]]\nface = \"disc\"\nshape = \"disc\"\ncentre = [3, 3.2, 2]\nnormal = [0, 0, -1]\nradius = 1.2"
}' >"$folder/tiles.toml"
options=("$folder/tiles.toml" --tolerance 1e-3)

expect_same_matrix() {
    local file
    [ "$(ls "$1")" = "$(ls "$2")" ] || fail "expected the same files in $1 and $2"
    for file in form_factors.json matrix.csv form_factors.npz half_widths.npz areas.npy; do
        expect_equal_files "$1/$file" "$2/$file"
    done
}

ffstudy form-factors "${options[@]}" --randomisations --out whole
expect_status 0
[ ! -e whole/rows.sqlite ] || fail "expected the rows to be gone when the matrix is whole"

for i in 1 2 3; do
    ffstudy form-factors "${options[@]}" --shard $i/3 --threads $i --out part$i
    expect_status 0
    expect_stdout "shard $i/3 is complete: part$i/rows.sqlite"
    [ "$(ls part$i)" = rows.sqlite ] || fail "expected a shard to leave its rows only"
done
ffstudy merge part3 part1/rows.sqlite --out merged
expect_status 4
expect_stderr "rows of the matrix are missing. Merge again with the shards that hold them"
ffstudy merge part3 part1/rows.sqlite part2 part1 --randomisations --out merged
expect_status 0
expect_no_stderr
expect_same_matrix whole merged
expect_equal_files whole/randomisations.npz merged/randomisations.npz
rm whole/randomisations.npz
ffstudy form-factors "${options[@]}" --shard 1/3 --randomisations --out other
expect_status 2
expect_stderr "--shard excludes --randomisations"

# Shards that follow each other in one folder are a whole run.
for i in 2 3 1; do ffstudy form-factors "${options[@]}" --shard $i/3 --out together; done
expect_same_matrix whole together

# A shard of which nothing has to be sampled can be merged like any other.
for i in 1 2; do
    ffstudy form-factors box:1x2x3 --shard $i/2 --out exact$i
    expect_status 0
    expect_stdout "shard $i/2 is complete: exact$i/rows.sqlite"
done
ffstudy form-factors box:1x2x3 --out exact
ffstudy merge exact1 exact2 --out exact_merged
expect_status 0
expect_same_matrix exact exact_merged

# Killed again and again while rows are kept, and stopped by limits.
RANDOM=5
kills=0
while [ $kills -lt 4 ]; do
    try_again "the matrix was whole before the program could be killed"
    begin form_factors "${options[@]}" --threads 1 --out killed
    wait_until is_over_or test -s killed/rows.sqlite
    sleep "0.$(printf '%02d' $((RANDOM % 20)))"
    kill -9 "$process" 2>/dev/null || true
    finish
    if [ -s killed/rows.sqlite ]; then kills=$((kills + 1)); else rm -rf killed; fi
done
ffstudy form-factors "${options[@]}" --max-memory 1M --out killed
[ "$status" -eq 130 ] || [ -e killed/areas.npy ] || fail "expected the limit of memory to stop the run"
ffstudy form-factors "${options[@]}" --out killed
expect_status 0
expect_same_matrix whole killed

# Rows of another matrix are not taken, nor damaged ones.
ffstudy form-factors "$folder/tiles.toml" --tolerance 2e-3 --out part1
expect_status 2
expect_stderr "rows of another matrix (its tolerance is "
ffstudy merge part1 part2 part3 --out part1
expect_status 2
expect_stderr "one of the shards lies there"
cp -r part1 damaged
printf 'XXXXXXXX' | dd of=damaged/rows.sqlite bs=1 seek=$(($(stat -c %s damaged/rows.sqlite) - 60)) conv=notrunc 2>/dev/null
ffstudy merge damaged part2 part3 --out from_damaged
expect_status 3
expect_stderr "damaged"

ffstudy form-factors "${options[@]}" --dry-run
expect_status 0
expect_stdout "73 faces of "
expect_stdout "of processor time"
expect_no_stderr
ffstudy form-factors "${options[@]}" --shard 1/2
expect_status 2
expect_stderr "--shard"

# Pairs with small factors are summed up, not listed.
ffstudy form-factors "${options[@]}" --drop 0.01 --out dropped
expect_status 0
expect_stdout "both factors are below 0.01"
expect_stdout "Dropped of a row is at most "
expect_in_file dropped/form_factors.json '"dropped_high": '
expect_in_file dropped/form_factors.json '"leaves_low": '
cp "$folder/stdout" "$folder/text"
ffstudy form-factors --load dropped
expect_equal_files "$folder/text" "$folder/stdout"
ffstudy form-factors --load dropped --repair
expect_status 2
expect_stderr "--repair: the matrix was made with --drop 0.01"
