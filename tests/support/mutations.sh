# One-line changes to a copy of the source, to see what notices them. Sourced by tests/gates/mutations and
# tests/cli/mutations.
# shellcheck shell=bash

set -euo pipefail
source_tree=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)

# build TARGET...: in the copy, as scripts/test does.
build() {
    cmake --build "$copy/build/dev" --parallel "$(nproc)" --target "$@" >"$copy/build.log" 2>&1 ||
        { cat "$copy/build.log" >&2 && exit 2; }
}

# fits: whether each change of standard input has the one line that it is for.
fits() {
    local file old rest misfits=0
    while IFS='|' read -r file old rest; do
        [ "$(grep -cF -- "$old" "$source_tree/$file")" = 1 ] || { echo "$file: not one line with: $old" && misfits=1; }
    done
    return $misfits
}

# with_each_change FUNCTION: on standard input one change a line: file, what is replaced (on one line), by what, what
# that does, and what the function is called with while it is so.
with_each_change() {
    local file old new meaning argument original
    while IFS='|' read -r file old new meaning argument; do
        original=$(<"$copy/$file")
        printf '%s\n' "${original/"$old"/"$new"}" >"$copy/$file"
        printf '\n%s: %s\n%s\n%s\n' "$file" "$meaning" "- $old" "+ $new"
        "$1" "$argument"
        printf '%s\n' "$original" >"$copy/$file"
    done
}

# copy_source: into a new folder, $copy.
copy_source() {
    copy=$(mktemp -d)
    trap 'rm -rf "$copy"' EXIT
    git -C "$source_tree" ls-files -z | tar -C "$source_tree" --null -T - -cf - | tar -C "$copy" -xf -
    (cd "$copy" && cmake --preset dev >/dev/null)
}

# test_exists NAME: whether NAME begins the name of a command-line case ("cli.a_killed_run") or of a test
# ("StoreFile.IsRefusedIfDamaged", or "Merge." for a whole suite). What does not exist would fail for the wrong reason.
test_exists() {
    case $1 in
        cli.*) compgen -G "$source_tree/tests/cli/cases/${1#cli.}*.sh" >/dev/null ;;
        *) grep -rqE "^(TEST|TEST_F|TEST_P|RC_GTEST_PROP)\\(${1%%.*}, *${1#*.}" "$source_tree/tests/unit" ;;
    esac
}

# run_test NAME: runs the tests whose names begin with NAME in the copy. Sets `status`: 0 they pass, 1 one of them fails.
# Anything else, such as that there is no such test, ends the script.
run_test() {
    local program found=no
    status=0
    if [[ $1 == cli.* ]]; then
        ctest --test-dir "$copy/build/dev" -N -R "^$1" | grep "^ *Test *#" >/dev/null || { echo "no such test: $1" >&2 && exit 2; }
        ctest --test-dir "$copy/build/dev" -R "^$1" --timeout 300 >"$copy/test.log" 2>&1 || status=$?
        case $status in
            0) ;;
            8) status=1 && sed -nE 's/^ *[0-9]+\/[0-9]+ Test +#[0-9]+: ([^ ]+) .*\*\*\*(.*)/FAILED: \1 (\2)/p' "$copy/test.log" ;;
            *) cat "$copy/test.log" >&2 && exit 2 ;;
        esac
        return
    fi
    for program in $(find "$copy/build/dev/tests" -name '*_tests' -type f -perm -u+x); do
        local code=0
        "$source_tree/tests/support/run_tests" --filter "$1*:*/$1*" "$program" >"$copy/test.log" 2>&1 || code=$?
        [ $code -le 2 ] || { cat "$copy/test.log" >&2 && exit 2; }
        [ $code = 2 ] || found=yes
        [ $code != 1 ] || { status=1 && grep '^FAILED: ' "$copy/test.log"; }
    done
    [ $found = yes ] || { echo "no such test: $1" >&2 && exit 2; }
}
