#!/bin/bash
# same_code.sh [COMMIT] -- checks that COMMIT (default HEAD) only renames or moves: that its object
# code is the code of its parent, except for symbols, strings and line numbers.
# same_code.sh --objects OLD.o NEW.o -- compares two object files in the same way.
#
# The C files that COMMIT changes, and those that include a header that COMMIT changes, are compiled
# in copies of both trees, with __LINE__ as 0 and without debug information. Compared are the
# instructions and the constants. Names of symbols and the contents of texts are left out. Prints
# each object that differs. Exits 1 if one differs, and 2 if a file does not compile.
set -u

# Prints the instructions, the constants and the relocations of an object file without names.
code_of() { # OBJECT
    objdump -dr --no-show-raw-insn -w "$1" | sed -E -e '1,/^Disassembly/d' -e 's/<[^>]*>//g' -e 's/^[0-9a-f]+ :$/function/' -e 's/[[:space:]]+#.*//' \
        -e 's/(R_[A-Z0-9_]+)[[:space:]]+\.L?(rodata\.str|C)[^[:space:]]*/\1 text/' \
        -e 's/(R_[A-Z0-9_]+)[[:space:]]+[.A-Za-z_][A-Za-z0-9_.]*/\1 name/g'
    for section in $(objdump -hw "$1" | awk '$2 ~ /^\.(ro)?data/ && $2 !~ /\.str/ { print $2 }' | sort); do
        echo "$section"
        objdump -s -j "$section" "$1" | sed 1,4d | cut -c1-43
    done
}

same() { # OLD NEW
    cmp -s <(code_of "$1") <(code_of "$2")
}

if [ "${1:-}" = --objects ]; then
    same "$2" "$3"
    exit
fi

commit=$(git rev-parse "${1:-HEAD}") || exit 2
work=$(mktemp -d)
trap 'rm -rf "$work"; git worktree prune' EXIT
git worktree add -q --detach "$work/new" "$commit" && git worktree add -q --detach "$work/old" "$commit^" || exit 2

# Each line of the list: the old path and the new path of a C file of the programs.
folders=(core drivers platform board)
git diff --name-status -M30% "$commit^" "$commit" -- "${folders[@]}" |
    awk '$1 ~ /^M/ { print $2, $2 } $1 ~ /^R/ { print $2, $3 } $1 ~ /^[AD]/ { print "no pair:", $2 }' >"$work/changed"
if grep '^no pair' "$work/changed"; then
    echo 'same_code.sh: the commit adds or removes these files, so it is no pure rename' >&2
    exit 1
fi
awk '{ from[$2] = $1; if ($2 ~ /\.c$/) print } END { for (new in from) if (new ~ /\.h$/) print new > "/dev/stderr" }' \
    "$work/changed" >"$work/list" 2>"$work/headers"
while read -r header; do
    (cd "$work/new" && grep -rlF "#include \"$header\"" --include='*.c' "${folders[@]}")
done <"$work/headers" | sort -u | awk -v changed="$work/changed" 'BEGIN { while ((getline < changed) > 0) from[$2] = $1 }
    { print ($1 in from ? from[$1] : $1), $1 }' >>"$work/list"
sort -u -o "$work/list" "$work/list"

build() { # TREE COLUMN
    # shellcheck disable=SC2046
    make -s -k -C "$work/$1" BUILD=same WARN=-w OPT='-O2 -D__LINE__=0' \
        $(cut -d' ' -f"$2" "$work/list" | sed 's|\(.*\)\.c$|same/\1.o|') >"$work/$1.log" 2>&1 || {
        tail -5 "$work/$1.log" >&2
        return 2
    }
}
build old 1 && build new 2 || exit 2
differ=0
while read -r old new; do
    same "$work/old/same/${old%.c}.o" "$work/new/same/${new%.c}.o" || { differ=$((differ + 1)) && echo "  differs: $new"; }
done <"$work/list"
echo "$(git log -1 --format='%h %s' "$commit"): $(wc -l <"$work/list") objects compared, $differ differ"
[ $differ -eq 0 ]
