/* pose_script.h -- scripts of poses: text with one pose of the poi (a paper scoop) in each line, a
 * simulated hand that moves smoothly from pose to pose, and the source of poses that reads standard
 * input. `kingyo-poi watch` prints the same lines.
 *
 * A pose line has one of two forms:
 *
 * [+MS] X Y Z PITCH YAW ROLL [KEY...], for example "+400 120 -50 30 -25 0 0 OK"
 *
 * [+MS] lost
 *
 * Positions are in millimetres and angles in degrees, in the axes of drivers/hid/poi_report.h. With
 * +MS, the simulated hand moves smoothly to the pose in MS milliseconds. Without +MS, the simulated
 * hand jumps to the pose. "lost" means that the position is unknown. # starts a comment.
 *
 * A line is used when the motion of the previous line has ended. The whole text of a round can
 * therefore be written to the text buffer as fast as there is room. A line without a duration lasts
 * one step. All functions are pure, except the step of the source. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "board/poi-gadget/run.h"
#include "drivers/hid/poi_report.h"

/* ---- Lines ----------------------------------------------------------------------------------- */

/* Maximum size of a line in bytes, with the terminating zero. Six numbers, a time and five keys
 * need 90 characters. */
#define POSE_LINE_SIZE 128u
/* Maximum duration of a motion in seconds, which is longer than any round of the game. */
#define POSE_LINE_GLIDE_S 600.0f

struct pose_line {
    /* Duration of the motion to the pose in seconds, in [0, POSE_LINE_GLIDE_S]. */
    float glide_s;
    bool lost;       /* True if the position of the poi is unknown. */
    uint8_t buttons; /* Bit mask of the pressed buttons (enum poi_button). */
    /* Pose of the poi. Positions are within +-POI_REPORT_REACH_M, and angles within one full turn
     * in each direction. */
    struct poi_target target;
};

/* Parses a line. Returns 1 for a pose, and 0 for an empty line or a comment. If the line is
 * invalid, sets `why` to a static text and returns -1. */
int pose_line_read(struct pose_line *out, const char *text, const char **why);

/* Writes the pose of the report as a line of text without a newline. */
void pose_line_write(const struct poi_report *report, char text[POSE_LINE_SIZE]);

/* ---- Motion from pose to pose ---------------------------------------------------------------- */

struct pose_glide {
    bool begun; /* True after the first pose has been set. */
    struct pose_line from, to;
    float at_s; /* Time in seconds since the start of the present motion, at most `to.glide_s`. */
};

/* Returns true if the simulated hand has reached its goal, or if no goal has been set. */
bool pose_glide_is_there(const struct pose_glide *glide);

/* Sets the next goal, which starts a new motion. At the start and after a lost pose, the present
 * position is unknown. In this case the hand jumps to the goal. */
void pose_glide_send(struct pose_glide *glide, const struct pose_line *to);

/* Advances the motion by `seconds`, and writes the position, the angles and the buttons to `out`.
 * pose_glide_send() must have been called before. */
void pose_glide_step(struct pose_glide *glide, float seconds, struct poi_report *out);

/* ---- Buffered text --------------------------------------------------------------------------- */

/* Size of the text buffer in bytes. If the buffer is full, the caller must keep further text. */
#define POSE_TAPE_SIZE 4096u

/* Buffer of text, to which the caller appends at `text` + `size`. */
struct pose_tape {
    char text[POSE_TAPE_SIZE];
    uint32_t size; /* Number of bytes in `text`. */
    uint32_t line; /* Number of the line that was used last, counted from 1. */
    bool ended;    /* True if the caller will append no more text. */
    struct pose_glide glide;
    const char *why; /* Error message for line number `line`, as a static text. */
};

/* Advances the hand by `seconds`. Returns 1 and writes the pose to `out`. Returns 0 at the end of
 * the text (`ended` is true), or if no line has been appended yet. After an error, sets `why` and
 * returns -1. The caller sets the sequence number of the report. */
int pose_tape_step(struct pose_tape *tape, float seconds, struct poi_report *out);

/* ---- Source of poses ------------------------------------------------------------------------- */

struct pose_script_source {
    int fd;
    const char *name; /* Name of the input for error messages. */
    float beat_s;     /* Duration in seconds of a line that has no duration of its own. */
    uint32_t step;    /* Number of poses that the source has returned. */
    struct pose_tape tape;
};

/* Returns a source that reads lines from `fd`. The source reads only when data is available, and
 * never blocks. `name` must outlive the source. If the board misses cycles of the main loop, the
 * source skips the same number of cycles in the script, so that the timing of the script stays
 * correct. A key that is pressed in a skipped line is reported in the next report. */
struct pose_source pose_script_source(struct pose_script_source *script, int fd, const char *name,
                                      uint32_t rate_hz);
