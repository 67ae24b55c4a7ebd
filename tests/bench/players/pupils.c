/* pupils.c -- the table of the pairs of pupils.h. */
#include "tests/bench/players/pupils.h"

/* Habits of a visitor with an average aim, who has the technique that the lessons teach. */
static const struct habits taught = {
    .reaction_s = 0.30f,
    .pause_s = 0.50f,
    .lead = 0.7f,
    .aim_px = 12.0f,
    .cost_distance = 1.0f,
    .cost_depth = 14.0f,
    .cost_random_px = 200.0f,
    .arm_px_s = 1000.0f,
    .beside_px = 95.0f,
    .reach_px = 20.0f,
    .patience_s = 2.0f,
    .hold_min_s = 0.45f,
    .hold_max_s = 0.55f,
    .follow_min_s = 1.2f,
    .follow_max_s = 1.6f,
    .glide_px_s = 160.0f,
    .over_px = 24.0f,
    .lost_px = 150.0f,
    .rise_s = 0.75f,
    .carry_px_s = 800.0f,
    /* The members dip_m_s, lift_m_s, entry_rad and tremor_m are used only for a physical poi. */
    .dip_m_s = 0.25f,
    .lift_m_s = 0.15f,
    .entry_rad = 0.6f,
    .tremor_m = 0.002f,
};

/* Each function below gives a pair of players its fault. `ill` are the habits with the fault.
 * `cured` are the habits after the player has seen the sign on the screen. Both habits begin as
 * copies of `taught`, and most functions change only `ill`. */

static void is_motionless(struct habits *ill, struct habits *cured)
{
    (void)cured;
    ill->start_s = 60.0f;
}

static void hovers(struct habits *ill, struct habits *cured)
{
    (void)cured;
    ill->dip_start_s = 60.0f;
}

static void stays_under(struct habits *ill, struct habits *cured)
{
    ill->beside_px = ill->follow_min_s = ill->follow_max_s = 0.0f;
    ill->hold_min_s = 5.0f;
    ill->hold_max_s = 8.0f;
    *cured = *ill;
    cured->until_px = 24.0f;
}

static void keeps_catch(struct habits *ill, struct habits *cured)
{
    (void)cured;
    ill->keeps = true;
}

static void rushes(struct habits *ill, struct habits *cured)
{
    ill->device = cured->device = PLAYER_POI;
    ill->dip_m_s = ill->lift_m_s = 0.8f;
}

static void clicks(struct habits *ill, struct habits *cured)
{
    (void)cured;
    ill->beside_px = ill->follow_min_s = ill->follow_max_s = 0.0f;
    ill->hold_min_s = 0.1f;
    ill->hold_max_s = 0.3f;
}

static void pushes_level(struct habits *ill, struct habits *cured)
{
    ill->device = cured->device = PLAYER_POI;
    ill->dip_m_s = cured->dip_m_s = 0.5f;
    ill->entry_rad = 0.0f;
}

static void dips_half(struct habits *ill, struct habits *cured)
{
    ill->device = cured->device = PLAYER_POI;
    ill->depth_m = 0.006f;
}

/* A beginner does not see how deep a fish swims. */
static void takes_any_fish(struct habits *ill, struct habits *cured)
{
    ill->cost_depth = 0.0f;
    ill->cost_random_px = 300.0f;
    *cured = *ill;
    cured->takes_marked = true;
}

static const struct {
    uint8_t sign;
    const char *name, *fault;
    void (*set_fault)(struct habits *ill, struct habits *cured);
} table[] = {
    { HINT_DIP, "move", "does not move", is_motionless },
    { HINT_DIP, "dip", "moves, but does not dip", hovers },
    { HINT_LIFT, "lift", "holds the ring under water for 5 to 8 s", stays_under },
    { HINT_BOWL, "bowl", "keeps the fish on the paper", keeps_catch },
    { HINT_SLOWLY, "slowly", "dips and lifts a physical poi fast", rushes },
    { HINT_GLIDE, "glide", "clicks on fish", clicks },
    { HINT_TILT, "tilt", "pushes a level physical poi into the water", pushes_level },
    { HINT_WET_ALL, "wet", "dips half of a physical poi", dips_half },
    { SIGN_ARROW, "arrow", "keeps the fish on the paper", keeps_catch },
    { SIGN_RING, "ring", "takes any fish", takes_any_fish },
    { SIGN_GHOST, "ghost", "clicks on fish", clicks },
};

uint32_t pupils_init(struct pupil pupils[PUPILS_MAX])
{
    const uint32_t count = sizeof table / sizeof *table;
    _Static_assert(sizeof table / sizeof *table <= PUPILS_MAX, "all pairs fit");
    for (uint32_t i = 0; i < count; i++) {
        struct pupil *pupil = &pupils[i];
        *pupil = (struct pupil){ .sign = table[i].sign,
                                 .name = table[i].name,
                                 .fault = table[i].fault,
                                 .ignores = taught,
                                 .cured = taught };
        pupil->ignores.name = pupil->cured.name = table[i].name;
        table[i].set_fault(&pupil->ignores, &pupil->cured);
        pupil->follows = pupil->ignores;
        pupil->follows.sign = table[i].sign;
        pupil->follows.cured = &pupil->cured;
    }
    return count;
}
