#!/bin/bash
# test_lost_output.sh -- every command of kingyoctl, and the options of kingyo and kingyo-poi that
# print. If standard output is full or closed, each exits with 74 and one line, and writes the same
# files as otherwise. Speaks TAP.
# shellcheck disable=SC2154,SC1091  # lib.sh sets these variables
. "$(dirname "$0")/../lib.sh"
data=$work/data
mkdir "$data" "$work/other" "$work/rounds" "$work/full" "$work/closed" "$work/loud"
cp tests/unit/platform/store/files/version-6.db "$data/kingyo.db"
"$ctl" play --bot novice --rounds 1 --round-s 10 --record "$work/rounds" >/dev/null
"$ctl" backup "$work/copy.db" --data "$data" >/dev/null
"$ctl" config defaults >"$work/kingyo.conf"
keys=tests/ctl/keyboard.hid
pad=tests/hid/good/descriptors/006-blaze-joypad.hid
printf 'id\tnumber\thex\nkeyboard\t1\t0000040000000000\n' >"$work/reports.tsv"
head -c 64 /dev/zero >"$work/raw"
cat >"$work/status.json" <<JSON
{ "version": "0.1.0", "pid": 7, "written_ms": 1000, "up_s": 1, "boot": 1, "phase": "closed", "players": 1,
  "credits": {"paid": 0, "service": 0, "units": 0, "untold": 0, "round_open": false},
  "store": {"well": true, "entry_id": 1, "saved_id": 1, "waiting": 0}, "frames": {"count": 1, "median_ms": 1, "p99_ms": 1},
  "ticks": {"count": 1, "dropped": 0}, "devices": [] }
JSON

# One command on each line. DIR is a separate folder for the files that the command writes.
commands=$(cat <<END
tank --fish 5 --seconds 1 --trace DIR/trace.csv
tank --fish 5 --seconds 1 --json
paper --grade 6 --seconds 1
paper --grade 6 --speed-m-s 0.3 --json
play --bot novice --rounds 1 --round-s 10 --record DIR
play --bot novice --rounds 1 --round-s 10 --json
morph list
morph weights wakin --steps 4
morph growth wakin --steps 4
morph path wakin --part eye --steps 4 --svg DIR/path.svg
morph graph wakin --svg DIR/graph.svg
morph check hirame --steps 2
morph export wakin --age-days 90 --obj DIR/wakin.obj
morph import DIR/wakin.kfish assets/species/wakin.txt
morph refit DIR/refit.kfish wakin nowhere.obj nowhere.obj nowhere.obj nowhere.obj nowhere.obj
replay info $work/rounds/round-00001.kgr
replay verify $work/rounds/round-00001.kgr
hid describe $keys
hid decode $keys $work/reports.tsv
hid map $pad
hid watch
hid watch $work/raw --descriptor $keys
lines list
lines watch start=NOT_A_LINE
lines set start-lamp=NOT_A_LINE on
lines pulse ticket=NOT_A_LINE 1
doctor --data $data
doctor --json --data $data
config check $work/kingyo.conf
config defaults
status --file $work/status.json
status --json --file $work/status.json
scores --data $data
scores verify 6 --data $data
scores replay 6 --with-pin -o DIR/6.kgr --data $data
audits --data $data
backup DIR/copy.db --data $data
backup --restore $work/copy.db --data $work/other
--help
--version
END
)
mapfile -t names < <("$ctl" --help | sed -nE 's/^  ([a-z]+) .*/\1/p')
mapfile -t parts < <("$ctl" morph --help | sed -nE 's/^  ([a-z]+) .*/morph \1/p'
    for name in "${names[@]}"; do "$ctl" "$name" --help | sed -nE 's/^  kingyoctl ([a-z]+ [a-z]+)( .*|$)/\1/p'; done | sort -u)
helps=$(for name in "${names[@]}" "${parts[@]}"; do echo "$name --help"; done)

# A command that prints nothing loses no output. The table may contain only a few such commands.
silent=0
# FULL|CLOSED PROGRAM WORDS...: The program exits with 74 and reports the reason in one line on
# standard error.
reports_output_error() {
    local how=$1 code words
    shift
    words=("${@//DIR/$work/$how}")
    if [ "$how" = full ]; then
        "${words[@]}" >/dev/full 2>"$work/err" </dev/null
    else
        "${words[@]}" >&- 2>"$work/err" </dev/null
    fi
    code=$?
    cat "$work/err"
    if [ $code -eq 0 ] && [ ! -s "$work/err" ]; then
        silent=$((silent + 1))
        words=("${@//DIR/$work/loud}")
        [ -z "$("${words[@]}" 2>&1 </dev/null)" ]
        return
    fi
    # Standard error may also contain the usual message of the command.
    [ $code -eq 74 ] && [ "$(grep -c 'standard output: ' "$work/err")" -le 1 ] && [ "$(wc -l <"$work/err")" -le 2 ]
}
all_report_output_error() { # FULL|CLOSED LIST: Runs each command of LIST and prints the commands that fail.
    local words bad=0
    while IFS= read -r words; do
        # shellcheck disable=SC2086
        reports_output_error "$1" "$ctl" $words || { echo "kingyoctl $words"; bad=1; }
    done <<<"$2"
    return $bad
}
covers() { # The table contains every command and every subcommand that --help lists.
    local name bad=0
    for name in "${names[@]}" "${parts[@]}"; do
        grep -qE "^$name( |\$)" <<<"$commands" || { echo "not in the table: $name"; bad=1; }
    done
    [ ${#names[@]} -ge 13 ] && [ ${#parts[@]} -ge 20 ] && [ $bad -eq 0 ]
}
# The files that the commands write are identical byte for byte, and contain no printed text.
same_files() {
    diff -r "$work/full" "$work/closed" && [ "$(ls "$work/closed" | wc -l)" -ge 7 ] &&
        "$ctl" replay verify "$work/closed/round-00001.kgr" &&
        [ "$(sqlite3 "$work/closed/copy.db" 'pragma integrity_check')" = ok ]
}
few_silent() { echo "$silent"; [ "$silent" -le 10 ]; }
is_reason() { # WORDS FULL|CLOSED PROGRAM...: The one line on standard error gives the reason WORDS.
    local expected=$1
    shift
    reports_output_error "$@" && [ "$(wc -l <"$work/err")" -eq 1 ] && grep -q "standard output: $expected" "$work/err"
}

echo 1..18
check 'the table of this test contains every command and subcommand' covers
check 'every command reports a full standard output' all_report_output_error full "$commands"
check 'every command reports a closed standard output' all_report_output_error closed "$commands"
check 'a closed standard output changes no file that a command writes' same_files
check 'every --help reports a full standard output' all_report_output_error full "$helps"
check 'every --help reports a closed standard output' all_report_output_error closed "$helps"
check 'at most ten commands of the table print nothing' few_silent
check 'a full disk is reported with its cause' is_reason 'No space left' full "$ctl" audits --data "$data"
check 'a full disk is reported with its cause after more than one buffer' is_reason 'No space left' full "$ctl" tank --help
check 'a closed descriptor is reported with its cause' is_reason 'Bad file descriptor' closed "$ctl" audits --data "$data"
check 'a command with an error of its own reports the lost output in one line' is_reason 'No space left' full "$ctl" lines list
for how in full closed; do
    check "hid watch without a device reports a $how standard output in one line" is_reason '' $how "$ctl" hid watch
    check "kingyo --help reports a $how standard output" is_reason '' $how "$build/kingyo" --help
    check "kingyo --version reports a $how standard output" is_reason '' $how "$build/kingyo" --version
done
check 'kingyo-poi --help reports a full standard output' is_reason 'No space' full "$build/kingyo-poi" --help
