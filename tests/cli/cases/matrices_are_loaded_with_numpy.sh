#!/usr/bin/env bash
# The matrices of form_factors are loaded as docs/form-factors.md says, and the sparse files as SciPy lays them out.
# (With pandas: tests/cli/examples_for_pandas_and_r.)
# Needs NumPy.
root=$(cd "$(dirname "$0")/../../.." && pwd)
source "$(dirname "$0")/../harness.sh"

blocks obj "$root/docs/scenes.md" >furnace.obj
ffstudy form-factors furnace.obj --tolerance 1e-3 --out results/furnace
expect_status 0
blocks python "$root/docs/form-factors.md" 1 >load.py
cat >>load.py <<'END'
import csv
rows = list(csv.DictReader(open("results/furnace/matrix.csv")))
names = list(dict.fromkeys(row["from"] for row in rows))
for row in rows:
    assert float(row["factor"]) == factors[names.index(row["from"]), names.index(row["to"])]
widths = numpy.load("results/furnace/half_widths.npy")
for name, whole in (("form_factors", factors), ("half_widths", widths)):
    sparse = numpy.load(f"results/furnace/{name}.npz")
    assert sparse["format"].item() == b"csr" and tuple(sparse["shape"]) == whole.shape
    rows_of = numpy.repeat(numpy.arange(len(whole)), numpy.diff(sparse["indptr"]))
    dense = numpy.zeros_like(whole)
    dense[rows_of, sparse["indices"]] = sparse["data"]
    assert (dense == whole).all() and len(sparse["data"]) == 42
END
/usr/bin/python3 load.py || fail "the files are not as documented"
