#!/usr/bin/env bash
# From a scene and its materials to flows, as docs/heat.md says.
root=$(cd "$(dirname "$0")/../../.." && pwd)
source "$(dirname "$0")/../harness.sh"

# The example is what the program prints.
blocks obj "$root/docs/scenes.md" 1 >furnace.obj
page=$root/docs/heat.md
blocks toml "$page" 1 >materials.toml
blocks "" "$page" 1 | sed '1d' >"$folder/promised"
ffstudy heat furnace.obj --materials materials.toml --out heat
expect_status 0
expect_equal_files "$folder/promised" "$folder/stdout"
[ "$(wc -l <heat/heat.csv)" -eq $(($(grep -c . "$folder/promised") - 3)) ] || fail "expected a row per face"
ffstudy heat furnace.obj --materials materials.toml --out again --threads 1
expect_equal_files heat/heat.csv again/heat.csv

# Samples where powers depend on them; from a mesh in millimetres to the answer.
promise() { blocks "" "$page" "$1" | sed '1d' >"$folder/promised_$1"; }
promise 2
ffstudy heat furnace.obj --materials materials.toml --tolerance-of flux --tolerance 0.001%
expect_status 0
tail -4 "$folder/stdout" >"$folder/end"
expect_equal_files "$folder/promised_2" "$folder/end"
cp "$root/docs/examples/oven.obj" .
blocks toml "$page" 2 >oven.toml
promise 3
promise 4
ffstudy heat oven.obj --materials oven.toml --scale 0.001 --tolerance-of flux --tolerance 0.1%
expect_status 0
expect_equal_files "$folder/promised_3" "$folder/stdout"
ffstudy heat oven.obj --materials oven.toml --scale 0.001 --tolerance-of flux --tolerance 0.1% --faces polygon --out oven
expect_status 0
head -5 "$folder/stdout" >"$folder/begin"
expect_equal_files "$folder/promised_4" "$folder/begin"
expect_in_file oven/report.html "tolerance 0.1% of powers"
sum=$(awk -F, '/^load/ {sum -= ($9 + $10) / 2} END {printf "%.1f", sum}' oven/heat.csv)
grep -Fq "The steel takes up $sum W" "$page" || fail "docs/heat.md does not say that the load takes up $sum W"
[ "$(awk -F, '$2 == "steel" {printf "%.1f", -($7 + $8) / 2}' oven/groups.csv)" = "$sum" ] || fail "expected the sum"
[ ! -e oven/form_factors.sqlite ] || fail "expected no factors that were sampled for flows"
{ cat oven.toml && blocks toml "$page" 3; } >grouped.toml
ffstudy heat oven.obj --materials grouped.toml --scale 0.001
expect_stdout "sides"
{ cat oven.toml && blocks toml "$page" 4; } >cases.toml
promise 5
ffstudy heat oven.obj --materials cases.toml --scale 0.001 --out cases
expect_status 0
expect_equal_files "$folder/promised_5" "$folder/stdout"
expect_in_file cases/report.html "one heater: net flux"
[ "$(grep -c '^design,' cases/heat.csv)" -eq 7 ] || fail "expected a row for each face of a case"
ffstudy heat oven.obj --materials cases.toml --scale 0.001 --tolerance-of flux
expect_status 2
expect_stderr "has 2 cases"
ffstudy heat oven.obj --materials cases.toml --scale 0.001 --gebhart --out gebhart
expect_status 0

# A folder keeps the form factors for the next run, with other materials too; it is of one scene and one request.
ffstudy heat oven.obj --materials oven.toml --scale 0.001 --out cases
expect_status 0
expect_stderr "the form factors are those of an earlier run in cases"
ffstudy heat oven.obj --materials oven.toml --scale 0.001 --out alone
expect_equal_files alone/heat.csv cases/heat.csv
ffstudy heat --load alone --materials oven.toml --scale 0.001 --out loaded
expect_equal_files alone/heat.csv loaded/heat.csv
rm -r loaded
ffstudy heat oven.obj --materials oven.toml --scale 0.001 --out cases --seed 2
expect_status 2
expect_stderr "its seed is 1, not 2"
ffstudy heat furnace.obj --materials materials.toml --out cases
expect_status 2
expect_stderr "the scene is another"
ffstudy heat --load heat --materials materials.toml --out cases
expect_status 2
expect_stderr "the scene is another"
ffstudy heat oven.obj --materials oven.toml --scale 0.001 --tolerance-of flux --out cases
expect_status 2
expect_stderr "has the form factors of another run (not sampled for flows)"
ffstudy heat --load cases --materials oven.toml --scale 0.001 --out cases
expect_status 0
expect_equal_files alone/heat.csv cases/heat.csv
{
    printf '[materials]\n"block.*" = { emissivity = 0.8, temperature = 1200 }\n'
    printf '"roof.*" = { emissivity = 0.6, temperature = 400 }\n'
    for face in floor south east north west; do printf '"%s.*" = { emissivity = 0.9, flux = 0 }\n' $face; done
} >polygons.toml
ffstudy heat furnace.obj --materials polygons.toml --faces polygon
for power in "397478" "398076"; do
    grep -Fq "${power::3} ${power:3} W" "$page" || fail "docs/heat.md does not say $power"
done
expect_stdout "-397477.6"
ffstudy heat furnace.obj --materials materials.toml --tolerance-of flux --tolerance 1e-9 --max-samples 1100000
expect_status 4
ffstudy heat furnace.obj --materials materials.toml --tolerance-of flux --flow-tolerance 1%
expect_status 2
expect_stderr "Give --tolerance alone"
for wrong in 2 0 5kW; do
    ffstudy heat furnace.obj --materials materials.toml --tolerance-of flux --tolerance $wrong
    expect_status 2
    expect_stderr "Write 0.001, 0.1% or 40W"
done
ffstudy heat furnace.obj --materials materials.toml --tolerance 0.1%
expect_status 2
expect_stderr "--tolerance-of flux"

# Nothing is exchanged between faces of one temperature, and that is known.
printf '[materials]\n"*" = { emissivity = 0.7, temperature = 600 }\n' >alike.toml
for of in factor flux; do
    ffstudy heat furnace.obj --materials alike.toml --tolerance-of $of
    expect_status 0
    expect_stdout "Nothing is exchanged"
done

# The same from a kept matrix, whose intervals have to hold all at once; Gebhart factors add up to 1.
ffstudy form-factors furnace.obj --simultaneous --tolerance 1e-4 --out plain --quiet
ffstudy heat --load plain --materials materials.toml --out bounds
expect_stderr "has no values of randomisations: intervals of flows are bounds"
expect_stdout "all at once at level 0.95"
ffstudy heat furnace.obj --materials materials.toml --interval bound --out heat_in_bounds
expect_equal_files bounds/heat.csv heat_in_bounds/heat.csv
ffstudy form-factors furnace.obj --simultaneous --tolerance 1e-4 --randomisations --out kept --quiet
ffstudy heat --load kept --materials materials.toml --out loaded --script-f
expect_equal_files "$folder/promised" "$folder/stdout"
expect_equal_files heat/heat.csv loaded/heat.csv
/usr/bin/python3 - <<'PYTHON' || fail "expected rows of Gebhart factors that can add up to 1, and script-F by reciprocity"
import csv
rows = list(csv.DictReader(open("loaded/gebhart.csv")))
areas = {r["face"]: float(r["area"]) for r in csv.DictReader(open("loaded/heat.csv"))}
assert len(rows) == 49
for face in areas:
    ends = [sum(float(r[f"gebhart_{end}"]) for r in rows if r["from"] == face) for end in ("low", "high")]
    assert 0.99 < ends[0] <= 1 <= ends[1] < 1.01, (face, ends)
script = {(r["from"], r["to"]): (float(r["script_f_low"]), float(r["script_f_high"])) for r in rows}
for (a, b), (low, high) in script.items():
    back = script[b, a]
    assert areas[a] * low <= areas[b] * back[1] and areas[b] * back[0] <= areas[a] * high, (a, b)
import zipfile
for name in ("gebhart", "gebhart_half_widths", "script_f", "script_f_half_widths"):
    assert {"data.npy", "indices.npy", "indptr.npy", "shape.npy"} <= set(zipfile.ZipFile(f"loaded/{name}.npz").namelist())
names = list(areas)
shape, *values = [line for line in open("loaded/script_f.mtx") if not line.startswith("%")]
assert shape.split() == [str(len(names))] * 2
for place, value in enumerate(values):  # column by column
    low, high = script[names[place % len(names)], names[place // len(names)]]
    assert abs(float(value) - (low + high) / 2) <= 1e-15, place
PYTHON
ffstudy form-factors furnace.obj --tolerance 1e-2 --out one_by_one --quiet
ffstudy heat --load one_by_one --materials materials.toml
expect_status 2
expect_stderr "Run 'ffstudy form-factors' again with --simultaneous."
ffstudy heat --materials materials.toml
expect_status 2
expect_stderr "SCENE is missing"

# What is stopped keeps what is known; what is missed, or not to be trusted, is said in the sentence.
ffstudy heat furnace.obj --materials materials.toml --tolerance-of flux --max-time 0.00001
expect_status 4
ffstudy heat furnace.obj --materials materials.toml --flow-tolerance 1W
expect_status 4
expect_stdout "The tolerance of 1W is missed"
sed 's/^g block/g occluder/' furnace.obj >occluder.obj
printf 'surroundings = 500\n[materials]\n"*" = { emissivity = 0.7, temperature = 500 }\n' >around.toml
ffstudy heat occluder.obj --materials around.toml
expect_status 0
expect_stdout "Nothing is exchanged"
{ echo "# scale 0.001" && cat oven.obj; } >scaled.obj
ffstudy heat scaled.obj --materials oven.toml --scale 0.001
expect_status 2
expect_stderr "says 'scale 0.001' itself"

# A tolerance that the form factors do not allow.
ffstudy heat furnace.obj --materials materials.toml --tolerance 0.01 --flow-tolerance 1e-6
expect_status 4

# Millimetres, and kelvin that are degrees Celsius.
sed 's/temperature = [0-9.]*/temperature = 20/' materials.toml >celsius.toml
ffstudy heat furnace.obj --materials celsius.toml --scale 0.001 --tolerance 0.01
expect_stderr "20 °C would be 293.15 K"

# Rows that miss 1 by chance, as all intervals at once do in one run of twenty, are widened; a hole is no chance.
sphere() { printf '[[surface]]\nface = "%s"\nshape = "sphere"\ncentre = %s\nradius = %s\nfacing = "%s"\n' "$@"; }
{ echo 'closed = true' && sphere outer '[0, 0, 0]' 2 inward && sphere inner '[0.7, 0.2, 0]' 1 outward; } >spheres.toml
printf '[materials]\n"*" = { emissivity = 0.5, temperature = 300 }\ninner = { emissivity = 0.5, temperature = 400 }\n' >two.toml
ffstudy heat spheres.toml --materials two.toml --tolerance 1e-3 --seed 7 --interval bound
expect_status 0
expect_stderr "note: the form factors of face 'outer' cannot add up to 1"
{ echo 'closed = true' && sphere outer '[0, 0, 0]' 2 inward && sphere inner '[1.8, 0, 0]' 1 outward; } >hole.toml
ffstudy heat hole.toml --materials two.toml --tolerance 1e-3
expect_status 4
expect_stderr "ffstudy: scene 'hole.toml': the form factors of face 'outer' cannot add up to 1"

mv furnace.obj "$folder" && rm -r ./*
refused() {
    printf '%b' "$1" >"$folder/wrong.toml"
    ffstudy heat cube --materials "$folder/wrong.toml" --out refused
    expect_refused 2 "$2"
}
printf '[materials]\n"*" = { emissivity = 0.5, flux = 0 }\n' >adiabatic.toml
ffstudy heat cube --materials adiabatic.toml --out kept
expect_status 2
expect_stderr "have a flux and no temperature"
[ "$(ls kept)" = form_factors.sqlite ] || fail "expected the form factors to be kept for other materials"
rm -r ./*
refused '[materials]\n7 = { emissivity = 0.5, flux = 0 }\n' "the scene has no face '7'"
refused '[materials]\n"*" = { emissivity = 2, flux = 0 }\n' "wrong.toml:2:"
ffstudy heat cube --materials "$folder/furnace.obj"
expect_refused 2 "a scene file (expected a materials file)"
ffstudy heat cube --materials missing.toml
expect_refused 3 "missing.toml"

# Missing surroundings are noticed before the factors of a large scene are computed.
{
    for row in $(seq 0 59); do
        for column in $(seq 0 59); do echo "v $column $row 0"; done
    done
    for row in $(seq 0 58); do
        for column in $(seq 0 58); do
            i=$((60 * row + column + 1))
            echo "f $i $((i + 1)) $((i + 61)) $((i + 60))"
        done
    done
} >sheet.obj
printf '[materials]\n"*" = { emissivity = 0.7, temperature = 500 }\n' >no_surroundings.toml
ffstudy heat sheet.obj --faces polygon --materials no_surroundings.toml
expect_status 2
expect_stderr "sees out of the scene, with more than half of the radiation of one of its surfaces"
expect_stderr "Give surroundings"
