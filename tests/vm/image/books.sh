# books.sh -- what a stall's store must say after its plug was pulled, held against what the stall had said. Source it
# after plug.sh; bad() is who sources it.
#
# Entries have ids that rise by one. What the stall was told is safe, and what it found at a start, must be on the disk for
# ever after, bit for bit; more may be there, since a recording ends up to a second before the plug is pulled.
# shellcheck shell=bash disable=SC2154,SC2034  # who sources it sets and uses them
sure_to=0       # No entry up to here may ever be missing again.
found_to=0 found_open=0
told_purse=''   # What the newest entry found says of the purse.
columns='id, boot, tick, kind, detail, count, value, units, bonus_units, paid, service, untold, open'
: >"$cache/sure.txt"   # Those entries, a line each.
: >"$cache/told.txt"   # What the last stall that told anything wrote, safe or not.
: >"$cache/fallen.txt" # "BOOT COINS": how many fell into the slot then, at most.

ask() { # SQL
    sqlite3 -separator ' ' "$share/out/kept/kingyo.db" "$1"
}

has_store() {
    [ -s "$share/out/kept/kingyo.db" ] && [ "$(ask "SELECT count(*) FROM sqlite_master WHERE name = 'entries'")" != 0 ]
}

# The audits are sums of the entries, written with them.
sums_agree() {
    [ "$(ask "SELECT coalesce(sum(count), 0) FROM audits WHERE name = 'coins-1'")" = \
        "$(ask 'SELECT coalesce(sum(count), 0) FROM entries WHERE kind = 2')" ]
}

# Coins of a start that nobody let fall.
coins_too_many() {
    ask 'SELECT boot, sum(count) FROM entries WHERE kind = 2 GROUP BY boot' |
        awk 'NR == FNR { fell[$1] = $2 > fell[$1] ? $2 : fell[$1]; next }
            $2 > fell[$1] + 0 { printf "%d coins of start %d, where %d fell", $2, $1, fell[$1] }' "$cache/fallen.txt" -
}

# What this start found on its disk before it opened (guest/kept.sh), against all that was ever sure. 1: it came not so far.
books_found() {
    local count missing whole
    [ -d "$share/out/kept" ] || return 1
    grep -q '^kept' "$share/out/kept/data" || bad "$(cat "$share/out/kept/data")"
    if ! has_store; then # The plug may be pulled before anything was ever kept.
        [ "$sure_to" -eq 0 ] || bad "entry $sure_to was acknowledged; there is no store"
        return 0
    fi
    whole=$(ask 'PRAGMA integrity_check' 2>&1 | head -1)
    [ "$whole" = ok ] || { bad "the store is damaged: $whole"; return 0; }
    ask "SELECT $columns FROM entries ORDER BY id" | sort >"$cache/disk.txt"
    read -r found_to count < <(ask 'SELECT coalesce(max(id), 0), count(*) FROM entries')
    [ "$found_to" -ge "$sure_to" ] || bad "entry $sure_to was acknowledged; the disk has $found_to"
    [ "$count" -eq "$found_to" ] || bad "$count entries up to $found_to"
    missing=$(comm -13 "$cache/disk.txt" "$cache/sure.txt" | head -1)
    [ -z "$missing" ] || bad "it was acknowledged, and the disk has another: $missing"
    # What was written and not acknowledged may be there or not; where it is, it is what was written. Another start
    # in between would have given its number to another.
    missing=$(awk -v to="$found_to" '$1 <= to' "$cache/told.txt" | sort | comm -13 "$cache/disk.txt" - | head -1)
    [ -z "$missing" ] || bad "the disk has another: $missing"
    missing=$(coins_too_many)
    [ -z "$missing" ] || bad "$missing"
    sums_agree || bad 'the audits are not the sums of the entries'
    told_purse=$(ask 'SELECT id, units, bonus_units, paid, service, untold, open FROM entries ORDER BY id DESC LIMIT 1')
    found_open=${told_purse##* }
    sure_to=$found_to
    cp "$cache/disk.txt" "$cache/sure.txt"
}

# What the stall of this start said of itself, by its recording: it began with what the disk had, gave back what was open,
# and from now on what it was told is safe is sure. 1: it had no time to say anything.
books_told() { # FALLEN
    local recording refunds started safe_to
    : >"$cache/told.txt"
    recording=$(find "$share/out" -name 'play-*.kgr' -size +0 | head -1)
    [ -n "$recording" ] && "$BUILD/tests/vm/image/witness" "$recording" >"$cache/witness.txt" || return 1
    started=$(awk '/^start/ { print $2, $4, $5, $6, $7, $8, $9 }' "$cache/witness.txt")
    [ "$started" = "${told_purse:-0 0 0 0 0 0 0}" ] || bad "it began with '$started'; the disk had '$told_purse'"
    awk '/^entry/ { print substr($0, 7) }' "$cache/witness.txt" >"$cache/told.txt"
    refunds=$(awk '$4 == 6 && $5 == 2' "$cache/told.txt" | wc -l)
    [ ! -s "$cache/told.txt" ] || [ "$refunds" -eq $((found_open != 0)) ] ||
        bad "it found a round ($found_open) and gave back $refunds"
    refunded=$refunds
    safe_to=$(awk '/^end/ { print $3 }' "$cache/witness.txt")
    awk -v to="$safe_to" '$1 <= to' "$cache/told.txt" | sort - "$cache/sure.txt" >"$cache/sure.new"
    mv "$cache/sure.new" "$cache/sure.txt"
    told_count=$((safe_to - sure_to)) sure_to=$safe_to
    echo "$(awk '/^start/ { print $3 }' "$cache/witness.txt") $1" >>"$cache/fallen.txt"
}
