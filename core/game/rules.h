/* rules.h -- the rules of each mode as data: tank, paper, duration, and the end of a round.
 *
 * Code outside the table of rules does not compare modes, but reads the mode's rules.
 * MODE_CHAMPIONSHIP follows the rules of the national championship:
 * - A round has three minutes and one No. 5 poi of 80 mm.
 * - The time is announced at one and two minutes, at ten seconds left, and for the last five
 * seconds.
 * - Three fouls end the round, and a torn poi may be used while it can hold a fish. */
#ifndef KINGYO_CORE_GAME_RULES_H
#define KINGYO_CORE_GAME_RULES_H

#include <stdint.h>

#include "core/scene.h"

#define RULES_STALLS_TANK 0xffu /* Value of `tank` that means the configured tank of the kiosk. */
/* Time to take the poi and find the bowl, in modes without an umpire. */
#define RULES_READY_S 3u

struct rules {
    const char *name; /* Name of the mode on the command line. */
    uint8_t tank;     /* Preset of the tank (enum tank_preset_id), or RULES_STALLS_TANK. */
    uint8_t grade;    /* Grade of the paper; 0 means the configured grade. */
    uint32_t round_s;
    uint32_t ready_s;     /* Length of READY in seconds, in which the player takes the poi before
                             the start. */
    uint8_t renews_paper; /* 1 if useless paper (paper that cannot hold a fish) is replaced after a
                             second, when the poi is out of the water. 0 if the player is out when
                             the paper is useless. */
    uint8_t judges;       /* 1 if fouls are counted and fish caught by a foul do not count. 0 if
                             every fish in the bowl counts, as at a real stall. */
    uint8_t calls;        /* 1 if the time is announced, otherwise 0. */
    uint8_t coaches;      /* 1 if hints explain the next step, 0 if hints only report fouls. */
    uint8_t shows_stress;
    uint8_t keeps_score; /* 1 if the round produces a record and can be ranked, otherwise 0. */
};

/* Returns the rules of `mode`. Asserts that `mode` < MODE_COUNT. */
const struct rules *rules_of(uint8_t mode);

#endif
