# lib.sh -- messages from the guest to the host: lines in out/talk of the shared folder, and
# requests for pictures.
# "ok ID words" and "bad ID words" are results of the checks in checks.txt. "shot NAME" requests a
# picture. Other lines are only printed.
# shellcheck shell=dash disable=SC2154,SC2034,SC1091  # init sources all files of this folder
talk=$host/out/talk # The script that sources this file has set the path of the shared folder.

say() { # WORDS
    echo "$(now_ms) $*" >>$talk
}

found() { # STATUS ID WORDS: Reports a check that passed (STATUS 0) or failed.
    if [ "$1" -eq 0 ]; then say "ok $2 ${3-}"; else say "bad $2 ${3-}"; fi
}

# Requests a picture of the screen as $host/shots/NAME.png, if necessary after waiting for that
# brightness.
shot() {
    rm -f "$host/shots/$1.png"
    say "shot $*"
    await 60 test -e "$host/shots/$1.done"
}

# Returns 0 as soon as COMMAND succeeds, or 1 after SECONDS. A long wait tries rarely, because a program that is started ten
# times a second would take one of the two emulated processors from the kiosk.
await() { # SECONDS COMMAND...
    local end=$(($(now_ms) + $1 * 1000)) pause=0.1
    [ "$1" -lt 200 ] || pause=2
    shift
    while ! "$@" >/dev/null 2>&1; do
        [ "$(now_ms)" -lt "$end" ] || return 1
        sleep $pause
    done
}

now_ms() { # Milliseconds since the boot. The file has a resolution of 10 ms.
    local up rest
    read -r up rest </proc/uptime
    echo "${up%.*}${up#*.}0"
}

# Returns 0 if the process belongs to the user kingyo with exactly the groups of board/sysusers.
is_kingyo() { # PID
    local id groups
    id=$(sed -n 's/^kingyo:[^:]*:\([0-9]*:[0-9]*\):.*/\1/p' /etc/passwd)
    groups=$(sed -n "s/^[^:]*:[^:]*:\([0-9]*\):.*\bkingyo\b.*/\1/p" /etc/group)
    groups=$(echo $groups ${id#*:} | tr ' ' '\n' | sort -nu | tr '\n' ' ')
    [ "$(sed -n 's/^Uid:\t//p' "/proc/$1/status" | tr '\t' '\n' | sort -u)" = "${id%:*}" ] &&
        [ "$(sed -n 's/^Groups:\t//p' "/proc/$1/status" | tr ' ' '\n' | sed '/^$/d' |
            sort -nu | tr '\n' ' ')" = "$groups" ]
}

groups_of() { # PID: Prints the names of the groups.
    for group in $(sed -n 's/^Groups:\t//p' "/proc/$1/status"); do
        sed -n "s/^\([^:]*\):[^:]*:$group:.*/\1/p" /etc/group
    done | tr '\n' ' '
}
