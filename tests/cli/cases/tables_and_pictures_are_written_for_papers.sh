#!/usr/bin/env bash
# Tables compile with LaTeX whatever users call their methods; pictures are drawn without a browser.
source "$(dirname "$0")/../harness.sh"

needs() { command -v "$1" >/dev/null || { echo "$1 is missing: apt-get install $2" >&2 && exit 1; }; }
needs pdflatex "texlive-latex-base texlive-latex-recommended"
needs xmllint libxml2-utils
needs rsvg-convert librsvg2-bin
needs node nodejs

{
    small_study 3 | sed -e "s/^name = \"small\"/&\ntitle = '50 % of \$x_1\$ \& more #1 ~ \\\\end{document} {'/" \
        -e "s/^name = \"SR\"/name = '[a]\&b%c_d\$e#f \\\\g~h^i{j}k'/" -e "s/^name = \"kernel\"/name = '*\"<-- -->\" Größe'/"
} >"$folder/study.toml"
ffstudy run "$folder/study.toml" --out out
expect_status 0
[ ! -e out/tables ] || fail "expected no tables before they are asked for"

# compile FOLDER: twice, as longtable wants it.
compile() {
    for _ in 1 2; do
        (cd "$1" && pdflatex -halt-on-error -interaction=nonstopmode tables.tex) >"$folder/stdout" 2>&1 </dev/null || return 1
    done
}

ffstudy report out --format latex --out paper --quiet
expect_status 0
cp -r paper again
compile again || fail "pdflatex refuses the tables"
expect_file again/tables.pdf
expect_in_file paper/tables/methods.tex '{[}a]\&b\%c\_d\$e\#f \textbackslash{}g\~{}h\^{}i\{j\}k'

# A name that nobody escaped is noticed.
sed -i 's/\\_d/_d/' again/tables/methods.tex
! compile again || fail "expected pdflatex to refuse a bare _"

# Own templates serve tables as well.
mkdir own
echo '{{title}}' >own/latex_table.mustache
ffstudy report out --format latex --out mine --templates own --quiet
expect_in_file mine/tables/methods.tex "Methods and sizes"

# Equal bytes each time, whatever the time is.
for pictures in one two; do
    ffstudy report out --format svg,pdf --out $pictures --quiet
    expect_status 0
done
expect_equal_files <(cd one && find . -type f | sort) <(cd two && find . -type f | sort)
for file in one/pictures/*; do expect_equal_files "$file" "two/pictures/${file##*/}"; done
for kind in convergence estimates bias-map cube; do
    ls one/pictures/$kind*.svg >/dev/null || fail "expected a picture $kind"
done
for file in one/pictures/*.svg; do
    xmllint --noout "$file" || fail "$file is malformed"
    ! grep -q -e 'var(--' -e NaN "$file" || fail "$file has a colour or a number that is none"
    [ "$(head -c 5 "${file%.svg}.pdf")" = %PDF- ] || fail "${file%.svg}.pdf is no PDF"
done

# What is missing is named before anything is written.
mkdir bin
for missing in node rsvg-convert; do
    PATH=$PWD/bin ffstudy report out --format csv,pdf --out none
    expect_status 2
    expect_stderr "needs $missing (it is not on PATH)"
    [ ! -e none ] || fail "expected nothing written"
    ln -sf "$(command -v node)" bin/node  # so that the next is missing
done
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
echo $$ >"$PIDS/$1"
exec sleep 60
END
sed -i 's/\$1/node/' bin/node
export PIDS=$PWD/pids
# Whoever inherits a process that ended may not have asked for its status yet: a zombie runs no more.
runs() { grep -qs '^State:[[:space:]]*[^Z[:space:]]' "/proc/$1/status"; }
for signal in INT TERM KILL; do
    rm -rf pids stopped
    mkdir pids
    command_line="ffstudy report --format svg (to be stopped by SIG$signal)" status=0
    PATH=$PWD/bin:$PATH "$program" report out --format svg --out stopped >"$folder/stdout" 2>"$folder/stderr" </dev/null &
    process=$!
    until [ -s pids/node ]; do
        kill -0 $process || fail "the report was over before it could be stopped"
        sleep 0.01
    done
    kill -$signal $process
    wait $process 2>/dev/null || status=$?
    for _ in {1..100}; do
        runs "$(cat pids/node)" || break
        sleep 0.01
    done
    ! runs "$(cat pids/node)" || fail "expected SIG$signal to end the program that draws"
    [ $signal = KILL ] || expect_status 130
    [ $signal = KILL ] || [ -z "$(ls -A stopped)" ] || fail "expected nothing left: $(ls -A stopped)"
done
# What could not be cleaned up by one that was killed, the next one does.
ffstudy report out --format csv --out stopped --quiet
expect_status 0
[ -z "$(find stopped -name '.ffstudy-part*')" ] || fail "expected nothing left of what was on its way"
