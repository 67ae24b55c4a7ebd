# doctor.sh -- shared functions for the tests of `kingyoctl doctor` on a machine that is simulated by
# files below $root. The command checks the permissions of the user nobody, so that the results are
# the same when root runs the test. Source this file after lib.sh.
# shellcheck shell=bash disable=SC2034,SC2154  # lib.sh sets variables, and the tests use variables.
root=$work/root
doctor() { "$ctl" doctor --root "$root" --user nobody --data /data "$@" >"$work/out" 2>"$work/err"; }
# LEVEL PART WHAT STATE [ADVICE] are extended regular expressions. Exactly one finding matches all
# of them.
finds() {
    doctor --json "${with[@]}"
    sqlite3 :memory: "select * from (select json_extract(value,'\$.level') as level, json_extract(value,'\$.part'),
        json_extract(value,'\$.what'), json_extract(value,'\$.state'), json_extract(value,'\$.todo')
        from json_each(readfile('$work/out'), '\$.findings'))" >"$work/rows"
    cat "$work/rows"
    [ "$(grep -cE "^$1\|$2\|[^|]*$3[^|]*\|[^|]*$4[^|]*\|${5:-}" "$work/rows")" -eq 1 ]
}
with=()
put() { # PATH TEXT: Writes TEXT into the file PATH of the simulated machine.
    mkdir -p "$(dirname "$root/$1")"
    printf '%s\n' "$2" >"$root/$1"
}
