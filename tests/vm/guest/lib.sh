# lib.sh -- how the guest talks to the machine outside: lines in out/talk of the folder they share, pictures on demand.
#
# "ok ID words", "bad ID words": one finding (checks.txt says which there are). "shot NAME": a picture,
# please. Anything else is for people.
# shellcheck shell=dash disable=SC2154,SC2034,SC1091  # init sources all of them
talk=$host/out/talk # Who sources this has said where the shared folder is.

say() { # WORDS
    echo "$(now_ms) $*" >>$talk
}

found() { # STATUS ID WORDS: what was to be seen was (STATUS 0), or was not
    if [ "$1" -eq 0 ]; then say "ok $2 ${3-}"; else say "bad $2 ${3-}"; fi
}

shot() { # NAME [dark|light]: $host/shots/NAME.png is what the screen shows now, or once its middle is so
    rm -f "$host/shots/$1.png"
    say "shot $*"
    await 60 test -e "$host/shots/$1.done"
}

await() { # SECONDS COMMAND...: 0 as soon as COMMAND says so, 1 when the time is up
    local end=$(($(now_ms) + $1 * 1000))
    shift
    while ! "$@" >/dev/null 2>&1; do
        [ "$(now_ms)" -lt "$end" ] || return 1
        sleep 0.1
    done
}

now_ms() { # Since the boot; the file says hundredths of a second.
    local up rest
    read -r up rest </proc/uptime
    echo "${up%.*}${up#*.}0"
}

# Whether a process is the user kingyo, in the groups that board/sysusers gives him and in no other.
is_kingyo() { # PID
    local id groups
    id=$(sed -n 's/^kingyo:[^:]*:\([0-9]*:[0-9]*\):.*/\1/p' /etc/passwd)
    groups=$(sed -n "s/^[^:]*:[^:]*:\([0-9]*\):.*\bkingyo\b.*/\1/p" /etc/group)
    groups=$(echo $groups ${id#*:} | tr ' ' '\n' | sort -nu | tr '\n' ' ')
    [ "$(sed -n 's/^Uid:\t//p' "/proc/$1/status" | tr '\t' '\n' | sort -u)" = "${id%:*}" ] &&
        [ "$(sed -n 's/^Groups:\t//p' "/proc/$1/status" | tr ' ' '\n' | sed '/^$/d' |
            sort -nu | tr '\n' ' ')" = "$groups" ]
}

groups_of() { # PID: by name
    for group in $(sed -n 's/^Groups:\t//p' "/proc/$1/status"); do
        sed -n "s/^\([^:]*\):[^:]*:$group:.*/\1/p" /etc/group
    done | tr '\n' ' '
}
