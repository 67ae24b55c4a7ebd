/* pose_tape.h -- converts lines of poses to one report in each step. The functions are pure.
 *
 * A line is used when the glide of the previous line has ended, so a whole round can be piped in. A
 * line without a glide lasts one step. */
#ifndef KINGYO_BOARD_POI_GADGET_POSE_TAPE_H
#define KINGYO_BOARD_POI_GADGET_POSE_TAPE_H

#include <stdint.h>

#include "board/poi-gadget/pose_glide.h"

/* Size of the text buffer in bytes. Further text stays in the input until there is room. */
#define POSE_TAPE_SIZE 4096u

struct pose_tape {
    char text[POSE_TAPE_SIZE];
    uint32_t size;
    uint32_t line; /* Number of the last used line, counted from 1. */
    uint8_t ended; /* 1 if no more text will arrive. */
    struct pose_glide glide;
    const char *why; /* Error of line `line`. */
};

/* pose_tape_room() returns the free part of the buffer and sets `room` to its size, at most
 * POSE_TAPE_SIZE bytes. The caller writes text there and passes the number of bytes to
 * pose_tape_wrote(). */
char *pose_tape_room(struct pose_tape *tape, uint32_t *room);
void pose_tape_wrote(struct pose_tape *tape, uint32_t count);

/* Advances the hand by `seconds`. Returns 1 and writes the pose to `out`. Returns 0 at the end of
 * the tape (`ended` is 1) or if no line has arrived yet. Returns -1 and sets `why` after an error.
 * The caller sets the sequence number. */
int pose_tape_step(struct pose_tape *tape, float seconds, struct poi_report *out);

#endif
