# judge.sh -- what was seen of a guest, by the lines of a list of checks, and the table of it. Source it after qemu.sh.
# shellcheck shell=bash disable=SC2154,SC2034  # lib.sh sets what it uses
declare -A verdict words
shots=$cache/shots

judge() { # ok|bad|out ID WORDS; out: this run does not try it
    [ "${verdict[$2]-ok}" = ok ] || return 0 # Once bad is bad.
    verdict[$2]=$1 words[$2]=${*:3}
}

passes() { # ID WORDS -- COMMAND...
    local id=$1 said=$2
    shift 3
    if "$@"; then judge ok "$id" "$said"; else judge bad "$id" "$said"; fi
}

# A picture's colours, and the share of its pixels, in thousandths, that are the tank's blue and fish's red.
picture() { # NAME
    convert "$shots/$1.png" -depth 8 rgb:- 2>/dev/null | od -An -v -tu1 -w3 | awk '
        { seen[$1 "," $2 "," $3] = 1 }
        $3 > 110 && $3 > $1 + 40 { blue++ }
        $1 > 140 && $2 < 130 && $3 < 110 && $1 > $2 + 40 { red++ }
        END { for (colour in seen) colours++; print colours + 0, int(1000 * blue / (NR ? NR : 1)), int(1000 * red / (NR ? NR : 1)) }'
}

shows_tank() { # COLOURS BLUE RED
    [ $# -eq 3 ] && [ "$1" -gt 800 ] && [ "$2" -gt 100 ] && [ "$3" -ge 3 ]
}

judge_tank() { # NAME of a picture, ID
    local it
    read -ra it < <(picture "$1") || true
    passes "$2" "${it[0]-0} colours, ${it[1]-0} / 1000 blue, ${it[2]-0} / 1000 red" -- shows_tank "${it[@]}"
}

first() { # PATTERN FILES...: the first line of them that has it; none is no mistake
    grep -hE "$1" "${@:2}" 2>/dev/null | head -1 || true
}

table() { # CHECKS TITLE: the verdict, a line each, and the count of both
    local id text passed=0 failed=0 left_out=0
    printf '\n%s, %d s\n' "$2" "$SECONDS"
    while read -r id text; do
        case ${verdict[$id]-} in
            ok) passed=$((passed + 1)); printf '  pass  %-10s %s: %s\n' "$id" "$text" "${words[$id]}" ;;
            bad) failed=$((failed + 1)); printf '  FAIL  %-10s %s: %s\n' "$id" "$text" "${words[$id]}" ;;
            out) left_out=$((left_out + 1)); printf '   --   %-10s %s: not run\n' "$id" "$text" ;;
            *) failed=$((failed + 1)); printf '  FAIL  %-10s %s: not reached\n' "$id" "$text" ;;
        esac
    done < <(grep -v '^#' "$1")
    printf '%d passed, %d failed%s; pictures in %s\n' "$passed" "$failed" \
        "$([ "$left_out" -eq 0 ] || echo ", $left_out not run")" "${shots#"$top"/}"
    [ "$failed" -eq 0 ]
}
