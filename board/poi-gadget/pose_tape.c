/* pose_tape.c -- removes lines of poses from the start of a text buffer. */
#include "board/poi-gadget/pose_tape.h"

#include <string.h>

char *pose_tape_room(struct pose_tape *tape, uint32_t *room)
{
    *room = POSE_TAPE_SIZE - tape->size;
    return tape->text + tape->size;
}

void pose_tape_wrote(struct pose_tape *tape, uint32_t count)
{
    tape->size += count;
}

/* Moves one line from the buffer to `line`. Returns 1, 0 if the buffer has no complete line, or -1
 * after setting `why` if the line is too long or not text. */
static int cut_line(struct pose_tape *tape, char line[POSE_LINE_SIZE])
{
    const char *end = memchr(tape->text, '\n', tape->size);
    if (!end && !(tape->ended && tape->size > 0) && tape->size < POSE_LINE_SIZE) {
        return 0;
    }
    const uint32_t whole = end ? (uint32_t)(end - tape->text) : tape->size;
    const uint32_t kept = whole < POSE_LINE_SIZE ? whole : POSE_LINE_SIZE - 1;
    memcpy(line, tape->text, kept);
    line[kept] = '\0';
    const uint32_t used = end ? whole + 1 : whole;
    memmove(tape->text, tape->text + used, tape->size - used);
    tape->size -= used;
    tape->line++;
    if (whole >= POSE_LINE_SIZE || strlen(line) != kept) {
        tape->why = "the line is longer than 127 bytes, or no text";
        return -1;
    }
    return 1;
}

/* Parses the next line and sets its pose as the goal of the hand. Returns 1, 0 if no complete line
 * is available, or -1 after setting `why` if the line is invalid. */
static int take_line(struct pose_tape *tape)
{
    char text[POSE_LINE_SIZE];
    struct pose_line line;
    for (;;) {
        int got = cut_line(tape, text);
        if (got == 1) {
            got = pose_line_read(&line, text, &tape->why);
            if (got == 0) {
                continue;
            }
        }
        if (got == 1) {
            pose_glide_send(&tape->glide, &line);
        }
        return got;
    }
}

int pose_tape_step(struct pose_tape *tape, float seconds, struct poi_report *out)
{
    if (pose_glide_is_there(&tape->glide)) {
        const int got = take_line(tape);
        if (got < 0) {
            return -1;
        }
        if (got == 0 && (!tape->glide.begun || tape->ended)) {
            return 0;
        }
    }
    pose_glide_step(&tape->glide, seconds, out);
    return 1;
}
