/* aim.c -- a person's eye: sees where fish are and how they move, not what they mean to do. */
#include "core/game/aim.h"

#include "core/core.h"
#include "core/game/paper.h"

#define CHOICE_ROOM_M 0.015f    /* More room than needed is wanted of a fish that will move on. */
#define SLANT_RUN 1.19175f      /* Forward for each metre down: 1 / tan(40 degrees). */
#define STOP_M 0.030f           /* It stops so far short of the fish, and glides the rest. */
#define RING_ROOM_M 0.052f      /* From a wall to the ring's centre. */
#define FLOOR_ROOM_M 0.034f     /* For the far edge of the slanted ring. */
#define TAIL_OFF 0.22f          /* The ring is ahead of the fish by this share of its length. */
#define CROWD_M 0.060f
#define FORESIGHT_S 0.25f

/* How a right hand can hold the handle: toward the player, and turned out to the right. */
static const float yaws_rad[] = { 0.35f, -0.30f, 0.90f, 1.45f };
#define YAW_COUNT (sizeof yaws_rad / sizeof yaws_rad[0])
#define YAW_EASY_RAD 0.35f

/* Costs are metres of way that a player would rather go. */
#define COST_DEPTH 12.0f        /* For each metre under water. */
#define COST_SPEED 3.0f         /* For each m/s. */
#define COST_LENGTH 1.0f        /* For each metre of fish: a big one tears the paper. */
#define COST_CROWD 0.30f        /* For each neighbour that would come along, or give the alarm. */
#define COST_TAIL_FIRST 0.10f
#define COST_YAW 0.06f          /* For each radian away from easy. */
#define COST_ALARM 0.30f

static vec3 forward_of(float yaw_rad)
{
    return v3(-f_sin(yaw_rad), 0.0f, -f_cos(yaw_rad));
}

static int inside_walls(const struct tank *tank, vec3 point_m, float room_m)
{
    return f_abs(point_m.x) < 0.5f * tank->size_m.x - room_m &&
           f_abs(point_m.z) < 0.5f * tank->size_m.z - room_m;
}

/* Whether the ring's way over the floor plan stays clear of a bowl. */
static int clears_bowl(const struct bowl *bowl, vec3 from_m, vec3 to_m, float room_m)
{
    const float dx = to_m.x - from_m.x, dz = to_m.z - from_m.z;
    const float bx = bowl->position_m.x - from_m.x, bz = bowl->position_m.z - from_m.z;
    const float t = f_clamp((bx * dx + bz * dz) / f_max(dx * dx + dz * dz, 1e-9f), 0.0f, 1.0f);
    const float ex = bx - t * dx, ez = bz - t * dz;
    const float clear_m = BOWL_RADIUS_M + room_m;
    return !bowl->present || ex * ex + ez * ez > clear_m * clear_m;
}

vec3 aim_foresee(const struct core *core, uint32_t fish, float ahead_s)
{
    const struct fish *seen = &core->tank.fish[fish];
    return v3_mad(seen->position_m, seen->velocity_m_s, ahead_s);
}

/* The ring's centre such that the fish lies on the best paper, its tail toward the rim. */
static vec3 ring_under(const struct core *core, uint32_t poi, uint32_t fish, float yaw_rad)
{
    const struct fish *seen = &core->tank.fish[fish];
    const vec3 nose = forward_of(seen->angles.yaw_rad);
    const vec3 ahead = forward_of(yaw_rad);
    const vec3 right = v3(-ahead.z, 0.0f, ahead.x);
    float x_m = 0.0f;
    float z_m = 0.0f;
    (void)paper_spot(&core->poi[poi].sheet, &x_m, &z_m);
    vec3 centre = aim_foresee(core, fish, FORESIGHT_S);
    if (x_m == 0.0f && z_m == 0.0f) {
        centre = v3_mad(centre, nose, TAIL_OFF * seen->length_m);
    }
    centre = v3_mad(v3_mad(centre, right, -x_m), ahead, z_m);
    centre.y = f_max(centre.y - AIM_UNDER_M, -core->tank.size_m.y + FLOOR_ROOM_M);
    return centre;
}

/* Fills `way` and says whether it keeps `room_m` from walls and bowl. */
static int lay_way(const struct core *core, uint32_t poi, uint32_t fish, float yaw_rad,
                   float room_m, struct way_in *way)
{
    const vec3 ahead = forward_of(yaw_rad);
    way->under_m = ring_under(core, poi, fish, yaw_rad);
    way->stop_m = v3_mad(way->under_m, ahead, -STOP_M);
    way->entry_m = v3_mad(way->stop_m, ahead, -SLANT_RUN * (AIM_ENTRY_Y_M - way->stop_m.y));
    way->entry_m.y = AIM_ENTRY_Y_M;
    return inside_walls(&core->tank, way->entry_m, room_m) &&
           inside_walls(&core->tank, way->under_m, room_m) &&
           clears_bowl(&core->bowl[poi], way->entry_m, way->under_m, room_m) &&
           core->tank.fish[fish].position_m.y > way->under_m.y + 0.5f * AIM_UNDER_M;
}

int aim_way_in(const struct core *core, uint32_t poi, uint32_t fish, float yaw_rad,
               struct way_in *way)
{
    return lay_way(core, poi, fish, yaw_rad, RING_ROOM_M, way);
}

static int is_calm(const struct fish *fish)
{
    return fish->gait < GAIT_HELD && fish->gait != GAIT_ESCAPE && fish->gait != GAIT_BURST;
}

static float cost_of_fish(const struct fish *fish, vec3 hand_m)
{
    const vec3 way = v3(fish->position_m.x - hand_m.x, 0.0f, fish->position_m.z - hand_m.z);
    return v3_length(way) - COST_DEPTH * fish->position_m.y +
           COST_SPEED * v3_length(fish->velocity_m_s) + COST_LENGTH * fish->length_m +
           COST_ALARM * fish->alarm;
}

static float cost_of_crowd(const struct tank *tank, uint32_t index)
{
    float cost = 0.0f;
    for (uint32_t i = 0; i < tank->fish_count; i++) {
        const vec3 d = v3_sub(tank->fish[i].position_m, tank->fish[index].position_m);
        if (i != index && d.x * d.x + d.z * d.z < CROWD_M * CROWD_M && d.y > -AIM_UNDER_M) {
            cost += COST_CROWD;
        }
    }
    return cost;
}

/* The cheapest hand for a fish, if any is free. */
static int choose_yaw(const struct core *core, uint32_t poi, uint32_t fish, float *yaw_rad,
                      float *cost)
{
    const vec3 nose = forward_of(core->tank.fish[fish].angles.yaw_rad);
    int found = 0;
    for (uint32_t i = 0; i < YAW_COUNT; i++) {
        struct way_in way;
        const float tail_first = 0.5f * (1.0f + v3_dot(nose, forward_of(yaws_rad[i])));
        const float strain_rad = f_abs(yaws_rad[i] - YAW_EASY_RAD);
        const float price = COST_TAIL_FIRST * tail_first + COST_YAW * strain_rad;
        if ((!found || price < *cost) &&
            lay_way(core, poi, fish, yaws_rad[i], RING_ROOM_M + CHOICE_ROOM_M, &way)) {
            found = 1;
            *cost = price;
            *yaw_rad = yaws_rad[i];
        }
    }
    return found;
}

uint16_t aim_choose(const struct core *core, uint32_t poi, vec3 hand_m, float *yaw_rad)
{
    uint16_t best = AIM_NO_FISH;
    float best_cost = 1e9f;
    for (uint32_t i = 0; i < core->tank.fish_count; i++) {
        const struct fish *fish = &core->tank.fish[i];
        float cost = cost_of_fish(fish, hand_m);
        if (!is_calm(fish) || cost >= best_cost) {
            continue; /* The dear questions are put only to what is cheap so far. */
        }
        float yaw = 0.0f;
        float yaw_cost = 0.0f;
        cost += cost_of_crowd(&core->tank, i);
        if (cost < best_cost && choose_yaw(core, poi, i, &yaw, &yaw_cost) &&
            cost + yaw_cost < best_cost) {
            best = (uint16_t)i;
            best_cost = cost + yaw_cost;
            *yaw_rad = yaw;
        }
    }
    return best;
}

uint16_t aim_over_ring(const struct core *core, uint32_t poi, float reach_m)
{
    const vec3 ring = core->poi[poi].position_m;
    uint16_t best = AIM_NO_FISH;
    float best_square = reach_m * reach_m;
    for (uint32_t i = 0; i < core->tank.fish_count; i++) {
        const struct fish *fish = &core->tank.fish[i];
        const vec3 d = v3_sub(fish->position_m, ring);
        const float square = d.x * d.x + d.z * d.z;
        if (is_calm(fish) && d.y > 0.0f && square < best_square) {
            best = (uint16_t)i;
            best_square = square;
        }
    }
    return best;
}
