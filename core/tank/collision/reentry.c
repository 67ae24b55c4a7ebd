/* reentry.c -- handles fish that came back into the water (reentry). Such a fish drifts, is pushed
 * by other fish, searches for a gap between the other fish, and then swims. */
#include "core/tank/tank.h"

#include "core/base/panic.h"
#include "core/input.h"
#include "core/tank/collision/obstacle.h"

/* Largest initial speed of a fish that comes back into the water (reentry). The water absorbs any
 * higher speed immediately. */
#define SPEED_MAX_M_S 0.5f
#define DRAG_PER_S 6.0f
/* Speed at which a fish sinks after it came back into the water (reentry). */
#define SINK_M_S 0.03f
/* Largest distance per tick by which other fish and obstacles push a fish that came back into the
 * water (reentry). The value equals 0.3 m/s, the speed at which a fish slips between other fish. */
#define PUSH_MAX_M 0.0025f
/* Largest distance per tick by which a fish in reentry (a fish that came back into the water) moves
 * down if the fish is above the water surface, for example on the paper of a poi (paper scoop). */
#define FALL_MAX_M 0.010f
/* Speed at which a fish in reentry slides sideways off the paper of a poi (paper scoop), which
 * would otherwise lift the fish out of the water again. */
#define SLIDE_M_S 0.3f
/* Speed at which a swimming fish is pushed aside if a fish in reentry overlaps the swimming fish.
 * The value is also the upper limit of all pushes on the swimming fish. */
#define ASIDE_M_S 0.06f
#define HURRY_ALARM 0.5f
#define BURST_S 0.6f
/* Initial speed of a fish that bursts away at the end of its reentry, in body lengths per
 * second. */
#define BURST_LENGTHS 4.0f
#define SWIM_S 0.5f /* Time from the end of the reentry of a fish until it chooses its next gait. */

/* Number of ticks of reentry after which a fish that still overlaps other fish moves toward the
 * nearest gap between the other fish. Until then, only pushes separate the fish. */
#define SEEK_TICKS 16u
/* Number of ticks of reentry after which a fish is placed directly into the nearest gap between
 * other fish. */
#define PUT_TICKS 48u
/* Number of ticks between two searches for a gap between other fish that has room for the fish. */
#define AGAIN_TICKS 8u
#define SEEK_M_S 0.3f
/* Radius around a fish in reentry within which find_gap() searches for a gap between other fish:
 * about one body length. The radius must be below NEAR_PLANE_M (6 cm) of obstacle.c, because
 * obstacle.c ignores the paper of a poi at a larger distance, and the fish could then pass through
 * the paper. */
#define SEEK_M 0.05f
#define SEEK_SHELLS 14u

/* Returns the number of ticks since the fish came back into the water (reentry). */
static uint32_t loose_ticks(const struct fish *fish)
{
    return (uint32_t)(fish->gait_left_s * (float)CORE_TICK_HZ + 0.5f);
}

static bool is_loose(const struct fish *fish)
{
    return fish->gait == GAIT_HELD && fish->holder == FISH_HOLDER_WATER;
}

static float fish_reach_m(const struct fish *fish)
{
    return 0.5f * (fish->length_m + fish->height_m);
}

/* Moves the fish within the walls and above the floor. The body may reach the water surface, and
 * the fish's centre may reach the height `high_m` if that is higher. */
static void stay_within(const struct tank *tank, struct fish *fish, float high_m)
{
    const struct box box = fish_box(fish);
    const vec3 extent = box_extent_m(&box);
    const float room_x = 0.5f * tank->size_m.x - extent.x;
    const float room_z = 0.5f * tank->size_m.z - extent.z;
    fish->position_m.x = f_clamp(fish->position_m.x, -room_x, room_x);
    fish->position_m.z = f_clamp(fish->position_m.z, -room_z, room_z);
    fish->position_m.y =
        f_clamp(fish->position_m.y, extent.y - tank->size_m.y, f_max(high_m, -extent.y));
}

void reentry_begin(struct tank *tank, struct fish *fish, vec3 velocity_m_s)
{
    CORE_ASSERT(v3_is_finite(velocity_m_s));
    CORE_ASSERT(tank->reentry_count <= TANK_FISH_MAX);
    fish->gait = GAIT_HELD;
    fish->holder = FISH_HOLDER_WATER;
    fish->velocity_m_s = v3_limit(velocity_m_s, SPEED_MAX_M_S);
    fish->angles.pitch_rad = 0.0f;
    fish->angles.roll_rad = 0.0f;
    fish->yaw_rate_rad_s = 0.0f;
    fish->heading_rad = fish->angles.yaw_rad;
    fish->push_m_s = v3(0.0f, 0.0f, 0.0f);
    fish->gait_left_s = 0.0f;
    stay_within(tank, fish, fish->position_m.y); /* The present height of the fish is its upper
                                                    limit, so that a fish over the paper of a poi is
                                                    not pushed down through the paper. */
    tank->reentry_count++;
}

/* Moves the fish into the tank if it is outside. A fish above the surface comes down by at most
 * FALL_MAX_M per tick. */
static void lower_into_tank(const struct tank *tank, struct fish *fish)
{
    const float high_m = fish->position_m.y - FALL_MAX_M;
    stay_within(tank, fish, -1.0f);
    fish->position_m.y = f_max(fish->position_m.y, high_m);
}

/* Returns the gap between two fish. `there` is a fish in reentry, with the index `index`, at a pose
 * that is tested. The other fish has the index `other`. Returns a large gap if both indices are
 * equal, or if fish `other` does not swim or is not near. */
static struct box_gap gap_to_fish(const struct tank *tank, const struct fish *there, uint32_t index,
                                  uint32_t other)
{
    CORE_ASSERT(index < tank->fish_count && other < tank->fish_count);
    const struct fish *fish = &tank->fish[other];
    const vec3 d = v3_sub(fish->position_m, there->position_m);
    const float near_m = fish_reach_m(there) + fish_reach_m(fish);
    if (index == other || !fish_swims(fish) || v3_dot(d, d) > near_m * near_m) {
        return (struct box_gap){ .body_m = 1.0f };
    }
    const struct box box = fish_box(there), other_box = fish_box(fish);
    return box_gap(&box, 0.0f, &other_box, 0.0f);
}

/* Separates the fish from the swimming fish that it overlaps: adds the necessary pushes to
 * `push_m`, and pushes the swimming fish in the opposite direction. Returns true if the fish
 * overlaps no swimming fish. */
static bool part_from_fish(struct tank *tank, uint32_t index, vec3 *push_m)
{
    bool is_clear = true;
    for (uint32_t i = 0; i < tank->fish_count; i++) {
        struct fish *other = &tank->fish[i];
        const struct box_gap gap = gap_to_fish(tank, &tank->fish[index], index, i);
        if (gap.body_m < 0.0f) {
            *push_m = v3_muladd(*push_m, gap.axis, gap.body_m);
            other->push_m_s = v3_muladd(other->push_m_s, gap.axis, ASIDE_M_S);
            other->push_m_s = v3_limit(other->push_m_s, ASIDE_M_S);
            is_clear = false;
        }
    }
    return is_clear;
}

/* Adds the pushes that the obstacles (rings and paper of pois, hulls of bowls) give to a fish to
 * `push_m`. Returns true if the fish touches no obstacle. */
static bool part_from_obstacles(const struct fish *fish, vec3 before_m,
                                const struct obstacle *obstacles, uint32_t obstacle_count,
                                vec3 *push_m)
{
    const struct box box = fish_box(fish);
    const struct body body = body_of(&box, 0.0f);
    bool is_clear = true;
    for (uint32_t o = 0; o < obstacle_count; o++) {
        const vec3 off = obstacle_clear(&obstacles[o], &box);
        const vec3 paper = obstacle_paper_push(&obstacles[o], &body, before_m);
        if (v3_dot(off, off) + v3_dot(paper, paper) > 0.0f) {
            *push_m = v3_add(*push_m, v3_add(off, paper));
            is_clear = false;
        }
    }
    return is_clear;
}

/* Keeps a fish from passing through the paper of a moving poi if the fish has no room to move away.
 * Moves the fish along with the paper, even above the water surface. The fish later slides off over
 * the ring. Returns true if the fish was moved along. */
static bool keep_off_paper(struct fish *fish, vec3 before_m, const struct obstacle *obstacles,
                           uint32_t obstacle_count)
{
    bool is_held = false;
    for (uint32_t o = 0; o < obstacle_count; o++) {
        const struct box box = fish_box(fish);
        const struct body body = body_of(&box, 0.0f);
        const vec3 hold_m = obstacle_paper_hold(&obstacles[o], &body, before_m);
        if (v3_dot(hold_m, hold_m) > 0.0f) {
            const vec3 away = v3_sub(fish->position_m, obstacles[o].centre_m);
            const vec3 out = v3_normalize_or(v3_flat(away), v3(1.0f, 0.0f, 0.0f));
            fish->position_m = v3_add(fish->position_m, hold_m);
            fish->velocity_m_s = v3_scale(out, SLIDE_M_S);
            is_held = true;
        }
    }
    return is_held;
}

/* ---- Search for a gap between other fish ----------------------------------------------------- */

/* Finds the nearest place within SEEK_M at which the fish would touch no other fish and no
 * obstacle. The fish must not have to cross the paper of a poi on the way. Tries 26 directions at
 * SEEK_SHELLS distances. In a full tank a third of all places is free, so the smallest distances
 * usually contain a free place. Returns true and writes the place to `gap_m`, or returns false if
 * no place is free. */
static bool find_gap(const struct tank *tank, uint32_t index, const struct obstacle *obstacles,
                     uint32_t obstacle_count, vec3 *gap_m)
{
    CORE_ASSERT(index < tank->fish_count);
    const struct fish *fish = &tank->fish[index];
    for (uint32_t k = 0; k < 26u * SEEK_SHELLS; k++) {
        struct fish there = *fish;
        vec3 unused_m = { 0.0f, 0.0f, 0.0f };
        const float out_m = SEEK_M * (float)(k / 26u + 1u) / (float)SEEK_SHELLS;
        /* `which` selects one of 26 directions: from the middle cell of a 3 x 3 x 3 cube to each
         * other cell. */
        const uint32_t which = k % 26u;
        const uint32_t cell = which < 13u ? which : which + 1u;
        const vec3 way = v3((float)(cell % 3u) - 1.0f, (float)(cell / 9u) - 1.0f,
                            (float)(cell / 3u % 3u) - 1.0f);
        there.position_m = v3_muladd(fish->position_m, v3_normalize_or(way, way), out_m);
        stay_within(tank, &there, -1.0f);
        bool is_free =
            part_from_obstacles(&there, fish->position_m, obstacles, obstacle_count, &unused_m);
        for (uint32_t i = 0; i < tank->fish_count && is_free; i++) {
            is_free = gap_to_fish(tank, &there, index, i).body_m >= 0.0f;
        }
        if (is_free) {
            *gap_m = there.position_m;
            return true;
        }
    }
    return false;
}

static void swim_off(const struct tank *tank, struct fish *fish)
{
    const bool hurries = fish->alarm > HURRY_ALARM;
    const float half_m = 0.5f * fish->height_m;
    fish->gait = hurries ? GAIT_BURST : GAIT_SWIM;
    fish->gait_left_s = hurries ? BURST_S : SWIM_S;
    fish->speed_m_s = hurries ? BURST_LENGTHS * fish->length_m : 0.0f;
    fish->depth_goal_m =
        hurries ? f_max(-0.6f * tank->size_m.y, half_m - tank->size_m.y) : fish->position_m.y;
    fish->climb_m_s = 0.0f;
    fish->falls = false;
}

/* Searches for a free gap between the other fish in every AGAIN_TICKS-th tick, and turns the
 * velocity of the fish toward the nearest gap. After PUT_TICKS in reentry, places the fish into the
 * gap instead and ends its reentry. */
static void seek_gap(struct tank *tank, uint32_t index, const struct obstacle *obstacles,
                     uint32_t obstacle_count)
{
    CORE_ASSERT(is_loose(&tank->fish[index]));
    struct fish *fish = &tank->fish[index];
    const uint32_t ticks = loose_ticks(fish);
    vec3 gap_m;
    if (ticks % AGAIN_TICKS != 0 || !find_gap(tank, index, obstacles, obstacle_count, &gap_m)) {
        return;
    }
    if (ticks >= PUT_TICKS) {
        fish->position_m = gap_m;
        swim_off(tank, fish);
    } else {
        fish->velocity_m_s = v3_scale(
            v3_normalize_or(v3_sub(gap_m, fish->position_m), fish->velocity_m_s), SEEK_M_S);
    }
}

/* ---- One tick of a fish in reentry ----------------------------------------------------------- */

/* Moves a fish in reentry for one tick. Other fish push the fish until it has been in reentry for
 * SEEK_TICKS. Then the fish ignores their pushes, because they would push the fish away from the
 * gap that it moves to. */
static void move_dropped_fish(struct tank *tank, uint32_t index, const struct obstacle *obstacles,
                              uint32_t obstacle_count)
{
    CORE_ASSERT(is_loose(&tank->fish[index]));
    struct fish *fish = &tank->fish[index];
    const vec3 before_m = fish->position_m;
    vec3 fish_push_m = { 0.0f, 0.0f, 0.0f }, push_m = { 0.0f, 0.0f, 0.0f };
    fish->gait_left_s += CORE_TICK_S;
    fish->velocity_m_s = v3_scale(fish->velocity_m_s, 1.0f - DRAG_PER_S * CORE_TICK_S);
    fish->velocity_m_s.y -= SINK_M_S * DRAG_PER_S * CORE_TICK_S;
    fish->position_m = v3_muladd(fish->position_m, fish->velocity_m_s, CORE_TICK_S);
    lower_into_tank(tank, fish);
    const bool off_fish = part_from_fish(tank, index, &fish_push_m);
    const bool swims = fish->position_m.y < 0.0f;
    if (part_from_obstacles(fish, before_m, obstacles, obstacle_count, &push_m) && off_fish &&
        swims) {
        swim_off(tank, fish);
        return;
    }
    const bool seeks = loose_ticks(fish) >= SEEK_TICKS && swims;
    push_m = seeks ? push_m : v3_add(push_m, fish_push_m);
    if (swims) { /* Pushes move the fish only in the water. A fish above the water only slides off
                    the paper of a poi and over its ring. */
        fish->position_m = v3_add(fish->position_m, v3_limit(push_m, PUSH_MAX_M));
    }
    lower_into_tank(tank, fish);
    if (!keep_off_paper(fish, before_m, obstacles, obstacle_count) && seeks) {
        seek_gap(tank, index, obstacles, obstacle_count);
    }
}

void reentry_tick(struct tank *tank, const struct obstacle *obstacles, uint32_t obstacle_count)
{
    CORE_ASSERT(obstacle_count <= TANK_OBSTACLE_MAX);
    CORE_ASSERT(tank->fish_count <= TANK_FISH_MAX);
    uint32_t left = 0;
    for (uint32_t i = 0; i < tank->fish_count && tank->reentry_count > 0; i++) {
        if (is_loose(&tank->fish[i])) {
            move_dropped_fish(tank, i, obstacles, obstacle_count);
            left += is_loose(&tank->fish[i]);
        }
    }
    tank->reentry_count = left;
}
