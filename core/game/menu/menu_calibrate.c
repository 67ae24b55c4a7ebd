/* menu_calibrate.c -- the menu page that calibrates a slot's poi. */
#include "core/game/menu/menu_calibrate.h"

#include "core/base/hash.h"
#include "core/base/mem.h"
#include "core/game/game.h"
#include "core/poi/world.h"
#include "core/config.h"
#include "core/game/menu/menu_internal.h"

/* ---- Items ---------------------------------------------------------------------------------- */

uint16_t menu_calibrate_enabled(const struct menu *menu)
{
    const struct calibrate *calibrate = &menu->calibrate;
    const uint32_t seat = 1u << calibrate->seat;
    return (uint16_t)(((calibrate->present & ~seat) != 0 ? MENU_TAG(CALIBRATE_NEXT) : 0u) |
                      (calibrate->present & seat ? MENU_TAG(CALIBRATE_BEGIN) : 0u) |
                      (calibrate->has_before & seat ? MENU_TAG(CALIBRATE_UNDO) : 0u) |
                      (calibrate->is_set & seat ? MENU_TAG(CALIBRATE_NONE) : 0u) |
                      MENU_TAG(CALIBRATE_BACK));
}

static void begin_anew(struct calibrate *calibrate)
{
    calibrate->step = CALIBRATE_IDLE;
    calibrate->has_anchor = 0;
    calibrate->still_ticks = 0;
}

static void next_seat(struct calibrate *calibrate)
{
    do {
        calibrate->seat = (uint8_t)((calibrate->seat + 1u) % POI_MAX);
    } while (!(calibrate->present >> calibrate->seat & 1u));
}

void menu_calibrate_open(struct game *game, const struct settings *settings)
{
    (void)settings;
    struct calibrate *calibrate = &game->menu.calibrate;
    begin_anew(calibrate);
    if (calibrate->present != 0 && !(calibrate->present >> calibrate->seat & 1u)) {
        next_seat(calibrate);
    }
}

/* Stores `value` as the slot's calibration. A complete previous calibration is kept, so that the
 * operator can restore it. */
static void swap_with(struct game *game, struct core_config *config,
                      int32_t value[CALIBRATION_VALUES])
{
    struct calibrate *calibrate = &game->menu.calibrate;
    const uint32_t first = calibration_setting(calibrate->seat);
    const struct settings *settings = &config->persistent.settings;
    int32_t before[CALIBRATION_VALUES] = { 0 };
    if (calibration_is_set(settings, calibrate->seat)) {
        memcpy(before, &settings->value[first], sizeof before);
    }
    for (uint32_t i = 0; i < CALIBRATION_VALUES; i++) {
        settings_edit_set(game, config, first + i, value[i]);
    }
    settings_edit_set(game, config, calibration_check_setting(calibrate->seat),
                      calibration_check(value));
    memcpy(calibrate->before[calibrate->seat], before, sizeof before);
    calibrate->has_before |= (uint8_t)(1u << calibrate->seat);
}

void menu_calibrate_activate(struct game *game, struct core_config *config, uint32_t tag,
                             struct output *output)
{
    struct calibrate *calibrate = &game->menu.calibrate;
    int32_t value[CALIBRATION_VALUES] = { 0 };
    (void)output;
    begin_anew(calibrate);
    if (tag == CALIBRATE_NEXT) {
        next_seat(calibrate);
    } else if (tag == CALIBRATE_BEGIN) {
        calibrate->step = CALIBRATE_CORNER;
        calibrate->must_move = 1; /* The poi may still be in its holder, and must move before the
                                     first pose counts. */
    } else if (tag == CALIBRATE_UNDO) {
        memcpy(value, calibrate->before[calibrate->seat], sizeof value);
        swap_with(game, config, value);
    } else {
        swap_with(game, config, value);
    }
}

/* ---- Stillness ------------------------------------------------------------------------------ */

int menu_calibrate_is_running(const struct calibrate *calibrate)
{
    return calibrate->step >= CALIBRATE_CORNER && calibrate->step <= CALIBRATE_WATER;
}

float menu_calibrate_progress(const struct calibrate *calibrate)
{
    return (float)calibrate->still_ticks / (float)CALIBRATE_STILL_TICKS;
}

static void rest_at(struct calibrate *calibrate, const struct poi_target *at)
{
    calibrate->has_anchor = 1;
    calibrate->anchor = *at;
    calibrate->sum = (struct poi_target){ { 0.0f, 0.0f, 0.0f }, { 0.0f, 0.0f, 0.0f } };
    calibrate->still_ticks = 0;
}

/* Adds the deviation of a pose from the anchor to the sum. A sum of positions would lose precision
 * far from the origin. */
static void add_sample(struct calibrate *calibrate, const struct poi_target *at)
{
    struct poi_target *sum = &calibrate->sum;
    const struct poi_target *anchor = &calibrate->anchor;
    sum->position_m = v3_add(sum->position_m, v3_sub(at->position_m, anchor->position_m));
    sum->angles.pitch_rad += f_wrap_angle(at->angles.pitch_rad - anchor->angles.pitch_rad);
    sum->angles.roll_rad += f_wrap_angle(at->angles.roll_rad - anchor->angles.roll_rad);
    calibrate->still_ticks++;
}

static struct poi_target mean(const struct calibrate *calibrate)
{
    const float share = 1.0f / (float)CALIBRATE_STILL_TICKS;
    struct poi_target at = calibrate->anchor;
    at.position_m = v3_muladd(at.position_m, calibrate->sum.position_m, share);
    at.angles.pitch_rad += share * calibrate->sum.angles.pitch_rad;
    at.angles.roll_rad += share * calibrate->sum.angles.roll_rad;
    return at;
}

/* Returns 1 if the poi has been still for CALIBRATE_STILL_TICKS, otherwise 0. */
static int watch_still(struct calibrate *calibrate, const struct poi_input *poi)
{
    const struct poi_target *at = &poi->target;
    if (!calibrate->has_anchor) {
        rest_at(calibrate, at);
        return 0;
    }
    const float way_m = v3_length(v3_sub(at->position_m, calibrate->anchor.position_m));
    if (calibrate->must_move && way_m <= CALIBRATE_MOVE_M) {
        return 0;
    }
    const float turn = poi->has_wrist ? input_turn(calibrate->anchor.angles, at->angles) : 0.0f;
    if (calibrate->must_move || way_m > CALIBRATE_STILL_M || turn > CALIBRATE_STILL_TURN) {
        calibrate->must_move = 0;
        rest_at(calibrate, at);
        return 0;
    }
    add_sample(calibrate, at);
    return calibrate->still_ticks == CALIBRATE_STILL_TICKS;
}

/* ---- The steps ------------------------------------------------------------------------------ */

static void finish(struct game *game, const struct world *world, struct core_config *config,
                   struct output *output)
{
    struct calibrate *calibrate = &game->menu.calibrate;
    int32_t value[CALIBRATION_VALUES];
    calibrate->fault = (uint8_t)calibration_solve(&calibrate->said, world->tank.size_m, value);
    if (calibrate->fault == CALIBRATION_GOOD) {
        swap_with(game, config, value);
    }
    calibrate->step = calibrate->fault == CALIBRATION_GOOD ? CALIBRATE_DONE : CALIBRATE_REFUSED;
    output_sound(output, calibrate->fault == CALIBRATION_GOOD ? SOUND_RESULT : SOUND_FOUL, 0.7f,
                 0.0f);
}

static void take_pose(struct game *game, const struct world *world, struct core_config *config,
                      const struct poi_input *poi, struct output *output)
{
    struct calibrate *calibrate = &game->menu.calibrate;
    const struct poi_target at = mean(calibrate);
    rest_at(calibrate, &poi->target);
    calibrate->must_move = 1;
    game->menu.act_tick = game->tick;
    if (calibrate->step == CALIBRATE_WATER) {
        calibrate->said.water = at;
        calibrate->said.has_wrist = poi->has_wrist != 0;
        finish(game, world, config, output);
    } else {
        calibrate->said.corner_m[calibrate->step - CALIBRATE_CORNER] = at.position_m;
        calibrate->step++;
        output_sound(output, SOUND_CATCH, 0.7f, 0.0f);
    }
}

static void look_round(struct menu *menu, const struct settings *settings, const struct input *said)
{
    struct calibrate *calibrate = &menu->calibrate;
    calibrate->present = calibrate->is_set = 0;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        const int is_there = said->poi[i].link == POI_SOURCE_LIVE;
        const int is_set = calibration_is_set(settings, i) || calibration_is_torn(settings, i);
        calibrate->present |= (uint8_t)((uint32_t)is_there << i);
        calibrate->is_set |= (uint8_t)((uint32_t)is_set << i);
    }
}

void menu_calibrate_tick(struct game *game, const struct world *world, struct core_config *config,
                         const struct input *said, struct output *output)
{
    struct calibrate *calibrate = &game->menu.calibrate;
    if (game->phase != PHASE_MENU) {
        return;
    }
    look_round(&game->menu, &config->persistent.settings, said);
    const struct poi_input *poi = &said->poi[calibrate->seat];
    if (game->menu.page != MENU_CALIBRATION || !menu_calibrate_is_running(calibrate)) {
        return;
    }
    if (poi->link != POI_SOURCE_LIVE || !input_pose_is_finite(&poi->target)) {
        calibrate->has_anchor = 0;
        calibrate->still_ticks = 0;
    } else if (watch_still(calibrate, poi)) {
        take_pose(game, world, config, poi, output);
    }
}

static uint64_t hash_pose(uint64_t hash, const struct poi_target *pose)
{
    hash = hash_vec3(hash, pose->position_m);
    return hash_vec3(hash, v3(pose->angles.yaw_rad, pose->angles.pitch_rad, pose->angles.roll_rad));
}

uint64_t menu_calibrate_hash(uint64_t hash, const struct calibrate *calibrate)
{
    const uint32_t words[] = { calibrate->seat,        calibrate->step,
                               calibrate->fault,       calibrate->present,
                               calibrate->is_set,      calibrate->has_before,
                               calibrate->has_anchor,  calibrate->must_move,
                               calibrate->still_ticks, calibrate->said.has_wrist };
    for (uint32_t i = 0; i < sizeof words / sizeof words[0]; i++) {
        hash = hash_u32(hash, words[i]);
    }
    for (uint32_t i = 0; i < POI_MAX * CALIBRATION_VALUES; i++) {
        const int32_t value = calibrate->before[i / CALIBRATION_VALUES][i % CALIBRATION_VALUES];
        hash = hash_u32(hash, (uint32_t)value);
    }
    for (uint32_t i = 0; i < CALIBRATE_CORNERS; i++) {
        hash = hash_vec3(hash, calibrate->said.corner_m[i]);
    }
    hash = hash_pose(hash_pose(hash, &calibrate->anchor), &calibrate->sum);
    return hash_pose(hash, &calibrate->said.water);
}
