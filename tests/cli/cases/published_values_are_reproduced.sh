#!/usr/bin/env bash
# What docs/beside-others.md says of published values, peers and independent computations is what its program prints.
root=$(cd "$(dirname "$0")/../../.." && pwd)
source "$(dirname "$0")/../harness.sh"
examples=$root/docs/examples/published

# compare: runs the command of the page. rows: of its tables, without the intervals of ffstudy, of which those by rays can
# differ in the last digits where Embree has other code for a CPU.
compare() {
    command_line="compare.py"
    status=0
    /usr/bin/python3 "$examples/compare.py" "$program" >"$folder/stdout" 2>"$folder/stderr" || status=$?
}
rows() { grep -E '^\| [a-z_0-9]+\.' "$1" | awk -F'|' 'BEGIN {OFS = "|"} NF > 6 {$5 = ""} {print}'; }
compare
expect_status 0
rows "$folder/stdout" | sort >"$folder/printed"
rows "$root/docs/beside-others.md" | sort >"$folder/promised"
[ "$(wc -l <"$folder/promised")" -eq 25 ] || fail "docs/beside-others.md does not show its 25 rows"
expect_equal_files "$folder/promised" "$folder/printed"
line=$(grep '^OpenViewFactor, without scenes' "$folder/stdout")
grep -Fq "$line" "$root/docs/beside-others.md" || fail "docs/beside-others.md does not show: $line"

# Each of two planted errors is found: an independent value, and one that View3D does not print.
mkdir planted
cp "$examples"/* planted
examples=planted
sed -i -E '/^(source|View3D),/!d' planted/values.csv
sed -i 's/^\(View3D,town.vs3,ground,wall,0.036812,1e-4,rays\),.*/\1,0.036812,1e-4/' planted/values.csv
sed -i 's/^squares.vs3,near,far,0.149870/squares.vs3,near,far,0.149970/' planted/view3d.csv
compare
expect_status 1
expect_stderr "differs: town.vs3: ground to wall"
expect_stderr "differs: squares.vs3: View3D differs by 1.0e-04"
[ "$(grep -c '^differs' "$folder/stderr")" -eq 2 ] || fail "expected two differences"
