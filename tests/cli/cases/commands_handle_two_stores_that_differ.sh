#!/usr/bin/env bash
# Two stores that differ in anything, in every command that takes two: a sentence and a documented exit code, never a
# crash, and nothing lost.
# Needs time: every pair of stores.
source "$(dirname "$0")/../harness.sh"

# study SCENE METHOD SIZES LINE...
study() {
    printf '%s\n' '[study]' 'name = "s"' "scene = \"$1\"" 'trials = 12' 'seed = 1' "${@:4}" \
        '[[method]]' "name = \"$2\"" 'sampler = "random"' 'estimator = "ray_shooting"' "samples_per_patch = $3"
}
# walls FACES: a closed room whose six walls belong to these faces.
walls() {
    printf '%s\n' '# closed' 'v 0 0 0' 'v 1 0 0' 'v 1 1 0' 'v 0 1 0' 'v 0 0 1' 'v 1 0 1' 'v 1 1 1' 'v 0 1 1'
    local corners=('1 2 3 4' '5 8 7 6' '1 5 6 2' '2 6 7 3' '3 7 8 4' '4 8 5 1') wall=0
    for face in "$@"; do printf 'g %s\nf %s\n' "$face" "${corners[wall++]}"; done
}
# run NAME: of NAME.toml, in a folder of that name.
run() {
    ffstudy run "$1.toml" --out "$1" --quiet
    expect_status 0
}

walls a b c d e f >room.obj
study room.obj rays 16 >base.toml && run base
study room.obj rays 16 'level = 0.9' >level.toml && run level
study room.obj others 16 >method.toml && run method
study room.obj rays '[16, 64]' >sizes.toml && run sizes
study room.obj rays 16 >completion.toml && echo 'completion = "reciprocal"' >>completion.toml && run completion
study cube rays 16 >cube.toml && run cube
walls a a a a b b >room.obj && study room.obj rays 16 >fewer_faces.toml && run fewer_faces
walls a b c d e g >room.obj && study room.obj rays 16 >other_face.toml && run other_face
walls a b c d e f >room.obj
study room.obj rays 16 >half.toml
ffstudy run half.toml --out half --shard 1/2 --quiet
expect_status 0
cp -r base empty && rm empty/results.sqlite && : >empty/results.sqlite

stores=(base level method sizes completion cube fewer_faces other_face half begun empty)
# ends COMMAND...: with a documented exit code, and where it refuses, in a sentence.
ends() {
    ffstudy "$@"
    case $status in
        0 | 1 | 4) ;;
        2 | 3)
            [ "$(wc -l <"$folder/stderr")" -le 2 ] || fail "expected a sentence"
            [ "$(wc -c <"$folder/stderr")" -lt 500 ] || fail "expected a short sentence"
            ;;
        *) fail "expected a documented exit code" ;;
    esac
}
# One that another process is writing, and what is left when that is killed.
study room.obj rays 4000000 >begun.toml
begin run begun.toml --out begun --quiet --threads 1
wait_until test -s begun/results.sqlite
for other in base cube half; do
    ends compare begun $other --quiet
    ends merge $other begun --out merged --quiet
    rm -rf merged
done
kill -9 "$process"
finish 2>"$folder/killed"

for one in "${stores[@]}"; do
    for other in "${stores[@]}"; do
        [[ $one < $other ]] || continue
        ends compare "$one" "$other" --quiet
        rm -rf merged
        ends merge "$other" "$one" --out merged --quiet
    done
    # Growing: the study of the first in the folder of another, which is kept aside or refused.
    [ "$one" = empty ] || [ "$one" = begun ] || for other in base sizes fewer_faces half; do
        rm -rf grown && cp -r $other grown
        before=$(cksum <grown/results.sqlite)
        ends run "$one.toml" --out grown --quiet
        [ "$status" = 0 ] || [ "$before" = "$(cksum <grown/results.sqlite)" ] || fail "expected nothing lost"
    done
done
