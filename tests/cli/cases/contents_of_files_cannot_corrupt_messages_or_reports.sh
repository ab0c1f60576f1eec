#!/usr/bin/env bash
source "$(dirname "$0")/../harness.sh"

# expect_readable: stderr has no control characters but line ends, and no page of the input.
expect_readable() {
    ! LC_ALL=C grep -q '[^[:print:][:space:]]' <(sed 's/…//g' "$folder/stderr") || fail "expected no control characters"
    [ "$(wc -c <"$folder/stderr")" -lt 6000 ] || fail "expected a short message"
}

study() { printf '[study]\nname = "s"\nscene = "%s"\ntrials = 4\nseed = 1\n[[method]]\nname = "%s"\nsampler = "random"\nestimator = "ray_shooting"\nsamples_per_patch = 9\n' "$1" "$2"; }

# Escape sequences and marks of direction stand in names, values and file names.
for name in 'a\u001b[31mb' 'a\u202eb' 'a\u2028b' 'a\u009bb' 'a\ufeffb' 'a\u2066b'; do
    study cube "$name" >"$folder/study.toml"
    ffstudy run "$folder/study.toml"
    expect_refused 2 "would break tables"
    expect_readable
done
ffstudy run $'no\e[31msuch.toml'
expect_refused 3 'no\x1b[31msuch.toml'
expect_readable
ffstudy run $'no\xe2\x80\xaesuch.toml'
expect_refused 3 'no\u202esuch.toml'
ffstudy form-factors $'caf\xe9.obj'
expect_refused 2 'caf\xe9.obj: not UTF-8 (reports could not hold it).'
ffstudy check bands.toml --out $'caf\xe9'
expect_refused 2 'caf\xe9: not UTF-8'

# Fields of ten megabytes.
printf 'trial,quantity,estimate\n0,q,%s\n' "$(head -c 10000000 /dev/zero | tr '\0' x)" >"$folder/long.csv"
printf '[[gate]]\nname = "g"\nkind = "bias"\nquantity = "q"\nreference = 1\nband = 1\n' >"$folder/bands.toml"
ffstudy check "$folder/bands.toml" --estimates "$folder/long.csv"
expect_refused 2 "long.csv:2:5: estimate = 'xxx"
expect_readable
printf '{"source": "%s", "source": 1}' "$(head -c 10000000 /dev/zero | tr '\0' y)" >"$folder/long.json"
ffstudy audit "$folder/long.json"
expect_refused 2 'the key "source" stands twice'
expect_readable
printf 'a\0b' >"$folder/null.toml"
ffstudy run "$folder/null.toml"
expect_refused 2 "null.toml:1:2: the byte 0x00 is not text"

# A text that a spreadsheet would evaluate is not accepted as a name; one that only begins with a sign is.
for name in '=1+1' '@SUM(A1)' '+A1*2' '-2+3' '=x'; do
    study cube "$name" >"$folder/study.toml"
    ffstudy run "$folder/study.toml"
    expect_refused 2 "(a spreadsheet would take it for a formula). Begin it with a letter."
done
printf '# a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 1 1\nv 1 0 1\ng +x\nf 1 2 3\ng -z\nf 4 5 6\n' >"$folder/signs.obj"
ffstudy form-factors "$folder/signs.obj" --tolerance 0.01
expect_status 0
sed 's/g +x/g __proto__/' "$folder/signs.obj" >"$folder/proto.obj"
ffstudy form-factors "$folder/proto.obj"
expect_refused 2 "proto.obj:9: face '__proto__' (the pictures of report.html cannot have it). Rename it."

# A byte order mark hides no line.
{ printf '\xef\xbb\xbf# closed\n' && sed 1d "$folder/signs.obj"; } >"$folder/closed.obj"
ffstudy form-factors "$folder/closed.obj" --tolerance 0.01
expect_stderr "though the scene is said to be closed"

# Indices that the loader would wrap, cut or take for others.
for corner in 9223372036854775808 4294967297 1.5 0 1x 1//2/3 x# 1/0; do
    sed "s|^f 1 2 3|f 1 2 $corner|" "$folder/signs.obj" >"$folder/corner.obj"
    ffstudy form-factors "$folder/corner.obj"
    expect_refused 2 "corner.obj:9: corner 3 is '$corner' (vertices count from 1, or back from -1). Write f 1 2 3."
done
for corner in 3/1 3/1/1 3//1 -4; do
    sed "s|^f 1 2 3|f 1 2 $corner|" "$folder/signs.obj" >"$folder/corner.obj"
    ffstudy form-factors "$folder/corner.obj" --tolerance 0.01
    expect_status 0
done

# Depth that would overflow the stack.
head -c 1000000 /dev/zero | tr '\0' '[' >"$folder/deep.json"
ffstudy audit "$folder/deep.json"
expect_refused 2 "deep.json:1:101: more than 100 objects and lists within each other"

# Templates that include themselves, and each other.
study cube SR >"$folder/study.toml"
ffstudy run "$folder/study.toml" --out kept --quiet
expect_status 0
mkdir "$folder/own"
echo '{{>report}}' >"$folder/own/report.mustache"
ffstudy report kept --templates "$folder/own" --out "$folder/none"
expect_status 2
expect_stderr "report.mustache: the template includes itself (report > report). Leave one of these out."
echo '{{> one }}' >"$folder/own/report.mustache"
echo '{{=<% %>=}}<%>two%>' >"$folder/own/one.mustache"
echo '{{>one}}' >"$folder/own/two.mustache"
ffstudy report kept --templates "$folder/own" --out "$folder/none"
expect_status 2
expect_stderr "one.mustache: the template includes itself (report > one > two > one)."

# A store whose table is a view that never ends, or computes what it holds.
ffstudy run "$folder/study.toml" --out other --quiet
expect_status 0
view="DROP TABLE observations; CREATE VIEW observations AS WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i FROM n)
  SELECT 0 AS cell, 'hits' AS observable, 1 AS from_face, 2 AS to_face, i AS trial, 1 AS value FROM n"
/usr/bin/python3 -c "import sqlite3, sys; sqlite3.connect(sys.argv[1]).executescript(sys.argv[2])" kept/results.sqlite "$view"
for command in "report kept --out none" "run $folder/study.toml --out kept" "compare kept other" "merge kept --out none"; do
    # shellcheck disable=SC2086
    begin $command
    finish
    expect_status 2
    expect_stderr "not a result store (table 'observations' is missing)"
done

# Another study is told by section, key and both values.
sed -i 's/trials = 4/trials = 4\nequivalence_margin = 0.1/; s/samples_per_patch = 9/samples_per_patch = 10/' "$folder/study.toml"
ffstudy run "$folder/study.toml" --out other
expect_status 2
expect_stderr "differs in [[method]] \"SR\": 'sizes = [{ patches_per_face = 1, samples_per_patch = 9 },]' there, 'sizes = [{ patches_per_face = 1, samples_per_patch = 10 },]' here, and in 1 more key): 4 of its 4 trials are none of this one."
