/* random_step.c -- implementation of random_step.h: draws the keys, pointer motion, window size
 * and plug events of one step at random. */
#include "tests/monkey/random_step.h"

#include "core/base/rng.h"

#define ROLE_STEPS 360u
/* Sum of each column of the table `weights`. */
#define PLAYER_WEIGHTS 83u
#define OPERATOR_WEIGHTS 94u

/* Relative frequency of each key. The first column is for steps that imitate a player, and the
 * second for steps that imitate an operator. */
static const uint8_t weights[STEP_KEY_COUNT][2] = {
    [STEP_KEY_START] = { 20, 8 },   [STEP_KEY_LEFT] = { 8, 8 },
    [STEP_KEY_RIGHT] = { 8, 8 },    [STEP_KEY_UP] = { 8, 8 },
    [STEP_KEY_DOWN] = { 8, 8 },     [STEP_KEY_ENTER] = { 8, 4 },
    [STEP_KEY_COIN] = { 8, 4 },     [STEP_KEY_COIN_2] = { 4, 4 },
    [STEP_KEY_LANGUAGE] = { 4, 4 }, [STEP_KEY_FULL_SCREEN] = { 1, 1 },
    [STEP_KEY_TILT] = { 1, 1 },     [STEP_KEY_UNUSED] = { 3, 3 },
    [STEP_KEY_TEST] = { 0, 16 },    [STEP_KEY_SERVICE] = { 0, 12 },
    [STEP_KEY_ESCAPE] = { 2, 5 },
};

static uint32_t draw(const struct rng_key *from, uint32_t which, uint32_t limit)
{
    const struct rng_key key = { from->seed, from->tick, which, RNG_TEST };
    return rng_u32(key) % limit;
}

/* Returns a random key (enum step_key) with a probability of 1/4, otherwise -1. */
static int draw_key(const struct rng_key *from)
{
    if (draw(from, 0, 4) != 0) {
        return -1;
    }
    const struct rng_key role = { from->seed, from->tick / ROLE_STEPS, UINT32_MAX, RNG_TEST };
    const uint32_t is_operator = rng_u32(role) % 3u == 0;
    uint32_t left = draw(from, 1, is_operator ? OPERATOR_WEIGHTS : PLAYER_WEIGHTS);
    int key = 0;
    while (key < STEP_KEY_COUNT - 1 && left >= weights[key][is_operator]) {
        left -= weights[key++][is_operator];
    }
    return key;
}

/* If Esc was drawn in the previous step, returns 1 with a probability of 1/2. Two successive
 * presses of Esc end the kiosk, which would otherwise be rare. */
static int repeats_escape(const struct rng_key *from)
{
    const struct rng_key last = { from->seed, from->tick - 1u, 0, RNG_TEST };
    return from->tick > 0 && draw_key(&last) == STEP_KEY_ESCAPE && draw(from, 14, 2) == 0;
}

struct random_step random_step_at(uint32_t seed, uint32_t step)
{
    /* Possible widths and heights of the window in pixels. Some sizes are below the kiosk's
     * minimum, because a window manager may ignore this minimum. */
    static const int sides[] = { 1, 2, 7, 16, 60, 120, 240, 320, 480 };
    const uint32_t side_count = sizeof sides / sizeof sides[0];
    const struct rng_key from = { seed, step, 0, RNG_TEST };
    struct random_step out = {
        .key = repeats_escape(&from) ? STEP_KEY_ESCAPE : draw_key(&from),
        .moves = draw(&from, 2, 2) == 0,
        .x_mille = (int)draw(&from, 3, 1100) - 50,
        .y_mille = (int)draw(&from, 4, 1100) - 50,
        .plugs = draw(&from, 5, 45) == 0,
        .chance = draw(&from, 6, UINT32_MAX),
    };
    if (draw(&from, 7, 8) == 0) {
        out.press = draw(&from, 8, 5) == 0 ? STEP_PRESS_RIGHT : STEP_PRESS_LEFT;
    }
    if (draw(&from, 9, 16) == 0) {
        out.wheel = (int)draw(&from, 10, 3) - 1;
    }
    if (draw(&from, 11, 90) == 0) {
        out.width = sides[draw(&from, 12, side_count)];
        out.height = sides[draw(&from, 13, side_count)];
    }
    return out;
}
