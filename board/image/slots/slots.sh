# slots.sh -- reads and writes the state of the two root slots. The initramfs, the units of the image and the tests
# source this file. It needs dd, tr, head and sha256sum, and runs in dash and in the shell of busybox.
#
# The partition kingyo-slots has two copies of the state, 512 KiB apart. Each copy is one sector of 512 bytes with one
# line of text: "kingyo-slots 1 NUMBER GOOD TRIAL STARTS SHA256". NUMBER rises with each write. GOOD is the slot (a or b)
# whose system has reached the demonstration before. TRIAL is the slot of a new system that has not reached it yet, or -.
# STARTS is the number of starts that remain to TRIAL. SHA256 is the checksum of the words before it.
# A write replaces the older copy. A write that a power cut interrupts therefore leaves the newer copy valid.
# shellcheck shell=dash disable=SC2034  # the scripts that source this file use the variables

slots_sum() { # WORDS: prints the checksum of the words.
    slots_hash=$(printf '%s' "$*" | sha256sum)
    echo "${slots_hash%% *}"
}

slots_is_number() { # WORD: succeeds for a decimal number of at most nine digits without a leading 0.
    case $1 in '' | 0?* | *[!0-9]* | ??????????*) return 1 ;; esac
}

slots_is_valid() { # WORDS of a copy
    [ $# -eq 7 ] && [ "$1 $2" = 'kingyo-slots 1' ] && slots_is_number "$3" && slots_is_number "$6" || return 1
    case $4$5 in ab | ba | a- | b-) ;; *) return 1 ;; esac
    [ "$7" = "$(slots_sum "$1 $2 $3 $4 $5 $6")" ]
}

slots_take() { # PLACE WORDS of the copy at this place
    slots_place=$1
    shift
    if slots_is_valid "$@" && [ "$3" -gt "$number" ]; then
        number=$3 good=$4 trial=$5 starts=$6 slots_next=$((1024 - slots_place))
    fi
}

# Sets number, good, trial and starts to the newest valid state, and slots_next to the position of the other copy.
# Returns 1 if no copy is valid; the state is then that of a new disk.
slots_read() { # FILE
    number=0 good=a trial=- starts=0 slots_next=0
    for slots_at in 0 1024; do
        # shellcheck disable=SC2046  # the words of the line
        slots_take "$slots_at" $(dd if="$1" bs=512 skip="$slots_at" count=1 2>/dev/null | tr -cd 'a-z0-9 \n-' | head -n 1)
    done
    [ "$number" -gt 0 ]
}

# Writes a new state and waits until it is on the disk. Returns 1 if the state cannot be read back from the disk.
slots_write() { # FILE GOOD TRIAL STARTS
    slots_read "$1" || : # A caller may have set -e.
    slots_text="kingyo-slots 1 $((number + 1)) $2 $3 $4"
    slots_want="$((number + 1)) $2 $3 $4"
    printf '%-511s\n' "$slots_text $(slots_sum "$slots_text")" |
        dd of="$1" bs=512 seek="$slots_next" count=1 conv=notrunc,fsync 2>/dev/null || return 1
    slots_read "$1" && [ "$number $good $trial $starts" = "$slots_want" ]
}

# Prints the slots in the order in which the initramfs tries to start them. Counts the start of a system on trial before
# that start. If the count cannot be written, the number of trials would have no limit, so the good system starts.
slots_order() { # FILE
    if ! slots_read "$1"; then
        echo 'a b'
    elif [ "$trial" = - ]; then
        echo "$good $(slots_other "$good")"
    elif [ "$starts" -gt 0 ] && slots_write "$1" "$good" "$trial" $((starts - 1)); then
        echo "$trial $good"
    else
        echo "$good $trial"
    fi
}

slots_other() { # SLOT
    case $1 in a) echo b ;; b) echo a ;; esac
}
