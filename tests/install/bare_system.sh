# Bare systems of Debian (debootstrap, minbase: no compiler, no locale but C, no configuration of git), for the scripts
# beside this one. Sourced, never run. Needs root, debootstrap, and a mirror that apt-get knows.
# shellcheck shell=bash

systems=$(mktemp -d)
trap 'umount -ql "$systems"/*/{proc,dev} 2>/dev/null || true; rm -rf --one-file-system "$systems"' EXIT

# make_system SUITE [PACKAGE,...]: makes $systems/SUITE, with access to packages as this system has it.
make_system() {
    local system=$systems/$1 certificates=/etc/ssl/certs/ca-certificates.crt mirror
    mirror=$(apt-get indextargets --format '$(REPO_URI)' | grep -m 1 '/debian/$')
    debootstrap --variant=minbase --include="ca-certificates${2:+,$2}" "$1" "$system" "$mirror" >"$systems/log" 2>&1 ||
        { cat "$systems/log" >&2 && return 1; }
    cp /etc/resolv.conf /etc/hosts "$system/etc"
    [ ! -e $certificates ] || cp $certificates "$system$certificates"
    mount -t proc proc "$system/proc"
    mount --rbind --make-rslave /dev "$system/dev"
    rm -f "$system"/var/cache/apt/archives/*.deb
}

# inside SUITE FOLDER COMMAND [VARIABLE=VALUE...]: runs the command in this folder of the system, without a terminal, and
# with nothing of this environment but these variables.
inside() {
    env --ignore-environment PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root CI="${CI:-}" DEBIAN_FRONTEND=noninteractive "${@:4}" \
        chroot "$systems/$1" sh -ec "cd $2 && $3" </dev/null
}

# leave_system SUITE: its folder is then one like others.
leave_system() { umount -l "$systems/$1"/{proc,dev}; }
