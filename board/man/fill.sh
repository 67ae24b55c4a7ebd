#!/bin/bash
# fill.sh PAGE.in -- writes a manual page to standard output. The help texts of the programs in $BUILD replace the lines
# @OPTIONS@, @COMMANDS@ and @SETTINGS@, so that page and program always agree. Exits with 74 if a program fails.
set -eu -o pipefail
build=${BUILD:-build}

# Formats text for mdoc(7): one sentence on each line, at most 76 columns, and no word that mdoc would read as a macro.
words='
function escape(text) {
    gsub(/\\/, "\\e", text)
    return text ~ /^[.\x27]/ ? "\\&" text : text
}
function fill(text,    count, word, i, line) {
    count = split(text, word, " ")
    for (i = 1; i <= count; i++) {
        if (line != "" && (length(line) + length(word[i]) > 75 || line ~ /[.!?]$/)) {
            print escape(line)
            line = ""
        }
        line = line == "" ? word[i] : line " " word[i]
    }
    if (line != "") print escape(line)
}'

options() { # Converts the output of kingyo --help: "  --name VALUE   description", in one or more lines.
    "$build/kingyo" --help | awk "$words"'
        function flush() {
            if (name == "") return
            if (value ~ /^\[/) { gsub(/[][]/, "", value); value = "Op Ar " value }
            else if (value != "") value = "Ar " value
            print ".It Fl -" name (value == "" ? "" : " " value)
            fill(toupper(substr(text, 1, 1)) substr(text, 2) ".")
            name = ""
        }
        /^  --/ {
            flush()
            left = substr($0, 3)
            at = index(left, "  ")
            text = at ? substr(left, at) : ""
            left = at ? substr(left, 1, at - 1) : left
            sub(/^ +/, "", text)
            name = left
            sub(/ .*/, "", name)
            name = substr(name, 3)
            value = left ~ / / ? substr(left, index(left, " ") + 1) : ""
            next
        }
        /^    +/ && name != "" { sub(/^ +/, ""); text = text == "" ? $0 : text " " $0; next }
        { flush() }
        END { flush() }'
}

commands() { # Converts the --help output of each command.
    local name text
    "$build/kingyoctl" --help | sed -nE 's/^  ([a-z]+) .*/\1/p' | while read -r name; do
        # One call for each command, because "subcommand --help" works only if there are subcommands.
        text=$("$build/kingyoctl" "$name" --help)
        echo ".Ss kingyoctl $name"
        sed -n '1s/^[^:]*: *//p' <<<"$text" | awk "$words"'{ fill(toupper(substr($0, 1, 1)) substr($0, 2) ".") }'
        printf '.Bd -literal\n'
        tail -n +3 <<<"$text" | awk "$words"'{ print $0 == "" ? "" : escape($0) }'
        printf '.Ed\n'
    done
}

settings() { # Converts the output of kingyoctl config defaults: help, range, and default.
    "$build/kingyoctl" config defaults | awk "$words"'
        /^\[/ { if (open) print ".El"; open = 1; print ".Ss Section " substr($0, 2, length($0) - 2); print ".Bl -tag -width Ds"; next }
        !open { next }
        /^# Expects / { range = substr($0, 3); next }
        /^# / { help = substr($0, 3); next }
        /^#[a-z]/ {
            key = substr($1, 2)
            value = $0
            sub(/^#[^=]*= ?/, "", value)
            print ".It Ic " key
            fill(help)
            fill(range)
            if (value != "") fill("Default: " value ".")
        }
        END { if (open) print ".El" }'
}

while IFS= read -r line; do
    case $line in
    @OPTIONS@) options ;;
    @COMMANDS@) commands ;;
    @SETTINGS@) settings ;;
    *) printf '%s\n' "$line" ;;
    esac || exit 74
done <"$1"
