/* output_devices.c -- plays sounds, sets output lines and dims the picture; see
 * output_devices.h. */
#include "platform/kiosk/output_devices.h"

#include <string.h>

#include "core/base/panic.h"
#include "core/scene.h"

/* Interval between two attempts to use a device that failed, and between two searches for a sound
 * card. */
#define RETRY_NS NS_PER_S

bool output_is_settled(int result, uint64_t now_ns, uint64_t *retry_ns)
{
    CORE_ASSERT(retry_ns);
    if (hal_is_fault(result)) {
        *retry_ns = now_ns + RETRY_NS;
    }
    return result >= 0 || result == HAL_ERR_ABSENT;
}

void output_audio_open(struct output_audio *voice, const struct hal_audio *audio, uint64_t now_ns)
{
    CORE_ASSERT(audio->ops);
    voice->retry_ns = audio->ops->open(audio->self) == HAL_OK ? 0 : now_ns + RETRY_NS;
}

/* Levels of music and surroundings in the phases in which nobody plays, and on the pages that
 * people read. The operator's menu has no music, because the operator listens to the tests. */
#define ATTRACT_LEVEL 0.6f
#define PAGE_LEVEL 0.5f

/* Returns true if the time of day of `input` is in the hours that begin at the setting `from` and
 * end at the setting `to`. The hours may include midnight. Equal settings mean no hours. Without a
 * correct clock the result is false. */
static bool is_in_hours(const struct settings *settings, enum setting_id from, enum setting_id to,
                        const struct input *input)
{
    const int32_t begin = settings->value[from], end = settings->value[to];
    const bool is_after = input->minute >= begin, is_before = input->minute < end;
    return input->day != 0 && begin != end &&
           (begin < end ? is_after && is_before : is_after || is_before);
}

/* Returns the levels for the present phase of the game and the time of day. A level is the square
 * of its setting, because hearing follows a power law: half of the setting then sounds about half
 * as loud. In the operator's menu no hour is quiet, because the operator listens to the tests. */
static struct sound_levels levels_of(const struct settings *settings, const struct output *output,
                                     const struct input *input, bool is_silent)
{
    static const float music_in_phase[] = {
        [PHASE_ATTRACT] = ATTRACT_LEVEL,
        [PHASE_READY] = 1.0f,
        [PHASE_ROUND] = 1.0f,
        [PHASE_RESULT] = 1.0f,
        [PHASE_WORDLESS] = 0.0f,
        [PHASE_MODE_SELECT] = 1.0f,
        [PHASE_LAB] = PAGE_LEVEL,
        [PHASE_ALBUM] = PAGE_LEVEL,
        [PHASE_MENU] = 0.0f,
        [PHASE_NAME] = PAGE_LEVEL,
        [PHASE_LEADERBOARD] = PAGE_LEVEL,
    };
    CORE_ASSERT(output->phase < sizeof music_in_phase / sizeof music_in_phase[0]);
    static const float steps[SETTING_SOUND_STEPS] = { 1.0f, 0.75f, 0.50f, 0.25f, 0.0f };
    static const float quiet[QUIET_VOLUME_COUNT] = { 0.50f, 0.30f, 0.15f, 0.0f };
    const bool is_quiet = output->phase != PHASE_MENU &&
                          is_in_hours(settings, SET_QUIET_FROM_MIN, SET_QUIET_TO_MIN, input);
    const float share = (is_silent ? 0.0f : 0.01f * (float)settings->value[SET_VOLUME]) *
                        (is_quiet ? quiet[settings->value[SET_QUIET_VOLUME]] : 1.0f);
    const float of_effects = share * steps[settings->value[SET_EFFECTS]];
    const float of_music = share * steps[settings->value[SET_MUSIC]];
    const float music = of_music * of_music * music_in_phase[output->phase];
    return (struct sound_levels){
        .effects = of_effects * of_effects,
        .music = music,
        .ambience = music,
        .song = output->round_tick,
        .has_pump = output->has_pump,
        .is_stone_right = input->is_turned != 0,
    };
}

uint32_t output_audio_play(struct output_audio *voice, const struct hal_audio *audio,
                           const struct output *output, const struct settings *settings,
                           const struct input *input, bool is_attract, uint64_t now_ns)
{
    CORE_ASSERT(output->sound_count <= OUTPUT_SOUND_MAX);
    uint32_t faults = 0;
    if (voice->retry_ns > 0 && now_ns >= voice->retry_ns) {
        output_audio_open(voice, audio, now_ns);
    }
    if (!is_attract) {
        voice->attract_ns = 0;
    } else if (voice->attract_ns == 0) {
        voice->attract_ns = now_ns;
    }
    const uint64_t section = (now_ns - voice->attract_ns) / NS_PER_S / OUTPUT_AUDIO_SHOW_S;
    const uint64_t every = (uint64_t)settings->value[SET_ATTRACT_SOUND];
    const bool is_silent = is_attract && (every == 0 || section % every != 0);
    const struct sound_levels levels = levels_of(settings, output, input, is_silent);
    audio->ops->set_levels(audio->self, &levels);
    if (levels.effects <= 0.0f) {
        return 0;
    }
    for (uint32_t i = 0; i < output->sound_count && voice->retry_ns == 0; i++) {
        const int result = audio->ops->play(audio->self, &output->sounds[i]);
        faults += (uint32_t)hal_is_fault(result);
        if (result == HAL_ERR_GONE) { /* The loss of the sound card counts as one fault. The
                                         remaining sounds of the frame are dropped. */
            voice->retry_ns = now_ns + RETRY_NS;
        }
    }
    return faults;
}

/* ---- Lamp, lockout, counter and tickets ---------------------------------------------------- */

/* Sends changed outputs to the driver. A request that a busy driver did not accept is sent again in
 * the next frame. A request that failed is sent again after one second. An output that the cabinet
 * does not have counts as set. */

static uint32_t output_lines_set(struct output_lines *switches, const struct hal_switches *device,
                                 enum hal_switch which, bool active, uint64_t now_ns)
{
    CORE_ASSERT(which < HAL_SWITCH_COUNT);
    const uint32_t bit = 1u << which;
    if (!(switches->active & bit) == !active || now_ns < switches->retry_ns[which]) {
        return 0;
    }
    const int result = device->ops->set(device->self, which, active);
    if (output_is_settled(result, now_ns, &switches->retry_ns[which])) {
        switches->active ^= bit;
    }
    return (uint32_t)hal_is_fault(result);
}

/* Requests one pulse of the output for each increase of the count `wanted` since the last accepted
 * request. Returns 1 on a fault, otherwise 0. */
static uint32_t send_new_pulses(struct output_lines *switches, const struct hal_switches *device,
                                enum hal_switch which, uint32_t wanted, uint64_t now_ns)
{
    CORE_ASSERT(which < HAL_SWITCH_COUNT);
    const uint32_t count = wanted - switches->given[which];
    if (count == 0 || now_ns < switches->retry_ns[which]) {
        return 0;
    }
    const int result = device->ops->pulse(device->self, which, count);
    if (output_is_settled(result, now_ns, &switches->retry_ns[which])) {
        switches->given[which] = wanted;
    }
    return (uint32_t)hal_is_fault(result);
}

uint32_t output_lines_put(struct output_lines *switches, const struct hal_switches *device,
                          const struct output *output, uint64_t now_ns)
{
    CORE_ASSERT(device->ops);
    return output_lines_set(switches, device, HAL_START_LAMP, output->start_lamp, now_ns) +
           output_lines_set(switches, device, HAL_COIN_LOCKOUT, output->coin_lockout, now_ns) +
           send_new_pulses(switches, device, HAL_COIN_COUNTER, output->coins_counted, now_ns) +
           send_new_pulses(switches, device, HAL_TICKET, output->tickets, now_ns);
}

uint32_t output_lines_are_done(const struct output_lines *switches,
                               const struct hal_switches *device, enum hal_switch which)
{
    CORE_ASSERT(which < HAL_SWITCH_COUNT);
    return switches->given[which] - device->ops->pending(device->self, which);
}

/* ---- Brightness and position of the picture ------------------------------------------------ */

/* Duration of dimming in seconds. Dimming is slow so that players do not notice the change. */
#define FADE_DOWN_S 4.0f
/* Duration of brightening in seconds. Brightening is fast because an arriving player needs
 * light. */
#define FADE_UP_S 0.3f
/* Maximum time step in milliseconds. Limits the change of brightness after a delayed frame. */
#define STEP_MS_MAX 100u

/* Periods of the picture's slow horizontal and vertical movement in milliseconds. The numbers of
 * minutes (37 and 23) have no common divisor. Therefore the picture reaches every position in its
 * range within a day. The picture moves by one pixel every few minutes. */
#define WANDER_X_MS (37u * 60000u)
#define WANDER_Y_MS (23u * 60000u)
#define WANDER_MS (37u * WANDER_Y_MS)

void output_dimmer_notice(struct output_dimmer *dimmer, const struct input *input, bool is_attract)
{
    if (input->pressed != 0 || input_coin_pulses(input) > 0 || !is_attract) {
        dimmer->was_stirred = true;
    }
}

static float dimmer_shift_at(uint32_t ms, uint32_t period_ms)
{
    return DIMMER_SHIFT * f_sin(F_TAU * (float)(ms % period_ms) / (float)period_ms);
}

struct display_settings output_dimmer_step(struct output_dimmer *dimmer,
                                           const struct settings *settings,
                                           const struct input *input, bool is_attract,
                                           uint64_t now_ns)
{
    CORE_ASSERT(dimmer->wander_ms < WANDER_MS);
    const int32_t *value = settings->value;
    const bool is_first = dimmer->seen_ns == 0;
    const uint64_t elapsed = is_first ? 0 : (now_ns - dimmer->seen_ns) / NS_PER_MS;
    dimmer->seen_ns = is_first ? now_ns : dimmer->seen_ns + elapsed * NS_PER_MS;
    const uint32_t ms = elapsed < STEP_MS_MAX ? (uint32_t)elapsed : STEP_MS_MAX;
    /* Detects whether a poi has moved. Positions are not validated, because a comparison with a
     * non-finite position never counts as a movement. */
    for (uint32_t i = 0; i < POI_MAX; i++) {
        const vec3 at_m = input->poi[i].target.position_m;
        const float moved_m = v3_length(v3_sub(at_m, dimmer->hand_m[i]));
        const bool is_hand = input->poi[i].link == POI_SOURCE_LIVE && f_is_finite(moved_m);
        if (is_hand && moved_m > DIMMER_STIR_M) {
            dimmer->hand_m[i] = at_m;
            dimmer->was_stirred = true;
        }
    }
    if (is_first || dimmer->was_stirred) {
        dimmer->touched_ns = now_ns;
        dimmer->was_stirred = false;
    }
    const uint64_t idle_s = (now_ns - dimmer->touched_ns) / NS_PER_S;
    /* `wanted` is the target brightness as a fraction of the brightness that the operator has
     * set. */
    const bool is_night = is_in_hours(settings, SET_NIGHT_FROM_MIN, SET_NIGHT_TO_MIN, input);
    const uint64_t dim_s = 60u * (uint64_t)value[SET_DIM_AFTER_MIN];
    const float wanted = is_night && idle_s >= DIMMER_NIGHT_IDLE_S ? 0.0f
                         : dim_s > 0 && idle_s >= dim_s            ? 0.01f * (float)value[SET_DIM]
                                                                   : 1.0f;
    const float share = 1e-3f * (float)ms;
    dimmer->light = is_first                 ? wanted
                    : dimmer->light > wanted ? f_max(dimmer->light - (share / FADE_DOWN_S), wanted)
                                             : f_min(dimmer->light + (share / FADE_UP_S), wanted);
    if (is_attract) { /* The picture is not moved during a game, because the players aim at objects
                         in the picture. */
        dimmer->wander_ms = (dimmer->wander_ms + ms) % WANDER_MS;
    }
    return (struct display_settings){
        .rotation = (uint32_t)value[SET_ROTATION],
        .inset_x = 1e-3f * (float)value[SET_OVERSCAN_X],
        .inset_y = 1e-3f * (float)value[SET_OVERSCAN_Y],
        .shift_x = dimmer_shift_at(dimmer->wander_ms, WANDER_X_MS),
        .shift_y = dimmer_shift_at(dimmer->wander_ms, WANDER_Y_MS),
        .light = dimmer->light * 0.01f * (float)value[SET_BRIGHTNESS],
        .dips_by_click = (uint32_t)value[SET_DIP],
        .reach_percent = (uint32_t)value[SET_REACH],
        .has_white_bowls = (uint32_t)value[SET_BOWL],
        .is_day = (uint32_t)value[SET_TIME],
    };
}

/* Periods of the camera's drift in ticks along x, y and z, and the largest distance from its place
 * of rest in metres. */
static const uint32_t drift_ticks[3] = { 41u * CORE_TICK_HZ, 29u * CORE_TICK_HZ,
                                         53u * CORE_TICK_HZ };
static const float drift_m[3] = { 0.045f, 0.020f, 0.030f };
/* Place of the camera relative to the bowl that it shows closely, in the player's axes. */
static const vec3 close_eye_m = { 0.0f, 0.36f, 0.27f };

/* Returns `share` after one step toward 1 if `is_wanted` is true, otherwise toward 0. */
static float move_share(float share, bool is_wanted, float step)
{
    return f_clamp(share + (is_wanted ? step : -step), 0.0f, 1.0f);
}

/* Remembers the bowl into which a fish has fallen since the previous frame. */
static void notice_catch(struct output_camera *camera, const struct scene *scene, bool is_idle)
{
    for (uint32_t i = 0; i < POI_MAX; i++) {
        const struct scene_bowl *const bowl = &scene->bowl[i];
        const uint32_t count = bowl->present ? bowl->fish_count : 0u;
        if (is_idle && count > camera->caught[i]) {
            camera->close_m = bowl->position_m;
            camera->close_until_tick =
                scene->tick + (uint32_t)(CAMERA_CLOSE_S * (float)CORE_TICK_HZ);
        }
        camera->caught[i] = count;
    }
}

/* Distance to the place of rest below which the camera rests exactly, in metres and as a share. */
#define CAMERA_REST 1e-4f
/* Share of the largest possible approach that leaves room to follow the poi to the sides, and a
 * positive lower bound of the share that is divided by. */
#define CAMERA_SIDE_SHARE 0.90f
#define CAMERA_CLOSER_MIN 0.01f

/* Advances `spring` by `step_s` seconds of a critically damped motion to `target`. */
static void camera_spring_step(struct camera_spring *spring, float target, float step_s)
{
    const float rate = CAMERA_CLOSER_RATE;
    const float away = spring->at - target;
    const float drive = spring->speed + rate * away;
    const float left = f_exp(-rate * step_s);
    spring->at = target + (away + drive * step_s) * left;
    spring->speed = (spring->speed - rate * drive * step_s) * left;
}

/* Edges of the picture, in the order in which the point of approach is moved to show them. */
enum picture_edge { EDGE_FAR = 0, EDGE_NEAR, EDGE_LEFT, EDGE_RIGHT, EDGE_COUNT };

/* Writes the normals of the planes through the eye that bound the part of the picture in which the
 * water is shown. The normals point into the picture. */
static void picture_bounds(const struct view *view, const struct basis *axes, bool is_turned,
                           vec3 normal[EDGE_COUNT])
{
    const float far = is_turned ? CAMERA_FAR_EDGE_TURNED : CAMERA_FAR_EDGE;
    const float across = CAMERA_SIDE_EDGE * view->half_height_tan * view->aspect_min;
    const vec3 ahead = v3_scale(axes->back, -1.0f);
    normal[EDGE_FAR] = v3_sub(v3_scale(ahead, far * view->half_height_tan), axes->up);
    normal[EDGE_NEAR] = v3_add(v3_scale(ahead, CAMERA_NEAR_EDGE * view->half_height_tan), axes->up);
    normal[EDGE_LEFT] = v3_add(v3_scale(ahead, across), axes->right);
    normal[EDGE_RIGHT] = v3_sub(v3_scale(ahead, across), axes->right);
}

/* Moves the point `*at_m` in the direction `way` until its distance from the plane with the normal
 * `normal` through `eye_m` is at most `limit_m`. */
static void move_inside(vec3 *at_m, vec3 normal, vec3 eye_m, vec3 way, float limit_m)
{
    const float excess_m = v3_dot(normal, v3_sub(*at_m, eye_m)) - limit_m;
    if (excess_m > 0.0f) {
        *at_m = v3_muladd(*at_m, way, -excess_m / v3_dot(normal, way));
    }
}

/* Returns the width of the strip of water that may leave the picture at the wall in the horizontal
 * direction `way`, which is parallel to an axis, while the poi is at `at_m`. */
static float hidden_strip_m(vec3 tank_size_m, vec3 way, vec3 at_m)
{
    const float half_m = 0.5f * (f_abs(way.x) * tank_size_m.x + f_abs(way.z) * tank_size_m.z);
    const float away_m = half_m - v3_dot(at_m, way);
    return CAMERA_HIDDEN_M * f_smoothstep(CAMERA_HIDES_FROM_M, CAMERA_HIDES_TO_M, away_m);
}

/* Returns the share by which the camera `view` comes closer to a point, and moves the point
 * `*at_m`, which is the place of the poi, so that the water remains in the picture, except for
 * strips at the walls that are far from the poi. If the camera comes closer by a share, the
 * distance of every object from a plane through the eye decreases by this share of the point's
 * distance from the plane. */
static float find_approach(const struct view *view, bool is_turned, vec3 tank_size_m, vec3 *at_m)
{
    const struct basis axes = view_basis(view);
    const vec3 toward = v3_normalize_or(v3_flat(axes.back), v3(0.0f, 0.0f, 1.0f));
    const vec3 way[EDGE_COUNT] = { v3_scale(toward, -1.0f), toward, v3_scale(axes.right, -1.0f),
                                   axes.right };
    vec3 normal[EDGE_COUNT];
    float room_m[EDGE_COUNT]; /* Distance from each plane of the water that must be visible. */
    picture_bounds(view, &axes, is_turned, normal);
    for (uint32_t edge = 0; edge < EDGE_COUNT; edge++) {
        const float reach_m =
            f_abs(normal[edge].x) * tank_size_m.x + f_abs(normal[edge].z) * tank_size_m.z;
        const float strip_m =
            edge == EDGE_FAR ? 0.0f : hidden_strip_m(tank_size_m, way[edge], *at_m);
        room_m[edge] = f_max(-v3_dot(normal[edge], view->eye_m) - 0.5f * reach_m, 0.0f) -
                       strip_m * v3_dot(normal[edge], way[edge]);
    }
    float share = CAMERA_CLOSER_MAX;
    for (uint32_t edge = EDGE_FAR; edge <= EDGE_NEAR; edge++) {
        move_inside(at_m, normal[edge], view->eye_m, toward, room_m[edge] / share);
    }
    const float width_m =
        v3_dot(v3_add(normal[EDGE_LEFT], normal[EDGE_RIGHT]), v3_sub(*at_m, view->eye_m));
    const float side_m = room_m[EDGE_LEFT] + room_m[EDGE_RIGHT];
    share = f_clamp(CAMERA_SIDE_SHARE * side_m / width_m, CAMERA_CLOSER_MIN, share);
    for (uint32_t edge = EDGE_LEFT; edge <= EDGE_RIGHT; edge++) {
        move_inside(at_m, normal[edge], view->eye_m, axes.right, room_m[edge] / share);
    }
    for (uint32_t edge = 0; edge < EDGE_COUNT; edge++) {
        share = f_min(share, room_m[edge] / v3_dot(normal[edge], v3_sub(*at_m, view->eye_m)));
    }
    return share;
}

/* Returns the player who plays alone in a round, or POI_MAX. */
static uint32_t find_single_player(const struct scene *scene)
{
    uint32_t count = 0, player = POI_MAX;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        count += scene->bowl[i].present;
        player = scene->bowl[i].present ? i : player;
    }
    return scene->phase == PHASE_ROUND && count == 1 ? player : (uint32_t)POI_MAX;
}

/* Moves `view` closer to the poi of a player who plays alone. `rest` is the camera at rest. */
static void come_closer(struct output_camera *camera, const struct scene *scene, bool is_turned,
                        bool follows, float step_s, const struct view *rest, struct view *view)
{
    const uint32_t player = follows ? find_single_player(scene) : (uint32_t)POI_MAX;
    struct camera_spring *const closer = camera->closer;
    float target[3] = { 0.0f, 0.0f, 0.0f };
    if (player < POI_MAX) {
        const struct scene_poi *const poi = &scene->poi[player];
        vec3 at_m = v3_flat(poi->position_m);
        const bool is_still = !poi->present || poi->position_m.y < 0.0f;
        const float share = find_approach(rest, is_turned, scene->tank_size_m, &at_m);
        target[0] = is_still ? closer[0].at : share;
        target[1] = is_still ? closer[1].at : share * at_m.x;
        target[2] = is_still ? closer[2].at : share * at_m.z;
    }
    float far = 0.0f;
    for (uint32_t i = 0; i < 3; i++) {
        if (step_s > 0.0f) { /* A step of 0 s would round the place. */
            camera_spring_step(&closer[i], target[i], step_s);
        }
        far = f_max(far, f_max(f_abs(closer[i].at), f_abs(closer[i].speed)));
    }
    if (player == POI_MAX && far < CAMERA_REST) {
        memset(camera->closer, 0, sizeof camera->closer);
        return;
    }
    const vec3 shift_m = v3(closer[1].at, 0.0f, closer[2].at);
    view->eye_m = v3_muladd(shift_m, view->eye_m, 1.0f - closer[0].at);
    view->target_m = v3_muladd(shift_m, view->target_m, 1.0f - closer[0].at);
}

void output_camera_step(struct output_camera *camera, const struct output_dimmer *dimmer,
                        const struct scene *scene, bool is_turned, bool follows, struct view *view)
{
    const struct view rest = *view;
    const uint32_t ticks = scene->tick - camera->seen_tick;
    const float step_s = (float)(ticks < CORE_TICK_HZ ? ticks : 0u) * CORE_TICK_S;
    const float step = step_s * (1.0f / CAMERA_MOVE_S);
    /* `seen_ns` is rounded down to a millisecond, so that it may be before `touched_ns`. */
    const uint64_t idle_ns =
        dimmer->seen_ns > dimmer->touched_ns ? dimmer->seen_ns - dimmer->touched_ns : 0;
    const float idle_s = (float)idle_ns * 1e-9f;
    const bool is_idle = scene->phase == PHASE_ATTRACT && idle_s >= CAMERA_IDLE_S;
    camera->seen_tick = scene->tick;
    notice_catch(camera, scene, is_idle);
    const int32_t left_ticks = (int32_t)(camera->close_until_tick - scene->tick);
    camera->drift = move_share(camera->drift, is_idle, step);
    const bool is_close =
        left_ticks > 0 && (float)left_ticks <= CAMERA_CLOSE_S * (float)CORE_TICK_HZ;
    camera->close = move_share(camera->close, is_idle && is_close, step);
    const float drift = f_smoothstep(0.0f, 1.0f, camera->drift);
    float off_m[3];
    for (uint32_t i = 0; i < 3; i++) {
        const float turn = (float)(scene->tick % drift_ticks[i]) / (float)drift_ticks[i];
        off_m[i] = drift * drift_m[i] * f_sin(F_TAU * turn);
    }
    const vec3 eye_m =
        v3_add(view->eye_m, view_to_world(is_turned, v3(off_m[0], off_m[1], off_m[2])));
    const float close = f_smoothstep(0.0f, 1.0f, camera->close);
    view->eye_m =
        v3_lerp(eye_m, v3_add(camera->close_m, view_to_world(is_turned, close_eye_m)), close);
    view->target_m = v3_lerp(view->target_m, camera->close_m, close);
    come_closer(camera, scene, is_turned, follows, step_s, &rest, view);
}
