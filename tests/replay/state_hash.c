/* state_hash.c -- plays a fixed half-minute of the core and prints the hash of its state every
 * second.
 *
 * Usage: state_hash [LANES | growth]. LANES is the SIMD width. With `growth`, the program prints
 * one line for each species instead (growth_hash.h).
 *
 * The half-minute has attract mode, then a round of a bot, and then a player who dips and sweeps
 * next to a second player who holds a fan. The program uses no clock, file or device, so the lines
 * depend only on the core. Every compiler, optimization level, board and SIMD width must print the
 * lines of tests/replay/golden.txt.
 *
 * Returns exit status 77 if this machine does not support the SIMD width. */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/panic.h"
#include "core/core.h"
#include "tests/replay/growth_hash.h"

#define SEED 20130213u
/* End of attract mode. */
#define START_TICK (2u * CORE_TICK_HZ)
/* Start of the scripted player, who replaces the bot at this tick. */
#define HAND_TICK (20u * CORE_TICK_HZ)
#define END_TICK (30u * CORE_TICK_HZ)

_Noreturn void core_panic(const char *condition, const char *file, int line)
{
    fprintf(stderr, "%s:%d: %s\n", file, line, condition);
    exit(70);
}

/* Returns the pose of a scripted player: the poi sweeps back and forth through the tank, and makes
 * a tilted dip every two seconds. */
static struct poi_target pose_at(uint32_t tick)
{
    const float s = (float)(tick - HAND_TICK) * CORE_TICK_S;
    return (struct poi_target){
        .position_m =
            v3(0.15f * f_sin(1.1f * s), 0.01f + 0.05f * f_cos(F_PI * s), 0.10f * f_cos(0.7f * s)),
        .angles = { .yaw_rad = 0.3f * f_sin(s), .pitch_rad = 0.4f * f_sin(F_PI * s) },
    };
}

/* Returns the pose of the fan. The fan moves over the water, stays until fish gather below it,
 * moves along the tank, and leaves. */
static struct shade_input fan_at(uint32_t tick)
{
    const float s = (float)(tick - HAND_TICK) * CORE_TICK_S;
    return (struct shade_input){
        .present = s > 1.0f && s < 8.0f,
        .x_m = -0.2f + 0.3f * f_smoothstep(5.5f, 8.0f, s),
        .z_m = 0.5f - 0.5f * f_smoothstep(1.0f, 1.5f, s),
        .radius_m = 0.1f,
    };
}

static struct input input_at(uint32_t tick)
{
    struct input input = { 0 };
    input.poi[0].link = POI_SOURCE_BOT;
    if (tick >= HAND_TICK) {
        input.poi[0].link = POI_SOURCE_LIVE;
        input.poi[0].target = pose_at(tick);
        input.shade[1] = fan_at(tick);
    }
    if (tick == START_TICK) {
        input.held = input.pressed = INPUT_START;
    }
    return input;
}

static int machine_has(uint32_t lanes)
{
#ifdef __x86_64__
    return lanes <= 4u || __builtin_cpu_supports("avx2");
#else
    return lanes <= 4u;
#endif
}

int main(int argc, char **argv)
{
    const uint32_t lanes = argc > 1 ? (uint32_t)strtoul(argv[1], NULL, 10) : 0u;
    if (argc > 1 && strcmp(argv[1], "growth") == 0) {
        print_growth_hashes();
        return 0;
    }
    if (!machine_has(lanes)) {
        return 77;
    }
    static struct core core;
    static struct output output;
    const struct core_config config = { .seed = SEED, .lanes = (uint8_t)lanes };
    if (core_init(&core, &config) != CORE_OK) {
        fprintf(stderr,
                "state_hash: the core refuses its preset, the lanes or this floating point\n");
        return 70;
    }
    while (core.game.tick < END_TICK) {
        const struct input input = input_at(core.game.tick);
        output.sound_count = 0;
        if (core_tick(&core, &input, &output) != CORE_OK) {
            fprintf(stderr, "state_hash: floating point is not IEEE 754's default\n");
            return 70;
        }
        if (core.game.tick % CORE_TICK_HZ == 0) {
            printf("%2" PRIu32 " s  %016" PRIx64 "  caught %" PRIu32 "\n",
                   core.game.tick / CORE_TICK_HZ, core_hash(&core), core.game.player[0].caught);
        }
    }
    return 0;
}
