/* self_test.h -- ready for opening? One page that tries everything a guest will touch, and what
 * keeps the stall alive below it.
 *
 * What tries itself is known within twenty seconds: an entry of the ledger that comes back from the
 * disk, the clock, the picture's rate, what was refused at the start, and what the shell knows of
 * the machine (struct scene_machine), which never reaches the core's state. What has not answered
 * by then is bad. What only a person knows is asked: whether the note was heard, whether lamp and
 * slot moved, each button, a coin, each poi in all three directions. Nothing is ready that was not
 * tried, but for what this stall does not have: lamp and slot without lines, coins without a
 * price. */
#ifndef KINGYO_CORE_GAME_SELF_TEST_H
#define KINGYO_CORE_GAME_SELF_TEST_H

#include <stdint.h>

#include "core/input.h"
#include "core/output.h"
#include "core/scene.h"

#define SELF_TEST_TICKS (20u * CORE_TICK_HZ) /* Then there is a verdict. */
#define SELF_TEST_STORE_TICKS (10u * CORE_TICK_HZ) /* A card that takes longer is no card. */
#define SELF_TEST_WAY_M 0.03f      /* A poi has moved in a direction once it went so far. */
#define SELF_TEST_LATE_TICKS 4u    /* Reports this old: fewer than 30 a second. */
#define SELF_TEST_FRAMES_MIN 25u   /* A second; a picture that is slower is none to play by. */

#define SELF_BACKUP_OLD_MIN 180u   /* One is made at the start and each hour. */
#define SELF_ROOM_LOW_MIB 64u      /* The database, twice, with a replay of each ranked round. */
#define SELF_ROOM_BAD_MIB 8u       /* Not even an evening's entries and their backup. */
#define SELF_HEAT_NEAR_C 10        /* A hot afternoon more, and the machine slows itself down. */

/* What the machine is asked, and then what is played with. */
enum self_check {
    SELF_STORE = 0, /* An entry came back from the disk; no database was set aside. */
    SELF_BACKUP,
    SELF_DATA,    /* What is written outlives the power. */
    SELF_ROOM,
    SELF_FILES,   /* Nothing was refused at the start. */
    SELF_CLOCK,
    SELF_HEAT,
    SELF_WATCHDOG,
    SELF_DISPLAY,
    SELF_SOUND,
    SELF_LAMP,
    SELF_BUTTONS,
    SELF_COINS,
    SELF_POIS,
    SELF_CHECKS,
};

enum self_state {
    SELF_WAITS = 0,
    SELF_GOOD,
    SELF_LOOK, /* The stall can open; somebody is to see to it today. */
    SELF_BAD,
    SELF_ASKS,
    SELF_STATES,
};

enum { SELF_UNSAID = 0, SELF_SAYS_YES, SELF_SAYS_NO };

struct self_test {
    uint8_t heard, moved;      /* What the operator said of the note, of lamp and slot. */
    uint8_t present;           /* Seats with a controller, a bit each. */
    uint8_t ways[POI_MAX];     /* Directions that each went: a bit each of x, y, z. */
    uint8_t worst_age[POI_MAX]; /* Of its reports, in ticks. */
    vec3 first_m[POI_MAX];     /* Where each was first seen. */
    uint8_t knows_first;       /* A bit each. */
    uint32_t begin_tick;
    uint32_t entry_id;         /* That was written for it; 0: none could be. */
};

struct core;

/* Tries what is to be tried, while its page of the menu is open; once a tick. */
void self_test_tick(struct core *core, const struct input *input, struct output *output);

/* What there is to know of it, for self_test_judge(). */
void self_test_show(const struct core *core, struct scene_self_test *out);

/* While lamp and slot are asked about: both by turns, half a second each. */
int self_test_shows(const struct core *core);

/* Judges what the scene says of the core and of devices, all of enum self_check. Returns what
 * the operator should hear of next: what he is to try, then what is bad, then what is to be looked
 * at, then what is not known yet; SELF_CHECKS: ready. */
uint32_t self_test_judge(const struct scene *scene, uint8_t state[SELF_CHECKS]);

/* How many of them need somebody: all that are not good. */
uint32_t self_test_left(const uint8_t state[SELF_CHECKS]);

uint64_t self_test_hash(uint64_t hash, const struct self_test *self);

#endif
