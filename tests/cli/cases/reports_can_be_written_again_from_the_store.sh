#!/usr/bin/env bash
source "$(dirname "$0")/../harness.sh"

small_study >"$folder/study.toml"
ffstudy run "$folder/study.toml" --out out
expect_status 0
ffstudy report out --out again --quiet
expect_status 0
expect_no_stdout
for file in report.html report.md summary.csv trials.csv results.json context.json; do expect_equal_files out/$file again/$file; done

ffstudy report out/results.sqlite --format csv --out only
expect_status 0
expect_file only/summary.csv
[ ! -e only/report.md ] || fail "expected no report.md"

mkdir empty
ffstudy report out --format cvs --out empty
expect_status 2
expect_stderr "Did you mean 'csv'?"
[ -z "$(ls -A empty)" ] || fail "expected nothing in the folder"

# Own templates take the place of those that come with the program.
mkdir own
echo '{{title}}: {{verdict}}' >own/report.mustache
ffstudy report out --format html --out mine --templates own --quiet
expect_status 0
expect_in_file mine/report.html "small: $(sed -n 's/^\*\*\(.*\)\*\*$/\1/p' out/report.md)"
echo '{{#open}}' >own/report.mustache
ffstudy report out --format html --out mine --templates own
expect_status 2
expect_stderr "report.mustache: malformed template"
ffstudy report out --templates /no/such/folder
expect_status 3
expect_stderr "/no/such/folder"
