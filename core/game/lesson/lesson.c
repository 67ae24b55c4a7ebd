/* lesson.c -- decides in each tick what the lesson of each player shows. */
#include "core/game/lesson/lesson.h"

#include "core/base/panic.h"
#include "core/game/phases.h"

/* Ticks between two selections of the marked fish and of the hint: ten selections per second. */
#define CHECK_TICKS 12u
/* Time after which a marked fish that was not caught may be replaced by an easier one, unless the
 * ring is in the water. */
#define MARK_TICKS (3u * CORE_TICK_HZ)
/* Longest time for which a hint is shown. If the player's fault persists, the hint is hidden for
 * the same time and then shown again. */
#define HINT_TICKS_MAX (5u * CORE_TICK_HZ)
/* A dip is flat if the ring enters the water at FLAT_M_S or faster while its pitch is smaller than
 * FLAT_RAD. The water then pushes on the whole paper at once. */
#define FLAT_M_S 0.25f
#define FLAT_RAD 0.2f
/* Number of flat dips after which the hint to tilt the poi is shown. */
#define FLAT_DIPS 2u
/* The motion of the poi is too fast if the ring is faster than HASTE_M_S while its paper tears, or
 * while the ring is in the water and the tension in the paper exceeds HASTE_SHARE of the strength
 * of fresh wet paper. Earlier damage has no effect. The hint is then due for HASTE_TICKS. */
#define HASTE_M_S 0.12f
#define HASTE_SHARE 0.6f
#define HASTE_TICKS (3u * CORE_TICK_HZ)
/* Time under water after which a player who does not lift a fish gets the hint to lift. */
#define UNDER_TICKS (3u * CORE_TICK_HZ / 2u)

/* Time for which a hint must fit the situation before it is shown. In this time the player may do
 * the right thing without a hint. Hints that follow from a fault need no time. */
static const uint16_t fault_ticks[HINT_COUNT] = {
    [HINT_DIP] = 4u * CORE_TICK_HZ,
    [HINT_BOWL] = 3u * CORE_TICK_HZ / 2u,
};

/* Resets the lesson of `player`, but not the ghost. */
static void reset_lesson(struct lessons *lessons, uint32_t player)
{
    lessons->player[player] = (struct lesson){ .fish = LESSON_NO_FISH,
                                               .hints.pupil = (uint8_t)player,
                                               .ghost = lessons->player[player].ghost };
}

void lesson_init(struct lessons *lessons)
{
    lessons->is_first = true;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        lessons->player[i].ghost = (struct ghost){ .fish = LESSON_NO_FISH };
        reset_lesson(lessons, i);
    }
}

/* Returns true if the game gives lessons to `player`, who has a poi and takes part in the round. */
static bool is_taught(const struct game *game, const struct world *world, uint32_t player)
{
    const bool is_round = game->phase == PHASE_READY || game->phase == PHASE_ROUND;
    return is_round && rules_of(game->mode)->shows_hints && player_has_poi(world, player) &&
           world->poi[player].link == POI_SOURCE_LIVE && !game->player[player].out;
}

/* Returns true if `player` gets lessons and may dip the poi. */
static bool is_scooping(const struct game *game, const struct world *world, uint32_t player)
{
    return is_taught(game, world, player) && game_may_scoop(game, player);
}

/* ---- Marked fish ----------------------------------------------------------------------------- */

static void mark_fish(struct lessons *lessons, const struct game *game, const struct world *world,
                      uint32_t player)
{
    struct lesson *lesson = &lessons->player[player];
    const struct poi *poi = &world->poi[player];
    const bool has_mark = game->player[player].level != LEVEL_MASTER && poi->carried_count == 0 &&
                          is_scooping(game, world, player) && lesson->ghost.state != GHOST_RUNS;
    const uint32_t count = world->tank.fish_count;
    uint16_t fish = LESSON_NO_FISH;
    if (has_mark && lesson->fish < count &&
        lesson_is_easy(&world->tank.fish[lesson->fish], world, player, true)) {
        fish = lesson->fish;
    }
    const bool is_old = game->tick - lesson->fish_tick >= MARK_TICKS && poi->immersed <= 0.0f;
    if (has_mark && (fish == LESSON_NO_FISH || is_old)) {
        const uint16_t easiest = lesson_easiest_fish(lessons, world, player);
        fish = easiest != LESSON_NO_FISH ? easiest : fish;
    }
    if (fish != lesson->fish) {
        lesson->fish = fish;
        lesson->fish_tick = game->tick;
    }
}

/* ---- Hint beside the poi --------------------------------------------------------------------- */

/* Returns true if the player has made the fault that `hint` corrects. The hints about haste,
 * technique and wet paper need no further condition, because hints.c selects these hints only after
 * a fault. */
static bool is_fault(const struct lesson *lesson, const struct game *game,
                     const struct world *world, uint8_t hint)
{
    const uint8_t player = lesson->hints.pupil;
    switch (hint) {
    case HINT_LIFT:
        return lesson->under_ticks >= UNDER_TICKS &&
               lesson_fish_is_over(world, &world->poi[player]);
    case HINT_TILT:
        return lesson->flat_dips >= FLAT_DIPS;
    /* Show this hint in the championship (the mode with fouls) and in practice (the mode without a
     * score), but not in the festival. */
    case HINT_CLEAR_RIM:
        return rules_of(game->mode)->counts_fouls || !rules_of(game->mode)->keeps_score;
    case HINT_LOST_POI:
    case HINT_NO_SHADE:
        return false; /* These hints concern all players, so lesson_screen_hint() returns them. */
    default:
        return game->phase == PHASE_ROUND;
    }
}

/* Returns the hint that fits the situation. HINT_DIP replaces HINT_MOVE, because its picture shows
 * both actions. This function detects haste and flat dips earlier than hints.c, which detects haste
 * only by torn paper, and shows HINT_TILT only after the first catch. */
static uint8_t wanted_hint(const struct lesson *lesson, const struct game *game,
                           const struct world *world)
{
    const uint8_t shown = lesson->hints.shown;
    const uint8_t hint = shown == HINT_MOVE ? (uint8_t)HINT_DIP : shown;
    const bool is_taught_now =
        is_scooping(game, world, lesson->hints.pupil) && hint != HINT_CLEAR_RIM;
    const bool is_free = hint == HINT_NONE || hint == HINT_GLIDE;
    if (is_taught_now && lesson->haste_tick != 0 && game->tick - lesson->haste_tick < HASTE_TICKS) {
        return HINT_SLOWLY;
    }
    return is_taught_now && is_free && lesson->flat_dips >= FLAT_DIPS &&
                   world->poi[lesson->hints.pupil].immersed <= 0.0f
               ? (uint8_t)HINT_TILT
               : hint;
}

/* Returns the hint that is due beside the poi of `lesson`, and updates `lesson->wanted`. */
static uint8_t due_hint(struct lesson *lesson, const struct game *game, const struct world *world)
{
    const uint8_t hint = wanted_hint(lesson, game, world);
    CORE_ASSERT(hint < HINT_COUNT);
    if (hint != lesson->wanted) {
        lesson->wanted = hint;
        lesson->wanted_tick = game->tick;
    }
    const uint32_t since = lesson->wanted_tick, start = game->phase_tick;
    const uint32_t age = game->tick - (since - start < UINT32_MAX / 2u ? since : start);
    if (hint == HINT_TORN) {
        const bool is_live = world->poi[lesson->hints.pupil].link == POI_SOURCE_LIVE;
        return is_live && age < HINT_TICKS_MAX ? (uint8_t)HINT_TORN : (uint8_t)HINT_NONE;
    }
    const bool is_turn = age >= fault_ticks[hint] &&
                         (age - fault_ticks[hint]) % (2u * HINT_TICKS_MAX) < HINT_TICKS_MAX;
    return is_turn && lesson->ghost.state != GHOST_RUNS && is_fault(lesson, game, world, hint)
               ? hint
               : HINT_NONE;
}

static void observe_faults(struct lesson *lesson, const struct poi *poi, uint32_t tick)
{
    const float pitch_rad = f_abs(poi->angles.pitch_rad);
    if (poi->splash_m_s >= FLAT_M_S && pitch_rad < FLAT_RAD && lesson->flat_dips < UINT8_MAX) {
        lesson->flat_dips++;
    } else if (poi->splash_m_s > 0.0f && pitch_rad >= FLAT_RAD) {
        lesson->flat_dips = 0; /* The player has tilted the poi, as the hint demands. */
    }
    const bool is_loaded =
        poi->immersed > 0.0f &&
        poi->strain.tension_max_n_m > HASTE_SHARE * sheet_grade(poi->sheet.grade)->wet_n_m;
    if (v3_length(poi->velocity_m_s) > HASTE_M_S && (poi->strain.cells_torn > 0 || is_loaded)) {
        lesson->haste_tick = tick;
    }
}

static void tick_hint(struct lesson *lesson, const struct game *game, const struct world *world)
{
    const uint8_t player = lesson->hints.pupil;
    const struct poi *poi = &world->poi[player];
    const bool is_round = game->phase == PHASE_READY || game->phase == PHASE_ROUND;
    if (is_scooping(game, world, player)) {
        observe_faults(lesson, poi, game->tick);
    }
    lesson->under_ticks = poi->immersed > 0.5f ? lesson->under_ticks + 1u : 0u;
    if (!is_round || !player_has_poi(world, player)) {
        lesson->hint = HINT_NONE;
        return;
    }
    hints_player_tick(&lesson->hints, game, world);
    if (game->tick != game->phase_tick && game->tick % CHECK_TICKS != 0) {
        return;
    }
    const uint8_t next = due_hint(lesson, game, world);
    if (hints_may_change(lesson->hint, next, game->tick - lesson->hint_tick, poi)) {
        lesson->hint = next;
        lesson->hint_tick = game->tick;
    }
}

/* ---- Public functions ------------------------------------------------------------------------ */

void lesson_tick(struct lessons *lessons, const struct game *game, const struct world *world)
{
    CORE_ASSERT(game->phase <= PHASE_LEADERBOARD && game->mode < MODE_COUNT);
    if (game->phase == PHASE_ATTRACT) {
        lesson_init(lessons);
        return;
    }
    lessons->is_first = lessons->is_first && game->phase != PHASE_RESULT;
    const bool is_new_game = game->phase == PHASE_READY && game->tick == game->phase_tick;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        if (is_new_game || world->poi[i].link == POI_SOURCE_ABSENT) {
            reset_lesson(lessons, i);
        }
        lesson_ghost_tick(lessons, game, world, i, is_taught(game, world, i));
        if (game->tick == game->phase_tick || game->tick % CHECK_TICKS == 0) {
            mark_fish(lessons, game, world, i);
        }
        tick_hint(&lessons->player[i], game, world);
    }
}

uint8_t lesson_screen_hint(const struct game *game)
{
    const uint8_t hint = game->hints.shown;
    const bool is_round = game->phase == PHASE_READY || game->phase == PHASE_ROUND;
    const bool is_of_poi = is_round && hint != HINT_LOST_POI && hint != HINT_NO_SHADE;
    return is_of_poi ? (uint8_t)HINT_NONE : hint;
}

/* Returns true if the arrow to the bowl is shown: a fish lies on paper that is out of the water,
 * and the ring is not yet over the bowl. */
static bool points_to_bowl(const struct game *game, const struct world *world, uint32_t player)
{
    const struct poi *poi = &world->poi[player];
    const vec3 way_m = v3_sub(world->bowl[player].position_m, poi->position_m);
    const bool is_carrying = game->phase == PHASE_ROUND && is_taught(game, world, player);
    return is_carrying && !game->paused && poi->carried_count > 0 && poi->immersed <= 0.0f &&
           way_m.x * way_m.x + way_m.z * way_m.z > BOWL_RADIUS_M * BOWL_RADIUS_M;
}

void lesson_show(const struct lessons *lessons, const struct game *game, const struct world *world,
                 uint32_t player, struct scene_lesson *out)
{
    const struct lesson *lesson = &lessons->player[player];
    CORE_ASSERT(player < POI_MAX);
    *out = (struct scene_lesson){
        .hint = lesson->hint,
        .hint_s = (float)(game->tick - lesson->hint_tick) * CORE_TICK_S,
        .marks_fish = lesson->fish < world->tank.fish_count,
        .fish = lesson->fish,
        .mark_s = (float)(game->tick - lesson->fish_tick) * CORE_TICK_S,
        .points_to_bowl = points_to_bowl(game, world, player),
    };
    if (is_taught(game, world, player)) {
        lesson_ghost_show(&lesson->ghost, &world->bowl[player], &out->ghost);
    }
}
