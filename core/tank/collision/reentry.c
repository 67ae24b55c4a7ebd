/* reentry.c -- reentry of fish into the water: drift, pushes, the search for a gap, and the end of
 * reentry. */
#include "core/tank/tank.h"

#include "core/base/panic.h"
#include "core/input.h"
#include "core/tank/collision/obstacle.h"

/* Largest initial speed of a fish in reentry. The water absorbs any higher speed immediately. */
#define SPEED_MAX_M_S 0.5f
#define DRAG_PER_S 6.0f
#define SINK_M_S 0.03f /* Speed at which a fish in reentry sinks. */
/* Largest push per tick on a fish in reentry. The value equals 0.3 m/s, the speed of a fish that
 * slips between other fish. */
#define PUSH_MAX_M 0.0025f
/* Largest descent per tick of a fish that slides off paper above the water. */
#define FALL_MAX_M 0.010f
/* Speed at which a fish slides off paper that would otherwise lift it. */
#define SLIDE_M_S 0.3f
/* Initial speed of a fish that bursts away at the end of its reentry, in body lengths per
 * second. */
#define ASIDE_M_S 0.06f
#define HURRY_ALARM 0.5f
#define BURST_S 0.6f
/* Initial speed of a fish that bursts away, in body lengths per second. */
#define BURST_LENGTHS 4.0f
#define SWIM_S 0.5f /* Time after reentry until the fish chooses its next gait. */

/* Ticks in which only pushes move a fish in reentry. Afterwards the fish moves toward the nearest
 * gap between other fish. */
#define SEEK_TICKS 16u
/* Ticks after which a fish in reentry is placed directly into the nearest gap between other
 * fish. */
#define PUT_TICKS 48u
#define AGAIN_TICKS 8u /* Ticks between two searches for a gap between other fish. */
#define SEEK_M_S 0.3f
/* Largest distance from a fish in reentry to a gap between other fish: about one body length.
 * obstacle.c detects paper on the way only within 6 cm. */
#define SEEK_M 0.05f
#define SEEK_SHELLS 14u

/* Returns the ticks since the fish came back into the water. */
static uint32_t loose_ticks(const struct fish *fish)
{
    return (uint32_t)(fish->gait_left_s * (float)CORE_TICK_HZ + 0.5f);
}

static int is_loose(const struct fish *fish)
{
    return fish->gait == GAIT_HELD && fish->holder == FISH_HOLDER_WATER;
}

static float fish_reach_m(const struct fish *fish)
{
    return 0.5f * (fish->length_m + fish->height_m);
}

/* Keeps the fish within the walls and above the floor. The upper limit is just below the surface,
 * or `high_m` if `high_m` is higher. */
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

static void stay_in_tank(const struct tank *tank, struct fish *fish)
{
    stay_within(tank, fish, -1.0f);
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
    stay_within(tank, fish, fish->position_m.y); /* The limit is the fish's present height, so that
                                                    a fish over paper is not pushed down through the
                                                    paper. */
    tank->reentry_count++;
}

/* Keeps the fish within the tank. A fish above the surface comes down by FALL_MAX_M per tick at
 * most. */
static void come_down(const struct tank *tank, struct fish *fish)
{
    const float high_m = fish->position_m.y - FALL_MAX_M;
    stay_in_tank(tank, fish);
    fish->position_m.y = f_max(fish->position_m.y, high_m);
}

/* Separates the fish from the swimming fish that it overlaps: adds the necessary pushes to
 * `push_m`, and pushes the swimming fish in the opposite direction. Returns 1 if the fish overlaps
 * no swimming fish, otherwise 0. */
static int part_from_fish(struct tank *tank, uint32_t index, vec3 *push_m)
{
    CORE_ASSERT(index < tank->fish_count);
    struct fish *fish = &tank->fish[index];
    const struct box box = fish_box(fish);
    int clear = 1;
    for (uint32_t i = 0; i < tank->fish_count; i++) {
        struct fish *other = &tank->fish[i];
        const vec3 d = v3_sub(other->position_m, fish->position_m);
        const float near_m = fish_reach_m(fish) + fish_reach_m(other);
        if (i == index || !fish_swims(other) || v3_dot(d, d) > near_m * near_m) {
            continue;
        }
        const struct box other_box = fish_box(other);
        const struct box_gap gap = box_gap(&box, 0.0f, &other_box, 0.0f);
        if (gap.body_m < 0.0f) {
            *push_m = v3_muladd(*push_m, gap.axis, gap.body_m);
            other->push_m_s = v3_muladd(other->push_m_s, gap.axis, ASIDE_M_S);
            other->push_m_s = v3_limit(other->push_m_s, ASIDE_M_S);
            clear = 0;
        }
    }
    return clear;
}

/* Adds the pushes by rings, paper and hulls to `push_m`. Returns 1 if the fish touches no obstacle,
 * otherwise 0. */
static int part_from_obstacles(const struct fish *fish, vec3 before_m,
                               const struct obstacle *obstacles, uint32_t obstacle_count,
                               vec3 *push_m)
{
    const struct box box = fish_box(fish);
    const struct body body = body_of(&box, 0.0f);
    int clear = 1;
    for (uint32_t o = 0; o < obstacle_count; o++) {
        const vec3 off = obstacle_clear(&obstacles[o], &box);
        const vec3 paper = obstacle_paper_push(&obstacles[o], &body, before_m);
        if (v3_dot(off, off) + v3_dot(paper, paper) > 0.0f) {
            *push_m = v3_add(*push_m, v3_add(off, paper));
            clear = 0;
        }
    }
    return clear;
}

/* Handles a fish that touches the paper of a moving poi and has no room to move away. Moves the
 * fish along with the paper, even above the water surface. The fish later slides off over the ring,
 * so no fish passes through paper. Returns 1 if the fish was moved along, otherwise 0. */
static int keep_off_paper(struct fish *fish, vec3 before_m, const struct obstacle *obstacles,
                          uint32_t obstacle_count)
{
    int held = 0;
    for (uint32_t o = 0; o < obstacle_count; o++) {
        const struct box box = fish_box(fish);
        const struct body body = body_of(&box, 0.0f);
        const vec3 hold_m = obstacle_paper_hold(&obstacles[o], &body, before_m);
        if (v3_dot(hold_m, hold_m) > 0.0f) {
            const vec3 away = v3_sub(fish->position_m, obstacles[o].centre_m);
            const vec3 out = v3_normalize_or(v3(away.x, 0.0f, away.z), v3(1.0f, 0.0f, 0.0f));
            fish->position_m = v3_add(fish->position_m, hold_m);
            fish->velocity_m_s = v3_scale(out, SLIDE_M_S);
            held = 1;
        }
    }
    return held;
}

/* ---- Search for gaps ------------------------------------------------------------------------- */

static int meets_fish(const struct tank *tank, uint32_t index, const struct fish *there)
{
    CORE_ASSERT(index < tank->fish_count);
    const struct box box = fish_box(there);
    for (uint32_t i = 0; i < tank->fish_count; i++) {
        const struct fish *other = &tank->fish[i];
        const vec3 d = v3_sub(other->position_m, there->position_m);
        const float near_m = fish_reach_m(there) + fish_reach_m(other);
        if (i == index || v3_dot(d, d) > near_m * near_m || !fish_swims(other)) {
            continue;
        }
        const struct box other_box = fish_box(other);
        if (box_gap(&box, 0.0f, &other_box, 0.0f).body_m < 0.0f) {
            return 1;
        }
    }
    return 0;
}

/* Finds the nearest place within SEEK_M that is free of fish and obstacles and on the fish's side
 * of every paper. Tries 26 directions at SEEK_SHELLS distances. In a full tank a third of all
 * places is free, so the smallest distances usually contain a free place. Returns 1 and writes the
 * place to `gap_m`, or returns 0 if no place is free. */
static int find_gap(const struct tank *tank, uint32_t index, const struct obstacle *obstacles,
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
        stay_in_tank(tank, &there);
        if (part_from_obstacles(&there, fish->position_m, obstacles, obstacle_count, &unused_m) &&
            !meets_fish(tank, index, &there)) {
            *gap_m = there.position_m;
            return 1;
        }
    }
    return 0;
}

static void swim_off(const struct tank *tank, struct fish *fish)
{
    const int hurries = fish->alarm > HURRY_ALARM;
    const float half_m = 0.5f * fish->height_m;
    fish->gait = hurries ? GAIT_BURST : GAIT_SWIM;
    fish->gait_left_s = hurries ? BURST_S : SWIM_S;
    fish->speed_m_s = hurries ? BURST_LENGTHS * fish->length_m : 0.0f;
    fish->depth_goal_m =
        hurries ? f_max(-0.6f * tank->size_m.y, half_m - tank->size_m.y) : fish->position_m.y;
    fish->climb_m_s = 0.0f;
    fish->falls = 0;
}

/* Moves a fish toward the nearest gap if the pushes did not free it within SEEK_TICKS. After
 * PUT_TICKS, places the fish into the gap. */
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

/* ---- Advancing by a tick --------------------------------------------------------------------- */

/* Moves a fish in reentry. A fish on its way to a gap ignores the pushes by other fish, because
 * they would lead it away from the gap. */
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
    come_down(tank, fish);
    const int off_fish = part_from_fish(tank, index, &fish_push_m);
    const int swims = fish->position_m.y < 0.0f;
    if (part_from_obstacles(fish, before_m, obstacles, obstacle_count, &push_m) && off_fish &&
        swims) {
        swim_off(tank, fish);
        return;
    }
    const int seeks = loose_ticks(fish) >= SEEK_TICKS && swims;
    push_m = seeks ? push_m : v3_add(push_m, fish_push_m);
    if (swims) { /* Above the water the fish only slides over the ring and ignores all other
                    pushes. */
        fish->position_m = v3_add(fish->position_m, v3_limit(push_m, PUSH_MAX_M));
    }
    come_down(tank, fish);
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
            left += (uint32_t)is_loose(&tank->fish[i]);
        }
    }
    tank->reentry_count = left;
}
