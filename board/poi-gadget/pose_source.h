/* pose_source.h -- the interface of all sources of poses: the real sensors, the simulated sensors,
 * and scripts. */
#ifndef KINGYO_BOARD_POI_GADGET_POSE_SOURCE_H
#define KINGYO_BOARD_POI_GADGET_POSE_SOURCE_H

#include "drivers/hid/poi_report.h"

enum pose_result {
    POSE_NEW = 1,  /* A report is available. The position in the report is NaN if the position is
                      unknown. */
    POSE_NONE = 0, /* No report is available yet. */
    POSE_END = -1, /* The source has ended. */
    /* The input contains an invalid pose. An error line was printed to standard error. */
    POSE_BAD = -2,
};

struct pose_source {
    /* Computes the next report. `seconds` is the time since the previous call. Never blocks. The
     * caller sets the sequence number of the report. */
    enum pose_result (*step)(void *self, float seconds, struct poi_report *out);
    void *self;
};

#endif
