/* script_source.h -- poses from standard input, a line each (pose_line.h). */
#ifndef KINGYO_POI_GADGET_SCRIPT_SOURCE_H
#define KINGYO_POI_GADGET_SCRIPT_SOURCE_H

#include "board/poi-gadget/pose_source.h"
#include "board/poi-gadget/pose_tape.h"

struct script_source {
    int fd;
    const char *name; /* For messages. */
    float beat_s;     /* How long a line without a glide lasts. */
    uint32_t step;    /* Since the start. */
    struct pose_tape tape;
};

/* `fd` is read only when it has something; `name` must outlive the source. A board that misses
 * beats skips as many lines, so that a script takes its time; their keys are kept. */
struct pose_source script_source(struct script_source *script, int fd, const char *name,
                                 uint32_t rate_hz);

#endif
