/* announcements.h -- schedules the time announcements of a round: at one minute, at two minutes, at
 * ten seconds left, and for each of the last five seconds. */
#ifndef KINGYO_CORE_GAME_ANNOUNCEMENTS_H
#define KINGYO_CORE_GAME_ANNOUNCEMENTS_H

#include <stdint.h>

#include "core/scene.h"

/* Returns the announcement at `elapsed_ticks` into a round of `total_ticks`, or CALL_NONE. Each
 * announcement is returned in exactly one tick. A minute announcement is omitted if the round is
 * too short or has ten seconds or less left. */
enum time_call announcements_call_at(uint32_t elapsed_ticks, uint32_t total_ticks);

#endif
