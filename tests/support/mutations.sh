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
