#!/usr/bin/env bash
# Man pages and completion come from the definitions that --help shows: every command, option and value is in all three.
# Needs time: every option.
root=$(cd "$(dirname "$0")/../../.." && pwd)
source "$(dirname "$0")/../harness.sh"

ffstudy man_pages manual
expect_status 0
sed -i 's/\\-/-/g; s/\\&//g' manual/*

# offered WORD...: what completion offers in place of the last word.
offered() {
    ffstudy complete ffstudy "$@"
    expect_status 0
    expect_no_stderr
    cut -f1 "$folder/stdout" >"$folder/offered"
}
expect_offered() { grep -Fqxe "$1" "$folder/offered" || fail "expected to be offered: $1"; }
# expect_in NAMES FILE WHERE: every line of NAMES is one of FILE. expect_offered_are NAMES: these are offered, and nothing else.
expect_in() { ! grep -Fxvf "$2" "$1" >&2 || fail "expected in $3"; }
expect_offered_are() { diff <(sort "$1") <(grep -v '^:' "$folder/offered" | sort) >&2 || fail "expected to be offered: $1"; }

ffstudy --help
sed '1,/^Everyday:/d' "$folder/stdout" | sed -nE 's/^  ([a-z_0-9-]+) .*/\1/p' >"$folder/commands"
[ "$(wc -l <"$folder/commands")" -ge 20 ] || fail "expected the commands"
! grep -Eq '^(complete|man_pages)$' "$folder/commands" || fail "expected no hidden command"
offered ""
expect_offered_are "$folder/commands"
sed -nE 's/^\.BR ffstudy-([a-z_0-9-]+).*/\1/p' manual/ffstudy.1 >"$folder/pages"
expect_in "$folder/commands" "$folder/pages" ffstudy.1
[ "$(ls manual | wc -l)" -eq $(($(wc -l <"$folder/commands") + 1)) ] || fail "expected a page for each command"
while read -r command; do
    ffstudy "$command" --help
    ! grep -Ew TEXT "$folder/stdout" || fail "expected every value to have a name"
    grep -oE '^  (-[a-zA-Z],)?--[a-z,-]+' "$folder/stdout" | grep -oE -e '--[a-z-]+' >"$folder/options"
    sed -nE '/^Positionals:/,/^$/s/^  ([A-Z]+).*/\1/p' "$folder/stdout" >"$folder/arguments"
    offered "$command" --
    expect_offered_are "$folder/options"
    sed -nE 's/^\.BR "(-[a-zA-Z],)?([a-zA-Z,-]+)".*/\2/p' "manual/ffstudy-$command.1" | tr , '\n' >"$folder/described"
    cat "$folder/options" "$folder/arguments" >"$folder/wanted"
    expect_in "$folder/wanted" "$folder/described" "ffstudy-$command.1"
done <"$folder/commands"

# The kinds are those that can be listed; help and completion name all of them, and every name of each.
kinds=$("$program" list --help | sed -nE 's/^  KIND +//p; s/^ {30,}//p' | tr -d , | tr '\n' ' ')
offered explain ""
for kind in $kinds; do
    ffstudy list "$kind"
    expect_status 0
    cut -d' ' -f1 "$folder/stdout" >"$folder/$kind"
    expect_in "$folder/$kind" "$folder/offered" "what explain is offered"
done
offered list ""
[ "$(sort "$folder/offered" | tr '\n' ' ')" = "$(tr ' ' '\n' <<<"$kinds" | sed '/^$/d' | sort | tr '\n' ' ')" ] ||
    fail "expected the kinds of help: $kinds"

# taken PLURAL WORD...: exactly the names that 'list PLURAL' shows are offered.
taken() {
    local plural=$1
    shift
    offered "$@" ""
    diff "$folder/$plural" <(grep -v '^:' "$folder/offered") >&2 || fail "expected $plural"
}
taken samplers convergence --sampler
taken estimators convergence --estimator
taken allocations convergence --allocation
taken completions convergence --completion
taken maps convergence --map
taken scenes convergence --scene
taken scenes form-factors
taken formats report results --format
taken studies run
offered report --format=csv,h
expect_offered --format=csv,html
offered run s
expect_offered sr_vs_pdm
expect_offered :files
offered run x --out ""
expect_offered :folders
offered run sr_vs_pdm --trials ""
[ ! -s "$folder/offered" ] || fail "expected nothing for a number"
offered nothing ""
[ ! -s "$folder/offered" ] || fail "expected nothing for an unknown command"
ffstudy report --help
tr -s ' \n' ' ' <"$folder/stdout" | grep -F "$(paste -sd, "$folder/formats" | sed 's/,/, /g') (default: html, markdown, csv, json)" >/dev/null ||
    fail "expected every format in help"

# docs/command-line.md names them too.
named() { sed -nE "s/$1/\\1/p" "$root/docs/command-line.md" | grep -oE '`[a-z_]+`' | tr -d '`' | sort; }
diff <(tr ' ' '\n' <<<"$kinds" | sed '/^$/d' | sort) <(named '^`KIND` is one of (.*)\.$') >&2 || fail "expected the kinds"
diff <(sort "$folder/formats") <(named '^\| `--format LIST` \| of (.*); separated.*') >&2 || fail "expected the formats"
