#!/bin/bash
# same_code.sh [COMMIT] -- checks that COMMIT (default HEAD) only renames or moves: that its object
# code is the code of its parent, except for symbols, strings and line numbers.
# same_code.sh --objects OLD.o NEW.o -- compares two object files in the same way.
#
# The C files that COMMIT changes, and those that include a header that COMMIT changes, directly or
# through other headers, are compiled in copies of both trees, with __LINE__ as 0 and without debug
# information; the files for 8 lanes are compiled for 4 and for 8. Compared are the instructions,
# the constants and the tables. Names of symbols and the contents of texts are left out. Prints each
# object that differs. Exits 1 if one differs, and 2 if a file does not compile.
#
# Not compared are C files that the build makes from other files (.sql, .txt). A symbol of the same
# object counts as its place there. A symbol of another object counts as its number in the order of
# first use. Therefore two functions of another object that change places are found only if one of
# them was used before.
set -u

# Prints the instructions, the constants and the relocations of an object file without names.
code_of() { # OBJECT
    {
        objdump -tw "$1" | sed 1,4d
        objdump -dr --no-show-raw-insn "$1" | sed -E -e '1,/^Disassembly/d' -e 's/<[^>]*>//g' \
            -e 's/^[0-9a-f]+ :$/function/' -e 's/[[:space:]]+#.*//'
        for section in $(objdump -hw "$1" | awk '$2 ~ /^\.(ro)?data/ && $2 !~ /\.str/ { print $2 }' | sort); do
            echo "$section"
            objdump -s -j "$section" "$1" | sed 1,4d | cut -c1-43
            objdump -rw -j "$section" "$1" | grep ' R_'
        done
    } | awk '
        /^[0-9a-f]+ .*\t[0-9a-f]+ / { # A line of the list of symbols: value, flags, section, tab, size, name.
            split($0, half, "\t")
            section = half[1]
            sub(/.* /, "", section)
            if (section != "*UND*" && section != "*ABS*") place[$NF] = section " " $1
            next
        }
        match($0, /R_[A-Z0-9_]+[ \t]+/) {
            head = substr($0, 1, RSTART + RLENGTH - 1)
            symbol = substr($0, RSTART + RLENGTH)
            addend = match(symbol, /[-+]0x[0-9a-f]+$/) ? substr(symbol, RSTART) : ""
            symbol = substr(symbol, 1, length(symbol) - length(addend))
            if (symbol ~ /^\.L?(rodata\.str|C)/) { print head "text"; next }
            if (!(symbol in place)) place[symbol] = "other symbol " ++others
            print head place[symbol] addend
            next
        }
        { print }'
}

same() { # OLD NEW
    [ -s "$1" ] && [ -s "$2" ] && cmp -s <(code_of "$1") <(code_of "$2")
}

if [ "${1:-}" = --objects ]; then
    same "$2" "$3"
    exit
fi

commit=$(git rev-parse "${1:-HEAD}") || exit 2
work=$(mktemp -d)
trap 'rm -rf "$work"; git worktree prune' EXIT
git worktree add -q --detach "$work/new" "$commit" && git worktree add -q --detach "$work/old" "$commit^" || exit 2

# Each line of the list: the old path and the new path of an object of the programs, without .o.
folders=(core drivers platform board)
git diff --name-status -M30% "$commit^" "$commit" -- "${folders[@]}" |
    awk '$1 ~ /^M/ { print $2, $2 } $1 ~ /^R/ { print $2, $3 } $1 ~ /^[AD]/ { print "no pair:", $2 }' >"$work/changed"
if grep '^no pair' "$work/changed"; then
    echo 'same_code.sh: the commit adds or removes these files, so it is no pure rename' >&2
    exit 1
fi
awk '$2 ~ /\.h$/ { print $2 }' "$work/changed" >"$work/headers"
includers() { # KIND: Prints the files of this kind that include a header of the list.
    sed 's/.*/#include "&"/' "$work/headers" >"$work/includes"
    (cd "$work/new" && grep -rlFf "$work/includes" --include="*.$1" "${folders[@]}")
}
known=-1
until [ "$known" -eq "$(wc -l <"$work/headers")" ]; do
    known=$(wc -l <"$work/headers")
    includers h | sort -u -o "$work/headers" "$work/headers" -
done
# The build compiles one of the files gpio_lines0.c to 2.c, which fits the installed libgpiod.
gpiod=$(pkg-config --modversion libgpiod 2>/dev/null)
gpiod=${gpiod:-0} gpiod=${gpiod%%.*}
lanes=4
[[ $(${CC:-cc} -dumpmachine) = x86_64* ]] && lanes=8
{
    awk '$2 ~ /\.c$/ { print $2 }' "$work/changed"
    includers c
} | sort -u | grep -vE "/gpio_lines[^$gpiod]\.c$" | awk -v lanes=$lanes '
    NR == FNR { from[$2] = $1; next }
    {
        old = $1 in from ? from[$1] : $1
        new = $1
        sub(/\.c$/, "", old)
        sub(/\.c$/, "", new)
        print old, new
        if (lanes == 8 && new ~ /^core\/.*_simd$/) print old "_8", new "_8"
    }' "$work/changed" - >"$work/list"
if [ ! -s "$work/list" ]; then
    echo "$(git log -1 --format='%h %s' "$commit"): no C file changed"
    exit 0
fi

build() { # TREE COLUMN
    # shellcheck disable=SC2046
    make -s -k -C "$work/$1" BUILD=same WARN=-w OPT='-O2 -D__LINE__=0' \
        $(cut -d' ' -f"$2" "$work/list" | sed 's|.*|same/&.o|') >"$work/$1.log" 2>&1 || {
        tail -5 "$work/$1.log" >&2
        return 2
    }
}
build old 1 && build new 2 || exit 2
differ=0
while read -r old new; do
    same "$work/old/same/$old.o" "$work/new/same/$new.o" || { differ=$((differ + 1)) && echo "  differs: $new"; }
done <"$work/list"
echo "$(git log -1 --format='%h %s' "$commit"): $(wc -l <"$work/list") objects compared, $differ differ"
[ $differ -eq 0 ]
