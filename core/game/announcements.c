/* announcements.c -- the time announcements of the national championship. */
#include "core/game/announcements.h"

#include "core/input.h"

#define MINUTE_TICKS (60u * CORE_TICK_HZ)
#define TEN_TICKS (10u * CORE_TICK_HZ)
#define LAST_TICKS (5u * CORE_TICK_HZ)

enum time_call announcements_call_at(uint32_t elapsed_ticks, uint32_t total_ticks)
{
    if (elapsed_ticks >= total_ticks) {
        return elapsed_ticks == total_ticks ? CALL_TIME : CALL_NONE;
    }
    const uint32_t left_ticks = total_ticks - elapsed_ticks;
    if (left_ticks <= LAST_TICKS) {
        return left_ticks % CORE_TICK_HZ == 0 ? CALL_COUNTDOWN : CALL_NONE;
    }
    if (left_ticks <= TEN_TICKS) {
        return left_ticks == TEN_TICKS ? CALL_TEN_SECONDS : CALL_NONE;
    }
    switch (elapsed_ticks) {
    case MINUTE_TICKS:
        return CALL_ONE_MINUTE;
    case 2u * MINUTE_TICKS:
        return CALL_TWO_MINUTES;
    default:
        return CALL_NONE;
    }
}
