/* rules.h -- the modes of the stall as data: what is played, for how long, and what ends it.
 *
 * No code asks which mode is played; it asks what its rules say. Championship: the rules of the
 * national championship (three minutes, one No. 5 poi of 80 mm, calls at one and two minutes, ten
 * seconds and the last five, three fouls end the round, a torn poi may be used while it can). */
#ifndef KINGYO_CORE_GAME_RULES_H
#define KINGYO_CORE_GAME_RULES_H

#include <stdint.h>

#include "core/scene.h"

#define RULES_STALLS_TANK 0xffu /* The tank that the stall has open anyway. */
#define RULES_READY_S 3u        /* To take the poi and find the bowl, where nobody judges. */

struct rules {
    const char *name;      /* As the command line names it. */
    uint8_t tank;          /* enum tank_preset_id, or RULES_STALLS_TANK */
    uint8_t grade;         /* Of the paper; 0: the stall's own. */
    uint32_t round_s;
    uint32_t ready_s;      /* To take the poi, before the start. */
    uint8_t renews_paper;  /* A poi that can hold no fish any more is changed for a fresh one, a
                              second later and clear of the water; else who holds it is out. */
    uint8_t judges;        /* Fouls are called, and what came by one does not count. Where nobody
                              judges, every fish in the bowl does, as at a stall. */
    uint8_t calls;         /* The keeper calls the time. */
    uint8_t coaches;       /* ... and says what to do next; an umpire says only what is wrong. */
    uint8_t shows_stress;
    uint8_t keeps_score;   /* A record and a best of the day come of it. */
};

/* `mode` < MODE_COUNT, else it asserts. */
const struct rules *rules_of(uint8_t mode);

#endif
