/* whim.c -- implementation of whim.h: draws the keys, pointer motion, window size and plug events
 * of one step at random. */
#include "tests/monkey/whim.h"

#include "core/base/rng.h"

#define MOOD_STEPS 360u
/* Sum of each column of the table `weights`. */
#define PLAYER_WEIGHTS 83u
#define OPERATOR_WEIGHTS 94u

/* Relative frequency of each key. The first column is for steps that imitate a player, and the
 * second for steps that imitate an operator. */
static const uint8_t weights[WHIM_KEY_COUNT][2] = {
    [WHIM_KEY_START] = { 20, 8 },   [WHIM_KEY_LEFT] = { 8, 8 },
    [WHIM_KEY_RIGHT] = { 8, 8 },    [WHIM_KEY_UP] = { 8, 8 },
    [WHIM_KEY_DOWN] = { 8, 8 },     [WHIM_KEY_ENTER] = { 8, 4 },
    [WHIM_KEY_COIN] = { 8, 4 },     [WHIM_KEY_COIN_2] = { 4, 4 },
    [WHIM_KEY_LANGUAGE] = { 4, 4 }, [WHIM_KEY_FULL_SCREEN] = { 1, 1 },
    [WHIM_KEY_TILT] = { 1, 1 },     [WHIM_KEY_UNUSED] = { 3, 3 },
    [WHIM_KEY_TEST] = { 0, 16 },    [WHIM_KEY_SERVICE] = { 0, 12 },
    [WHIM_KEY_ESCAPE] = { 2, 5 },
};

static uint32_t draw(const struct rng_key *from, uint32_t which, uint32_t limit)
{
    const struct rng_key key = { from->seed, from->tick, which, RNG_TEST };
    return rng_u32(key) % limit;
}

/* Returns a random key (enum whim_key) with a probability of 1/4, otherwise -1. */
static int draw_key(const struct rng_key *from)
{
    if (draw(from, 0, 4) != 0) {
        return -1;
    }
    const struct rng_key mood = { from->seed, from->tick / MOOD_STEPS, UINT32_MAX, RNG_TEST };
    const uint32_t is_operator = rng_u32(mood) % 3u == 0;
    uint32_t left = draw(from, 1, is_operator ? OPERATOR_WEIGHTS : PLAYER_WEIGHTS);
    int key = 0;
    while (key < WHIM_KEY_COUNT - 1 && left >= weights[key][is_operator]) {
        left -= weights[key++][is_operator];
    }
    return key;
}

/* If Esc was drawn in the previous step, returns 1 with a probability of 1/2. Two successive
 * presses of Esc end the kiosk, which would otherwise be rare. */
static int repeats_escape(const struct rng_key *from)
{
    const struct rng_key last = { from->seed, from->tick - 1u, 0, RNG_TEST };
    return from->tick > 0 && draw_key(&last) == WHIM_KEY_ESCAPE && draw(from, 14, 2) == 0;
}

struct whim whim_at(uint32_t seed, uint32_t step)
{
    /* Possible widths and heights of the window in pixels. Some sizes are below the kiosk's
     * minimum, because a window manager may ignore this minimum. */
    static const int sides[] = { 1, 2, 7, 16, 60, 120, 240, 320, 480 };
    const uint32_t side_count = sizeof sides / sizeof sides[0];
    const struct rng_key from = { seed, step, 0, RNG_TEST };
    struct whim whim = {
        .key = repeats_escape(&from) ? WHIM_KEY_ESCAPE : draw_key(&from),
        .moves = draw(&from, 2, 2) == 0,
        .x_mille = (int)draw(&from, 3, 1100) - 50,
        .y_mille = (int)draw(&from, 4, 1100) - 50,
        .plugs = draw(&from, 5, 45) == 0,
        .chance = draw(&from, 6, UINT32_MAX),
    };
    if (draw(&from, 7, 8) == 0) {
        whim.press = draw(&from, 8, 5) == 0 ? WHIM_PRESS_RIGHT : WHIM_PRESS_LEFT;
    }
    if (draw(&from, 9, 16) == 0) {
        whim.wheel = (int)draw(&from, 10, 3) - 1;
    }
    if (draw(&from, 11, 90) == 0) {
        whim.width = sides[draw(&from, 12, side_count)];
        whim.height = sides[draw(&from, 13, side_count)];
    }
    return whim;
}
