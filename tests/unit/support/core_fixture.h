/* core_fixture.h -- test fixture of the whole core. The test plays through inputs only, as in the
 * kiosk. */
#ifndef KINGYO_TESTS_UNIT_SUPPORT_CORE_FIXTURE_H
#define KINGYO_TESTS_UNIT_SUPPORT_CORE_FIXTURE_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "core/core.h"

#define ABOVE_M 0.06f
#define BELOW_M (-0.05f)

static struct core core;
static struct input input;
static struct output output;
static struct scene scene;
/* Number of sounds of each kind since open_core(). A test may clear these counts. */
static uint32_t sounds[SOUND_COUNT];

/* Initializes the core with `config`, and resets input, output and sound counts. */
static inline void open_core(const struct core_config *config)
{
    assert_int_equal(core_init(&core, config), CORE_OK);
    memset(&input, 0, sizeof input);
    memset(&output, 0, sizeof output);
    memset(sounds, 0, sizeof sounds);
}

/* Runs one tick (1/120 s) of the core. Afterwards, the pressed buttons of the input are cleared,
 * because a press lasts one tick. */
static inline void tick(void)
{
    output.sound_count = 0;
    assert_int_equal(core_tick(&core, &input, &output), CORE_OK);
    input.pressed = 0;
    for (uint32_t i = 0; i < output.sound_count; i++) {
        sounds[output.sounds[i].sound]++;
    }
}

/* Runs `count` ticks of the core. */
static inline void ticks(uint32_t count)
{
    for (uint32_t i = 0; i < count; i++) {
        tick();
    }
}

/* Runs one tick with `buttons` pressed. */
static inline void press(uint32_t buttons)
{
    input.pressed = buttons;
    tick();
}

/* Sets the controller input of player `index` to a level poi at `at_m`. The controller also reports
 * angles. The input stays until it is set again. */
static inline void hold(uint32_t index, vec3 at_m)
{
    input.poi[index] = (struct poi_input){
        .link = POI_SOURCE_LIVE,
        .has_wrist = 1,
        .target.position_m = at_m,
    };
}

/* Moves the poi of player `index` in a straight line to `to_m` at 0.5 m/s, the speed of an
 * unhurried arm. */
static inline void lead(uint32_t index, vec3 to_m)
{
    const vec3 way_m = v3_sub(to_m, input.poi[index].target.position_m);
    const uint32_t count = 1u + (uint32_t)(v3_length(way_m) / (0.5f * CORE_TICK_S));
    for (uint32_t i = 0; i < count; i++) {
        const vec3 step_m = v3_scale(way_m, 1.0f / (float)count);
        input.poi[index].target.position_m = v3_add(input.poi[index].target.position_m, step_m);
        tick();
    }
}

/* Holds the poi of player `index` above (x_m, z_m) for half a second, then moves the poi straight
 * down under water. */
static inline void dip(uint32_t index, float x_m, float z_m)
{
    hold(index, v3(x_m, ABOVE_M, z_m));
    ticks(60);
    lead(index, v3(x_m, BELOW_M, z_m));
}

/* Returns the current scene. The result is valid until the next call. */
static inline const struct scene *look(void)
{
    core_scene(&core, &scene);
    return &scene;
}

/* Runs ticks until the game is in the phase `phase`. If this takes more than `ticks_max` ticks, the
 * test fails. */
static inline void wait_for_phase(uint8_t phase, uint32_t ticks_max)
{
    for (uint32_t i = 0; core.game.phase != phase && i < ticks_max; i++) {
        tick();
    }
    assert_int_equal(core.game.phase, phase);
}

/* Turns all paper of poi `index` into holes. */
static inline void tear_all(uint32_t index)
{
    struct sheet *sheet = &core.world.poi[index].sheet;
    for (uint32_t i = 0; i < SHEET_CELL_COUNT; i++) {
        if (sheet->state[i] == CELL_PAPER) {
            sheet->state[i] = CELL_HOLE;
        }
    }
    sheet->paper_cells = 0;
}

#endif
