/* person.c -- connects a simulated player with the player's input device. */
#include "tests/bench/players/person.h"

void person_init(struct person *person, const struct habits *habits, const struct view *view,
                 uint32_t slot, uint32_t seed, uint64_t now_ns)
{
    person->clock = (struct clock_sim){ .now_ns = now_ns };
    person->slot = slot;
    device_init(&person->device, habits, &person->clock, view, seed);
    sim_player_init(&person->player, habits, view, seed);
    person->command = person->player.command;
}

struct hal_poi person_poi(struct person *person)
{
    return device_poi(&person->device);
}

void person_act(struct person *person)
{
    device_frame(&person->device, &person->command);
}

void person_see(struct person *person, const struct scene *scene)
{
    if (person->player.habits->device != PLAYER_BOT) {
        sim_player_see(scene, person->slot, &person->sight);
        person->command = sim_player_frame(&person->player, &person->sight);
        person->device.habits = person->player.habits; /* A sign may have changed the habits. */
    }
}
