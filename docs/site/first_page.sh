# What the site's first page shows beside the README, each with the command that makes it. Read by scripts/docs, whose
# variables `program` and `out` it uses; prints Markdown.

# session COMMAND: the command, and what the program prints.
session() {
    printf '\n```\n$ ffstudy %s\n' "$1"
    eval "\"\$program\" $1" || [ $? -eq 1 ]  # 1: something was found
    printf '```\n'
}

cat <<'END'

## What it has found

**Beside View3D**, a program for the same task: a cube of 1110 facets within a cube, one thread. View3D's tolerance is its
`eps`; *off* is the share of the pairs that are wrong by more. `benchmarks/README.md` of the source has other scenes, some
of which View3D finishes sooner.

END
awk -F '|' 'function row() { print "|" $4 "|" $5 "|" $6 "|" $8 "|" $9 "|" }
            /^\| scene \| facets/ && !head++ { row(); getline; row() }
            /^\| `nested:13:4`/ { row() }' benchmarks/README.md
cat <<'END'

```sh
benchmarks/beside_view3d build/release/app/ffstudy nested:13:4 --view3d path/to/view3d
```

**In the tables of a paper**, the one that ffstudy begins with:
END
session 'audit studies/built_in/paper_tables.json'

cat <<'END'

**In published form factors.** Of [those compared](docs/beside-others.md), these lie outside the interval of ffstudy; independent
calculations agree with it:

| published by | factor | published | ffstudy: interval | published is off by |
|---|---|--:|---|--:|
END
awk -F ' *[|] *' '/^## / { by = substr($0, 4) }
                  /published is off by/ { rows = 1 }
                  !/^[|]/ { rows = 0 }
                  rows && /%/ { printf "| %s | %s, `%s` | %s | %s | %s |\n", by, $3, $2, $4, $5, $7 }' docs/beside-others.md
cat <<'END'

```sh
docs/examples/published/compare.py build/release/app/ffstudy
```
END
mkdir -p "$out/halton"
cp docs/examples/scipy_halton.py "$out/halton"
[ -f "$out/halton/halton.npy" ] || (cd "$out/halton" && /usr/bin/python3 scipy_halton.py)
checks=$("$program" check-sampler "file:$out/halton/halton.npy" | grep -E 'FAIL|mean' || true)
# Means are those of values whose integral is 1. Later versions of SciPy do not have the fault.
error=$(sed -nE 's/^FAIL .*slanting plane.*biased by ([-0-9.e]+).*/\1/p' <<<"$checks")
if [ -n "$error" ]; then
    awk -v error="$error" 'BEGIN {
        print "\n**In scrambled Halton points.** SciPy 1.10 gives every coordinate a copy of one random generator, so their"
        print "scrambling is not independent, and the mean of a step along a slanting plane is"
        printf "%.2g %% too %s. With `scipy_halton.py`,\n", 100 * (error < 0 ? -error : error), error < 0 ? "low" : "high"
    }'
else
    printf '\n**In scrambled Halton points** of SciPy 1.10, whose coordinates were not scrambled independently, `check-sampler` finds\n'
    printf 'that means are biased. Later versions pass. With `scipy_halton.py`,\n'
fi
printf '\n```python\n%s\n```\n' "$(cat docs/examples/scipy_halton.py)"
printf '\nand SciPy %s:\n\n```\n' "$(/usr/bin/python3 -c 'import scipy; print(scipy.__version__)')"
printf '$ python3 scipy_halton.py\n$ ffstudy check-sampler file:halton.npy | grep -E "FAIL|mean"\n%s\n```\n' "$checks"
