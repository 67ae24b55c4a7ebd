# check_ledger.sh -- compares the database after a power cut with the entries that the kiosk reported
# before. Source it after plug.sh. The script that sources this file defines bad().
# Entries have ids that rise by one. Each entry that was acknowledged to the kiosk, or that was
# found at a start, must stay on the disk unchanged. The disk may have more entries, because a
# recording ends up to a second before the power cut.
# shellcheck shell=bash disable=SC2154,SC2034  # the sourcing scripts set and use these variables
payment_paid=2 payment_kind_mask=3 payment_spent=4 # enum round_payment (core/ledger.h)
open_mask=255   # Bits of the column `open` with the payment of the open round (ledger_file.h).
sure_to=0       # No entry with an id up to this value may be missing.
found_to=0 found_open=0
last_entry=''   # The balance according to the newest entry that was found.
columns='id, boot, tick, kind, detail, count, value, units, bonus_units, paid, service, untold, open'
: >"$cache/sure.txt"   # The entries up to sure_to, one on each line.
: >"$cache/reported.txt"   # The entries that the last reporting start wrote, acknowledged or not.
: >"$cache/fallen.txt" # "BOOT COINS": the maximum number of coins that were inserted in that start.

ask() { # SQL
    sqlite3 -separator ' ' "$share/out/kept/kingyo.db" "$1"
}

has_store() {
    [ -s "$share/out/kept/kingyo.db" ] && [ "$(ask "SELECT count(*) FROM sqlite_master WHERE name = 'entries'")" != 0 ]
}

# The audits are sums of the entries. Both are written in one transaction.
sums_agree() {
    [ "$(ask "SELECT coalesce(sum(count), 0) FROM audits WHERE name = 'coins-1'")" = \
        "$(ask 'SELECT coalesce(sum(count), 0) FROM entries WHERE kind = 2')" ]
}

# Prints an error if a start has more coins than were inserted.
coins_too_many() {
    ask 'SELECT boot, sum(count) FROM entries WHERE kind = 2 GROUP BY boot' |
        awk 'NR == FNR { fell[$1] = $2 > fell[$1] ? $2 : fell[$1]; next }
            $2 > fell[$1] + 0 { printf "%d coins of start %d, but only %d were inserted", $2, $1, fell[$1] }' "$cache/fallen.txt" -
}

# Compares the entries that this start found on its disk (guest/kept.sh) with all acknowledged
# entries. Returns 1 if the start did not get that far.
check_disk_ledger() {
    local count missing whole
    [ -d "$share/out/kept" ] || return 1
    grep -q '^kept' "$share/out/kept/data" || bad "$(cat "$share/out/kept/data")"
    if ! has_store; then # The power may be cut before the first entry is saved.
        [ "$sure_to" -eq 0 ] || bad "entry $sure_to was acknowledged, but there is no database"
        return 0
    fi
    whole=$(ask 'PRAGMA integrity_check' 2>&1 | head -1)
    [ "$whole" = ok ] || { bad "the database is damaged: $whole"; return 0; }
    ask "SELECT $columns FROM entries ORDER BY id" | sort >"$cache/disk.txt"
    read -r found_to count < <(ask 'SELECT coalesce(max(id), 0), count(*) FROM entries')
    [ "$found_to" -ge "$sure_to" ] || bad "entry $sure_to was acknowledged, but the disk ends at $found_to"
    [ "$count" -eq "$found_to" ] || bad "the disk has $count entries, but the last id is $found_to"
    missing=$(comm -13 "$cache/disk.txt" "$cache/sure.txt" | head -1)
    [ -z "$missing" ] || bad "an acknowledged entry differs on the disk: $missing"
    # An entry that was written but not acknowledged may be missing. If the entry is on the disk,
    # it must be unchanged, because no other start has used its number.
    missing=$(awk -v to="$found_to" '$1 <= to' "$cache/reported.txt" | sort | comm -13 "$cache/disk.txt" - | head -1)
    [ -z "$missing" ] || bad "a written entry differs on the disk: $missing"
    missing=$(coins_too_many)
    [ -z "$missing" ] || bad "$missing"
    sums_agree || bad 'the audits are not the sums of the entries'
    last_entry=$(ask 'SELECT id, units, bonus_units, paid, service, untold, open FROM entries ORDER BY id DESC LIMIT 1')
    found_open=$((${last_entry##* } & open_mask)) # The other bits are a returned credit, and tickets.
    sure_to=$found_to
    cp "$cache/disk.txt" "$cache/sure.txt"
}

# Prints the number of credits that a start must return for the open round that it found: 1 for a paid or SERVICE credit
# without the flag that the credit is not refundable, which a round gets whose credit was returned before.
refunds_due() { echo $(((found_open & payment_kind_mask) >= payment_paid && !(found_open & payment_spent))); }

# Compares the recording of this start with the database: the start has the balance of the disk and
# returns the credit of an open round, if it is refundable. The entries that this start acknowledged become sure.
# Returns 1 if there is no complete recording.
check_reported_ledger() { # FALLEN
    local recording refunds started safe_to
    : >"$cache/reported.txt"
    recording=$(find "$share/out" -name 'play-*.kgr' -size +0 | head -1)
    [ -n "$recording" ] && "$BUILD/tests/vm/image/witness" "$recording" >"$cache/witness.txt" || return 1
    started=$(awk '/^start/ { print $2, $4, $5, $6, $7, $8, $9 }' "$cache/witness.txt")
    [ "$started" = "${last_entry:-0 0 0 0 0 0 0}" ] || bad "the start began with '$started', but the disk had '$last_entry'"
    awk '/^entry/ { print substr($0, 7) }' "$cache/witness.txt" >"$cache/reported.txt"
    refunds=$(awk '$4 == 6 && $5 == 2 { sum += $6 } END { print sum + 0 }' "$cache/reported.txt")
    [ ! -s "$cache/reported.txt" ] || [ "$refunds" -eq "$(refunds_due)" ] ||
        bad "the start found an open round ($found_open) and returned $refunds credits"
    refunded=$refunds
    safe_to=$(awk '/^end/ { print $3 }' "$cache/witness.txt")
    awk -v to="$safe_to" '$1 <= to' "$cache/reported.txt" | sort - "$cache/sure.txt" >"$cache/sure.new"
    mv "$cache/sure.new" "$cache/sure.txt"
    reported_count=$((safe_to - sure_to)) sure_to=$safe_to
    echo "$(awk '/^start/ { print $3 }' "$cache/witness.txt") $1" >>"$cache/fallen.txt"
}
