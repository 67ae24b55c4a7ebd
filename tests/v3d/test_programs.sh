#!/bin/bash
# test_programs.sh -- programs.tsv has the present text of each shader program. A change of a shader, other than of its
# comments, fails this test until `make bench-v3d` has measured its instructions. Speaks TAP.
set -u
here=$(dirname "$0")
build=$(realpath "${BUILD:-build}")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

echo 1..2
# Expects that the programs in $work/table are those of $work/drawn.
same() { # TITLE
    if difference=$(diff "$work/table" "$work/drawn"); then echo "ok $1"; else
        echo "not ok $1"
        sed -n 's/^[<>] \w* */# changed and not measured again: /p' <<<"$difference" | sort -u
        echo '# run make bench-v3d, and then copy build/v3d/programs.tsv to tests/v3d/programs.tsv'
        return 1
    fi
}

LD_PRELOAD=$build/tests/v3d/gl_trace.so "$build/tests/render/shot" --seconds 0 -o "$work/shot.png" 2>"$work/trace" >/dev/null
sed -n 's/^PROGRAM [0-9]* //p' "$work/trace" | sort >"$work/drawn"
awk -F'\t' '!/^#/ && $1 != "hash" { print $1 " " $2 }' "$here/programs.tsv" | sort >"$work/table"
[ "$(wc -l <"$work/drawn")" -gt 20 ]
if [ $? -eq 0 ]; then echo 'ok 1 - the trace names every program'; else
    echo 'not ok 1 - the trace names every program'
    tail -5 "$work/trace" | sed 's/^/# /'
fi
same '2 - the instructions of every program were counted for its present text'
