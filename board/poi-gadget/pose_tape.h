/* pose_tape.h -- a hand made of text: lines of poses in, a report at each step out. Pure.
 *
 * A line is taken when the glide of the one before it has ended, so a whole round can be piped in
 * at once. A line without a glide lasts one step. */
#ifndef KINGYO_POI_GADGET_POSE_TAPE_H
#define KINGYO_POI_GADGET_POSE_TAPE_H

#include <stdint.h>

#include "board/poi-gadget/pose_glide.h"

#define POSE_TAPE_SIZE 4096u /* Bytes of text that wait; more stays where it comes from. */

struct pose_tape {
    char text[POSE_TAPE_SIZE];
    uint32_t size;
    uint32_t line;           /* Number of the last line taken, from 1. */
    uint8_t ended;           /* No more text will come. */
    struct pose_glide glide;
    const char *why;         /* What is wrong with line `line`. */
};

/* Room for more text, at most POSE_TAPE_SIZE bytes: write there, then tell how much. */
char *pose_tape_room(struct pose_tape *tape, uint32_t *room);
void pose_tape_wrote(struct pose_tape *tape, uint32_t count);

/* `seconds` later. 1: `out` is where the hand is; 0: the tape is at its end, or no line has come
 * yet (`ended` says which); -1: `why`. The sequence number stays the caller's. */
int pose_tape_step(struct pose_tape *tape, float seconds, struct poi_report *out);

#endif
