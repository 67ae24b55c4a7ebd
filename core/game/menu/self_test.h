/* self_test.h -- the self-test before the kiosk opens: one page that tests everything a player
 * uses, and shows the state of the machine.
 *
 * Automatic checks finish within twenty seconds. The checks cover a ledger entry that the store
 * confirms, the clock, the frame rate, and files rejected at startup. A check without a result
 * after twenty seconds is bad. The shell adds the state of the machine (struct scene_machine),
 * which never becomes part of the core's state. The operator confirms what only a person can
 * notice: the sound, the lamp and the coin slot. The operator also presses each button, inserts a
 * coin, and moves each poi in all three directions. An untested part is not ready, unless the kiosk
 * does not use the part. A kiosk without input lines does not use the lamp and the coin slot. A
 * kiosk in free play does not use coins. */
#ifndef KINGYO_CORE_GAME_MENU_SELF_TEST_H
#define KINGYO_CORE_GAME_MENU_SELF_TEST_H

#include <stdint.h>

#include "core/input.h"
#include "core/output.h"
#include "core/scene.h"

#define SELF_TEST_TICKS (20u * CORE_TICK_HZ) /* Time after which a check without a result is bad. */
/* Longest time for a write to disk. A store on a slower SD card fails the check. */
#define SELF_TEST_STORE_TICKS (10u * CORE_TICK_HZ)
/* Distance by which a poi must move along an axis to pass the check of that direction. */
#define SELF_TEST_WAY_M 0.03f
/* Report age in ticks that counts as late, which means fewer than 30 reports per second. */
#define SELF_TEST_LATE_TICKS 4u
/* Lowest frame rate, in frames per second, at which the display passes the check. */
#define SELF_TEST_FRAMES_MIN 25u

/* Age of a backup, in minutes, from which the backup is too old. A backup is made at startup and
 * every hour. */
#define SELF_BACKUP_OLD_MIN 180u
/* Free space in MiB below which the check needs attention: twice the size of the database, plus
 * a replay of each ranked round. */
#define SELF_ROOM_LOW_MIB 64u
/* Free space in MiB below which the check is bad. Less space is too little for the entries of
 * one evening and their backup. */
#define SELF_ROOM_BAD_MIB 8u
/* Margin to the throttling temperature, in degrees Celsius, below which the check needs attention.
 * A hot afternoon can raise the temperature by the same amount. */
#define SELF_HEAT_NEAR_C 10

/* Checks of the self-test: first the checks of the machine, then the checks of the parts that a
 * player uses. */
enum self_check {
    SELF_STORE = 0, /* The store confirmed a ledger entry on disk, and no database is in
                       quarantine. */
    SELF_BACKUP,
    SELF_DATA, /* Data written to the data folder survives a power cut. */
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
    uint8_t heard, moved;       /* The operator's answers to the question about the sound
                                   (`heard`) and to the question about the lamp and the coin slot
                                   (`moved`). */
    uint8_t present;            /* Bit mask of the slots with a controller. */
    uint8_t ways[POI_MAX];      /* Directions in which each poi moved, as a bit mask: one bit each
                                   for x, y and z. */
    uint8_t worst_age[POI_MAX]; /* Largest age of a report of each slot, in ticks. */
    vec3 first_m[POI_MAX];      /* Position at which each poi was first seen. */
    uint8_t knows_first;        /* Bit mask of the slots with a valid `first_m`. */
    uint32_t begin_tick;
    uint32_t entry_id; /* Id of the entry written for the test; 0 means that the ledger had no
                          room. */
};

struct game;
struct core_config;

/* Runs the checks while the self-test page of the menu is open. Call once per tick. */
void self_test_tick(struct game *game, const struct input *input, struct output *output);

/* Writes the results of the automatic checks to `out`, for self_test_judge(). */
void self_test_show(const struct game *game, const struct core_config *config,
                    struct scene_self_test *out);

/* Returns 1 in the first half of each second while the question about the lamp and the coin slot is
 * open, otherwise 0. While the function returns 1, the lamp is lit and the coin slot is closed. */
int self_test_shows(const struct game *game);

/* Evaluates the data of the core and of the devices in `scene`. Writes the state of each check
 * (enum self_check) to `state`. Returns the check to display next, or SELF_CHECKS if the kiosk is
 * ready. Checks are displayed in the following order: checks that the operator must perform, bad
 * checks, checks that need attention, checks without a result. */
uint32_t self_test_judge(const struct scene *scene, uint8_t state[SELF_CHECKS]);

/* Returns the number of checks whose state is not SELF_GOOD. */
uint32_t self_test_left(const uint8_t state[SELF_CHECKS]);

uint64_t self_test_hash(uint64_t hash, const struct self_test *self);

#endif
