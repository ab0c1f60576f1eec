#!/usr/bin/env bash
# bash loads what is installed for it, and completes what is typed. (zsh and fish: zsh_and_fish_complete_commands.sh.)
here=$(cd "$(dirname "$0")/.." && pwd)
source "$here/harness.sh"

scripts=$here/../../app/completion
mkdir -p bin studies
ln -s "$program" bin/ffstudy
printf '[study]\n' >studies/mine.toml
PATH=$PWD/bin:$PATH
declare -A loads=(
    [bash]="source $scripts/ffstudy.bash"
    [zsh]="fpath=($scripts \$fpath); autoload -U compinit; compinit -u -D"
    [fish]="source $scripts/ffstudy.fish"
)

# types SHELL LINE: what the shell shows when the line, in which \t completes, has been entered.
types() {
    command_line="$1: $2" status=0
    "$here/type_in_shell" "$1" "${loads[$1]}" "$2" >"$folder/stdout" 2>"$folder/stderr" || status=$?
    expect_status 0
}

for shell in ${other_shells:-bash}; do
    types $shell 'ffstudy expl\tsobol_l\t'
    expect_stdout "sobol_lms (sampler)"
    types $shell 'ffstudy report nowhere --fo\tcsv,htm\t --qui\t'
    expect_stdout "nowhere"
    ! grep -Fq "is unknown" "$folder/stdout" || fail "expected a format"
    types $shell 'ffstudy form-factors squares_blocked:\t --tol\t0.1'
    expect_stdout "are within 0.1"
    types $shell 'ffstudy form-factors --load=stud\t'
    expect_stdout "ffstudy: studies"
    types $shell 'ffstudy list --help; ffstudy report nowhere --format=csv,mark\t; ls'
    expect_stdout "nowhere"
    ! grep -Fq "is unknown" "$folder/stdout" || fail "expected a format"
    types $shell 'ffstudy run stud\tmi\t'
    expect_stdout "studies/mine.toml"
done
