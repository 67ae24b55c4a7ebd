#!/bin/bash
# test_untrusted_text.sh -- arguments, paths, files and names with escape sequences, line breaks
# and bytes that are not UTF-8. No program prints them raw, and each error stays one line. Speaks
# TAP.
# shellcheck disable=SC2154,SC1091  # lib.sh sets these variables
. "$(dirname "$0")/../lib.sh"
# ESC, C1 (U+009B, U+0085), DEL, a bidirectional override, a line separator, a lone byte of Latin 1, a line break, a tab.
evil=$'e\e[31mvil\xc2\x9b2J\xc2\x85\x7f\xe2\x80\xae\xe2\x80\xa8\x9b\rq\nkingyo: forged\tz'
# FILE...: The files are UTF-8 and contain no control character except line breaks and tabs between
# columns.
clean() {
    iconv -f UTF-8 -t UTF-8 "$@" >/dev/null || return 1
    ! LC_ALL=C grep -aP '[\x00-\x08\x0b-\x1f\x7f]|\xc2[\x80-\x9f]|\xe2\x80[\x8e\x8f\xa8-\xae]|\xe2\x81[\xa6-\xa9]|\xd8\x9c' "$@" &&
        ! grep -a '^kingyo: forged' "$@"
}
prints_clean() { # LINES PROGRAM WORDS...: The output is clean, and standard error has LINES lines.
    local lines=$1 program=$2
    shift 2
    "$build/$program" "$@" >"$work/out" 2>"$work/err" </dev/null
    cat -v "$work/out" "$work/err"
    clean "$work/out" "$work/err" && [ "$(wc -l <"$work/err")" -eq "$lines" ]
}
# Errors are printed by print_error() and log_print(). The remaining calls print progress or
# constant text.
one_way() {
    ! grep -rnE 'f(printf|puts|putc)\(.*stderr' --include=*.c platform drivers board |
        grep -vE '^platform/os/(print|log)\.c:|\\r|"\\n" : ""|fputs\(usage, stderr\)|fputc\(.\\n., stderr\)'
}
check 'every error message is printed by print_error() or log_print()' one_way
commands=(tank paper play morph replay hid lines status scores audits backup config doctor)
mkdir "$work/$evil"
here=$work/$evil
check 'kingyoctl: an unknown command is one line' prints_clean 1 kingyoctl "$evil"
check 'kingyo: an unknown option is one line' prints_clean 1 kingyo "--$evil"
check 'kingyo-poi: an unknown command is one line' prints_clean 1 kingyo-poi "$evil"
for command in "${commands[@]}"; do
    check "$command: an unknown word is one line" prints_clean 1 kingyoctl "$command" "$evil"
    check "$command: an unknown option is one line" prints_clean 1 kingyoctl "$command" "--$evil"
done

# ---- Missing files, and files of another kind
printf 'a,b\n%s\n' "$evil" >"$here/file"
for file in "$here/none" "$here/file"; do
    for words in 'tank --place' 'tank --poi-path' 'play --bot' 'replay info' 'replay verify' 'hid describe' 'hid map' \
        'status --file' 'status --json --file' 'morph weights' 'morph check'; do
        # shellcheck disable=SC2086  # several arguments
        check "$words: ${file##*/} is one line" prints_clean 1 kingyoctl $words "$file"
    done
    check "hid decode: ${file##*/} is one line" prints_clean 1 kingyoctl hid decode tests/ctl/keyboard.hid "$file"
    check "backup --restore: ${file##*/} is one line" prints_clean 1 kingyoctl backup --restore "$file" --data "$here"
    check "kingyo --replay: ${file##*/} is one line" prints_clean 1 kingyo --data "$work/own" --replay "$file"
    check "kingyo --poi: ${file##*/} is one line" prints_clean 1 kingyo --data "$work/own" --config "$file" --poi "$file"
    check "kingyo-poi --script: ${file##*/} is one line" prints_clean 1 kingyo-poi watch --script "$file"
done
check 'config check: a missing file is one line' prints_clean 1 kingyoctl config check "$here/none"
printf '%s = 1\nvolume = %s\n[%s]\n' "$evil" "$evil" "$evil" | tr '\n' '\f' | sed 's/\f\([v[]\)/\n\1/g' >"$here/kingyo.conf"
check 'config check: each problem is one line' prints_clean 3 kingyoctl config check "$here/kingyo.conf"
for command in scores audits 'backup x'; do
    # shellcheck disable=SC2086  # several arguments
    check "$command: a folder without a database is one line" prints_clean 1 kingyoctl $command --data "$here"
done

# ---- Names
mkdir "$work/data" && cp tests/unit/platform/store/files/version-6.db "$work/data/kingyo.db"
name_all() { # NAME: Gives NAME to every player and to every row of the ranking.
    printf "update round_players set name = cast(x'%s' as text)" "$(printf '%s' "$1" | basenc --base16)" |
        sqlite3 "$work/data/kingyo.db"
    sqlite3 "$work/data/kingyo.db" "update ranking set name = (select name from round_players limit 1)"
}
name_all $'\e[2J'
check 'scores: a control character in the ranking is reported in one line' prints_clean 1 kingyoctl scores --data "$work/data"
name_all $'\xc2\x9b2J\x9b\xe2\x80\xae'
check 'scores: a control character in a name is masked in the table' prints_clean 0 kingyoctl scores --data "$work/data"
check 'scores --json: a control character in a name is masked' prints_clean 0 kingyoctl scores --json --data "$work/data"
check 'scores --json: the output is valid JSON' test "$(sqlite3 :memory: "select json_valid(cast(readfile('$work/out') as text))")" = 1
# A name with control characters damages a database, and no copy of a damaged database is made.
mkdir "$work/whole" && cp tests/unit/platform/store/files/version-6.db "$work/whole/kingyo.db"
check 'backup: the path of the copy is masked' prints_clean 0 kingyoctl backup "$here/copy.db" --data "$work/whole"
check 'backup --json: the path of the copy is masked' prints_clean 0 kingyoctl backup "$here/copy.db" --json --data "$work/whole"
check 'backup --restore: both paths are masked' prints_clean 0 kingyoctl backup --restore "$here/copy.db" --data "$here"
check 'doctor: the path of the data folder is masked' prints_clean 0 kingyoctl doctor --data "$here/x"
check 'doctor --json: the path of the data folder is masked' prints_clean 0 kingyoctl doctor --json --data "$here/x"

# ---- Names in species files, meshes and landmarks, and lines of GPIO
raw=$'w\e[31m\xc2\x9b2Jn'
wakin=assets/species/wakin.txt
mkdir "$here/names"
printf 'mtllib %s\no %s\ng %s\nusemtl %s\nv 0 0 0\nv 0 1 0\nv 1 0 0\nf 1 2 3\n' "$raw" "$raw" "$raw" "$raw" >"$here/names/mesh.obj"
printf '%s 0 0 0\n' "$raw" >"$here/names/mesh.marks"
is_no_name() { # WORDS...: kingyoctl morph WORDS reports the invalid name.
    prints_clean 1 kingyoctl morph "$@" && grep -q "'w?\[31m?2Jn' is not a name" "$work/err"
}
for line in 'species wakin' 'key larva'; do
    RAW=$raw awk -v line="$line" 'index($0, line) == 1 { $2 = ENVIRON["RAW"] } { print }' $wakin >"$here/names/${line%% *}.txt"
    for command in check weights growth export; do
        check "morph $command: the name of a ${line%% *} is one line" is_no_name $command "$here/names/${line%% *}.txt"
    done
    check "morph graph: the name of a ${line%% *} is one line" is_no_name graph "$here/names/${line%% *}.txt" --svg "$here/graph.svg"
    check "morph import: the name of a ${line%% *} is one line" is_no_name import "$here/out.kfish" "$here/names/${line%% *}.txt"
done
check 'morph import: the paths of a species are masked' prints_clean 0 kingyoctl morph import "$here/out.kfish" $wakin
for command in 'check --steps 2' 'weights --steps 2' 'growth --steps 2'; do
    # shellcheck disable=SC2086  # several arguments
    check "morph $command: a packed species is printed" prints_clean 0 kingyoctl morph $command "$here/out.kfish"
done
check 'morph weights: the name of a curve is one line' prints_clean 1 kingyoctl morph weights "$here/out.kfish" --curve "$raw"
mesh=$here/names/mesh.obj
check 'morph import: the names in a mesh are one line' prints_clean 1 kingyoctl morph import "$here/mesh.kfish" "$mesh" "$mesh" "$mesh"
check 'morph import --names: names are one line' prints_clean 1 kingyoctl morph import "$here/mesh.kfish" "$mesh" "$mesh" "$mesh" --names "$raw,b,c"
check 'morph refit: the names in a mesh are one line' prints_clean 1 kingyoctl morph refit "$here/refit.kfish" wakin "$mesh" "$mesh" "$mesh" "$mesh" "$mesh"
check 'morph export: the path of a mesh is masked' prints_clean 0 kingyoctl morph export wakin --age-days 90 --obj "$here/wakin.obj"
check 'tank --trace: the path of a trace is masked' prints_clean 0 kingyoctl tank --fish 1 --seconds 1 --trace "$here/trace.csv"
check 'paper: a value is one line' prints_clean 1 kingyoctl paper --grade "$raw"
check 'play --bot: a bot is one line' prints_clean 1 kingyoctl play --bot "$raw"
printf 'base=expert\n' >"$here/bot"
check 'play --bot: the path of a bot is masked' prints_clean 0 kingyoctl play --bot "$here/bot" --rounds 1 --round-s 10 --record "$here/rounds"
check 'lines watch: the name of a line is one line' prints_clean 1 kingyoctl lines watch "start=$raw"
check 'audits: the path of a damaged database is one line' prints_clean 1 kingyoctl audits --data "$here/none"

# ---- The status file, which another user may write
now=$(awk '{ printf "%.0f", $1 * 1000 }' /proc/uptime)
raw=$'\xc2\x9b2J\xe2\x80\xae\x7f'
cat >"$work/status.json" <<JSON
{"written_ms": $now, "version": "1\u001b[2J$raw", "phase": "a\nb\u009b", "store": {"well": true},
 "faults": {"\u001b]0;x\u0007$raw": 3}, "devices": [{"part": "p\u202e", "text": "t\u001bc$raw"}]}
JSON
check 'status: control characters of the file are masked' prints_clean 0 kingyoctl status --file "$work/status.json"
check 'status --json: raw control characters are escaped' prints_clean 0 kingyoctl status --json --file "$work/status.json"
same() { # The JSON output has the same `version` as the status file.
    [ "$(sqlite3 :memory: "select json(cast(readfile('$work/out') as text)) ->> '$.version' =
        json(cast(readfile('$work/status.json') as text)) ->> '$.version'")" = 1 ]
}
check 'status --json: the values are unchanged' same

# ---- A valid file of reports
{
    printf 'id\tseq\treport\nkeyboard\t%s\t' $'e\e[31mvil\xc2\x9b2J\xc2\x85\x7f\xe2\x80\xae\x9bq'
    printf '0000040000000000\n'
} >"$work/reports.tsv"
decodes() {
    prints_clean 0 kingyoctl hid decode tests/ctl/keyboard.hid "$work/reports.tsv" && grep -q 'vil' "$work/out"
}
check 'hid decode: the sequence number of a report is masked' decodes

# ---- Names of devices below another root
node=$work/root/sys/class/hidraw/hidraw0/device
mkdir -p "$node" "$work/root/dev" "$work/root/proc"
printf 'HID_ID=0003:0000057E:00002009\nHID_NAME=%s\nDRIVER=%s\n' "${evil%%$'\n'*}" "${evil%%$'\n'*}" >"$node/uevent"
check 'doctor: the name of a device is masked' prints_clean 0 kingyoctl doctor --root "$work/root" --data /data
check 'doctor --json: the name of a device is masked' prints_clean 0 kingyoctl doctor --json --root "$work/root" --data /data

# ---- The summary of the kiosk (test_log.c checks its log)
plays() {
    prints_clean 1 kingyo --demo 5 --window 320x240 --shots "$here/shots" --data "$here/data" --record "$here/play.rec" &&
        grep -q 'pictures  *.*e?' "$work/out" && grep -q 'recorded [0-9.]* s to .*e?' "$work/out"
}
check 'kingyo: the paths of its pictures and its recording are masked' plays
check 'replay info: the text of a recording is masked' prints_clean 0 kingyoctl replay info "$here/play.rec"
check 'replay verify: the path of a recording is masked' prints_clean 0 kingyoctl replay verify "$here/play.rec"
echo "1..$count"
