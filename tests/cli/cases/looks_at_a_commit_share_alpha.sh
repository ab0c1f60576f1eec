#!/usr/bin/env bash
# Reruns of a commit are kept in a ledger and share alpha: no rerun until green.
source "$(dirname "$0")/../harness.sh"

printf '%s\n' '[[gate]]' 'name = "flux"' 'kind = "bias"' 'quantity = "flux"' 'reference = 1' 'band = 0.01' >bands.toml
mean() { printf 'quantity,mean,standard_error\nflux,%s,%s\n' "$1" "$2" >estimates.csv; }

mean 1.001 0.02
ffstudy check bands.toml --estimates estimates.csv --again 4ba5469
expect_status 4
expect_stdout "look 1 at 4ba5469: alpha 5e-05 of 0.0001"
ffstudy check bands.toml --estimates estimates.csv --again 4ba5469
expect_status 4
expect_stdout "the same data were judged before (bands.ledger.csv): inconclusive"
mean 1.001 0.002
ffstudy check bands.toml --estimates estimates.csv --again 4ba5469
expect_status 0
expect_stdout "look 2 at 4ba5469: alpha 2.5e-05 of 0.0001"
mean 2 0.02
ffstudy check bands.toml --estimates estimates.csv --again 4ba5469
expect_status 1
mean 1.001 0.0001
ffstudy check bands.toml --estimates estimates.csv --again 4ba5469
expect_status 1
expect_stdout "failed at an earlier look (bands.ledger.csv); a rerun does not take that back"
# Another commit has an alpha of its own, and a ledger may lie elsewhere.
ffstudy check bands.toml --estimates estimates.csv --again b/2 --ledger kept.csv
expect_status 0
expect_stdout "look 1 at b/2"
expect_in_file kept.csv "commit,bands,data,verdict"
expect_in_file bands.ledger.csv "4ba5469"

# What is not judged is not spent.
mean 1 -1
ffstudy check bands.toml --estimates estimates.csv --again c
expect_status 2
! grep -q '^c,' bands.ledger.csv || fail "expected no look at c"
ffstudy check bands.toml --estimates estimates.csv --again 'a,b'
expect_status 2
ffstudy check bands.toml --estimates estimates.csv --ledger kept.csv
expect_status 2
ffstudy check bands.toml --estimates estimates.csv --again c --dry-run
expect_status 2
