/* targeting.c -- computes paths through the water and their costs. A cost is a time in seconds: the
 * time of the path, plus the expected time of another attempt if the first attempt may fail. */
#include "core/game/bot/bot.h"

#include "core/base/mem.h"
#include "core/base/panic.h"

#define WALL_ROOM_M 0.052f  /* Smallest distance from a tank wall to the ring's centre on a path. */
#define FLOOR_ROOM_M 0.012f /* Smallest distance from the tank floor to the ring on a path. */
#define BOWL_ROOM_M 0.050f
/* Height of the ring's lowest edge above the water at the start of a path, before the dip. */
#define CLEAR_M 0.010f
/* Additional distance between the ring and the fish at the stop point of the path, as a share of
 * the fish's length. At the stop point the ring waits beside the fish. */
#define BESIDE_SHARE 0.30f
/* Distance from the fish's centre to the part of the tail that would hit the paper, as a share of
 * the fish's length. */
#define TAIL_SHARE 0.42f
/* Distance outside the paper's edge at which the fish's tail should be, so that the tail does not
 * hit the paper. */
#define TAIL_OFF_M 0.003f
/* Smallest and largest distance of the fish's centre from the paper's centre, in ring radii, if the
 * fish is scooped near the rim. */
#define RIM_MIN 0.20f
#define RIM_MAX 0.45f
/* Smallest tilt of the paper at which the ring enters the water exactly along the paper's plane. At
 * a smaller tilt the path is steeper than the paper's plane. */
#define STEEP_RAD (35.0f * F_DEG)

/* Smallest and largest yaw of the poi's handle that a right hand can reach. At yaw 0 the handle
 * points toward the player. */
#define YAW_MIN_RAD (-1.2f)
#define YAW_MAX_RAD 1.6f
#define YAW_EASY_RAD 0.35f
static const float yaws_rad[] = { YAW_EASY_RAD, -0.30f, 0.90f, 1.45f, -0.80f };
#define YAW_COUNT (sizeof yaws_rad / sizeof yaws_rad[0])

/* Estimated time in seconds from the selection of a fish until the ring is under this fish. The bot
 * plans the path to the place that the fish will have reached after this time. */
#define START_S 0.60f
#define DEPTH_S_M 8.0f
#define SPEED_S_PER_M_S 4.0f
/* Cost in seconds for each metre by which a fish's length differs from the technique's preferred
 * length. */
#define LENGTH_S_M 10.0f
/* Cost in seconds if the ring first passes under the end of the fish (head or tail) that the
 * technique does not prefer. */
#define SIDE_S 2.50f
#define YAW_S_RAD 0.10f
/* Cost reduction in seconds for a fish that gulps air, because such a fish notices the poi late and
 * dives late. */
#define GULP_S 0.30f
#define NEIGHBOUR_M 0.030f
/* Cost reduction in seconds for each further fish near the target fish, because the bot can scoop
 * that fish on the same path. */
#define NEIGHBOUR_S 0.25f
/* Distance from a fish to another player's poi below which the fish costs RIVAL_S more, because the
 * other player probably catches the fish first. */
#define RIVAL_M 0.10f
#define RIVAL_S 0.60f /* Cost in seconds of another player's poi near the fish. */

vec3 targeting_forward(float yaw_rad)
{
    return v3(-f_sin(yaw_rad), 0.0f, -f_cos(yaw_rad));
}

/* ---- Paths of the poi to a fish -------------------------------------------------------------- */

static bool inside_walls(vec3 tank_m, vec3 point_m)
{
    return f_abs(point_m.x) < 0.5f * tank_m.x - WALL_ROOM_M &&
           f_abs(point_m.z) < 0.5f * tank_m.z - WALL_ROOM_M;
}

bool targeting_approach(const struct technique *technique, const struct snapshot *snapshot,
                        vec3 fish_m, float length_m, float yaw_rad, struct approach_path *way)
{
    const vec3 ahead = targeting_forward(yaw_rad), right = v3(-ahead.z, 0.0f, ahead.x);
    const struct snapshot_paper *paper = &snapshot->paper;
    const struct vision_bowl *bowl = &snapshot->bowl;
    /* Slope of the path below the water surface. With level paper the path leads straight down.
     * With a larger tilt, the path follows the plane of the paper more closely. */
    const float entry_rad = technique->entry_deg * F_DEG;
    const float slope =
        f_lerp(0.5f * F_PI, f_max(entry_rad, STEEP_RAD), f_min(entry_rad / STEEP_RAD, 1.0f));
    /* Intended place of the fish on the paper, in the poi's plane: x to the right, z toward the
     * handle. */
    const float radius_m = snapshot->poi.radius_m;
    const float rim_m = f_clamp(radius_m + TAIL_OFF_M - TAIL_SHARE * length_m, RIM_MIN * radius_m,
                                RIM_MAX * radius_m);
    const float x_m = paper->middle ? 0.0f : paper->x_m;
    const float z_m = !paper->middle ? paper->z_m : technique->place == PLACE_RIM ? -rim_m : 0.0f;
    CORE_ASSERT(slope > 0.0f && slope <= 0.5f * F_PI + 0.001f);
    way->yaw_rad = yaw_rad;
    way->under_m = v3_muladd(v3_muladd(fish_m, right, -x_m), ahead, z_m);
    way->under_m.y = f_max(fish_m.y - TARGETING_UNDER_M, FLOOR_ROOM_M - snapshot->tank_m.y);
    const float run_m = TARGETING_RING_M + BESIDE_SHARE * length_m + z_m;
    way->stop_m = v3_muladd(way->under_m, ahead, -run_m);
    way->entry_m = way->stop_m;
    way->entry_m.y = TARGETING_RING_M * f_sin(technique->entry_deg * F_DEG) + CLEAR_M;
    const float back_m = (way->entry_m.y - way->stop_m.y) * f_cos(slope) / f_sin(slope);
    way->entry_m = v3_muladd(way->entry_m, ahead, -back_m);
    /* The ring's path, seen from above, must not touch the bowl. */
    const vec3 from_m = way->entry_m, to_m = way->under_m;
    const float dx = to_m.x - from_m.x, dz = to_m.z - from_m.z;
    const float bx = bowl->position_m.x - from_m.x, bz = bowl->position_m.z - from_m.z;
    const float t = f_clamp((bx * dx + bz * dz) / f_max(dx * dx + dz * dz, 1e-9f), 0.0f, 1.0f);
    const float ex = bx - t * dx, ez = bz - t * dz;
    const float clear_m = bowl->radius_m + BOWL_ROOM_M;
    const bool clears_bowl = !bowl->present || ex * ex + ez * ez > clear_m * clear_m;
    return inside_walls(snapshot->tank_m, from_m) && inside_walls(snapshot->tank_m, to_m) &&
           clears_bowl && fish_m.y > to_m.y + 0.5f * TARGETING_UNDER_M;
}

/* ---- Costs of a fish and of a path ----------------------------------------------------------- */

static float flat_m(vec3 a, vec3 b)
{
    return v3_length(v3(a.x - b.x, 0.0f, a.z - b.z));
}

/* Returns the cost in seconds of a fish as the target. A deep or fast fish costs more, and a
 * gulping fish costs less; HUNT_CHASE ignores all three. An unwanted length and other players' pois
 * nearby increase the cost. Further fish around the fish reduce the cost. */
static float cost_of_fish(const struct technique *technique, const struct snapshot *snapshot,
                          const struct snapshot_fish *fish)
{
    const float hardness_s = -DEPTH_S_M * fish->position_m.y +
                             SPEED_S_PER_M_S * v3_length(fish->velocity_m_s) -
                             (fish->gulps ? GULP_S : 0.0f);
    float rivals_s = 0.0f;
    for (uint32_t i = 0; i < snapshot->rival_count; i++) {
        rivals_s += flat_m(snapshot->rival_m[i], fish->position_m) < RIVAL_M ? RIVAL_S : 0.0f;
    }
    uint32_t neighbours = 0;
    for (uint32_t i = 0; i < snapshot->near_count; i++) {
        const struct snapshot_fish *other = &snapshot->near[i];
        neighbours += other != fish && flat_m(other->position_m, fish->position_m) < NEIGHBOUR_M &&
                      other->position_m.y > fish->position_m.y - 0.5f * TARGETING_UNDER_M;
    }
    CORE_ASSERT(technique->fish_max >= 1);
    const uint32_t wanted = (uint32_t)technique->fish_max - 1u;
    return (technique->hunt == HUNT_CHASE ? 0.0f : hardness_s) +
           LENGTH_S_M * f_abs(fish->length_m - technique->fish_m) + rivals_s +
           -NEIGHBOUR_S * (float)(neighbours < wanted ? neighbours : wanted);
}

/* Returns the cost in seconds of the path `way`: the time of the arm's motion and a penalty for its
 * handle yaw. The yaw determines under which end of the fish the ring passes first. */
static float cost_of_way(const struct technique *technique, const struct snapshot *snapshot,
                         const struct snapshot_fish *fish, const struct approach_path *way,
                         vec3 hand_m)
{
    const float along =
        v3_dot(targeting_forward(fish->heading_rad), targeting_forward(way->yaw_rad));
    const float tail_first = 0.5f * (1.0f + along);
    const float side_s = technique->side == SIDE_HEAD   ? SIDE_S * tail_first
                         : technique->side == SIDE_TAIL ? SIDE_S * (1.0f - tail_first)
                                                        : 0.0f;
    const float yaw_s = side_s + YAW_S_RAD * f_abs(way->yaw_rad - YAW_EASY_RAD);
    CORE_ASSERT(technique->arm_m_s > 0.0f && technique->carry_m_s > 0.0f);
    return yaw_s + (flat_m(way->entry_m, hand_m) / technique->arm_m_s +
                    flat_m(way->under_m, snapshot->bowl.position_m) / technique->carry_m_s);
}

float targeting_yaw(const struct technique *technique, const struct snapshot_fish *fish,
                    float yaw_rad)
{
    CORE_ASSERT(technique->side < SIDE_COUNT);
    const float back_rad = technique->side == SIDE_HEAD ? F_PI : 0.0f;
    const float wanted_rad = f_wrap_angle(fish->heading_rad + back_rad);
    const bool fits =
        technique->side != SIDE_ANY && wanted_rad >= YAW_MIN_RAD && wanted_rad <= YAW_MAX_RAD;
    return fits ? wanted_rad : yaw_rad;
}

const struct snapshot_fish *targeting_choose(const struct technique *technique,
                                             const struct snapshot *snapshot, vec3 hand_m,
                                             float age_s, float *yaw_rad)
{
    const struct snapshot_fish *best = NULL;
    float best_s = 1e9f;
    CORE_ASSERT(snapshot->near_count <= SNAPSHOT_NEAR_MAX && snapshot->rival_count < POI_MAX);
    for (uint32_t i = 0; i < snapshot->near_count; i++) {
        const struct snapshot_fish *fish = &snapshot->near[i];
        const vec3 then_m = snapshot_predict(fish, age_s + START_S);
        /* Handle yaw with the lowest cost for this fish (`way_yaw_rad`), and the cost (`way_s`). */
        float way_yaw_rad = 0.0f, way_s = 1e9f;
        bool found = false;
        for (uint32_t k = 0; k <= YAW_COUNT; k++) {
            const float yaw =
                k < YAW_COUNT ? yaws_rad[k] : targeting_yaw(technique, fish, YAW_EASY_RAD);
            struct approach_path way;
            if (!targeting_approach(technique, snapshot, then_m, fish->length_m, yaw, &way)) {
                continue;
            }
            const float cost_s = cost_of_way(technique, snapshot, fish, &way, hand_m);
            if (!found || cost_s < way_s) {
                found = true;
                way_s = cost_s;
                way_yaw_rad = yaw;
            }
        }
        const float cost_s = way_s + cost_of_fish(technique, snapshot, fish);
        if (found && cost_s < best_s) {
            best_s = cost_s;
            best = fish;
            *yaw_rad = way_yaw_rad;
        }
    }
    return best;
}

const struct snapshot_fish *targeting_nearest(const struct snapshot *snapshot, vec3 ring_m,
                                              float reach_m)
{
    CORE_ASSERT(reach_m >= 0.0f && snapshot->near_count <= SNAPSHOT_NEAR_MAX);
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
