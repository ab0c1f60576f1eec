#!/usr/bin/env bash
source "$(dirname "$0")/../harness.sh"

# study SAMPLER SEED [SCENE]: one sampled method, one deterministic.
study() {
    cat <<END
[study]
name = "s"
scene = "${3-cube}"
trials = 200
seed = $2

[[method]]
name = "rays"
sampler = "$1"
estimator = "ray_shooting"
samples_per_patch = 256

[[method]]
name = "PDM"
sampler = "gauss_legendre"
nodes = 3
estimator = "area_kernel"
END
}

run() {
    study "${@:2}" >"$1.toml"
    ffstudy run "$1.toml" --out "$1" --quiet
    expect_status 0
}
run a random 1
run again random 1
run other_seed random 2
run broken patch_centres 2
run other_scene random 1 box:2x1x0.5

# Sound: another seed makes no difference. The chance of one by accident is 5 %, and the seeds are fixed.
ffstudy compare a other_seed
expect_status 0
expect_stdout "a: study s, seed 1"
expect_stdout "Neither run is shown to be better: the RMSE of other_seed is "
expect_stdout "no difference found (would detect"
expect_stdout "Of the 2 methods and sizes in both runs, none differs."
expect_stdout "62 tests, 5 % together"
! grep -q $'\033' "$folder/stdout" || fail "expected no colour where there is no terminal"

# The same random numbers have to give the same hits.
ffstudy compare a again
expect_status 0
expect_stdout "the same random numbers, equal in all 200 trials"

# The same trials completed in two ways are neither equal nor independent.
study random 1 | sed 's/^estimator = "ray_shooting"/&\ncompletion = "reciprocal"/' >reciprocal.toml
study random 1 | sed 's/^estimator = "ray_shooting"/&\ncompletion = "direct"/' >direct.toml
for completion in reciprocal direct; do ffstudy run $completion.toml --out $completion --quiet; done
ffstudy compare direct reciprocal
expect_stdout "no test: the same trials, completed in two ways"

# Verdicts where no exact value is known, and so no error.
printf 'v %s\n' '0 0 0' '1 0 0' '1 1 0' '0 1 0' '0 0 1' '0.9 0.1 1.1' '1 1 1.2' '0 1 1.1' >open.obj
printf 'g below\nf 1 2 3\nf 1 3 4\ng above\nf 7 6 5\nf 8 7 5\n' >>open.obj
for sampler in random patch_centres; do
    study $sampler 1 open.obj | sed '/PDM/,$d' | sed '$d' >open_$sampler.toml
    ffstudy run open_$sampler.toml --out open_$sampler --quiet
    expect_status 0
done
ffstudy compare open_random open_patch_centres
expect_status 1
expect_stdout "DIFFERENT: mean of F"

# Broken: it is seen, and where the studies differ is said. The report is the same each time.
for out in one two; do
    ffstudy compare a broken --out $out
    expect_status 1
    expect_stdout "DIFFERENT: mean of F"
    expect_stdout '"patch_centres"'
    expect_stdout "is better: its RMSE is "
done
expect_equal_files one/comparison.html two/comparison.html
expect_equal_files one/comparison.md two/comparison.md
expect_in_file one/comparison.md "Of the 2 methods and sizes in both runs, 1 differs"
ffstudy compare a/results.sqlite broken --quiet
expect_status 1
expect_no_stdout
ffstudy compare a broken --json
expect_status 1
python3 -c "import json, sys
value = json.load(open(sys.argv[1]))
assert value['runs'] == ['a', 'broken'] and 'is better' in value['verdict']
assert any(cell['differs'] and cell['rmse'][0]['interval']['low'] > 0 for cell in value['cells'])" "$folder/stdout" ||
    fail "expected the same as JSON"

# Folders with the same name are distinguished by their parent folders.
mkdir -p old new
cp -r a old/run
cp -r other_seed new/run
ffstudy compare old/run new/run
expect_stdout "new/run: study s, seed 2"

# One method of each, in two runs or in one, whatever they are called.
ffstudy compare a:rays broken:rays
expect_status 1
expect_stdout "RMSE of broken:rays"
expect_stdout "The only method and size in both runs differs."
sed 's/name = "PDM"/name = "other rays"/; s/"gauss_legendre"/"sobol"/; s/nodes = 3/samples_per_patch = 256/; s/area_kernel/ray_shooting/' a.toml >two.toml
ffstudy run two.toml --quiet --out two
ffstudy compare two:rays "two:other rays"
expect_status 1
expect_stdout "other rays is better"
expect_stdout "rays | other rays"
! grep -q "not at the same cost" "$folder/stdout" || fail "expected nothing about costs, which are equal"
sed 's/"sobol"/"random"/; s/"ray_shooting"$/"area_kernel"/' two.toml | sed '0,/area_kernel/s//ray_shooting/' >costs.toml
grep -q area_kernel costs.toml || fail "expected a study of rays and kernel values"
ffstudy run costs.toml --quiet --out costs
ffstudy compare costs:rays "costs:other rays"
expect_stdout "At equal evaluations: "
expect_stdout "fewer evaluations"

# Methods whose sizes mean different things are compared at equal cost, in one run or two.
cat >one.toml <<'END_OF_STUDY'
[study]
name = "one"
scene = "cube"
trials = 50
seed = 3
[[method]]
name = "hemicube"
estimator = "hemicube"
patches_per_face = [1, 4]
samples_per_patch = 768
[[method]]
name = "rays"
sampler = "random"
estimator = "ray_shooting"
samples_per_patch = [256, 1024]
END_OF_STUDY
ffstudy run one.toml --out one_run --quiet
sed 's/seed = 3/seed = 4/' one.toml >another.toml
ffstudy run another.toml --out another_run --quiet
for other in one_run another_run; do
    ffstudy compare one_run:hemicube $other:rays --out at_equal_cost
    expect_status 1
    expect_stdout "At equal evaluations: "
    expect_stdout "At equal cost"
    expect_no_stderr
done
expect_in_file at_equal_cost/comparison.md "| at 18432 evaluations | parallel |"
ffstudy compare one_run:hemicube another_run:rays --json
python3 -c "import json, sys
bouts = json.load(open(sys.argv[1]))['equal_cost']
assert {bout['equal'] for bout in bouts} == {'evaluations', 'processor_time', 'error'}, bouts
assert all(bout['ratio'] >= 1 and bout['better'] in ('one_run:hemicube', 'another_run:rays') for bout in bouts)" \
    "$folder/stdout" || fail "expected all bouts as JSON"
ffstudy compare two:rays two
expect_status 2
expect_stderr "only one names a method"
ffstudy compare two:rays two:ray
expect_status 2
expect_stderr "Did you mean 'rays'?"
ffstudy compare two:rays two:rays
expect_status 2
expect_stderr "or two of its methods"

# On a terminal verdicts have colours, unless NO_COLOR says otherwise.
on_a_terminal() { /usr/bin/python3 -c 'import pty, sys; pty.spawn(sys.argv[1:])' "$program" compare a broken >"$folder/stdout"; }
TERM=xterm on_a_terminal
expect_stdout $'\033[31mDIFFERENT'
TERM=xterm NO_COLOR=1 on_a_terminal
! grep -q $'\033' "$folder/stdout" || fail "expected no colour with NO_COLOR"

# What cannot be compared is refused.
ffstudy compare a ./a
expect_status 2
expect_stderr "a run is equal to itself"
ffstudy compare a other_scene
expect_status 2
expect_stderr "on 'cube'; the second has "
ffstudy compare a missing
expect_status 3
ffstudy compare a a.toml
expect_status 2
ffstudy compare a
expect_status 2

# A scene file that changed between two runs: other faces are not compared, the same ones with something else between are.
room() {  # room FACES [BLOCKER]
    local corners=("1 4 3 2" "5 6 7 8" "1 2 6 5" "4 8 7 3" "1 5 8 4" "2 3 7 6")
    printf 'v %s\n' "0 0 0" "1 0 0" "1 1 0" "0 1 0" "0 0 1" "1 0 1" "1 1 1" "0 1 1" "0.4 0.4 0.5" "0.6 0.4 0.5" "0.6 0.6 0.5"
    for ((face = 0; face < $1; ++face)); do printf 'g wall%d\nf %s\n' "$face" "${corners[face]}"; done
    [ -z "${2-}" ] || printf 'g occluder\nf 9 10 11\n'
}
cat >changing.toml <<'END_OF_STUDY'
[study]
name = "changing"
scene = "room.obj"
trials = 20
seed = 1
[[method]]
name = "rays"
sampler = "sobol"
estimator = "ray_shooting"
samples_per_patch = 64
END_OF_STUDY
for version in "six 6" "four 4" "other 6 blocked"; do
    set -- $version
    room "${@:2}" >room.obj
    ffstudy run changing.toml --quiet --out "room_$1"
    expect_status 0
done
for pair in "room_six room_four" "room_four room_six"; do
    # shellcheck disable=SC2086  # two words
    ffstudy compare $pair
    expect_status 2
    expect_stderr "scene 'room.obj' has other faces in each run"
done
expect_stderr "in each run: 4 in the first and 6 in the second)"
ffstudy compare room_six room_other
expect_stdout "Scene 'room.obj' is not the same in both runs, but its faces are."
# What differs is said where the number of faces does not.
room 6 | sed '12{N;N;N;s/\(.*\n.*\)\n\(.*\n.*\)/\2\n\1/}' >room.obj
ffstudy run changing.toml --quiet --out room_in_another_order
ffstudy compare room_six room_in_another_order
expect_status 2
expect_stderr "in each run: number 1 is 'wall0' in the first and 'wall1' in the second)"
room 6 | sed 's/wall0/threshold/' >room.obj
ffstudy run changing.toml --quiet --out room_renamed
ffstudy compare room_six room_renamed
expect_status 2
expect_stderr "in each run: number 1 is 'wall0' in the first and 'threshold' in the second)"
room 6 | sed 's/ 1$/ 2/' >room.obj
ffstudy run changing.toml --quiet --out room_high
ffstudy compare room_six room_high
expect_status 2
expect_stderr "in each run: 'wall1' has another place or shape, or other surfaces)"
