/* ghost.c -- moves the ghost: a translucent poi that demonstrates at a real fish how to dip, glide,
 * lift and empty a poi. */
#include "core/base/panic.h"
#include "core/game/lesson/lesson.h"
#include "core/game/rules.h"

/* Largest speed at which the ghost follows its fish. A fish that flees leaves the ghost behind. */
#define FOLLOW_M_S 0.15f
#define FADE_S 0.35f /* Duration of the fade-in and of the fade-out of the ghost. */

/* A point of the ghost's path. The horizontal position of the point lies on the line from the fish
 * to the bowl, at `share` of the line's length plus `beside_m`. */
struct waypoint {
    float time_s;
    float share;     /* 0 at the fish, 1 at the bowl. */
    float beside_m;  /* Additional distance toward the bowl. */
    float height_m;  /* Height above the water if `is_under` is false, otherwise above the fish. */
    float pitch_rad; /* Tilt of the ring. A negative value lowers the far edge. */
    bool is_under;
};

/* The ghost comes from the bowl, dips beside the fish, glides under it, lifts it, and carries it to
 * the bowl. */
static const struct waypoint path[] = {
    { 0.0f, 0.8f, 0.0f, 0.060f, 0.0f, false },    { 0.9f, 0.0f, 0.075f, 0.045f, -0.3f, false },
    { 1.5f, 0.0f, 0.060f, -0.030f, -0.8f, true }, { 1.8f, 0.0f, 0.055f, -0.025f, -0.1f, true },
    { 2.6f, 0.0f, 0.0f, -0.022f, 0.0f, true },    { 3.4f, 0.0f, 0.0f, 0.055f, 0.15f, false },
    { 4.4f, 1.0f, 0.0f, 0.065f, 0.1f, false },    { 5.0f, 1.0f, 0.0f, 0.065f, 0.9f, false },
};
#define PATH_COUNT (sizeof path / sizeof *path)
#define UNDER_FISH 4u /* Index of the waypoint from which the ghost carries the fish. */
_Static_assert(LESSON_GHOST_TICKS == 5u * CORE_TICK_HZ, "the path lasts as long as the ghost");

static void follow_fish(struct ghost *ghost, const struct tank *tank)
{
    const float time_s = (float)ghost->ticks * CORE_TICK_S;
    if (ghost->fish < tank->fish_count && time_s < path[UNDER_FISH].time_s) {
        const vec3 way_m = v3_sub(tank->fish[ghost->fish].position_m, ghost->fish_m);
        ghost->fish_m = v3_add(ghost->fish_m, v3_limit(way_m, FOLLOW_M_S * CORE_TICK_S));
    }
}

void lesson_ghost_tick(struct lessons *lessons, const struct game *game, const struct world *world,
                       uint32_t player, bool is_taught)
{
    struct ghost *ghost = &lessons->player[player].ghost;
    const struct poi *poi = &world->poi[player];
    const float y_m = game->control[player].live_y_m;
    CORE_ASSERT(player < POI_MAX && ghost->state <= GHOST_IS_OVER);
    /* Before the round, the dips of the poi were made by the bot, and in READY the game holds the
     * poi above the water. A dip of the player is therefore detected by the pose of the
     * controller. The dip that begins the game does not count, because the pose must rise above
     * the water in READY before it sinks. */
    const bool begins = game->phase == PHASE_READY && game->tick == game->phase_tick;
    const bool was_raised = ghost->is_raised && !begins;
    const bool dips = (game->phase == PHASE_ROUND && (poi->immersed > 0.0f || poi->dips > 0)) ||
                      (was_raised && y_m < RULES_DIP_Y_M && y_m > -1.0f);
    ghost->is_raised = y_m >= 0.0f || (was_raised && y_m >= RULES_DIP_Y_M);
    if (ghost->state == GHOST_RUNS) {
        ghost->ticks += game->paused ? 0u : 1u;
        follow_fish(ghost, &world->tank);
    } else if (ghost->state == GHOST_WAITS && lessons->is_first && is_taught) {
        ghost->fish = lesson_easiest_fish(lessons, world, player);
        if (ghost->fish != LESSON_NO_FISH) {
            ghost->state = GHOST_RUNS;
            ghost->ticks = 0;
            ghost->fish_m = world->tank.fish[ghost->fish].position_m;
        }
    }
    if (!lessons->is_first || (is_taught && dips) || ghost->ticks >= LESSON_GHOST_TICKS) {
        ghost->state = GHOST_IS_OVER;
        ghost->fish = LESSON_NO_FISH;
    }
}

static vec3 place_of(const struct waypoint *point, vec3 fish_m, vec3 bowl_m)
{
    const vec3 way_m = v3(bowl_m.x - fish_m.x, 0.0f, bowl_m.z - fish_m.z);
    const float length_m = f_max(v3_length(way_m), 1e-3f);
    const vec3 at_m = v3_muladd(fish_m, way_m, point->share + point->beside_m / length_m);
    return v3(at_m.x, point->height_m + (point->is_under ? fish_m.y : 0.0f), at_m.z);
}

void lesson_ghost_show(const struct ghost *ghost, const struct bowl *bowl, struct scene_ghost *out)
{
    *out = (struct scene_ghost){ 0 };
    if (ghost->state != GHOST_RUNS) {
        return;
    }
    const float time_s = (float)ghost->ticks * CORE_TICK_S;
    uint32_t next = 1;
    while (next + 1u < PATH_COUNT && path[next].time_s <= time_s) {
        next++;
    }
    const struct waypoint *from = &path[next - 1u], *to = &path[next];
    const float part = f_smoothstep(from->time_s, to->time_s, time_s);
    const vec3 from_m = place_of(from, ghost->fish_m, bowl->position_m);
    const vec3 to_m = place_of(to, ghost->fish_m, bowl->position_m);
    *out = (struct scene_ghost){
        .is_present = 1,
        .carries = next > UNDER_FISH,
        .opacity = f_smoothstep(0.0f, FADE_S, time_s) *
                   (1.0f - f_smoothstep(path[PATH_COUNT - 1u].time_s - FADE_S,
                                        path[PATH_COUNT - 1u].time_s, time_s)),
        .position_m = v3_muladd(from_m, v3_sub(to_m, from_m), part),
        .angles = { .pitch_rad = f_lerp(from->pitch_rad, to->pitch_rad, part) },
    };
}
