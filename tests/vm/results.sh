# results.sh -- collects the results of a guest for a list of checks, and prints the table of
# results. Source it after qemu.sh.
# shellcheck shell=bash disable=SC2154,SC2034  # lib.sh sets these variables
declare -A verdict words
shots=$cache/shots

record_result() { # out means that this run does not try the check
    [ "${verdict[$2]-ok}" = ok ] || return 0 # A failed check stays failed.
    verdict[$2]=$1 words[$2]=${*:3}
}

passes() { # ID WORDS -- COMMAND...
    local id=$1 text=$2
    shift 3
    if "$@"; then record_result ok "$id" "$text"; else record_result bad "$id" "$text"; fi
}

# Prints the number of colours of a picture, and the shares of its pixels, in thousandths, that
# have the blue-green of the tank and the red of fish. The banner of the stall is blue without green.
picture() { # NAME
    convert "$shots/$1.png" -depth 8 rgb:- 2>/dev/null | od -An -v -tu1 -w3 | awk '
        { seen[$1 "," $2 "," $3] = 1 }
        $3 > 70 && $3 > $1 + 25 && $2 > $1 + 20 { blue++ }
        $1 > 140 && $2 < 130 && $3 < 110 && $1 > $2 + 40 { red++ }
        END { for (colour in seen) colours++; print colours + 0, int(1000 * blue / (NR ? NR : 1)), int(1000 * red / (NR ? NR : 1)) }'
}

shows_tank() { # COLOURS BLUE RED
    [ $# -eq 3 ] && [ "$1" -gt 800 ] && [ "$2" -gt 100 ] && [ "$3" -ge 3 ]
}

check_tank() { # NAME of a picture, ID
    local it
    read -ra it < <(picture "$1") || true
    passes "$2" "${it[0]-0} colours, ${it[1]-0} / 1000 blue, ${it[2]-0} / 1000 red" -- shows_tank "${it[@]}"
}

# PATTERN FILES...: Prints the first matching line of the files. A missing match is not an error.
first() {
    grep -hE "$1" "${@:2}" 2>/dev/null | head -1 || true
}

table() { # CHECKS TITLE: Prints one line for each check, and the totals.
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
