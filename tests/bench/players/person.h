/* person.h -- a simulated player (sim_player.h) with an input device (device.h), at one bowl of the
 * tank. */
#ifndef KINGYO_TESTS_BENCH_PLAYERS_PERSON_H
#define KINGYO_TESTS_BENCH_PLAYERS_PERSON_H

#include "tests/bench/players/device.h"
#include "tests/bench/players/sim_player.h"

struct person {
    struct clock_sim clock; /* Clock of the input device, which advances by one frame in
                               person_act(). */
    struct device device;
    struct sim_player player;
    struct sight sight;
    struct player_command command; /* Command to the device for the next frame. */
    uint32_t slot;                 /* Index of the player's poi and bowl, < POI_MAX. */
};

/* Initializes a player with the habits `habits` and the input device that these habits select. The
 * struct keeps the pointer `habits`. The clock of the device starts at `now_ns`. All random numbers
 * of the player depend only on `seed`. */
void person_init(struct person *person, const struct habits *habits, const struct view *view,
                 uint32_t slot, uint32_t seed, uint64_t now_ns);

/* Returns the poi driver that reads the input device, for struct hal. `person` must stay at the
 * same address while the driver is used. */
struct hal_poi person_poi(struct person *person);

/* Advances the clock of the device by one frame and sends the reports of the frame. */
void person_act(struct person *person);

/* Shows the scene of the frame to the player, who chooses the command for the next frame. The
 * expert bot (PLAYER_BOT) does not see the scene. */
void person_see(struct person *person, const struct scene *scene);

#endif
