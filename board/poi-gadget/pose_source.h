/* pose_source.h -- where the board's poses come from: sensors, their twin, or a script. */
#ifndef KINGYO_POI_GADGET_POSE_SOURCE_H
#define KINGYO_POI_GADGET_POSE_SOURCE_H

#include "drivers/poi_report.h"

enum pose_result {
    POSE_NEW = 1,    /* A report; its place is no number where the poi does not know it. */
    POSE_NONE = 0,   /* None yet. */
    POSE_END = -1,   /* None any more. */
    POSE_BAD = -2,   /* What was read is no pose; it was told on standard error. */
};

struct pose_source {
    /* `seconds` after the last call; never waits. The sequence number stays the caller's. */
    enum pose_result (*step)(void *self, float seconds, struct poi_report *out);
    void *self;
};

#endif
