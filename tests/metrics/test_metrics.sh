#!/bin/bash
# test_metrics.sh -- metrics.py computes the known values of a small tree that this script writes.
# If universal-ctags, cloc or clang-format-19 is missing, every test is skipped. Speaks TAP.
set -u
metrics=$(realpath "$(dirname "$0")/metrics.py")
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT
count=0

for tool in ctags cloc clang-format-19 python3; do
    command -v "$tool" >/dev/null && continue
    echo "ok 1 # SKIP $tool is not installed (board/setup.sh dev installs it)"
    echo '1..1'
    exit 0
done

check() { # STATUS TITLE
    count=$((count + 1))
    if [ "$1" -eq 0 ]; then echo "ok $count - $2"; else
        echo "not ok $count - $2"
        head -22 "$tree/table" | sed 's/^/# /'
    fi
}

# Expects a row of the table: the start of its measure, its value and its result.
row() { # MEASURE VALUE RESULT
    awk -v m="$1" -v v="$2" -v r="$3" 'index($0, m) == 1 && index($0, " " v "  ") && $NF == r { found = 1 }
        END { exit !found }' "$tree/table"
    check $? "$1: $2, $3"
}

measure() {
    python3 "$metrics" --root "$tree" "$@" >"$tree/table" 2>&1
}

mkdir -p "$tree"/{core/game,core/tank,drivers,platform/store,board,assets,tests/metrics,build}
printf 'BasedOnStyle: LLVM\nIndentWidth: 4\n' >"$tree/.clang-format"

# Two modules include each other; the module of core.h is in no cycle.
cat >"$tree/core/core.h" <<'END_C'
/* Declares the whole state of the game. */
struct core {
    int ticks; /* Ticks since the start. */
};
END_C
cat >"$tree/core/tank/fish.h" <<'END_C'
#include "core/tank/wall.h"

/* Whoever knows the fish is told. */
void fish_swim(int *fish);
END_C
cat >"$tree/core/tank/wall.h" <<'END_C'
int wall_touch(void);
END_C
cat >"$tree/core/tank/wall.c" <<'END_C'
#include "core/tank/wall.h"
#include "fish.h"
/* #include "core/core.h" is a comment here. */
static int once(void) { return 1; }
static int twice(int a);
static int twice(int a) { return a ? twice(a - 1) : 2; }
int wall_touch(void) { return once() + twice(1) + twice(2); }
END_C
cat >"$tree/core/game/coins.c" <<'END_C'
#include "core/core.h"
int coins_count(const struct core *core, const struct game *game) {
    CORE_ASSERT(core);
    _Static_assert(1, "CORE_ASSERT(1)");
    return core->ticks;
}
void coins_take(struct core *core, struct game *game) { core->ticks++; }
static void helper(void) {}
void give(int (*f)(void)) { helper(); }
static int entry(void) { return 1; }
int (*const coins_table[])(void) = { entry };
int CAPITALS(void) { return 1; }
END_C
for name in a b c; do # Four files, with coins.c, use the same name for a static function.
    printf 'void drivers_%s(void) {\n    int helper = 1;\n    (void)helper;\n}\n' "$name" >"$tree/drivers/$name.c"
done
cat >"$tree/platform/store/ledger_file.c" <<'END_C'
// Opens the file. It fails
// without a folder; so the caller creates one.
int ledger_open(void) { return 0; }
int store_close(void) { return "// It is no comment"[0]; }
int main(void) { return 0; }
END_C
printf '#include <stdio.h>\nint  x;\n' >"$tree/tests/test_a.c"
printf '# A comment\npoi core/tank/wall.c wall_touch\npoi core/tank/fish.h fish_swim\npoi core/tank/wall.c once\n' \
    >"$tree/tests/metrics/paths.txt"
printf 'coin core/game/coins.c coins_take\n' >>"$tree/tests/metrics/paths.txt"

measure
[ $? -eq 1 ]
check $? 'a missed bound gives exit status 1'
# Sentences: core.h 2, fish.h 1, wall.c 1, ledger_file.c 3.
row 'comment sentences that begin with a bare' '28.6 %' MISS
row 'comment sentences with idiom' '14.3 %' MISS
row 'production code lines' 39 ok
row 'production files' 9 MISS
row 'mean lines of a production file' 5.0 MISS
# Six sources, and two headers that have no source and are included once. wall.h has a source.
row 'small files without a reason' 8 MISS
row 'C files in the largest flat folder' 3 ok
# Fifteen functions in 45 lines: wall.c 3, coins.c 6, drivers 3, ledger_file.c 3. Declarations are not counted.
row 'functions per 1,000 lines' 333.3 MISS
# once() and helper() have one caller; twice() and entry() do not.
row 'static functions with one caller' '50.0 %' MISS
row 'assertions per function, core and drivers' 0.08 MISS
row 'assertions per function, platform' 0.00 MISS
# Three of nine lines; the blank line counts.
row 'comment share of headers' '33.3 %' MISS
row 'modules in the largest include cycle' 2 ok
row 'functions in core/game that take a mutable struct core' 1 ok
row 'functions in core/game that take a mutable struct game' 1 ok
row 'static function names used in more than 3' 1 ok
row "external functions without their module's name" 1 MISS
row 'files from a poi report' 2 ok
row 'files from a coin' 1 ok
row 'lines of paths.txt that no longer hold' 0 ok
row 'differences from .clang-format, tests (1 files)' 1 MISS
grep -q '1 core/game/coins.c  give' "$tree/table"
check $? 'the list of misses names the file and the function'

printf '# A comment\n' >"$tree/tests/metrics/small_files.tsv"
printf '%s\ta contract\n' core/tank/wall.c core/game/coins.c drivers/{a,b,c}.c platform/store/ledger_file.c \
    core/core.h core/tank/fish.h >>"$tree/tests/metrics/small_files.tsv"
measure
row 'small files without a reason' 0 ok
printf 'core/gone.c\ta contract\n' >>"$tree/tests/metrics/small_files.tsv"
sed -i 's/^\(drivers.a.c\).*/\1/' "$tree/tests/metrics/small_files.tsv" # A line without a reason.
seq -f 'int v%g;' 60 >"$tree/drivers/b.c" # A file that is no longer small.
measure
row 'small files without a reason' 3 MISS

printf 'poi core/gone.c wall_touch\ncoin core/game/coins.c gone\ncoin core/game/coins.c\n' \
    >>"$tree/tests/metrics/paths.txt"
printf 'x.o: core/tank/wall.c core/tank/wall.h \\\n core/tank/fish.h core/core.h\n' >"$tree/build/x.d"
measure
row 'lines of paths.txt that no longer hold' 3 MISS
grep -q 'core/tank/wall.c: core/core.h' "$tree/table"
check $? 'an include that only the compiler lists is reported'

measure sample core/tank 5 1
[ "$(grep -c '^\[' "$tree/table")" -eq 2 ] && grep -q '^  | static int once(void)' "$tree/table" &&
    [ "$(grep -c '^  | ' "$tree/table")" -eq 5 ]
check $? 'a sample prints comments with at most four lines of code below each'
measure sample core 1 7 && cp "$tree/table" "$tree/first" && measure sample core 1 7
cmp -s "$tree/first" "$tree/table"
check $? 'the same seed draws the same sample'
measure sample core
[ $? -eq 2 ]
check $? 'a wrong command line gives exit status 2'
echo "1..$count"
