/* sim_player.c -- the state machine of a simulated player. Each state has a function that sets the
 * command to the input device and returns the next state. */
#include "tests/bench/players/sim_player.h"

#include "core/base/panic.h"
#include "core/base/rng.h"
#include "core/view.h"
#include "drivers/pointer/pointer_poi.h"

/* Number of frames between the two pictures from which the player estimates the speed of a fish. */
#define SPEED_FRAMES 6u
/* Smallest distance of a fish from a wall (WALL_ROOM_M) and from the rim of a bowl (BOWL_ROOM_M) at
 * which the player chooses the fish. */
#define WALL_ROOM_M 0.05f
#define BOWL_ROOM_M 0.05f
/* If a fish that lies on paper is within this distance of the player's ring, the fish lies on the
 * player's own paper. */
#define OWN_CATCH_M 0.12f
/* Longest time in seconds in which the player tries to empty the poi over the bowl. */
#define CARRY_S 6.0f
#define TIP_PX 60.0f /* Distance from the bowl in pixels at which the player tips the poi. */

/* ---- What the player sees -------------------------------------------------------------------- */

void sim_player_to_screen(const struct view *view, vec3 point_m, float *x_px, float *y_px)
{
    const struct basis axes = view_basis(view);
    const vec3 body = vec_basis_to_body(&axes, v3_sub(point_m, view->eye_m));
    const float aspect = PLAYER_WIDTH_PX / PLAYER_HEIGHT_PX;
    const float tan_y = view_half_height_tan(view, aspect);
    CORE_ASSERT(body.z < 0.0f);
    *x_px = 0.5f * (body.x / -body.z / (tan_y * aspect) + 1.0f) * PLAYER_WIDTH_PX;
    *y_px = 0.5f * (1.0f - body.y / -body.z / tan_y) * PLAYER_HEIGHT_PX;
}

void sim_player_see(const struct scene *scene, uint32_t slot, struct sight *sight)
{
    CORE_ASSERT(scene->fish_count <= PLAYER_FISH_MAX && slot < POI_MAX);
    *sight = (struct sight){
        .in_round = scene->phase == PHASE_ROUND,
        .hint = scene->lesson[slot].hint,
        .has_arrow = scene->lesson[slot].points_to_bowl,
        .has_ghost = scene->lesson[slot].ghost.is_present,
        .marked = scene->lesson[slot].marks_fish ? scene->lesson[slot].fish : PLAYER_NO_FISH,
        .ring_m = scene->poi[slot].position_m,
        .bowl_m = scene->bowl[slot].position_m,
        .bowl_radius_m = scene->bowl[slot].radius_m,
        .tank_m = scene->tank_size_m,
        .fish_count = scene->fish_count,
    };
    for (uint32_t i = 0; i < scene->fish_count; i++) {
        const struct scene_fish *fish = &scene->fish[i];
        sight->fish[i] = (struct sight_fish){
            .position_m = fish->position_m,
            .length_m = fish->length_m,
            .swims = fish->place == SCENE_IN_TANK,
        };
        const vec3 off_m = v3_sub(fish->position_m, sight->ring_m);
        sight->has_catch |=
            fish->place == SCENE_ON_POI && v3_dot(off_m, off_m) < OWN_CATCH_M * OWN_CATCH_M;
    }
    for (uint32_t i = 0; i < POI_MAX; i++) {
        if (i != slot && scene->bowl[i].present) {
            sight->other_bowls_m[sight->other_bowl_count++] = scene->bowl[i].position_m;
        }
    }
}

/* Returns the picture that the player saw `frames` frames ago, or the oldest picture in the
 * buffer. */
static const struct sight *sight_before(const struct sim_player *player, uint32_t frames)
{
    const uint32_t seen = player->frame - 1u;
    const uint32_t back = frames < seen ? frames : seen;
    CORE_ASSERT(player->frame > 0 && frames < PLAYER_SIGHT_MAX);
    return &player->sights[(seen - back) % PLAYER_SIGHT_MAX];
}

static uint32_t reaction_frames(const struct sim_player *player)
{
    return (uint32_t)(player->habits->reaction_s * (float)PLAYER_HZ + 0.5f);
}

/* Returns the picture to which the player reacts now. This picture is older than the newest picture
 * by the player's reaction time. */
static const struct sight *seen_by(const struct sim_player *player)
{
    return sight_before(player, reaction_frames(player));
}

static vec3 fish_velocity_m_s(const struct sim_player *player, uint32_t fish)
{
    const struct sight *newer = seen_by(player);
    const struct sight *older = sight_before(player, reaction_frames(player) + SPEED_FRAMES);
    CORE_ASSERT(fish < newer->fish_count);
    if (fish >= older->fish_count || !older->fish[fish].swims) {
        return v3(0.0f, 0.0f, 0.0f);
    }
    return v3_scale(v3_sub(newer->fish[fish].position_m, older->fish[fish].position_m),
                    (float)PLAYER_HZ / (float)SPEED_FRAMES);
}

/* Returns the position where the player expects the fish to be now. */
static vec3 fish_now_m(const struct sim_player *player, uint32_t fish)
{
    const struct habits *habits = player->habits;
    return v3_muladd(seen_by(player)->fish[fish].position_m, fish_velocity_m_s(player, fish),
                     habits->lead * habits->reaction_s);
}

/* Returns the distance in pixels on the screen between two points of the tank. */
static float screen_gap_px(const struct sim_player *player, vec3 a_m, vec3 b_m)
{
    float ax, ay, bx, by;
    sim_player_to_screen(&player->view, a_m, &ax, &ay);
    sim_player_to_screen(&player->view, b_m, &bx, &by);
    return f_sqrt((ax - bx) * (ax - bx) + (ay - by) * (ay - by));
}

/* ---- States of the player -------------------------------------------------------------------- */

static float state_s(const struct sim_player *player)
{
    return (float)(player->frame - player->state_frame) / (float)PLAYER_HZ;
}

static float round_s(const struct sim_player *player)
{
    return (float)player->round_frame / (float)PLAYER_HZ;
}

static float draw(const struct sim_player *player, uint32_t what, float low, float high)
{
    return rng_range((struct rng_key){ player->seed, player->tries, what, RNG_BOT_CHOICE }, low,
                     high);
}

static bool is_clear_of_bowl(const struct sight *seen, vec3 bowl_m, vec3 fish_m)
{
    const float x = fish_m.x - bowl_m.x, z = fish_m.z - bowl_m.z;
    const float clear_m = seen->bowl_radius_m + BOWL_ROOM_M;
    return x * x + z * z > clear_m * clear_m;
}

/* Returns true if the fish is far enough from the walls and from all bowls to be caught. */
static bool is_in_reach(const struct sight *seen, vec3 fish_m)
{
    bool is_clear = is_clear_of_bowl(seen, seen->bowl_m, fish_m);
    for (uint32_t i = 0; i < seen->other_bowl_count; i++) {
        is_clear = is_clear && is_clear_of_bowl(seen, seen->other_bowls_m[i], fish_m);
    }
    return is_clear && f_abs(fish_m.x) < 0.5f * seen->tank_m.x - WALL_ROOM_M &&
           f_abs(fish_m.z) < 0.5f * seen->tank_m.z - WALL_ROOM_M;
}

static float cost_px(const struct sim_player *player, const struct sight *seen, uint32_t fish)
{
    const struct habits *habits = player->habits;
    const struct sight_fish *prey = &seen->fish[fish];
    const float speed_m_s = v3_length(fish_velocity_m_s(player, fish));
    return habits->cost_distance * screen_gap_px(player, seen->ring_m, prey->position_m) +
           1000.0f * (habits->cost_speed_s * speed_m_s - habits->cost_depth * prey->position_m.y +
                      habits->cost_length * prey->length_m) +
           draw(player, 16u + fish, 0.0f, habits->cost_random_px);
}

static uint16_t choose_fish(const struct sim_player *player)
{
    const struct sight *seen = seen_by(player);
    if (player->habits->takes_marked && seen->marked != PLAYER_NO_FISH) {
        return seen->marked;
    }
    uint16_t best = PLAYER_NO_FISH;
    float best_px = 0.0f;
    for (uint32_t i = 0; i < seen->fish_count; i++) {
        if (seen->fish[i].swims && is_in_reach(seen, seen->fish[i].position_m)) {
            const float px = cost_px(player, seen, i);
            if (best == PLAYER_NO_FISH || px < best_px) {
                best = (uint16_t)i;
                best_px = px;
            }
        }
    }
    return best;
}

static uint8_t tick_choose(struct sim_player *player)
{
    const struct habits *habits = player->habits;
    player->command.dips = player->command.tips = false;
    player->command.speed_px_s = 0.0f;
    if (state_s(player) < habits->pause_s || round_s(player) < habits->start_s) {
        return PLAYER_CHOOSE;
    }
    player->tries++;
    player->prey = choose_fish(player);
    if (player->prey == PLAYER_NO_FISH) {
        player->state_frame = player->frame;
        return PLAYER_CHOOSE;
    }
    player->side = seen_by(player)->fish[player->prey].position_m.x > 0.0f ? -1.0f : 1.0f;
    player->error_x_px = draw(player, 0, -habits->aim_px, habits->aim_px);
    player->error_y_px = draw(player, 1, -habits->aim_px, habits->aim_px);
    player->hold_s = draw(player, 2, habits->hold_min_s, habits->hold_max_s);
    player->follow_s = draw(player, 3, habits->follow_min_s, habits->follow_max_s);
    return PLAYER_REACH;
}

/* Sets the goal of the ring to a point `beside_px` beside the chosen fish, plus the aiming error of
 * this attempt. */
static void aim_at_prey(struct sim_player *player, float beside_px, float speed_px_s)
{
    struct player_command *command = &player->command;
    const vec3 goal_m = fish_now_m(player, player->prey);
    sim_player_to_screen(&player->view, goal_m, &command->x_px, &command->y_px);
    command->x_px += player->error_x_px + player->side * beside_px;
    command->y_px += player->error_y_px;
    command->speed_px_s = speed_px_s;
}

static uint8_t tick_reach(struct sim_player *player)
{
    const struct habits *habits = player->habits;
    const struct sight *seen = seen_by(player);
    if (!seen->fish[player->prey].swims) {
        return PLAYER_CHOOSE;
    }
    aim_at_prey(player, habits->beside_px, habits->arm_px_s);
    player->command.tilt_notches = habits->tilt_notches;
    float x_px, y_px;
    sim_player_to_screen(&player->view, seen->ring_m, &x_px, &y_px);
    const float dx = x_px - player->command.x_px, dy = y_px - player->command.y_px;
    const bool is_there = dx * dx + dy * dy < habits->reach_px * habits->reach_px;
    const bool is_calm = habits->calm_m_s <= 0.0f ||
                         v3_length(fish_velocity_m_s(player, player->prey)) < habits->calm_m_s;
    const bool may_dip = round_s(player) >= habits->dip_start_s;
    if (is_there && is_calm && may_dip) {
        return PLAYER_STILL;
    }
    if (state_s(player) > habits->patience_s) {
        return habits->calm_m_s > 0.0f || !may_dip ? PLAYER_CHOOSE : PLAYER_STILL;
    }
    return PLAYER_REACH;
}

/* Returns the index of the swimming fish above the ring that is nearest to the ring on the screen,
 * or PLAYER_NO_FISH. Writes the distance of this fish to `gap_px`. */
static uint16_t nearest_fish(const struct sim_player *player, float *gap_px)
{
    const struct sight *seen = seen_by(player);
    uint16_t best = PLAYER_NO_FISH;
    for (uint32_t i = 0; i < seen->fish_count; i++) {
        const struct sight_fish *fish = &seen->fish[i];
        const bool is_above = fish->swims && fish->position_m.y > seen->ring_m.y;
        const float px = screen_gap_px(player, fish->position_m, seen->ring_m);
        if (is_above && (best == PLAYER_NO_FISH || px < *gap_px)) {
            best = (uint16_t)i;
            *gap_px = px;
        }
    }
    return best;
}

static uint8_t tick_still(struct sim_player *player)
{
    const struct habits *habits = player->habits;
    float gap_px = 0.0f;
    player->command.dips = true;
    player->command.speed_px_s = 0.0f;
    const bool is_down = state_s(player) > DIP_DOWN_S + habits->reaction_s;
    if (habits->until_px > 0.0f && is_down && nearest_fish(player, &gap_px) != PLAYER_NO_FISH &&
        gap_px < habits->until_px) {
        return PLAYER_RISE;
    }
    if (state_s(player) < player->hold_s) {
        return PLAYER_STILL;
    }
    return player->follow_s > 0.0f ? PLAYER_FOLLOW : PLAYER_RISE;
}

static uint8_t tick_follow(struct sim_player *player)
{
    const struct habits *habits = player->habits;
    const struct sight *seen = seen_by(player);
    player->command.tilt_notches = habits->levels ? 0.0f : habits->tilt_notches;
    float gap_px = seen->fish[player->prey].swims
                       ? screen_gap_px(player, fish_now_m(player, player->prey), seen->ring_m)
                       : 1e6f;
    if (habits->lost_px > 0.0f && gap_px > habits->lost_px) {
        const uint16_t other = nearest_fish(player, &gap_px);
        player->prey = other != PLAYER_NO_FISH ? other : player->prey;
    }
    if (state_s(player) > player->follow_s || gap_px < habits->over_px ||
        !seen->fish[player->prey].swims) {
        return PLAYER_RISE;
    }
    aim_at_prey(player, 0.0f, habits->glide_px_s);
    return PLAYER_FOLLOW;
}

static uint8_t tick_rise(struct sim_player *player)
{
    player->command.dips = false;
    player->command.tilt_notches = 0.0f;
    player->command.speed_px_s = 0.0f;
    if (state_s(player) < player->habits->rise_s) {
        return PLAYER_RISE;
    }
    return seen_by(player)->has_catch ? PLAYER_CARRY : PLAYER_CHOOSE;
}

static uint8_t tick_carry(struct sim_player *player)
{
    const struct sight *seen = seen_by(player);
    struct player_command *command = &player->command;
    const vec3 bowl_m = v3(seen->bowl_m.x, DIP_HOVER_M, seen->bowl_m.z);
    sim_player_to_screen(&player->view, bowl_m, &command->x_px, &command->y_px);
    command->speed_px_s = player->habits->keeps ? 0.0f : player->habits->carry_px_s;
    command->tips = screen_gap_px(player, seen->ring_m, bowl_m) < TIP_PX;
    const bool is_done = !seen->has_catch || state_s(player) > CARRY_S;
    return is_done ? PLAYER_CHOOSE : PLAYER_CARRY;
}

/* ---- Public functions ------------------------------------------------------------------------ */

void sim_player_init(struct sim_player *player, const struct habits *habits,
                     const struct view *view, uint32_t seed)
{
    CORE_ASSERT(habits->reaction_s * (float)PLAYER_HZ + (float)SPEED_FRAMES + 1.0f <
                (float)PLAYER_SIGHT_MAX);
    *player = (struct sim_player){ .habits = habits,
                                   .view = *view,
                                   .seed = seed,
                                   .prey = PLAYER_NO_FISH,
                                   .command = { .x_px = 0.5f * PLAYER_WIDTH_PX,
                                                .y_px = 0.5f * PLAYER_HEIGHT_PX } };
}

/* Changes the habits of a player who sees the sign that the player follows. */
static void follow_sign(struct sim_player *player)
{
    const struct sight *seen = seen_by(player);
    const uint8_t sign = player->habits->sign;
    if (sign != 0 && (sign == SIGN_ARROW   ? seen->has_arrow
                      : sign == SIGN_GHOST ? seen->has_ghost
                      : sign == SIGN_RING  ? seen->marked != PLAYER_NO_FISH
                                           : sign == seen->hint)) {
        player->habits = player->habits->cured;
    }
}

struct player_command sim_player_frame(struct sim_player *player, const struct sight *now)
{
    static uint8_t (*const states[PLAYER_STATE_COUNT])(struct sim_player *) = {
        [PLAYER_CHOOSE] = tick_choose, [PLAYER_REACH] = tick_reach, [PLAYER_STILL] = tick_still,
        [PLAYER_FOLLOW] = tick_follow, [PLAYER_RISE] = tick_rise,   [PLAYER_CARRY] = tick_carry,
    };
    CORE_ASSERT(player->state < PLAYER_STATE_COUNT);
    player->sights[player->frame % PLAYER_SIGHT_MAX] = *now;
    player->frame++;
    const bool plays = seen_by(player)->in_round;
    player->round_frame = plays ? player->round_frame + 1u : 0u;
    follow_sign(player);
    const uint8_t next = plays ? states[player->state](player) : (uint8_t)PLAYER_CHOOSE;
    if (!plays) {
        player->command.dips = player->command.tips = false;
    }
    if (next != player->state || !plays) {
        player->state = next;
        player->state_frame = player->frame;
    }
    sim_player_to_screen(&player->view, seen_by(player)->ring_m, &player->command.ring_x_px,
                         &player->command.ring_y_px);
    return player->command;
}
