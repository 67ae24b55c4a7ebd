/* pose_tape.h -- converts buffered lines of poses (pose_line.h) to one report in each step. The
 * functions are pure.
 *
 * A line is used when the motion of the previous line has ended. The whole text of a round can
 * therefore be written to the buffer as fast as there is room. A line without a duration lasts one
 * step. */
#ifndef KINGYO_BOARD_POI_GADGET_POSE_TAPE_H
#define KINGYO_BOARD_POI_GADGET_POSE_TAPE_H

#include <stdint.h>

#include "board/poi-gadget/pose_glide.h"

/* Size of the text buffer in bytes. The caller keeps further text until the buffer has room. */
#define POSE_TAPE_SIZE 4096u

struct pose_tape {
    char text[POSE_TAPE_SIZE];
    uint32_t size;
    uint32_t line; /* Number of the line that was used last, counted from 1. */
    uint8_t ended; /* 1 if the caller will append no more text, otherwise 0. */
    struct pose_glide glide;
    const char *why; /* Static text with the error in line number `line`. */
};

/* pose_tape_room() returns the unused part of the buffer and sets `room` to its size in bytes, at
 * most POSE_TAPE_SIZE. The caller writes text there and then calls pose_tape_wrote() with the
 * number of bytes. */
char *pose_tape_room(struct pose_tape *tape, uint32_t *room);
void pose_tape_wrote(struct pose_tape *tape, uint32_t count);

/* Advances the hand by `seconds`. Returns 1 and writes the pose to `out`. Returns 0 at the end of
 * the text (`ended` is 1), or if no line has been appended yet. After an error, sets `why` and
 * returns -1. The caller sets the sequence number of the report. */
int pose_tape_step(struct pose_tape *tape, float seconds, struct poi_report *out);

#endif
