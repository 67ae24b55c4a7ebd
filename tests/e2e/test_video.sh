#!/bin/bash
# test_video.sh -- `kingyo --replay FILE --video FILE`: pictures and sound of the right length, the
# pictures and the WAV file that replace ffmpeg, and one line and code 74 for each failed write.
# Speaks TAP.
# shellcheck disable=SC2154,SC1091  # lib.sh sets these variables
. "$(dirname "$0")/lib.sh"

kingyo=$(realpath "$BUILD/kingyo")
good=$work/good.kgr
mkdir "$work/empty" "$work/stub" "$work/full"
printf '#!/bin/sh\necho "no such codec" >&2\nexit 3\n' >"$work/stub/ffmpeg"
chmod +x "$work/stub/ffmpeg"

search=$PATH # Folders in which the kiosk searches for ffmpeg.
video() { # FILE: Writes the video FILE of the recording.
    timeout 200 env PATH="$search" "$kingyo" --replay "$good" --window 321x241 --video "$1" >"$work/output" 2>"$work/err" </dev/null
}

no_part() { # FOLDER: The folder has no temporary file of a video.
    [ -z "$(find "$1" -maxdepth 1 -name '*.part' 2>/dev/null)" ]
}

# Runs COMMAND and expects exit code 74, one line on standard error that contains TEXT, and no
# unfinished file in FOLDER.
refuses() { # TEXT TITLE FOLDER COMMAND...
    local text=$1 title=$2 folder=$3 got
    shift 3
    "$@"
    got=$?
    echo "exit $got, expected 74" >>"$work/output"
    cat "$work/err" >>"$work/output"
    ls "$folder" >>"$work/output" 2>&1
    [ $got -eq 74 ] && one_line "$work/err" && grep -q -- "$text" "$work/err" && no_part "$folder"
    ok $? "$title: one line and code 74" "$work/output"
}

# Prints the field NAME of the first stream of the kind KIND (v or a).
field() { # FILE KIND NAME
    ffprobe -v error -select_streams "$2" -show_entries "stream=$3" -of csv=p=0 "$1"
}

# Returns 0 if the numbers A and B differ by at most LIMIT.
near() { # A B LIMIT
    awk -v a="$1" -v b="$2" -v limit="$3" 'BEGIN { exit !(a != "" && a - b <= limit && b - a <= limit) }'
}

is_audible() { # FILE: The mean level of the sound is above -50 dB.
    ffmpeg -nostdin -hide_banner -i "$1" -vn -af volumedetect -f null - 2>&1 |
        awk '/mean_volume/ { level = $(NF - 1) } END { print "level " level; exit !(level != "" && level > -50) }' >>"$work/output"
}

"$kingyo" --demo 5 --seed 7 --window 320x240 --shots "$work/shots" --record "$good" >"$work/output" 2>&1 </dev/null
ok $? 'a demonstration makes a recording' "$work/output"
ticks=$("$BUILD/kingyoctl" replay info "$good" | sed -nE 's/^length .* ([0-9]+) ticks$/\1/p')
pictures=$((ticks / 2))
seconds=$(awk -v count="$pictures" 'BEGIN { print count / 60 }')

video "$work/out.mp4" && grep -q ' each as recorded$' "$work/output" && [ ! -s "$work/err" ] && [ "$pictures" -gt 300 ]
ok $? 'a recording becomes a video' "$work/err"
{
    for entry in codec_name width height nb_frames avg_frame_rate duration; do field "$work/out.mp4" v $entry; done
    field "$work/out.mp4" a codec_name
    field "$work/out.mp4" a duration
} >"$work/output"
[ "$(field "$work/out.mp4" v width,height,nb_frames)" = "322,242,$pictures" ] &&
    [ "$(field "$work/out.mp4" v avg_frame_rate)" = 60/1 ] && near "$(field "$work/out.mp4" v duration)" "$seconds" 0.001
ok $? 'the video has one picture for every two ticks, at 60 a second' "$work/output"
near "$(field "$work/out.mp4" a duration)" "$seconds" 0.03 && is_audible "$work/out.mp4"
ok $? 'the sound is as long as the pictures, and not silent' "$work/output"
ffmpeg -nostdin -v error -ss 1 -i "$work/out.mp4" -frames:v 1 "$work/first.png" &&
    ffmpeg -nostdin -v error -ss 8 -i "$work/out.mp4" -frames:v 1 "$work/later.png" &&
    ! cmp -s "$work/first.png" "$work/later.png" && [ "$(identify -format %k "$work/later.png")" -gt 100 ]
ok $? 'the pictures have many colours, and change'
ls "$work" >"$work/output"
no_part "$work"
ok $? 'no temporary file remains' "$work/output"

search=$work/empty video "$work/none.mp4"
code=$?
cp "$work/err" "$work/output"
[ $code -eq 0 ] && one_line "$work/err" && grep -q 'ffmpeg.*written to .*none.mp4.frames$' "$work/err" && [ ! -e "$work/none.mp4" ]
ok $? 'without ffmpeg, one line names the folder' "$work/output"
[ "$(ls "$work"/none.mp4.frames/frame-*.png | wc -l)" -eq "$pictures" ] &&
    [ "$(identify -format %wx%h "$work/none.mp4.frames/frame-000001.png")" = 321x241 ]
ok $? 'the folder has all pictures'
near "$(field "$work/none.mp4.frames/sound.wav" a duration)" "$seconds" 0.001 && is_audible "$work/none.mp4.frames/sound.wav"
ok $? 'the WAV file is as long as the pictures, and not silent' "$work/output"

echo old >"$work/old.mp4"
with_stub() { search=$work/stub:$PATH video "$work/old.mp4"; }
refuses 'no such codec' 'an ffmpeg that fails' "$work" with_stub
[ "$(cat "$work/old.mp4")" = old ]
ok $? 'after a failure the older file is unchanged'
refuses 'nowhere/x.mp4: cannot write' 'a missing folder' /nowhere video /nowhere/x.mp4
if [ "$(id -u)" -eq 0 ] && [ ! -e /sound.wav ]; then
    echo own >/sound.wav
    video /nowhere/x.mp4
    cat /sound.wav >"$work/output" 2>&1
    [ "$(cat /sound.wav 2>/dev/null)" = own ]
    ok $? 'a video that was not begun removes no file' "$work/output"
    rm -f /sound.wav
else
    ok 0 'a video that was not begun removes no file # skip: only the superuser can write a file in /'
fi
refuses '/dev/full: cannot write' 'a device in place of a file' /dev video /dev/full
limited() { (trap '' XFSZ; ulimit -f 300; video "$work/limit.mp4"); }
refuses 'File too large' 'a file above the limit' "$work" limited
mkdir "$work/lost.mp4.frames" && ln -s /dev/full "$work/lost.mp4.frames/frame-000001.png"
without_ffmpeg() { # The first line on standard error names the folder.
    local code
    search=$work/empty video "$work/lost.mp4"
    code=$?
    sed -i '1{/written to/d}' "$work/err"
    return $code
}
refuses 'frame-000001.png: cannot write' 'a picture that cannot be written' "$work/lost.mp4.frames" without_ffmpeg
[ ! -e "$work/lost.mp4.frames/sound.wav" ]
ok $? 'after a failure no WAV file remains'
if unshare -m true 2>/dev/null; then
    export -f video
    export kingyo good work search
    on_small_disk() { unshare -m bash -c "mount -t tmpfs -o size=300k none '$work/full' && video '$work/full/x.mp4'"; }
    refuses 'No space left' 'a full disk' "$work/full" on_small_disk
else
    ok 0 'a full disk # skip: no permission to mount'
fi
timeout 60 "$kingyo" --video "$work/x.mp4" 2>"$work/err" </dev/null
[ $? -eq 2 ] && one_line "$work/err" && grep -q replay "$work/err"
ok $? 'a video without a replay is a wrong option' "$work/err"
done_testing
