/* pace.c -- time into ticks. */
#include "platform/kiosk/pace.h"

#include "core/input.h"

#define NS_PER_S 1000000000ull
#define FRAME_TICKS 2u
#define FRAME_NS (NS_PER_S * FRAME_TICKS / CORE_TICK_HZ)
#define SNAP_NS 1500000ull /* 55 .. 66 Hz count as 60. */

uint32_t pace_ticks_due(struct pace *pace, uint64_t now_ns)
{
    if (!pace->started) {
        pace->started = 1;
        pace->last_ns = now_ns;
        return FRAME_TICKS;
    }
    const uint64_t elapsed_ns = now_ns > pace->last_ns ? now_ns - pace->last_ns : 0;
    pace->last_ns = now_ns;
    if (elapsed_ns > FRAME_NS - SNAP_NS && elapsed_ns < FRAME_NS + SNAP_NS) {
        return FRAME_TICKS;
    }
    /* A century owes less than 2^64 of these units, but a wild clock might owe more. */
    const uint64_t hour_ns = 3600u * NS_PER_S;
    pace->owed += (elapsed_ns < hour_ns ? elapsed_ns : hour_ns) * CORE_TICK_HZ;
    uint64_t ticks = pace->owed / NS_PER_S;
    pace->owed %= NS_PER_S;
    if (ticks > PACE_TICKS_MAX) {
        pace->dropped += ticks - PACE_TICKS_MAX;
        ticks = PACE_TICKS_MAX;
    }
    return (uint32_t)ticks;
}
