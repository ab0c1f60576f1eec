#!/usr/bin/env bash
# Tables compile with LaTeX whatever users call their methods, and pictures become PDF.
# Needs LaTeX and rsvg-convert.
source "$(dirname "$0")/../harness.sh"

oddly_named_study >"$folder/study.toml"
ffstudy run "$folder/study.toml" --out out
expect_status 0
ffstudy report out --format latex --out paper --quiet
expect_status 0

# compile: twice, as longtable wants it.
compile() {
    for _ in 1 2; do
        (cd paper && pdflatex -halt-on-error -interaction=nonstopmode tables.tex) >"$folder/stdout" 2>&1 </dev/null || return 1
    done
}
compile || fail "pdflatex refuses the tables"
expect_file paper/tables.pdf
# A name that nobody escaped is noticed.
sed -i 's/\\_d/_d/' paper/tables/methods.tex
! compile || fail "expected pdflatex to refuse a bare _"

# Equal bytes each time, whatever the time is.
for pictures in one two; do
    ffstudy report out --format pdf --out $pictures --quiet
    expect_status 0
done
expect_equal_files <(cd one && find . -type f | sort) <(cd two && find . -type f | sort)
for file in one/pictures/*.pdf; do
    expect_equal_files "$file" "two/pictures/${file##*/}"
    [ "$(head -c 5 "$file")" = %PDF- ] || fail "$file is no PDF"
done
