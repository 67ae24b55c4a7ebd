#!/bin/bash
# bench.sh FOLDER [SCENE...] -- prints what the scenes of scenes.txt cost on V3D, and compares the programs with
# programs.tsv. Exits with 1 if a scene exceeds its milliseconds, or if a program spills or has more instructions than
# the table allows.
# FOLDER is that of build.sh. FOLDER/programs.tsv is the new table. Copy it over tests/v3d/programs.tsv after a change
# of a shader whose cost is accepted. FOLDER/logs keeps the logs, and the passes of each scene as SCENE-pi4.txt.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
folder=$(cd "$1" && pwd)
shift
root=$folder/root
. "$here/inside.sh"
logs=$folder/logs
mkdir -p "$logs" "$root/logs"
mesa=/mesa/build/src
trace=/kingyo/build/v3d/kingyo/tests/v3d/gl_trace.so

# The lines that v3d.py reads, and errors of shot.
kept='QPU:$|tmus|r:unif|^(PROGRAM|DRAW|QUADS|STEP|JOB|SHADER-DB)|shader .*:|target .*:'

# Runs shot in the root and keeps its standard error as a log. Variables before `--` are set for shot.
shot() { # LOG VARIABLE=VALUE... -- OPTION...
    local log=$1 variables=()
    shift
    while [ "$1" != -- ]; do variables+=("$1"); shift; done
    shift
    inside env LD_LIBRARY_PATH=$mesa/egl:$mesa/mapi/es2api:$mesa/mapi/shared-glapi:$mesa/gbm:$mesa/gallium/targets/dri \
        LIBGL_DRIVERS_PATH=$mesa/gallium/targets/dri GBM_BACKENDS_PATH=$mesa/gbm/backends/dri EGL_PLATFORM=surfaceless \
        "${variables[@]}" /kingyo/build/v3d/kingyo/${SHOT:-tests/render/shot} --start --seconds 20 --steps -o /logs/shot.png "$@" \
        2>&1 >"$logs/$log.out" | grep -aE "$kept" >"$logs/$log.log" || { tail -5 "$logs/$log.log" >&2; exit 1; }
}

# Runs shot with the driver v3d, which compiles programs and draws nothing.
v3d() { # LOG VARIABLE... -- OPTION...
    local log=$1
    shift
    shot "$log" LD_PRELOAD=$mesa/broadcom/drm-shim/libv3d_noop_drm_shim.so:$trace MESA_LOADER_DRIVER_OVERRIDE=v3d "$@"
}

status=0
: >"$logs/frames.txt"
v3d pi4 V3D_DEBUG=precompile,shaderdb,fs,vs -- --mode festival --players 1
v3d pi5 V3D_DEBUG=precompile,shaderdb,fs,vs V3D_SHIM_71=1 -- --mode festival --players 1
"$here/v3d.py" programs "$logs/pi4.log" "$logs/pi5.log" >"$folder/programs.tsv"
sed -i "1i # Instructions, threads, spills and texture lookups of each program on V3D (README.md). Written by make bench-v3d." "$folder/programs.tsv"
grep -v "^#" "$folder/programs.tsv" | column -t -s "$(printf "\t")"
"$here/v3d.py" check "$here/programs.tsv" "$folder/programs.tsv" || status=1
while read -r name size fans pois pi4_ms pi5_ms options; do
    [[ $name == \#* || -z $name ]] && continue
    [[ $# -eq 0 || " $* " == *" $name "* ]] || continue
    # shellcheck disable=SC2086
    {
        v3d "$name-jobs" -- --size "$size" $options
        shot "$name-quads" LD_PRELOAD=$trace LIBGL_ALWAYS_SOFTWARE=1 GALLIUM_DRIVER=softpipe GL_TRACE_RENDERER=V3D \
            -- --size "$size" $options
    }
    for gpu in pi4 pi5; do
        limit_ms=$pi4_ms
        [ $gpu = pi4 ] || limit_ms=$pi5_ms
        "$here/v3d.py" frame "$logs/$gpu.log" "$logs/$name-jobs.log" "$logs/$name-quads.log" --gpu $gpu --fans "$fans" \
            --pois "$pois" --limit "${limit_ms/#-/inf}" >"$logs/$name-$gpu.txt" || status=1
        printf '\n%s on %s: passes and jobs\n' "$name" "$gpu"
        cat "$logs/$name-$gpu.txt"
        printf '%-18s %s\n' "$name" "$(tail -1 "$logs/$name-$gpu.txt")" >>"$logs/frames.txt"
    done
done <"$here/scenes.txt"
printf '\nframes\n'
cat "$logs/frames.txt"
[ $status -eq 0 ] || echo "bench-v3d: if higher costs are accepted: cp $folder/programs.tsv tests/v3d/programs.tsv" >&2
exit $status
