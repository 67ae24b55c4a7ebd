/* lesson.c -- decides in each tick what the lesson of each player shows. */
#include "core/game/lesson/lesson.h"

#include "core/base/panic.h"
#include "core/game/phases.h"

/* Ticks between two choices of the marked fish: ten choices per second. */
#define LOOK_TICKS 12u
/* Time after which a marked fish that was not caught may be replaced by an easier one, unless the
 * ring is in the water. */
#define MARK_TICKS (3u * CORE_TICK_HZ)

void lesson_init(struct lessons *lessons)
{
    for (uint32_t i = 0; i < POI_MAX; i++) {
        lessons->player[i] = (struct lesson){ .fish = LESSON_NO_FISH };
    }
}

/* Returns true if the game gives lessons to `player`, who plays and may dip the poi. */
static bool is_pupil(const struct game *game, const struct world *world, uint32_t player)
{
    return game->phase == PHASE_ROUND && rules_of(game->mode)->shows_hints &&
           game_may_scoop(game, player) && player_has_poi(world, player) &&
           world->poi[player].link == POI_SOURCE_LIVE;
}

static void mark_fish(struct lessons *lessons, const struct game *game, const struct world *world,
                      uint32_t player)
{
    struct lesson *lesson = &lessons->player[player];
    const struct poi *poi = &world->poi[player];
    const bool has_mark = game->player[player].level != LEVEL_MASTER && poi->carried_count == 0 &&
                          is_pupil(game, world, player);
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

void lesson_tick(struct lessons *lessons, const struct game *game, const struct world *world)
{
    CORE_ASSERT(game->phase <= PHASE_LEADERBOARD && game->mode < MODE_COUNT);
    for (uint32_t i = 0; i < POI_MAX; i++) {
        if (game->tick == game->phase_tick || game->tick % LOOK_TICKS == 0) {
            mark_fish(lessons, game, world, i);
        }
    }
}

/* Returns true if the arrow to the bowl is shown: a fish lies on paper that is out of the water,
 * and the ring is not yet over the bowl. */
static bool points_to_bowl(const struct game *game, const struct world *world, uint32_t player)
{
    const struct poi *poi = &world->poi[player];
    const vec3 way_m = v3_sub(world->bowl[player].position_m, poi->position_m);
    const float room_m = BOWL_RADIUS_M;
    return is_pupil(game, world, player) && poi->carried_count > 0 && poi->immersed <= 0.0f &&
           way_m.x * way_m.x + way_m.z * way_m.z > room_m * room_m;
}

void lesson_show(const struct lessons *lessons, const struct game *game, const struct world *world,
                 uint32_t player, struct scene_lesson *out)
{
    const struct lesson *lesson = &lessons->player[player];
    CORE_ASSERT(player < POI_MAX);
    *out = (struct scene_lesson){
        .marks_fish = lesson->fish < world->tank.fish_count,
        .fish = lesson->fish,
        .mark_s = (float)(game->tick - lesson->fish_tick) * CORE_TICK_S,
        .points_to_bowl = points_to_bowl(game, world, player),
    };
}
