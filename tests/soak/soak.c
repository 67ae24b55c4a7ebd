/* soak.c -- runs full tanks for minutes, with and without a dragged poi, and checks every tick.
 *
 * Usage: soak [SECONDS [SEED]]. The default is 600 s for each tank.
 *
 * Prints a line for each tank. Overlap depths are in mm. The other columns are:
 * - pace: mean speed as a fraction of the gait's speed.
 * - rev/s: reversals of turns per fish and second.
 * - walls: number of fish near walls relative to an even distribution.
 * - stuck: longest time in s for which a swimming fish stayed in one place.
 * - loose: longest time in s for which a fish that was put back into the water overlapped others.
 * - lag: distance of the ring behind the requested pose in mm.
 * - back: reverted poses (contact_solver.h) per fish and second.
 *
 * Returns exit status 1 if an overlap was deeper than 0.5 mm, or if the fish did not move
 * naturally. */
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>

#include "tests/soak/drag.h"

struct density {
    const char *name;
    uint8_t preset;
    uint32_t fish_count;
};

static const struct density densities[] = {
    { "thesis 600", TANK_PRESET_THESIS, 600 },
    { "official 1000", TANK_PRESET_OFFICIAL, 1000 },
    { "thesis 1500", TANK_PRESET_THESIS, 1500 },
};

static struct drag drag;
static struct apart apart;

/* Limits of natural motion: fish must not tremble, block each other or crowd at the walls, however
 * many they are. */
#define PACE_MIN 0.5f
#define REVERSALS_MAX_PER_S 1.0f
/* Highest yaw rate of a startled fish. Calm fish that avoid each other must stay below this
 * rate. */
#define YAW_RATE_MAX_RAD_S (720.0f * F_DEG)
#define CROWDING_MAX 1.5f
#define STUCK_MAX_S 5.0f
#define LOOSE_MAX_S 0.5f

/* Number of times that the contact solver set a fish back to its previous pose. */
static uint64_t reverted_count;
/* 1 if the check of all pairs found an overlap that the check with the grid missed. */
static int cells_missed;

static void run(const struct density *density, int dragged, uint32_t seconds, uint32_t seed)
{
    reverted_count = 0;
    cells_missed = 0;
    apart_init(&apart);
    drag_init(&drag, density->preset, density->fish_count, seed);
    if (dragged) {
        drag_begin(&drag);
    }
    for (uint32_t tick = 0; tick < seconds * CORE_TICK_HZ; tick++) {
        if (dragged) {
            drag_tick(&drag);
        } else {
            drag_calm_tick(&drag);
        }
        reverted_count += drag.core.world.tank.solver.reverted_count;
        apart_check(&apart, &drag.core.world.tank, drag.core.world.poi, dragged ? 1u : 0u,
                    drag.core.world.bowl, 1);
        if (tick % (5u * CORE_TICK_HZ) == 0) {
            cells_missed |= apart_all_pairs_m(&drag.core.world.tank) > apart.pair_m;
        }
    }
}

static bool is_well(void)
{
    const float calm_rad_s = apart.yaw_rate_max_rad_s, turns_s = apart_reversals_per_s(&apart);
    return !cells_missed && apart_deepest_m(&apart) <= APART_DEEP_M &&
           apart_pace(&apart) > PACE_MIN && turns_s < REVERSALS_MAX_PER_S &&
           calm_rad_s < YAW_RATE_MAX_RAD_S &&
           apart_wall_crowding(&apart, &drag.core.world.tank) < CROWDING_MAX &&
           apart.stuck_s < STUCK_MAX_S && apart.loose_s < LOOSE_MAX_S;
}

static float mm(float m)
{
    return 1000.0f * m;
}

static void print(const struct density *density, int dragged)
{
    printf("%-14s %-8s %6u %5u  %5.2f %5.2f %5.2f %5.2f %5.2f %5.2f", density->name,
           dragged ? "dragged" : "calm", apart.pair_count, apart.other_count, mm(apart.pair_m),
           mm(apart.wall_m), mm(apart.floor_m), mm(apart.surface_m), mm(apart.ring_m),
           mm(apart.hull_m));
    const double fish_s = (double)apart.fish_ticks * (double)CORE_TICK_S;
    printf("  %4.2f %6.0f %5.2f %5.2f %5.1f %5.1f %5.1f %6.4f  %s\n", (double)apart_pace(&apart),
           (double)(apart.yaw_rate_max_rad_s / F_DEG), (double)apart_reversals_per_s(&apart),
           (double)apart_wall_crowding(&apart, &drag.core.world.tank), (double)apart.stuck_s,
           (double)apart.loose_s, drag.ticks > 0 ? 1000.0 * drag.lag_sum_m / drag.ticks : 0.0,
           (double)reverted_count / fish_s, is_well() ? "ok" : "NOT OK");
    fflush(stdout);
}

int main(int argc, char **argv)
{
    const uint32_t seconds = argc > 1 ? (uint32_t)strtoul(argv[1], 0, 10) : 600u;
    const uint32_t seed = argc > 2 ? (uint32_t)strtoul(argv[2], 0, 10) : 1u;
    int failed = 0;
    printf("%-14s %-8s %6s %5s  %5s %5s %5s %5s %5s %5s  %4s %6s %5s %5s %5s %5s %5s %6s\n", "tank",
           "", "pairs", "other", "body", "wall", "floor", "surf", "ring", "hull", "pace", "deg/s",
           "rev/s", "walls", "stuck", "loose", "lag", "back");
    for (uint32_t d = 0; d < sizeof densities / sizeof densities[0]; d++) {
        for (int dragged = 0; dragged < 2; dragged++) {
            run(&densities[d], dragged, seconds, seed);
            print(&densities[d], dragged);
            failed |= !is_well();
        }
    }
    return failed;
}
