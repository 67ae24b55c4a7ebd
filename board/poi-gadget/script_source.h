/* script_source.h -- reads poses from standard input, one pose in each line (pose_line.h). */
#ifndef KINGYO_BOARD_POI_GADGET_SCRIPT_SOURCE_H
#define KINGYO_BOARD_POI_GADGET_SCRIPT_SOURCE_H

#include "board/poi-gadget/pose_source.h"
#include "board/poi-gadget/pose_tape.h"

struct script_source {
    int fd;
    const char *name; /* Name of the input for messages. */
    float beat_s;     /* Duration of a line without a glide, in seconds. */
    uint32_t step;    /* Number of steps since the start. */
    struct pose_tape tape;
};

/* Returns a source that reads from `fd` only when data is available. `name` must outlive the
 * source. If the board misses beats, the source skips as many lines, so that the script keeps its
 * timing. The keys of skipped lines are kept. */
struct pose_source script_source(struct script_source *script, int fd, const char *name,
                                 uint32_t rate_hz);

#endif
