/* habits.c -- the table of the simulated players, with the habits of each player as numbers. */
#include "tests/bench/players/sim_player.h"

/* Habits of a person who has learned the technique: the player chooses a slow, small fish near the
 * surface, dips beside it, glides below it, and lifts. */
/* clang-format off */
#define CAREFUL                                                                                    \
    .reaction_s = 0.20f, .pause_s = 0.35f, .lead = 1.0f, .aim_px = 9.0f,                           \
    .cost_distance = 1.0f, .cost_speed_s = 4.0f, .cost_depth = 16.0f, .cost_length = 6.0f,         \
    .arm_px_s = 900.0f, .beside_px = 95.0f, .reach_px = 14.0f, .calm_m_s = 0.05f,                  \
    .patience_s = 2.5f, .hold_min_s = 0.45f, .hold_max_s = 0.55f,                                  \
    .follow_min_s = 1.4f, .follow_max_s = 1.6f, .glide_px_s = 140.0f, .over_px = 22.0f,            \
    .lost_px = 150.0f, .rise_s = 0.75f, .carry_px_s = 700.0f

const struct habits sim_player_table[] = {
    {
        .name = "clicks",
        .reaction_s = 0.25f, .pause_s = 0.8f, .aim_px = 12.0f, .lead = 0.5f,
        .cost_distance = 1.0f, .cost_depth = 14.0f, .cost_random_px = 300.0f,
        .arm_px_s = 1600.0f, .reach_px = 24.0f, .patience_s = 1.5f,
        .hold_min_s = 0.10f, .hold_max_s = 0.30f, .glide_px_s = 1600.0f,
        .rise_s = 0.70f, .carry_px_s = 1200.0f,
    },
    {
        .name = "child",
        .reaction_s = 0.35f, .pause_s = 2.8f, .aim_px = 16.0f, .lead = 0.5f,
        .cost_distance = 1.0f, .cost_depth = 3.0f, .cost_random_px = 300.0f,
        .arm_px_s = 1300.0f, .reach_px = 30.0f, .patience_s = 1.5f,
        .hold_min_s = 0.15f, .hold_max_s = 0.30f,
        .follow_min_s = 0.25f, .follow_max_s = 0.60f, .glide_px_s = 700.0f,
        .rise_s = 0.80f, .carry_px_s = 900.0f,
    },
    {
        .name = "waits",
        .reaction_s = 0.30f, .pause_s = 0.50f, .aim_px = 12.0f,
        .cost_distance = 1.0f, .cost_depth = 14.0f, .cost_random_px = 100.0f,
        .arm_px_s = 900.0f, .reach_px = 24.0f, .patience_s = 1.5f,
        .hold_min_s = 4.0f, .hold_max_s = 6.0f, .until_px = 24.0f,
        .rise_s = 0.75f, .carry_px_s = 800.0f,
    },
    { .name = "careful", CAREFUL },
    /* This player turns the wheel away from the body before the dip, so that the far edge is higher
     * and the dip is less slanted, and levels the ring under water. With a ring that stays tilted
     * until the lift, the gain at level master is only half as large. */
    { .name = "careful-tilt", CAREFUL, .tilt_notches = 1.0f, .levels = true },
    /* This player turns the wheel in the other direction, so that the dip is more slanted, and
     * levels the ring under water. */
    { .name = "careful-slant", CAREFUL, .tilt_notches = -3.0f, .levels = true },
    {
        .name = "plunges",
        .reaction_s = 0.25f, .pause_s = 0.25f, .aim_px = 20.0f,
        .cost_distance = 1.0f, .cost_random_px = 500.0f,
        .arm_px_s = 2500.0f, .reach_px = 60.0f, .patience_s = 0.8f,
        .hold_min_s = 0.02f, .hold_max_s = 0.08f,
        .rise_s = 0.45f, .carry_px_s = 2000.0f,
    },
    {
        .name = "chases",
        .reaction_s = 0.25f, .pause_s = 0.25f, .aim_px = 12.0f,
        .cost_distance = 1.0f,
        .arm_px_s = 1500.0f, .reach_px = 40.0f, .patience_s = 1.0f,
        .hold_min_s = 0.30f, .hold_max_s = 0.40f,
        .follow_min_s = 3.0f, .follow_max_s = 5.0f, .glide_px_s = 900.0f, .over_px = 30.0f,
        .rise_s = 0.70f, .carry_px_s = 1000.0f,
    },
    {
        .name = "holds-still",
        .reaction_s = 0.25f, .pause_s = 0.25f, .aim_px = 12.0f,
        .cost_distance = 1.0f, .cost_random_px = 200.0f,
        .arm_px_s = 900.0f, .reach_px = 24.0f, .patience_s = 1.5f,
        .hold_min_s = 2.0f, .hold_max_s = 4.0f,
        .rise_s = 0.75f, .carry_px_s = 800.0f,
    },
    { .name = "finger", .device = PLAYER_FINGER, CAREFUL },
    { .name = "gamepad", .device = PLAYER_GAMEPAD, CAREFUL },
    {
        .name = "poi-tremor", .device = PLAYER_POI, CAREFUL,
        .dip_m_s = 0.25f, .lift_m_s = 0.15f, .entry_rad = 0.6f, .tremor_m = 0.002f,
    },
    { .name = "expert-bot", .device = PLAYER_BOT },
};
/* clang-format on */
const uint32_t sim_player_table_count = sizeof sim_player_table / sizeof sim_player_table[0];
