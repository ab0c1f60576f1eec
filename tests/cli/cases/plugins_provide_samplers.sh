#!/usr/bin/env bash
# Samplers in shared libraries, as docs/adding-a-sampler.md describes them.
source "$(dirname "$0")/../harness.sh"

include=$data/../../include
# plugin NAME [FLAG...]: builds libNAME.so of tests/data/plugins/broken.c.
plugin() {
    cc -std=c99 -Wall -Wextra -Wpedantic -Werror -O1 -shared -fPIC -I"$include" "${@:2}" "$data/plugins/broken.c" \
        -o "lib$1.so"
}
# study NAME SAMPLER [LINE]: with a line of [study].
study() {
    cat >"$1.toml" <<END
[study]
name = "$1"
scene = "cube"
trials = 20
seed = 1
${3-}
[[method]]
name = "mine"
sampler = "$2"
estimator = "ray_shooting"
samples_per_patch = 1500
END
}

# They are listed, explained, checked and drawn as others are; whatever way their points are made, they are the same.
plugin sound
ffstudy list samplers --plugin ./libsound.so
expect_status 0
expect_stdout "independent points, part by part"
ffstudy explain fixed --plugin ./libsound.so
expect_status 0
expect_stdout "From the plug-in ./libsound.so"
expect_stdout "powers of 2"
ffstudy check-sampler parts --plugin ./libsound.so --n 1500 --trials 8000
expect_status 0
ffstudy check-sampler whole --plugin ./libsound.so --n 1500 --trials 8000
expect_status 0
expect_stdout "coordinates 2 and 3 uniform"
ffstudy points fixed --plugin ./libsound.so --n 64
expect_status 2
expect_stderr "points of 1 to 2 coordinates"

# A study names its plug-in, and says so before it loads it; threads do not matter.
study own whole 'plugins = ["libsound.so"]'
mkdir elsewhere
cp libsound.so own.toml elsewhere
ffstudy run elsewhere/own.toml --threads 1 --out a
expect_status 0
expect_stderr "note: elsewhere/own.toml:6:11 loads the plug-in libsound.so"
expect_stdout "none found"
ffstudy run own.toml --threads 2 --out b
expect_status 0
expect_equal_files a/trials.csv b/trials.csv
# Reports need no plug-in, a run does.
cp a/summary.csv before.csv
rm -r elsewhere
ffstudy report a
expect_status 0
expect_equal_files a/summary.csv before.csv
ffstudy run own.toml --no-commands --out c
expect_status 2
expect_stderr "own.toml:6:11: loads the plug-in libsound.so (--no-commands refuses it)"
[ ! -e c ] || fail "something was written"
study named parts
ffstudy run named.toml
expect_status 2
expect_stderr 'sampler "parts" (there is none of this name)'
ffstudy run named.toml --plugin ./libsound.so --no-commands --out c
expect_status 0
ffstudy convergence --sampler parts,whole --samples 2^6..2^8 --trials 20 --plugin ./libsound.so --out d
expect_status 0
cat >bands.toml <<'END'
[gates]
plugins = ["libsound.so"]
[[gate]]
name = "unbiased"
kind = "bias"
scene = "cube"
sampler = "whole"
estimator = "ray_shooting"
samples_per_patch = 256
band = 0.02
END
ffstudy check bands.toml --out e
expect_status 0
expect_stderr "note: bands.toml:2:11 loads the plug-in libsound.so"

# Built again it is another sampler.
plugin sound -DBUILT_AGAIN -g
ffstudy run own.toml --out a
expect_status 2
expect_stderr "holds another study"

# refuse CODE TEXT ARGUMENT...: the command fails so.
refuse() {
    rm -rf f.csv
    ffstudy "${@:3}" --out f.csv
    expect_status "$1"
    expect_stderr "$2"
}
bad=(points whole --n 64)
for how in VERSION SYMBOL NAME DIMENSION; do plugin "$how" "-DBROKEN_$how"; done
refuse 2 "./libVERSION.so: made for version 2 of the interface (this program has 1)" "${bad[@]}" --plugin ./libVERSION.so
refuse 2 "./libSYMBOL.so: no function ffstudy_samplers" "${bad[@]}" --plugin ./libSYMBOL.so
refuse 2 'sampler "sobol" (there is one of this name already)' "${bad[@]}" --plugin ./libNAME.so
refuse 2 'sampler "whole": most_dimension = 5 (1 to 4 coordinates)' "${bad[@]}" --plugin ./libDIMENSION.so
refuse 3 "./missing.so: cannot be read" "${bad[@]}" --plugin ./missing.so
echo "no library" >text.so
refuse 2 "./text.so: cannot be loaded" "${bad[@]}" --plugin ./text.so
plugin twin -DBUILT_AGAIN
refuse 2 'sampler "whole" (there are two of this name' "${bad[@]}" --plugin ./libsound.so --plugin ./libtwin.so

# What goes wrong while a study runs names the trial and the place; what was saved stays.
for how in RESULT RANGE MISSING; do plugin "$how" "-DBROKEN_$how"; done
study wrong whole
refuse 2 'whole of ./libRESULT.so (trial 3, seed ' run wrong.toml --threads 1 --plugin ./libRESULT.so
expect_stderr 'returns 7, "no such trial" (0 is success)'
refuse 2 'points of 4 coordinates): point 5, coordinate 1 is 1 (counted from 0; not in [0, 1))' \
    run wrong.toml --threads 1 --plugin ./libRANGE.so
expect_stderr "whole of ./libRANGE.so (trial 3, seed "
refuse 2 'point 6, coordinate 0 is ' run wrong.toml --threads 1 --plugin ./libMISSING.so
c++ -std=c++17 -shared -fPIC -I"$include" "$data/plugins/throws.cpp" -o libthrows.so
refuse 2 'thrower of ./libthrows.so (trial 0, seed ' points thrower --n 64 --plugin ./libthrows.so
expect_stderr 'throws "thrown in trial 0"'
