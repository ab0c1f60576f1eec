#!/usr/bin/env bash
# From a scene and its materials to flows, as docs/heat.md says.
root=$(cd "$(dirname "$0")/../../.." && pwd)
source "$(dirname "$0")/../harness.sh"

# The example is what the program prints.
blocks obj "$root/docs/scenes.md" 1 >furnace.obj
blocks toml "$root/docs/heat.md" >materials.toml
blocks "" "$root/docs/heat.md" | sed '1d' >"$folder/promised"
ffstudy heat furnace.obj --materials materials.toml --out heat
expect_status 0
expect_equal_files "$folder/promised" "$folder/stdout"
[ "$(wc -l <heat/heat.csv)" -eq $(($(grep -c . "$folder/promised") - 2)) ] || fail "expected a row per face"
ffstudy heat furnace.obj --materials materials.toml --out again --threads 1
expect_equal_files heat/heat.csv again/heat.csv

# A tolerance that the form factors do not allow.
ffstudy heat furnace.obj --materials materials.toml --tolerance 0.01 --flow-tolerance 1e-6
expect_status 4

# Millimetres, and kelvin that are degrees Celsius.
sed 's/temperature = [0-9.]*/temperature = 20/' materials.toml >celsius.toml
ffstudy heat furnace.obj --materials celsius.toml --scale 0.001
expect_stderr "20 °C would be 293.15 K"

mv furnace.obj "$folder" && rm -r ./*
refused() {
    printf '%b' "$1" >"$folder/wrong.toml"
    ffstudy heat cube --materials "$folder/wrong.toml" --out refused
    expect_refused 2 "$2"
}
refused '[materials]\n"*" = { emissivity = 0.5, flux = 0 }\n' "have a flux and no temperature"
refused '[materials]\n7 = { emissivity = 0.5, flux = 0 }\n' "the scene has no face '7'"
refused '[materials]\n"*" = { emissivity = 2, flux = 0 }\n' "wrong.toml:2:"
ffstudy heat cube --materials "$folder/furnace.obj"
expect_refused 2 "a scene file (a materials file is wanted here)"
ffstudy heat cube --materials missing.toml
expect_refused 3 "missing.toml"
