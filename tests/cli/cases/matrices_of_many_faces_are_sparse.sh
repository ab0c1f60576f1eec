#!/usr/bin/env bash
# Above 4096 faces files without zeros are written, others on request; a matrix of any size is closed and repaired.
source "$(dirname "$0")/../harness.sh"

# Strips on two plates that see each other, those of the upper one within one face for each of 66 rows.
awk 'BEGIN {
    columns = 64
    for (k = 0; k < 65 * columns; ++k) {
        x = k % columns; y = int(k / columns)
        printf "g low%d\nv %d %d 0\nv %d %d 0\nv %d %d 0\nv %d %d 0\nf -4 -3 -2 -1\n", k, x, y, x + 1, y, x + 1, y + 1, x, y + 1
    }
    printf "g high\nv 0 0 900\nv 0 65 900\nv 64 65 900\nv 64 0 900\nf -4 -3 -2 -1\n"
}' </dev/null >plates.obj
ffstudy form-factors plates.obj --surroundings sky --repair --text --randomisations --out all
expect_status 0
expect_stdout "plates.obj: 4162 faces"
expect_stdout "Repaired: row sums off 1 by up to"
[ ! -e all/form_factors.npy ] || fail "expected no file with all zeros"
[ "$(wc -l <all/matrix.csv)" -eq 16643 ] || fail "expected 2 * (4160 * 2 + 1) entries, found $(wc -l <all/matrix.csv)"
head -1 all/repaired.mtx | grep coordinate >/dev/null || fail "expected a sparse file"
[ "$(sed -n 3p all/repaired.mtx)" = "4162 4162 16642" ] || fail "unexpected: $(sed -n 3p all/repaired.mtx)"
ffstudy form-factors --load all --out again
expect_status 0
[ ! -e again/matrix.csv ] && [ ! -e again/repaired.mtx ] || fail "expected no text files without --text"
for file in form_factors repaired half_widths; do expect_equal_files all/$file.npz again/$file.npz; done
