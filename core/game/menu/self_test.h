/* self_test.h -- the self-test before opening: one page that tests everything a player uses, and
 * the state of the machine.
 *
 * Automatic checks finish within twenty seconds: a ledger entry that returns from the disk, the
 * clock, the frame rate, and files rejected at startup. The shell adds the state of the machine
 * (struct scene_machine), which never reaches the core's state. A check without a result by then is
 * bad. The operator confirms what only a person can notice: the sound, the lamp and the coin slot.
 * The operator also presses each button, inserts a coin, and moves each poi in all three
 * directions. An untested part is not ready, unless the kiosk does not have it: lamp and slot
 * without input lines, coins in free play. */
#ifndef KINGYO_CORE_GAME_MENU_SELF_TEST_H
#define KINGYO_CORE_GAME_MENU_SELF_TEST_H

#include <stdint.h>

#include "core/input.h"
#include "core/output.h"
#include "core/scene.h"

#define SELF_TEST_TICKS (20u * CORE_TICK_HZ) /* Time after which every check has a result. */
/* Time for a write to disk; a slower card counts as failed. */
#define SELF_TEST_STORE_TICKS (10u * CORE_TICK_HZ)
#define SELF_TEST_WAY_M 0.03f   /* Distance that counts as a motion in one direction. */
#define SELF_TEST_LATE_TICKS 4u /* Report age that is late: fewer than 30 reports per second. */
/* Frames per second below which the display is too slow to play. */
#define SELF_TEST_FRAMES_MIN 25u

#define SELF_BACKUP_OLD_MIN 180u /* Minutes; a backup is made at startup and every hour. */
#define SELF_ROOM_LOW_MIB 64u    /* Twice the database, plus a replay of each ranked round. */
#define SELF_ROOM_BAD_MIB 8u     /* Too little for one evening's entries and their backup. */
/* Degrees Celsius to throttling; a hot afternoon can add as much. */
#define SELF_HEAT_NEAR_C 10

/* Checks of the machine, followed by checks of the game devices. */
enum self_check {
    SELF_STORE = 0, /* A ledger entry returned from the disk, and no database is in quarantine. */
    SELF_BACKUP,
    SELF_DATA, /* Written data survives a power cut. */
    SELF_ROOM,
    SELF_FILES, /* No file was rejected at startup. */
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
    SELF_LOOK, /* The kiosk can open, but the part needs attention today. */
    SELF_BAD,
    SELF_ASKS,
    SELF_STATES,
};

enum { SELF_UNSAID = 0, SELF_SAYS_YES, SELF_SAYS_NO };

struct self_test {
    uint8_t heard, moved;       /* The operator's answers about the sound, and about lamp and
                                   slot. */
    uint8_t present;            /* Bit mask of the slots with a controller. */
    uint8_t ways[POI_MAX];      /* Directions in which each poi moved: one bit each for x, y, z. */
    uint8_t worst_age[POI_MAX]; /* Largest age of a report, in ticks. */
    vec3 first_m[POI_MAX];      /* Position at which each poi was first seen. */
    uint8_t knows_first;        /* Bit mask of the slots with a valid `first_m`. */
    uint32_t begin_tick;
    uint32_t entry_id; /* Id of the entry written for the test; 0: the ledger had no room. */
};

struct game;
struct core_config;

/* Runs the tests while their page of the menu is open. Call once per tick. */
void self_test_tick(struct game *game, const struct input *input, struct output *output);

/* Writes the results for self_test_judge() to `out`. */
void self_test_show(const struct game *game, const struct core_config *config,
                    struct scene_self_test *out);

/* Returns 1 for the first half of each second while the question about lamp and slot is open. Lamp
 * and slot follow this value. */
int self_test_shows(const struct game *game);

/* Evaluates core and device data of the scene, and writes the state of each enum self_check.
 * Returns the check to display next, or SELF_CHECKS if the kiosk is ready. The order is: checks for
 * the operator to perform, bad checks, checks that need attention, checks without a result. */
uint32_t self_test_judge(const struct scene *scene, uint8_t state[SELF_CHECKS]);

/* Returns the number of checks that are not good. */
uint32_t self_test_left(const uint8_t state[SELF_CHECKS]);

uint64_t self_test_hash(uint64_t hash, const struct self_test *self);

#endif
