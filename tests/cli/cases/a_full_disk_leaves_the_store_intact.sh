#!/usr/bin/env bash
# A limit on file sizes simulates a full disk everywhere; where this user may mount one, a small tmpfs is really full.
source "$(dirname "$0")/../harness.sh"

small_study 60 >"$folder/study.toml"
ffstudy run "$folder/study.toml" --threads 1 --out whole
expect_status 0

# goes_on OUT: what is there can be read, and leads to the same results once there is room.
goes_on() {
    if [ -s "$1/results.sqlite" ]; then
        /usr/bin/python3 -c "import sqlite3, sys
[answer] = sqlite3.connect(sys.argv[1]).execute('PRAGMA integrity_check').fetchone()
sys.exit(answer != 'ok')" "$1/results.sqlite" || fail "the store in $1 is damaged"
    fi
    ffstudy run "$folder/study.toml" --out "$1"
    expect_status 0
    expect_same_results whole "$1"
}

# From the first page of the store to the last of the reports; KiB.
largest=$(($(stat -c %s whole/trials.csv) / 1024))
for size in 0 40 $((largest / 2)) $largest; do
    command_line="ulimit -f $size; ffstudy run" status=0
    (
        # The program ignores this signal; a sanitizer writes a file of its own before the program begins.
        [ $size -ne 0 ] || trap '' XFSZ
        ulimit -f $size
        exec "$program" run "$folder/study.toml" --out out$size
    ) >"$folder/stdout" 2>"$folder/stderr" </dev/null || status=$?
    # Nothing can be said where files of no size are allowed and the messages go to files.
    expect_status 3
    [ $size -eq 0 ] || expect_stderr "ffstudy: "
    [ -z "$(find . -name '.ffstudy-part*')" ] || fail "a temporary file is left behind"
    goes_on out$size
done

# on_small_disk SIZE OUT: runs the study on a tmpfs of this size, and leaves in OUT what was there in the end. A run that
# may end before the disk is full, for its time, is not refused beforehand.
on_small_disk() {
    command_line="ffstudy run on a tmpfs of $1" status=0
    mkdir disk "$2"
    "${namespace[@]}" bash -c 'mount -t tmpfs -o size='"$1"' none disk && {
        "$0" run "$1" --max-time 1h --out disk/out; status=$?; cp -r disk/out/. "$2"; exit $status; }' \
        "$program" "$folder/study.toml" "$2" >"$folder/stdout" 2>"$folder/stderr" </dev/null || status=$?
    rmdir disk
}
namespace=(unshare --mount)
[ "$(id -u)" -eq 0 ] || namespace=(unshare --user --map-root-user --mount)
mkdir probe
if "${namespace[@]}" mount -t tmpfs none probe 2>/dev/null; then
    store=$(stat -c %s whole/results.sqlite) reports=$(du -s --block-size=1 --exclude=results.sqlite whole | cut -f1)
    # Full while the store grows; full when the reports are written.
    for size in $((store / 3)) $((store + 65536)) $((store + reports - 4096 * 20)); do
        on_small_disk $size disk$size
        expect_status 3
        # Not what the system has said of something else.
        grep -Eq 'disk is full|No space left on device' "$folder/stderr" || fail "expected the reason"
        goes_on disk$size
    done
    echo "on disks of several sizes"
else
    echo "with limits on file sizes only: this user cannot mount a tmpfs"
fi
