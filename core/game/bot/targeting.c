/* targeting.c -- computes paths through the water and their costs. A cost is a time in seconds: the
 * time of the path, plus the expected time of another attempt if the first attempt may fail. */
#include "core/game/bot/targeting.h"

#include "core/base/mem.h"

#define WALL_ROOM_M 0.052f  /* Smallest distance from a wall to the ring's centre. */
#define FLOOR_ROOM_M 0.012f /* Smallest distance from the floor to the ring. */
#define BOWL_ROOM_M 0.050f
/* Height of the ring's lowest edge above the water before the dip. */
#define CLEAR_M 0.010f
/* Distance of the stop point from the fish's centre beyond the ring's radius, as a share of the
 * fish's length. */
#define BESIDE_SHARE 0.30f
/* Distance from the fish's centre to the part of the tail that hits the paper, as a share of the
 * fish's length. */
#define TAIL_SHARE 0.42f
#define TAIL_OFF_M 0.003f /* Distance of the tail outside the paper's edge. */
/* Smallest and largest distance of the fish's centre from the paper's centre, in ring radii. */
#define RIM_MIN 0.20f
#define RIM_MAX 0.45f
/* Entry angle from which the ring enters the water along the paper's plane. */
#define STEEP_RAD (35.0f * F_DEG)

/* Range of handle yaws for a right hand. At 0 the handle points toward the player. */
#define YAW_MIN_RAD (-1.2f)
#define YAW_MAX_RAD 1.6f
#define YAW_EASY_RAD 0.35f
static const float yaws_rad[] = { YAW_EASY_RAD, -0.30f, 0.90f, 1.45f, -0.80f };
#define YAW_COUNT (sizeof yaws_rad / sizeof yaws_rad[0])

#define START_S 0.60f /* Time that is added to the path time until the ring is under the fish. */
#define DEPTH_S_M 8.0f
#define SPEED_S_PER_M_S 4.0f
/* Cost in seconds per metre of difference from the preferred fish length. */
#define LENGTH_S_M 10.0f
/* Cost of passing first under the end of the fish that the technique does not prefer. */
#define SIDE_S 2.50f
#define YAW_S_RAD 0.10f
/* Cost reduction for a gulping fish, because the fish notices the poi late and dives late. */
#define GULP_S 0.30f
#define COMPANY_M 0.030f
/* Cost reduction for each further fish nearby, because it needs no complete path of its own. */
#define COMPANY_S 0.25f
#define RIVAL_M 0.10f /* Distance at which another player's poi interferes. */
#define RIVAL_S 0.60f /* Cost of a nearby poi of another player. */

vec3 targeting_forward(float yaw_rad)
{
    return v3(-f_sin(yaw_rad), 0.0f, -f_cos(yaw_rad));
}

/* ---- Paths ---------------------------------------------------------------------------------- */

/* Chooses the place of the fish on the paper, in the poi's plane: x to the right, z toward the
 * handle. */
static void choose_place(const struct technique *technique, const struct snapshot *snapshot,
                         float length_m, float *x_m, float *z_m)
{
    const float radius_m = snapshot->poi.radius_m;
    const float rim = f_clamp(radius_m + TAIL_OFF_M - TAIL_SHARE * length_m, RIM_MIN * radius_m,
                              RIM_MAX * radius_m);
    *x_m = snapshot->paper.middle ? 0.0f : snapshot->paper.x_m;
    *z_m = snapshot->paper.middle ? 0.0f : snapshot->paper.z_m;
    if (snapshot->paper.middle && technique->place == PLACE_RIM) {
        *z_m = -rim;
    }
}

/* Returns the angle of the path below the water surface. With level paper the path goes straight
 * down. With more tilt the path follows the paper's plane more closely. */
static float slope_rad(const struct technique *technique)
{
    const float entry_rad = technique->entry_deg * F_DEG;
    const float share = f_min(entry_rad / STEEP_RAD, 1.0f);
    return f_lerp(0.5f * F_PI, f_max(entry_rad, STEEP_RAD), share);
}

static int inside_walls(vec3 tank_m, vec3 point_m)
{
    return f_abs(point_m.x) < 0.5f * tank_m.x - WALL_ROOM_M &&
           f_abs(point_m.z) < 0.5f * tank_m.z - WALL_ROOM_M;
}

/* Returns 1 if the ring's path, seen from above, does not touch the bowl, otherwise 0. */
static int clears_bowl(const struct vision_bowl *bowl, vec3 from_m, vec3 to_m)
{
    const float dx = to_m.x - from_m.x, dz = to_m.z - from_m.z;
    const float bx = bowl->position_m.x - from_m.x, bz = bowl->position_m.z - from_m.z;
    const float t = f_clamp((bx * dx + bz * dz) / f_max(dx * dx + dz * dz, 1e-9f), 0.0f, 1.0f);
    const float ex = bx - t * dx, ez = bz - t * dz;
    const float clear_m = bowl->radius_m + BOWL_ROOM_M;
    return !bowl->present || ex * ex + ez * ez > clear_m * clear_m;
}

int targeting_approach(const struct technique *technique, const struct snapshot *snapshot,
                       vec3 fish_m, float length_m, float yaw_rad, struct approach_path *way)
{
    const vec3 ahead = targeting_forward(yaw_rad), right = v3(-ahead.z, 0.0f, ahead.x);
    const float slope = slope_rad(technique);
    float x_m, z_m;
    choose_place(technique, snapshot, length_m, &x_m, &z_m);
    const float deepest_m = FLOOR_ROOM_M - snapshot->tank_m.y;
    way->yaw_rad = yaw_rad;
    way->under_m = v3_muladd(v3_muladd(fish_m, right, -x_m), ahead, z_m);
    way->under_m.y = f_max(fish_m.y - TARGETING_UNDER_M, deepest_m);
    const float run_m = TARGETING_RING_M + BESIDE_SHARE * length_m + z_m;
    way->stop_m = v3_muladd(way->under_m, ahead, -run_m);
    way->entry_m = way->stop_m;
    way->entry_m.y = TARGETING_RING_M * f_sin(technique->entry_deg * F_DEG) + CLEAR_M;
    const float back_m = (way->entry_m.y - way->stop_m.y) * f_cos(slope) / f_sin(slope);
    way->entry_m = v3_muladd(way->entry_m, ahead, -back_m);
    return inside_walls(snapshot->tank_m, way->entry_m) &&
           inside_walls(snapshot->tank_m, way->under_m) &&
           clears_bowl(&snapshot->bowl, way->entry_m, way->under_m) &&
           fish_m.y > way->under_m.y + 0.5f * TARGETING_UNDER_M;
}

/* ---- Costs ---------------------------------------------------------------------------------- */

static float flat_m(vec3 a, vec3 b)
{
    return v3_length(v3(a.x - b.x, 0.0f, a.z - b.z));
}

static float company_s(const struct technique *technique, const struct snapshot *snapshot,
                       const struct snapshot_fish *fish)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < snapshot->near_count; i++) {
        const struct snapshot_fish *other = &snapshot->near[i];
        count += other != fish && flat_m(other->position_m, fish->position_m) < COMPANY_M &&
                 other->position_m.y > fish->position_m.y - 0.5f * TARGETING_UNDER_M;
    }
    const uint32_t wanted = (uint32_t)technique->fish_max - 1u;
    return -COMPANY_S * (float)(count < wanted ? count : wanted);
}

static float rivals_s(const struct snapshot *snapshot, vec3 fish_m)
{
    float cost_s = 0.0f;
    for (uint32_t i = 0; i < snapshot->rival_count; i++) {
        cost_s += flat_m(snapshot->rival_m[i], fish_m) < RIVAL_M ? RIVAL_S : 0.0f;
    }
    return cost_s;
}

/* Returns the cost of a fish's depth and speed, reduced if the fish gulps. HUNT_CHASE ignores this
 * cost. */
static float hardness_s(const struct snapshot_fish *fish)
{
    return -DEPTH_S_M * fish->position_m.y + SPEED_S_PER_M_S * v3_length(fish->velocity_m_s) -
           (fish->gulps ? GULP_S : 0.0f);
}

static float cost_of_fish(const struct technique *technique, const struct snapshot *snapshot,
                          const struct snapshot_fish *fish)
{
    return (technique->hunt == HUNT_CHASE ? 0.0f : hardness_s(fish)) +
           LENGTH_S_M * f_abs(fish->length_m - technique->fish_m) +
           rivals_s(snapshot, fish->position_m) + company_s(technique, snapshot, fish);
}

/* Returns the cost of handle yaw `yaw_rad`. The yaw determines under which end of the fish the ring
 * passes first. */
static float cost_of_yaw(const struct technique *technique, const struct snapshot_fish *fish,
                         float yaw_rad)
{
    const float along = v3_dot(targeting_forward(fish->heading_rad), targeting_forward(yaw_rad));
    const float tail_first = 0.5f * (1.0f + along);
    const float side_s = technique->side == SIDE_HEAD   ? SIDE_S * tail_first
                         : technique->side == SIDE_TAIL ? SIDE_S * (1.0f - tail_first)
                                                        : 0.0f;
    return side_s + YAW_S_RAD * f_abs(yaw_rad - YAW_EASY_RAD);
}

static float cost_of_way(const struct technique *technique, const struct snapshot *snapshot,
                         const struct approach_path *way, vec3 hand_m)
{
    return flat_m(way->entry_m, hand_m) / technique->arm_m_s +
           flat_m(way->under_m, snapshot->bowl.position_m) / technique->carry_m_s;
}

float targeting_yaw(const struct technique *technique, const struct snapshot_fish *fish,
                    float yaw_rad)
{
    const float back_rad = technique->side == SIDE_HEAD ? F_PI : 0.0f;
    const float wanted_rad = f_wrap_angle(fish->heading_rad + back_rad);
    const int fits =
        technique->side != SIDE_ANY && wanted_rad >= YAW_MIN_RAD && wanted_rad <= YAW_MAX_RAD;
    return fits ? wanted_rad : yaw_rad;
}

/* Finds the handle yaw with the lowest cost for one fish. Returns 1, or 0 if no yaw leaves room for
 * a path. */
static int choose_yaw(const struct technique *technique, const struct snapshot *snapshot,
                      vec3 hand_m, const struct snapshot_fish *fish, float age_s, float *yaw_rad,
                      float *cost_s)
{
    const vec3 then_m = snapshot_predict(fish, age_s + START_S);
    int found = 0;
    for (uint32_t i = 0; i <= YAW_COUNT; i++) {
        const float yaw =
            i < YAW_COUNT ? yaws_rad[i] : targeting_yaw(technique, fish, YAW_EASY_RAD);
        struct approach_path way;
        if (!targeting_approach(technique, snapshot, then_m, fish->length_m, yaw, &way)) {
            continue;
        }
        const float price_s =
            cost_of_yaw(technique, fish, yaw) + cost_of_way(technique, snapshot, &way, hand_m);
        if (!found || price_s < *cost_s) {
            found = 1;
            *cost_s = price_s;
            *yaw_rad = yaw;
        }
    }
    return found;
}

const struct snapshot_fish *targeting_choose(const struct technique *technique,
                                             const struct snapshot *snapshot, vec3 hand_m,
                                             float age_s, float *yaw_rad)
{
    const struct snapshot_fish *best = NULL;
    float best_s = 1e9f;
    for (uint32_t i = 0; i < snapshot->near_count; i++) {
        const struct snapshot_fish *fish = &snapshot->near[i];
        float yaw = 0.0f, way_s = 0.0f;
        if (choose_yaw(technique, snapshot, hand_m, fish, age_s, &yaw, &way_s)) {
            const float cost_s = way_s + cost_of_fish(technique, snapshot, fish);
            if (cost_s < best_s) {
                best_s = cost_s;
                best = fish;
                *yaw_rad = yaw;
            }
        }
    }
    return best;
}

const struct snapshot_fish *targeting_nearest(const struct snapshot *snapshot, vec3 ring_m,
                                              float reach_m)
{
    const struct snapshot_fish *best = NULL;
    for (uint32_t i = 0; i < snapshot->near_count; i++) {
        const struct snapshot_fish *fish = &snapshot->near[i];
        const float away_m = flat_m(fish->position_m, ring_m);
        if (fish->position_m.y > ring_m.y && away_m < reach_m) {
            best = fish;
            reach_m = away_m;
        }
    }
    return best;
}
