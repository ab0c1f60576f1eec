#!/usr/bin/env bash
source "$(dirname "$0")/../harness.sh"

ffstudy --help
expect_status 0
for words in Everyday Laboratory Checks "Built-in studies" sr_vs_pdm run audit; do expect_stdout "$words"; done
expect_no_stderr
cp "$folder/stdout" "$folder/help"

# The same without a word, and by name; that of a command too.
for words in "" help; do
    ffstudy $words
    expect_status 0
    diff "$folder/help" "$folder/stdout" >&2 || fail "expected the help of the program"
done
ffstudy check --help
cp "$folder/stdout" "$folder/help"
ffstudy help check
diff "$folder/help" "$folder/stdout" >&2 || fail "expected the help of check"

# Options in a reader's words, not in those of the parser; commands also by their former names.
for command in form-factors form_factors heat check; do
    ffstudy help $command
    expect_status 0
    ! grep -E "Excludes|Needs:|UINT|FLOAT|TEXT|:\{" "$folder/stdout" >&2 || fail "expected no words of the parser"
done
ffstudy form-factors --help
expect_stdout "--seed N                    Seed of all random numbers (default: 1)"
ffstudy form_factors cube --quiet
expect_status 0

# What there is, for a reader and for a program.
for command in list explain; do
    ffstudy $command
    expect_status 0
    expect_stdout "samplers"
    expect_stdout "'ffstudy explain sobol'"
done
# Terms of the glossary, however they are spelled.
for term in PDM rmse form-factors "Form factor"; do
    ffstudy explain "$term"
    expect_status 0
    expect_stdout " (term)"
done
# json EXPRESSION: true of what was printed.
json() { python3 -c "import json, sys; value = json.load(open(sys.argv[1])); sys.exit(not ($1))" "$folder/stdout" || fail "expected $1"; }
ffstudy list --json
json "'sobol' in value['samplers'] and 'cube' in value['scenes']"
ffstudy list samplers --json
json "{'name', 'summary'} == set(value[0]) and 'sobol' in [row['name'] for row in value]"
ffstudy explain sobol --json
json "value[0]['kind'] == 'sampler' and 'net' in value[0]['details'] and value[0]['reference']"
expect_nothing_written
