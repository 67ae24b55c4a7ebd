#!/bin/bash
# mutants.sh FOLDER COUNT SEED FILE... -- counts the small faults in FILE... that the unit tests
# detect.
# The script draws mutations by SEED (mutate.c) until COUNT of them change the object code, and
# links each into the unit tests of a copy of the tree. The nearest tests run first: test_NAME*,
# the tests that include the module's header, those that call a function of the module if at most
# 12 tests do, and those that share its first word. The other tests
# that link the module follow, fastest first, up to BUDGET seconds (15), and then the golden
# hashes. The first failing test ends a mutant. A test may take three times its own processor time
# plus 3 s. A test that fails without a mutation, or takes more than SLOW seconds (30), is omitted.
# KEEP=1 reuses the copy of the last run.
# FOLDER/results.tsv has one row for each mutant. FOLDER/survivors.txt has the diffs of the mutants
# that no test detected.
set -eu
folder=$1 count=$2 seed=$3
shift 3
budget_s=${BUDGET:-15} slow_s=${SLOW:-30} jobs=${JOBS:-$(nproc)}
mkdir -p "$folder"
folder=$(cd "$folder" && pwd)
tree=$folder/tree times=$folder/times
export folder tree times budget_s slow_s

copy_tree() {
    mkdir -p "$tree"
    rm -rf "$tree"/{core,drivers,platform,tests/unit} # Otherwise deleted files would remain.
    git ls-files -z --cached --others --exclude-standard |
        xargs -0 sh -c 'for f; do [ ! -f "$f" ] || printf "%s\0" "$f"; done' sh |
        tar --null -T - -cf - | tar -C "$tree" -xf -
}

# ---- The commands of make, and the tests without a mutation ----

# Saves the exact link command of each test and the exact compile command of each source.
note_commands() { # FILE...
    local file line name
    rm -rf "$folder/link" "$folder/compile"
    mkdir -p "$folder/link" "$folder/compile"
    # shellcheck disable=SC2086
    make --no-print-directory -n V=1 -W build/tests/unit/support/panic.o $unit | grep -- ' -o build/tests/unit/.*test_' |
        while read -r line; do
            name=${line#* -o build/tests/unit/}
            name=${name%% *}
            echo "$line" >"$folder/link/${name##*/}"
        done
    for file in "$@"; do printf -- '-W %s build/%s ' "$file" "${file%.c}.o"; done |
        xargs make --no-print-directory -n V=1 | grep -- ' -c -o build/' |
        while read -r line; do
            file=${line##* }
            echo "${line% -c -o *}" >"$folder/compile/${file//\//,}"
        done
}

# Runs PROGRAM for at most LIMIT seconds of processor time, so that a busy machine changes no
# result, and prints the time it took in seconds. Returns the exit status of PROGRAM.
timed() { # LIMIT PROGRAM
    local status=0 seconds TIMEFORMAT='%U %S'
    seconds=$({
        time sh -c 'ulimit -t "$1" && exec timeout --kill-after=2 "$2" "$3"' - "$1" $((20 * $1)) "$2" \
            >/dev/null 2>&1 </dev/null
        status=$?
    } 2>&1
    exit "$status") || status=$?
    awk '{ print $1 + $2 }' <<<"$seconds"
    return "$status"
}

# Prints the path of a test below tests/unit, without its suffix. Each name exists once
# (tests/run.sh counts by name).
place_of() { # TEST
    grep -m 1 -- "/$1\$" "$folder/places"
}

# Times one unmutated test and lists its global symbols.
base_one() { # TEST
    local program seconds
    program=$tree/build/tests/unit/$(place_of "$1")
    [ ! "$times/$1" -nt "$program" ] || [ ! -s "$folder/calls/$1" ] || return 0
    rm -f "$times/$1"
    nm -g --defined-only "$program" | awk '{ print $3 }' | sort >"$folder/symbols/$1"
    nm -u "$program.o" | awk '{ print $2 }' | sort >"$folder/calls/$1"
    if seconds=$(timed "$slow_s" "$program"); then
        echo "$seconds" >"$times/$1"
    else
        echo "  left out: $1 (it fails or takes more than $slow_s s)"
    fi
}

# ---- Mutants ----

# Every version of a file is compiled under one name, so that __FILE__ does not differ.
compile() { # FILE TEXT OBJECT
    local place
    place=$(dirname "$3")/text/$1
    mkdir -p "$(dirname "$place")"
    cp "$2" "$place"
    (cd "$tree" && eval "$(cat "$folder/compile/${1//\//,}") -g0 -w -fmacro-prefix-map='${place%"$1"}'= \
            -c -o '$3' '$place'") 2>/dev/null
}

base_object() { # FILE: Compiles FILE without a mutation into base/FILE/base.o.
    mkdir -p "$folder/base/${1//\//,}"
    compile "$1" "$tree/$1" "$folder/base/${1//\//,}/base.o"
}

# Creates candidate/ID/mutant.o if the mutation changes the object code.
mutate_one() { # ID FILE SITE
    local own=$folder/candidate/$1
    mkdir -p "$own"
    echo "$2" >"$own/file"
    "$folder/mutate" apply "$tree/$2" "$3" >"$own/text.c" 2>"$own/place"
    if ! compile "$2" "$own/text.c" "$own/mutant.o"; then
        echo broken >"$own/state"
    elif cmp -s "$folder/base/${2//\//,}/base.o" "$own/mutant.o"; then
        echo same >"$own/state"
    else
        diff -U0 "$tree/$2" "$own/text.c" | tail -n +3 >"$own/diff"
        echo tested >"$own/state"
    fi
}

# Compiles one and a half times COUNT mutations, and keeps the first COUNT that differ.
make_mutants() { # FILE...
    local id kept=0 broken=0 same=0 state
    rm -rf "$folder/mutant" "$folder/candidate" "$folder/base"
    mkdir -p "$folder/mutant"
    (cd "$tree" && "$folder/mutate" draw $((count * 3 / 2 + 10)) "$seed" "$@") >"$folder/drawn"
    cut -d ' ' -f 1 "$folder/drawn" | sort -u | xargs -P "$jobs" -I{} bash -c 'base_object {}'
    awk '{ print NR - 1, $0 }' "$folder/drawn" | xargs -P "$jobs" -L 1 bash -c 'mutate_one "$@"' mutate
    for ((id = 0; kept < count; id++)); do
        [ -s "$folder/candidate/$id/state" ] || break
        state=$(cat "$folder/candidate/$id/state")
        case $state in
        broken) broken=$((broken + 1)) ;;
        same) same=$((same + 1)) ;;
        tested)
            mv "$folder/candidate/$id" "$folder/mutant/$kept"
            kept=$((kept + 1))
            ;;
        esac
    done
    count=$kept
    echo "  $id drawn: $broken do not compile, $same have the same object code, $kept are tested"
}

# Prints the tests that link the mutant, nearest first, as "near NAME" or "wide NAME".
tests_for() { # FILE OBJECT
    local stem name callers
    stem=$(basename "$1" .c)
    nm -g --defined-only "$2" | awk '{ print $3 }' | sort >"$2.symbols"
    callers=$(grep -lxFf "$2.symbols" "$folder"/calls/* | wc -l)
    for name in "$times"/*; do
        name=${name##*/}
        if [ -n "$(comm -23 "$2.symbols" "$folder/symbols/$name")" ]; then
            continue
        elif [[ $name == test_$stem* ]]; then
            echo "1 near $name $(cat "$times/$name")"
        elif grep -qs "\"${1%.c}.h\"" "$tree/tests/unit/$(place_of "$name").c"; then
            echo "2 near $name $(cat "$times/$name")"
        elif [ "$callers" -le 12 ] && grep -qxFf "$2.symbols" "$folder/calls/$name"; then
            echo "3 near $name $(cat "$times/$name")"
        elif [[ $name == test_${stem%%_*}* ]]; then
            echo "4 near $name $(cat "$times/$name")"
        else
            echo "5 wide $name $(cat "$times/$name")"
        fi
    done | sort -k1,1 -k4,4n | cut -d ' ' -f 2,3
}

links() { # TEST MUTANT_FOLDER OBJECT_PATH: Links TEST with the mutant in place of the object.
    local command output
    command=$(cat "$folder/link/$1")
    output=build/tests/unit/$(place_of "$1")
    case "$command " in
    *" $3 "*) command=${command/ $3 / $2\/mutant.o } ;;
    *) command=${command/ -o $output / -o $output $2/mutant.o } ;;
    esac
    command=${command/ -o $output / -Wl,-S -o $2/test }
    (cd "$tree" && eval "$command") 2>/dev/null
}

golden_differs() { # MUTANT_FOLDER: Succeeds if the mutant changes a golden hash.
    (cd "$tree" && gcc -o "$1/test" build/variants/gcc-O2/tests/replay/state_hash.o "$1/mutant.o" \
        build/core.a -lm) 2>/dev/null || return 1
    ! (cd "$tree" && timeout 200 "$1/test" 2>/dev/null) | cmp -s - tests/replay/golden.txt
}

run_mutant() { # ID: Runs the tests on a mutant until one fails or the budget is spent.
    local mutant=$folder/mutant/$1 file line kind near name seconds spent=0 run=0 verdict=survived by=-
    file=$(cat "$mutant/file")
    read -r line kind <"$mutant/place"
    ulimit -f 1000000 # The unit is KiB. A mutant may write without end.
    export TMPDIR=$mutant
    cd "$tree"
    while read -r near name; do
        seconds=$(cat "$times/$name")
        if [ "$near" = wide ] && awk "BEGIN { exit !($spent + $seconds > $budget_s) }"; then
            break
        fi
        links "$name" "$mutant" "build/${file%.c}.o" || continue
        run=$((run + 1))
        if ! timed "$(awk "BEGIN { print int(3 * $seconds + 3) }")" "$mutant/test" >/dev/null; then
            verdict=killed by=$name
            break
        fi
        [ "$near" = near ] || spent=$(awk "BEGIN { print $spent + $seconds }")
    done < <(tests_for "$file" "$mutant/mutant.o")
    if [ $verdict = survived ] && [[ $file = core/* ]] && golden_differs "$mutant"; then
        verdict=killed near=wide by=golden
    fi
    [ $verdict = killed ] || near=-
    rm -f "$mutant/test" "$mutant/mutant.o"
    printf '%s\t%s:%s\t%s\t%s\t%s\t%s\t%s\n' "$1" "$file" "$line" "$kind" $verdict "$near" "$by" "$run" \
        >"$mutant/result"
    printf '  %-9s %s:%s %s%s\n' $verdict "$file" "$line" "$kind" "$([ "$by" = - ] || echo ", by $by")"
}
export -f timed place_of base_one compile base_object mutate_one tests_for links golden_differs run_mutant

report() {
    local mutant
    printf 'id\tplace\tkind\tverdict\tdistance\tby\ttests\n' >"$folder/results.tsv"
    cat "$folder"/mutant/*/result | sort -n >>"$folder/results.tsv"
    for mutant in "$folder"/mutant/*; do
        if grep -qs '	survived	' "$mutant/result"; then
            cut -f 2,3,7 "$mutant/result"
            cat "$mutant/diff"
            echo
        fi
    done >"$folder/survivors.txt"
    awk -F'\t' -v seed="$seed" -v out="$folder" '
        NR > 1 { n++; killed += $4 == "killed"; wide += $5 == "wide" }
        END { printf "  seed %s: %d mutants, %d killed (%d of them by tests of other modules only), %d survived: ", \
              seed, n, killed, wide, n - killed; print out "/survivors.txt" }' "$folder/results.tsv"
}

gcc -std=c17 -O1 -D_GNU_SOURCE -o "$folder/mutate" tests/mutants/mutate.c
[ "${KEEP:-0}" = 1 ] && [ -s "$folder/build.log" ] || copy_tree
cd "$tree"
echo "  seed $seed; building the tests of the copy"
(cd tests/unit && find . -name 'test_*.c' | sed 's/^\.\///; s/\.c$//' | sort) >"$folder/places"
tests=$(sed 's/.*\///' "$folder/places")
unit=$(sed 's/^/build\/tests\/unit\//' "$folder/places" | tr '\n' ' ')
# shellcheck disable=SC2086
make --no-print-directory -j"$jobs" build build/variants/gcc-O2/state_hash $unit >"$folder/build.log" 2>&1 ||
    { tail -20 "$folder/build.log"; exit 1; }
mkdir -p "$times" "$folder/symbols" "$folder/calls"
note_commands "$@"
for old in "$times"/*; do [ -s "$folder/link/${old##*/}" ] || rm -f "$old"; done
echo "$tests" | nice xargs -P "$jobs" -I{} bash -c 'base_one {}'
make_mutants "$@"
seq 0 $((count - 1)) | nice xargs -P "$jobs" -I{} bash -c 'run_mutant {}'
report
