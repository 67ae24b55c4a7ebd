/* calls.h -- what the keeper calls out when: one minute, two, ten seconds left, the last five. */
#ifndef KINGYO_CORE_GAME_CALLS_H
#define KINGYO_CORE_GAME_CALLS_H

#include <stdint.h>

#include "core/scene.h"

/* What is called `elapsed_ticks` into a round of `total_ticks`, each once: a round too short for a
 * minute has no call of it, and none comes when ten seconds or less are left. */
enum time_call call_at(uint32_t elapsed_ticks, uint32_t total_ticks);

#endif
