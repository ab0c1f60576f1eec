#!/usr/bin/env bash
# Tables hold whatever users call their methods, and pictures are drawn without a browser. (LaTeX and PDF:
# latex_compiles_tables_and_pictures.sh.)
# Needs Node.js.
source "$(dirname "$0")/../harness.sh"

oddly_named_study >"$folder/study.toml"
ffstudy run "$folder/study.toml" --out out
expect_status 0
[ ! -e out/tables ] || fail "expected no tables before they are asked for"

ffstudy report out --format latex --out paper --quiet
expect_status 0
expect_file paper/tables.tex
expect_in_file paper/tables/methods.tex '{[}a]\&b\%c\_d\$e\#f \textbackslash{}g\~{}h\^{}i\{j\}k'

# Own templates serve tables as well.
mkdir own
echo '{{title}}' >own/latex_table.mustache
ffstudy report out --format latex --out mine --templates own --quiet
expect_in_file mine/tables/methods.tex "Methods and sizes"

# Equal bytes each time, whatever the time is.
for pictures in one two; do
    ffstudy report out --format svg --out $pictures --quiet
    expect_status 0
done
expect_equal_files <(cd one && find . -type f | sort) <(cd two && find . -type f | sort)
for file in one/pictures/*; do expect_equal_files "$file" "two/pictures/${file##*/}"; done
ffstudy report out --format svg --out drawn --pictures convergence --quiet
expect_status 0
ls drawn/pictures/convergence-*.svg >/dev/null || fail "expected the pictures that are named"
[ -z "$(find drawn/pictures -type f ! -name 'convergence-*')" ] || fail "expected no others: $(ls drawn/pictures)"
ffstudy report out --format svg --out none --pictures convergent
expect_status 2
expect_stderr "--pictures convergent (no picture has a name that begins so)"
[ ! -e none ] || fail "expected nothing written"
for kind in convergence estimates bias-map cube; do
    ls one/pictures/$kind*.svg >/dev/null || fail "expected a picture $kind"
done
for file in one/pictures/*.svg; do
    xmllint --noout "$file" || fail "$file is malformed"
    ! grep -q -e 'var(--' -e NaN "$file" || fail "$file has a colour or a number that is none"
done

# What is missing is named before anything is written.
mkdir bin
PATH=$PWD/bin ffstudy report out --format csv,svg --out none
expect_status 2
expect_stderr "needs node (it is not on PATH)"
ln -s "$(command -v node)" bin/node
PATH=$PWD/bin ffstudy report out --format csv,pdf --out none
expect_status 2
expect_stderr "needs rsvg-convert (it is not on PATH)"
[ ! -e none ] || fail "expected nothing written"
rm bin/node
printf '#!/bin/sh\nexit 1\n' >bin/node
chmod +x bin/node
PATH=$PWD/bin:$PATH ffstudy report out --format svg --out none
expect_status 3
expect_stderr "bin/node: failed"
[ -z "$(find none -name '.ffstudy-part*')" ] || fail "expected nothing left of what was on its way"

# A report that is stopped takes the program that draws with it, and what both had begun.
cat >bin/node <<'END'
#!/bin/sh
echo $$ >"$PIDS/node"
exec sleep 600
END
export PIDS=$PWD/pids
# Whoever inherits a process that ended may not have asked for its status yet: a zombie runs no more.
runs() { grep -qs '^State:[[:space:]]*[^Z[:space:]]' "/proc/$1/status"; }
draws_no_more() { ! runs "$(cat pids/node)"; }
for signal in INT TERM KILL; do
    rm -rf pids stopped
    mkdir pids
    PATH=$PWD/bin:$PATH begin report out --format svg --out stopped
    wait_until test -s pids/node
    kill -$signal "$process"
    finish
    wait_until draws_no_more
    [ $signal = KILL ] || expect_status 130
    [ $signal = KILL ] || [ -z "$(ls -A stopped)" ] || fail "expected nothing left: $(ls -A stopped)"
done
# What could not be cleaned up by one that was killed, the next one does.
ffstudy report out --format csv --out stopped --quiet
expect_status 0
[ -z "$(find stopped -name '.ffstudy-part*')" ] || fail "expected nothing left of what was on its way"
