/* game_fixture.h -- test fixture of the game module with a tank that does not move, for tests of
 * the game's clock and rules. The fixture core_fixture.h runs the whole core instead. */
#ifndef KINGYO_TESTS_UNIT_SUPPORT_GAME_FIXTURE_H
#define KINGYO_TESTS_UNIT_SUPPORT_GAME_FIXTURE_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "core/base/hash.h"
#include "core/core.h"
#include "core/poi/paper/paper_patch.h"
#include "core/game/phases.h"
#include "tests/unit/support/balance.h"

#define ROUND_S 20u
#define ABOVE_M 0.06f
#define BELOW_M (-0.05f)

static struct core core;
static struct input input;
static struct output output;
static uint32_t sounds[SOUND_COUNT]; /* Number of sounds of each kind since the last
                                        clear_sounds(). */

/* Sets all sound counts to 0. */
static inline void clear_sounds(void)
{
    memset(sounds, 0, sizeof sounds);
}

/* If 1, the test itself sets which ledger entries the store has written. If 0, step() reports each
 * entry as written. */
static int store_is_late;

/* Runs one tick (1/120 s) of the game module. Afterwards the pressed buttons are cleared, and the
 * dispenser has finished its tickets. Unless store_is_late is set, the store has also written all
 * ledger entries. */
static inline void step(void)
{
    struct poi_target targets[POI_MAX];
    uint8_t live[POI_MAX];
    const struct catch_result caught[POI_MAX] = { 0 };
    output.sound_count = 0;
    game_tick(&core.game, &core.world, &core.config, &input, &output, targets, live);
    game_score(core.game.player, &core.game.album, &core.game, &core.world, caught, false, &output);
    core.game.tick++;
    input.pressed = 0;
    input.tickets_done = output.tickets;
    if (!store_is_late) {
        input.store_well = 1;
        input.record_saved_id = output.entry_id;
    }
    for (uint32_t i = 0; i < output.sound_count; i++) {
        sounds[output.sounds[i].sound]++;
    }
}

/* Runs `count` ticks of the game module. */
static inline void steps(uint32_t count)
{
    for (uint32_t i = 0; i < count; i++) {
        step();
    }
}

/* Runs one tick with `buttons` pressed. */
static inline void press(uint32_t buttons)
{
    input.pressed = buttons;
    step();
}

/* Sets the input of the first poi to a position at the height `y_m` above the water. */
static inline void hold_at(float y_m)
{
    input.poi[0].link = POI_SOURCE_LIVE;
    input.poi[0].target.position_m = v3(0.05f, y_m, 0.02f);
}

/* Runs two ticks. The first poi is above the water in the first tick, and below the water in the
 * second. */
static inline void dip(void)
{
    hold_at(ABOVE_M);
    step();
    hold_at(BELOW_M);
    step();
}

/* Initializes core, input and output; a cmocka setup function. */
static inline int setup(void **state)
{
    (void)state;
    const struct core_config config = {
        .seed = 7,
        .fish_count = 12,
        .round_s = ROUND_S,
        .persistent.ranking.row[MODE_FESTIVAL][RANK_DAY][0].caught = 2,
    };
    assert_int_equal(core_init(&core, &config), CORE_OK);
    memset(&input, 0, sizeof input);
    memset(&output, 0, sizeof output);
    clear_sounds();
    return 0;
}

/* Runs two ticks. The first poi appears above the water in the first tick, and START is pressed in
 * the second. */
static inline void start_with_a_poi(void)
{
    hold_at(ABOVE_M);
    step();
    press(INPUT_START);
}

/* Starts a round and runs ticks until the first tick of the round. */
static inline void play_into_round(void)
{
    start_with_a_poi();
    steps(GAME_READY_TICKS);
    assert_int_equal(core.game.phase, PHASE_ROUND);
}

/* Starts a round and runs ticks until the first tick of its result. */
static inline void play_into_result(void)
{
    play_into_round();
    steps(ROUND_S * CORE_TICK_HZ);
    assert_int_equal(core.game.phase, PHASE_RESULT);
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

/* Asserts that each of the first `count` fish swims within half a second, even if the fish was
 * poured back onto other fish. */
static inline void expect_all_to_swim_soon(uint32_t count)
{
    uint8_t swam[16] = { 0 };
    for (uint32_t tick = 0; tick < CORE_TICK_HZ / 2u; tick++) {
        assert_int_equal(core_tick(&core, &input, &output), CORE_OK);
        for (uint32_t i = 0; i < count; i++) {
            swam[i] |= core.world.tank.fish[i].gait < GAIT_HELD;
        }
    }
    for (uint32_t i = 0; i < count; i++) {
        assert_true(swam[i]);
    }
}

#endif
