/* rules.h -- the rules of each mode as data: tank, paper, duration, and the end of a round.
 *
 * Code outside the table of rules does not compare modes, but reads the mode's rules.
 * MODE_CHAMPIONSHIP follows the rules of the national championship:
 * - A round has three minutes and one No. 5 poi of 80 mm.
 * - The time is announced at one and two minutes, at ten seconds left, and for the last five
 * seconds.
 * - Three fouls end the round, and a torn poi may be used while it can hold a fish. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "core/scene.h"
#include "core/tank/behavior_params.h"

/* Value of the member `tank` of struct rules that stands for the configured tank of the kiosk. */
#define RULES_STALLS_TANK 0xffu
/* Length of READY in seconds in modes without an umpire. In READY the player takes the poi and
 * finds the bowl. */
#define RULES_READY_S 3u
/* Time without input after which the mode selection ends and attract mode begins. */
#define RULES_MODE_SELECT_TICKS (15u * CORE_TICK_HZ)
/* Height that a pose must cross downward to count as a dip. */
#define RULES_DIP_Y_M (-0.010f)

struct rules {
    const char *name; /* Name of the mode on the command line. */
    /* Preset of the tank in this mode (enum tank_preset_id), or RULES_STALLS_TANK. */
    uint8_t tank;
    uint8_t grade; /* Grade of the paper in this mode; 0 means the configured grade. */
    uint32_t round_s;
    /* Length of READY in seconds, in which the player takes the poi before the start. */
    uint32_t ready_s;
    /* True if useless paper (paper that cannot hold a fish) is replaced after a second, when the
     * poi is out of the water. False if the player is out when the paper is useless. */
    bool renews_paper;
    /* True if fouls are counted and fish caught by a foul do not count. False if every fish in the
     * bowl counts, as at a real stall. */
    bool counts_fouls;
    bool announces_time; /* True if the remaining time of the round is announced. */
    /* True if hints explain the player's next step. False if hints only report fouls. */
    bool shows_hints;
    bool shows_stress;
    /* True if each player may choose a level. False if every player plays at LEVEL_MASTER. */
    bool has_levels;
    bool keeps_score; /* True if the round produces a record and can be ranked. */
};

/* Changes that a level (enum level) makes to the rules and the physics. The fields of LEVEL_MASTER
 * change nothing. */
struct level_rules {
    const char *name;    /* Name of the level in kingyo.conf and on the command line. */
    float ring_radius_m; /* Inner radius of the player's ring. */
    /* Number of grades by which the player's paper is stronger than the paper of the mode. */
    uint8_t grade_step;
    /* Time constant that smooths the motion of the player's poi in water; 0 means no smoothing. */
    float stroke_s;
    float stroke_m_s; /* Highest speed of the player's poi in water; 0 means no limit. */
    /* Temper of all fish (how much calmer they are than living fish), if this level is the easiest
     * level in the round. */
    struct temper temper;
};

/* Returns the grade of a player's paper at `level` in a round whose paper has the grade `grade`. */
uint8_t rules_grade_at_level(uint8_t grade, uint8_t level);

/* Returns the changes of `level` to the rules and the physics. Asserts that `level` <
 * LEVEL_COUNT. */
const struct level_rules *rules_of_level(uint8_t level);

/* Returns the rules of `mode`. Asserts that `mode` < MODE_COUNT. */
const struct rules *rules_of(uint8_t mode);
