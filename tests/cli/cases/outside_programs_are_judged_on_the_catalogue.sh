#!/usr/bin/env bash
# An outside form-factor program is judged on every polygonal scene of the catalogue; one that is 5 % off is found.
# Needs NumPy.
source "$(dirname "$0")/../harness.sh"

cp "$data"/../../docs/examples/shoot* .
# Fewer rays than the example has. The seed is fixed: with the program unchanged there are no false alarms.
sed -i 's|python3|/usr/bin/python3|; s/^samples_per_patch = .*/samples_per_patch = 512/; s/^trials = .*/trials = 32/' \
    shoot_catalogue.toml

# agreements: with how many exact values shoot.py agrees.
agreements() { grep -c '^[a-z0-9_]* *shoot\.py,.* agrees$' "$folder/stdout" || true; }
ffstudy run shoot_catalogue.toml --out right
expect_status 0
[ "$(agreements)" -eq 14 ] || fail "expected shoot.py to agree with 14 exact values"

sed -i '/^scene/,/\]/c scene = "perpendicular_rectangles"' shoot_catalogue.toml
sed -i 's|^trials = .*|trials = 40|; s|^samples_per_patch = .*|samples_per_patch = 16384|' shoot_catalogue.toml
sed -i 's|{np.count_nonzero|{1.05 * np.count_nonzero|' shoot.py
ffstudy run shoot_catalogue.toml --out wrong
expect_status 0
[ "$(agreements)" -eq 0 ] || fail "expected estimates that are 5 % too large to be found"
