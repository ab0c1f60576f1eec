# What the scripts share; sourced, never run.
# shellcheck shell=bash

set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cd "$root"

step=starting
trap 'status=$?; [ $status -eq 0 ] || echo "$(basename "$0"): stopped while $step (exit $status)." >&2' EXIT

# begin "building the program": names what happens now, on the screen and in the message if it fails.
begin() {
    step=$1
    echo "== $step" >&2
}

# jobs_at_once: one compiler a processor, as far as memory allows 1.5 GiB for each.
jobs_at_once() {
    local processors memory
    processors=$(nproc)
    memory=$(awk '/^MemAvailable/ {print int($2 / 1572864)}' /proc/meminfo 2>/dev/null) || memory=$processors
    [ "${memory:-0}" -ge 1 ] || memory=1
    echo $((processors < memory ? processors : memory))
}

# packages_of GROUP...: the packages of these groups in scripts/packages.txt.
packages_of() {
    local group
    for group in "$@"; do
        awk -v group="$group" '$1 == group || (group == "build" && $1 == "gates") {print $2}' scripts/packages.txt
    done
}

# missing_of PACKAGE...: those that are not installed.
missing_of() {
    local package installed
    installed=$(dpkg-query --show --showformat='${db:Status-Status} ${Package}\n' "$@" 2>/dev/null) || true
    for package in "$@"; do
        grep -Fqx "installed $package" <<<"$installed" || echo "$package"
    done
}

# quietly COMMAND...: shows what it prints only if it fails.
quietly() {
    local log status=0
    log=$(mktemp)
    "$@" >"$log" 2>&1 || status=$?
    [ $status -eq 0 ] || cat "$log" >&2
    rm -f "$log"
    return $status
}

# as_root COMMAND...: runs it as root, with sudo where needed.
as_root() {
    if [ "$(id -u)" -eq 0 ]; then "$@"; else sudo "$@"; fi
}

# install_packages GROUP...: installs what is missing of these groups. Calls apt-get only when something is.
install_packages() {
    local wanted missing
    wanted=($(packages_of "$@"))
    if ! command -v apt-get >/dev/null || ! command -v dpkg-query >/dev/null; then
        echo "This set-up installs Debian packages, and this system has no apt-get. Install what these packages" >&2
        echo "contain in your system's way, then configure with CMake as CONTRIBUTING.md shows: ${wanted[*]}" >&2
        return 2
    fi
    missing=($(missing_of "${wanted[@]}"))
    [ ${#missing[@]} -gt 0 ] || return 0
    if [ "$(id -u)" -ne 0 ] && ! command -v sudo >/dev/null; then
        echo "Packages are missing, and installing them needs root or sudo. As root, run:" >&2
        echo "apt-get update && apt-get install --no-install-recommends ${missing[*]}" >&2
        return 1
    fi

    begin "installing ${#missing[@]} packages and what they need (takes minutes when many are missing): ${missing[*]}"
    local get=(env DEBIAN_FRONTEND=noninteractive apt-get --quiet --quiet --yes -o DPkg::Lock::Timeout=120 -o Acquire::Retries=3)
    if finish_installations && listed "${missing[@]}" && install_listed; then return 0; fi
    # The package lists are absent or older than the archive.
    finish_installations && quietly as_root "${get[@]}" update && install_listed || {
        echo "Packages could not be installed: see above. Where the network failed, run this again: it continues" >&2
        echo "where it stopped. Where a package is broken, repair it with these, as root, and run this again:" >&2
        echo "dpkg --configure -a && apt-get --fix-broken install" >&2
        return 1
    }
}

# The next two are parts of install_packages, and use its variables.

# finish_installations: what a killed apt-get left half-installed would fail every later one.
finish_installations() {
    [ -n "$(dpkg --audit)" ] || [ -n "$(ls -A /var/lib/dpkg/updates)" ] || return 0
    echo "   finishing an interrupted installation" >&2
    quietly as_root env DEBIAN_FRONTEND=noninteractive dpkg --configure -a || true
    quietly as_root "${get[@]}" --fix-broken install
}
install_listed() { quietly as_root "${get[@]}" install --no-install-recommends "${missing[@]}"; }

# listed PACKAGE...: whether apt-get knows all of them.
listed() {
    [ "$(apt-cache show --no-all-versions "$@" 2>/dev/null | grep -c '^Package:')" -eq $# ]
}

# needs_version_14 TOOL: ends the script with 77, "skipped" for ctest, where TOOL of clang is not that of Debian 12. Another
# version lays out some lines differently and has other findings, and the source cannot follow two.
needs_version_14() {
    local found
    found=$("$1" --version | sed -nE 's/.*version ([0-9]+).*/\1/p')
    [ "$found" != 14 ] || return 0
    echo "$(basename "$0"): nothing done. The source follows $1 14, of Debian 12, and this is $1 $found. $2" >&2
    trap - EXIT
    exit 77
}
