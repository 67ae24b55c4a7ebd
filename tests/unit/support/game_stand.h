/* game_stand.h -- test fixture of the game module alone with a static tank, for tests of its clock
 * and rules. stall_stand.h runs the whole stall. */
#ifndef KINGYO_TESTS_UNIT_SUPPORT_GAME_STAND_H
#define KINGYO_TESTS_UNIT_SUPPORT_GAME_STAND_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "core/base/hash.h"
#include "core/core.h"
#include "core/game/paper.h"
#include "tests/unit/support/purse.h"

#define ROUND_S 20u
#define ABOVE_M 0.06f
#define BELOW_M (-0.05f)

static struct core core;
static struct input input;
static struct output output;
static uint32_t sounds[SOUND_COUNT]; /* Number of sounds of each kind after the last
                                        clear_sounds(). */

/* Resets the sound counts. */
static inline void clear_sounds(void)
{
    memset(sounds, 0, sizeof sounds);
}

/* 1 means that the test itself sets which entries the store has written. */
static int store_is_late;

/* Runs one tick of the game alone. Button edges last one tick. Before the next tick the store has
 * written an entry and the dispenser has finished a ticket. */
static inline void step(void)
{
    struct poi_target targets[POI_MAX];
    uint8_t live[POI_MAX];
    const struct catch_result caught[POI_MAX] = { 0 };
    output.sound_count = 0;
    game_tick(&core, &input, &output, targets, live);
    game_score(&core, caught, &output);
    core.tick++;
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

/* Runs `count` ticks of the game. */
static inline void steps(uint32_t count)
{
    for (uint32_t i = 0; i < count; i++) {
        step();
    }
}

/* Presses `buttons` for one tick. */
static inline void press(uint32_t buttons)
{
    input.pressed = buttons;
    step();
}

/* Holds the first poi at the height `y_m` over the tank. */
static inline void hold_at(float y_m)
{
    input.poi[0].link = POI_SOURCE_LIVE;
    input.poi[0].target.position_m = v3(0.05f, y_m, 0.02f);
}

/* Holds the first poi above the water for one tick and below it for the next tick. */
static inline void dip(void)
{
    hold_at(ABOVE_M);
    step();
    hold_at(BELOW_M);
    step();
}

/* Initializes the core, the input and the output. This is a cmocka setup function. */
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

/* Holds the first poi above the water for a tick and presses START. */
static inline void start_with_a_hand(void)
{
    hold_at(ABOVE_M);
    step();
    press(INPUT_START);
}

/* Plays into the first tick of the round. */
static inline void play_into_round(void)
{
    start_with_a_hand();
    steps(GAME_READY_TICKS);
    assert_int_equal(core.game.phase, PHASE_ROUND);
}

/* Plays into the first tick of the result. */
static inline void play_into_result(void)
{
    play_into_round();
    steps(ROUND_S * CORE_TICK_HZ);
    assert_int_equal(core.game.phase, PHASE_RESULT);
}

/* Turns all paper of a poi into holes. */
static inline void tear_all(uint32_t index)
{
    struct sheet *sheet = &core.poi[index].sheet;
    for (uint32_t i = 0; i < SHEET_CELL_COUNT; i++) {
        if (sheet->state[i] == CELL_PAPER) {
            sheet->state[i] = CELL_HOLE;
        }
    }
    sheet->paper_cells = 0;
}

/* Checks that the first `count` fish swim within half a second after they were put back, even if
 * they fell onto other fish. */
static inline void expect_all_to_swim_soon(uint32_t count)
{
    uint8_t swam[16] = { 0 };
    for (uint32_t tick = 0; tick < CORE_TICK_HZ / 2u; tick++) {
        assert_int_equal(core_tick(&core, &input, &output), CORE_OK);
        for (uint32_t i = 0; i < count; i++) {
            swam[i] |= core.tank.fish[i].gait < GAIT_HELD;
        }
    }
    for (uint32_t i = 0; i < count; i++) {
        assert_true(swam[i]);
    }
}

#endif
