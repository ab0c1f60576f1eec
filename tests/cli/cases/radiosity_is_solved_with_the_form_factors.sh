#!/usr/bin/env bash
# A study with [radiosity], or `ffstudy radiosity`, says what errors do to the light; the files are as documented. What no
# room has is refused before anything is written.
root=$(cd "$(dirname "$0")/../../.." && pwd)
source "$(dirname "$0")/../harness.sh"

small_study 20 >"$folder/study.toml"
ffstudy radiosity "$folder/study.toml" --reflectance 0.5,0.95 --emission 0,0,0,0,0,1 --out lit
expect_status 0
expect_stdout "I − P F keeps diagonal dominance at every reflectance below 1; at 0.5 the exitance error is"
expect_stdout "Exitance error at reflectance 0.5, estimated or repaired: "
grep -Fq "## What the errors do to the light" lit/report.md || fail "report.md says nothing of light"

# Every column of the tables is explained, under its own name or that of its three.
for file in matrices systems exitance solvers residuals; do
    [ "$(wc -l <lit/$file.csv)" -gt 1 ] || fail "$file.csv is empty"
    for column in $(head -n 1 lit/$file.csv | tr , ' '); do
        grep -Fq "\`$column\`" "$root/docs/results.md" || grep -Fq "\`${column%_*}_*\`" "$root/docs/results.md" ||
            fail "docs/results.md does not explain $column of $file.csv"
    done
done

# The same from a study file, and again from the store.
{ cat "$folder/study.toml"; printf '[radiosity]\nreflectance = [0.5, 0.95]\nemission = [0, 0, 0, 0, 0, 1]\n'; } >lit.toml
ffstudy run lit.toml --out from_file --threads 1
expect_status 0
ffstudy report from_file --out again
for file in matrices systems exitance solvers residuals; do
    expect_equal_files lit/$file.csv from_file/$file.csv
    expect_equal_files lit/$file.csv again/$file.csv
done

# Matrices for other programs: the two formats hold the same numbers, and the header of .npy is as NumPy wants it.
ffstudy report lit --format matrices --out files
expect_status 0
/usr/bin/python3 - <<'END' || fail "the matrices are not as they should be"
import ast, pathlib, struct

def npy(path):
    data = path.read_bytes()
    assert data[:8] == b"\x93NUMPY\x01\x00", path
    (length,) = struct.unpack("<H", data[8:10])
    assert (10 + length) % 64 == 0 and data[10 + length - 1:10 + length] == b"\n", path
    header = ast.literal_eval(data[10:10 + length].decode())
    assert header["descr"] == "<f8" and header["fortran_order"] is True, path
    return header["shape"], struct.unpack(f"<{len(data[10 + length:]) // 8}d", data[10 + length:])

def mtx(path):
    lines = path.read_text().splitlines()
    assert lines[0] == "%%MatrixMarket matrix array real general", path
    body = [line for line in lines if not line.startswith("%")]
    return tuple(int(n) for n in body[0].split()), tuple(float(x) for x in body[1:])

root = pathlib.Path("files/matrices")
paths = sorted(root.rglob("*.npy"))
assert len(paths) == len(list(root.rglob("*.mtx"))) > 40, len(paths)
for path in paths:
    shape, values = npy(path)
    rows, read = mtx(path.with_suffix(".mtx"))
    assert read == values and len(values) == rows[0] * rows[1], path
    assert shape == (rows if rows[1] > 1 else rows[:1]), path
# Rows of the exact cube sum to 1, I - P F at reflectance 0.5 has half of that left; column by column.
_, exact = npy(root / "exact_0/form_factors.npy")
_, system = npy(root / "exact_0/system_0.npy")
for row in range(6):
    assert abs(sum(exact[row::6]) - 1) < 1e-14 and abs(sum(system[row::6]) - 0.5) < 1e-14
# Between patches: the rows of rays sum to 1, and the hits on the patches of a face are those on the face.
shape, patches = npy(root / "cell_1/patch_form_factors.npy")
assert shape == (24, 24)
assert all(abs(sum(patches[row::24]) - 1) < 1e-12 for row in range(24))
_, faces = npy(root / "cell_1/form_factors.npy")
to_face_6 = sum(patches[column * 24 + row] for row in range(4) for column in range(20, 24)) / 4
assert abs(to_face_6 - faces[5 * 6 + 0]) < 1e-14, (to_face_6, faces[30])
END

# Between patches as well: every file has them, the same for any number of threads, and from the store again.
{ cat lit.toml; echo 'patch_trials = 3'; } >patches.toml
ffstudy run patches.toml --out patches --threads 2
expect_status 0
expect_stdout "Between the 24 patches of "
grep -Fq "Exitance errors, between patches" patches/report.md || fail "report.md says nothing of patches"
ffstudy radiosity "$folder/study.toml" --reflectance 0.5,0.95 --emission 0,0,0,0,0,1 --patch-trials 3 --threads 1 \
    --out patches_again
for file in matrices systems exitance solvers residuals; do
    grep -Fq ",patches," patches/$file.csv || fail "$file.csv has no systems between patches"
    ! grep -Fq ",patches," lit/$file.csv || fail "$file.csv has systems that nobody asked for"
    expect_equal_files patches/$file.csv patches_again/$file.csv
done

# What does not fit is refused before anything is done, and the message says how much would.
sed 's/patches_per_face = .*/patches_per_face = 400/' patches.toml >large.toml
ffstudy run large.toml --max-memory 100M --out refused
expect_status 2
expect_stderr "--max-memory 100 MiB: too little for 'small' (about 6"
[ ! -e refused ] || fail "something was written"
sed 's/patches_per_face = .*/patches_per_face = 1764/' patches.toml >larger.toml
ffstudy run larger.toml --out refused
expect_status 2
expect_stderr "at most 10000 patches with ray_shooting"

# The light is proportional to the emission, as far as it is taken.
for emission in 1e-30 1e30; do
    ffstudy radiosity "$folder/study.toml" --reflectance 0.5,0.95 --emission "0,0,0,0,0,$emission" --out "lit_$emission"
    expect_status 0
    expect_in_file "lit_$emission/report.md" "exitance error"
    errors() { grep -F "exitance error" "$1/report.md"; }
    [ "$(errors "lit_$emission")" = "$(errors lit)" ] || fail "at emission $emission the exitance error differs"
    ffstudy radiosity "$folder/study.toml" --reflectance 1e-30,0.999999999 --emission "$emission" --out "far_$emission"
    expect_status 0
    ! grep -Eqw 'nan|inf' "far_$emission/report.md" || fail "a number is none at emission $emission"
done

# Without the section there are none.
ffstudy run "$folder/study.toml" --out dark
[ ! -e dark/exitance.csv ] || fail "a study without [radiosity] has exitances"

refused() {
    ffstudy radiosity "$folder/study.toml" --out refused "$@"
    expect_status 2
    [ ! -e refused ] || fail "something was written for $*"
}
refused --reflectance 1
expect_stderr "light that nothing absorbs piles up"
refused --reflectance 0.5,-0.1
refused --reflectance bright
expect_stderr "not a list of numbers"
refused --emission=-1
expect_stderr "no surface emits that"
refused --emission 1,2
expect_stderr "has 6 faces"
refused --emission 1e200
expect_stderr "Use another unit"
refused --emission 0
