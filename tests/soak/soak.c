/* soak.c -- minutes of full tanks, calm and with a poi dragged through, looked at in every tick.
 *
 *     soak [SECONDS [SEED]]        600 s of each unless told
 *
 * Fails (1) when anything was deeper than 0.5 mm in anything else, or fish did not move as fish. */
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

static void run(const struct density *density, int dragged, uint32_t seconds, uint32_t seed)
{
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
        apart_look(&apart, &drag.core.tank, drag.core.poi, dragged ? 1u : 0u, drag.core.bowl, 1);
    }
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
    printf("  %4.2f %6.0f %5.2f %5.2f %5.1f %5.1f %5.1f\n", apart_pace(&apart),
           apart.yaw_rate_max_rad_s / F_DEG, apart_reversals_per_s(&apart),
           apart_wall_crowding(&apart, &drag.core.tank), apart.stuck_s, apart.loose_s,
           drag.ticks > 0 ? 1000.0 * drag.lag_sum_m / drag.ticks : 0.0);
    fflush(stdout);
}

int main(int argc, char **argv)
{
    const uint32_t seconds = argc > 1 ? (uint32_t)strtoul(argv[1], 0, 10) : 600u;
    const uint32_t seed = argc > 2 ? (uint32_t)strtoul(argv[2], 0, 10) : 1u;
    int failed = 0;
    printf("%-14s %-8s %6s %5s  %5s %5s %5s %5s %5s %5s  %4s %6s %5s %5s %5s %5s %5s\n", "tank", "",
           "pairs", "other", "body", "wall", "floor", "surf", "ring", "hull", "pace", "deg/s",
           "rev/s", "walls", "stuck", "loose", "lag");
    for (uint32_t d = 0; d < sizeof densities / sizeof densities[0]; d++) {
        for (int dragged = 0; dragged < 2; dragged++) {
            run(&densities[d], dragged, seconds, seed);
            print(&densities[d], dragged);
            failed |= apart_deepest_m(&apart) > APART_DEEP_M;
        }
    }
    return failed;
}
