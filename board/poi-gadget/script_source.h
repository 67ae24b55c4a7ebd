/* script_source.h -- a source of poses that reads standard input, with one pose in each line
 * (pose_line.h). */
#ifndef KINGYO_BOARD_POI_GADGET_SCRIPT_SOURCE_H
#define KINGYO_BOARD_POI_GADGET_SCRIPT_SOURCE_H

#include "board/poi-gadget/pose_source.h"
#include "board/poi-gadget/pose_tape.h"

struct script_source {
    int fd;
    const char *name; /* Name of the input for error messages. */
    float beat_s;     /* Duration in seconds of a line that has no duration of its own. */
    uint32_t step;    /* Number of poses that the source has returned. */
    struct pose_tape tape;
};

/* Returns a source that reads lines from `fd`. The source reads only when data is available, and
 * never blocks. `name` must outlive the source. If the board misses cycles, the source skips the
 * same number of cycles in the script, so that the script keeps its timing. A key that is pressed
 * in a skipped line is reported in the next report. */
struct pose_source script_source(struct script_source *script, int fd, const char *name,
                                 uint32_t rate_hz);

#endif
