/* core_scene.c -- builds the scene from the state. The module has no state of its own. */
#include "core/base/mem.h"
#include "core/base/panic.h"
#include "core/core.h"
#include "core/game/accounting/accounts.h"
#include "core/game/control/controller.h"
#include "core/game/lab/lab.h"
#include "core/game/menu/menu.h"
#include "core/game/mode_tags.h"
#include "core/game/phases.h"
#include "core/game/ranking/name.h"
#include "core/game/rules.h"
#include "core/game/table_setup.h"
#include "core/morph/morph.h"
#include "core/scene_helpers.h"
#include "core/tank/behavior/surface_breathing.h"

static void show_fish(const struct fish *fish, uint32_t tick, struct scene_fish *out)
{
    CORE_ASSERT(fish->gait < GAIT_COUNT && fish->age_days >= 0.0f);
    out->position_m = fish->position_m;
    out->angles = fish->angles;
    out->length_m = fish->length_m;
    out->tail_phase_rad = fish->tail_phase_rad;
    out->tail_amplitude = fish->tail_amplitude;
    out->bend_rad = fish->bend_rad;
    out->gape = surface_gape(fish, tick);
    out->gulp = surface_gulp(fish, tick);
    out->maturity = scene_maturity(fish->age_days);
    out->look = fish->look;
    out->place = scene_place_of(fish->gait);
    out->age_days = fish->age_days;
    out->progress = life_progress(&species_wakin.card, fish->age_days);
}

/* THRASH_HZ is the frequency at which a lifted fish curls up and stretches. THRASH_RAD is the
 * largest bend of the fish's body. */
#define THRASH_HZ 5.5f
#define THRASH_RAD 1.2f
/* THRASH_REST is the share of the largest bend that a thrashing fish keeps while it stretches.
 * THRASH_RISE is the height by which the largest bend raises the middle of the fish above the
 * paper, as a share of the fish's length. */
#define THRASH_REST 0.25f
#define THRASH_RISE 0.10f

/* Ratio of the shown bend of a thrashing fish to the strength `vigour` of its slaps. Even a calm
 * fish, which has a strength of about 0.5 at its capture, therefore bends its body almost
 * completely. */
#define THRASH_VIGOUR 1.6f

/* Shows the fish on `poi` as thrashing from the tick of their capture. The motion is only a part of
 * the picture, because core/poi/catch/carried_fish.h computes the slaps that load the paper. The
 * strength of these slaps, `vigour`, sets the size of the shown motion. */
static void show_thrash(const struct poi *poi, uint32_t tick, struct scene_fish fish[])
{
    const vec3 up = vec_basis_from_angles(poi->angles).up;
    for (uint32_t i = 0; i < poi->carried_count; i++) {
        const struct carried_fish *carried = &poi->carried_fish[i];
        struct scene_fish *shown = &fish[carried->fish];
        const uint32_t second_tick = (tick + 37u * carried->fish) % (2u * CORE_TICK_HZ);
        const float wave =
            0.5f - 0.5f * f_cos(F_TAU * THRASH_HZ * (float)second_tick * CORE_TICK_S);
        const float curl =
            f_min(THRASH_VIGOUR * carried->vigour, 1.0f) * f_lerp(THRASH_REST, 1.0f, wave);
        if (shown->place == SCENE_ON_POI) { /* The head and the tail bend away from the paper. */
            shown->bend_rad = (float)carried->side * THRASH_RAD * curl;
            shown->tail_amplitude = f_max(shown->tail_amplitude, curl);
            shown->position_m =
                v3_muladd(shown->position_m, up, THRASH_RISE * curl * shown->length_m);
        }
    }
}

/* Presents are fish given to players without a catch. PRESENT_TICKS is the time in which a present
 * falls into the bowl, and PRESENT_FALL_M is the height of the fall. */
#define PRESENT_TICKS (CORE_TICK_HZ / 2u)
#define PRESENT_FALL_M 0.20f

/* Shows the presents falling into their bowls at the start of PHASE_RESULT. In the core's state the
 * presents are in the bowls from the first tick of the phase. */
static void show_presents(const struct game *game, struct scene_fish fish[])
{
    const uint32_t elapsed = game->tick - game->phase_tick;
    const float left = 1.0f - f_min((float)elapsed / (float)PRESENT_TICKS, 1.0f);
    for (uint32_t i = 0; i < game->album.fish_count && game->phase == PHASE_RESULT; i++) {
        struct scene_fish *shown = &fish[game->album.fish[i].fish];
        if (album_has_present(game, game->album.fish[i].owner) && shown->place == SCENE_IN_BOWL) {
            shown->position_m.y += PRESENT_FALL_M * left * (2.0f - left);
        }
    }
}

/* Copies values into the cells outside the ring, so that a renderer can interpolate between cells.
 * Each outside cell receives the value of the nearest paper cell in its row. */
static void spread_to_rim(const struct sheet *sheet, uint8_t cells[SHEET_CELL_COUNT])
{
    for (uint32_t row = 0; row < SHEET_SIDE; row++) {
        uint8_t *line = cells + row * SHEET_SIDE;
        const uint8_t *state = sheet->state + row * SHEET_SIDE;
        uint32_t first = 0;
        while (first < SHEET_SIDE && state[first] == CELL_OUTSIDE) {
            first++;
        }
        if (first == SHEET_SIDE) {
            continue; /* A row without paper has no value to copy. */
        }
        uint32_t last = SHEET_SIDE - 1u;
        while (state[last] == CELL_OUTSIDE) {
            last--;
        }
        memset(line, line[first], first);
        memset(line + last, line[last], SHEET_SIDE - last);
    }
}

static void show_sheet(const struct sheet *sheet, struct scene_poi *out)
{
    for (uint32_t i = 0; i < SHEET_CELL_COUNT; i++) {
        out->wetness[i] = scene_wetness(sheet, i);
        out->integrity[i] = scene_integrity(sheet, i);
        out->stress[i] = sheet->state[i] == CELL_PAPER ? sheet->stress[i] : 0;
    }
    spread_to_rim(sheet, out->wetness);
    spread_to_rim(sheet, out->integrity);
    spread_to_rim(sheet, out->stress);
}

/* Distance of a player from the wall of the tank, in m. */
#define PLAYER_AWAY_M 0.40f

/* Returns the rotation of the drawn handle of a bot about the axis of the ring, in rad, so that the
 * handle points to the place of the player. On a wide screen, the players 0 and 1 stand at the near
 * side of the tank, and the players 2 and 3 at the ends of the tank. On a portrait screen
 * (`turned`), the players whose bowls are in the near half stand at the near end, and the others at
 * the sides. */
static float bot_handle_rad(const struct world *world, uint32_t index, bool turned)
{
    const struct poi *const poi = &world->poi[index];
    const vec3 bowl_m = tank_preset(world->tank.preset)->bowl_m[index];
    const vec3 half_m = v3_scale(world->tank.size_m, 0.5f);
    const bool is_at_end = turned ? bowl_m.x > 0.0f : index >= 2u;
    const float end_m = half_m.x + PLAYER_AWAY_M, side_m = half_m.z + PLAYER_AWAY_M;
    const float near = turned && bowl_m.z < 0.0f ? -1.0f : 1.0f;
    const vec3 place_m = is_at_end ? v3(bowl_m.x < 0.0f ? -end_m : end_m, 0.0f, bowl_m.z)
                                   : v3(bowl_m.x, 0.0f, near * side_m);
    const struct basis axes = vec_basis_from_angles(poi->angles);
    const vec3 way = vec_basis_to_body(&axes, v3_sub(place_m, poi->position_m));
    return f_atan2(way.x, way.z);
}

static void show_poi(const struct core *core, uint32_t index, struct scene_poi *out)
{
    CORE_ASSERT(index < POI_MAX);
    const struct poi *poi = &core->world.poi[index];
    out->present = (uint8_t)controller_is_active(&core->world, index);
    out->owner = (uint8_t)index;
    if (!out->present) {
        return;
    }
    out->position_m = poi->position_m;
    out->angles = poi->angles;
    const bool is_bot = poi->link == POI_SOURCE_BOT;
    out->handle_rad = is_bot ? bot_handle_rad(&core->world, index, false) : 0.0f;
    out->turned_handle_rad = is_bot ? bot_handle_rad(&core->world, index, true) : 0.0f;
    const vec3 bowl_m = core->world.bowl[index].home_m;
    out->left_hand = bowl_m.x < 0.0f;
    out->turned_left_hand = view_from_world(true, bowl_m).x < 0.0f;
    out->ring_radius_m = poi_radius_m(poi);
    /* Paper that is about to tear is stretched and sags deeper. */
    out->warning = sheet_warning(&poi->sheet);
    out->sag_m = poi->sheet.sag_m * (1.0f + out->warning);
    out->paper_left = sheet_left(&poi->sheet);
    const struct shade_cast *cast = &core->world.tank.shade[SHADE_MAX + index].cast;
    out->shade_dark = cast->present ? cast->dark : 0.0f;
    out->water_m = carried_water_m(poi);
    out->shows_stress = core->game.phase == PHASE_ROUND && rules_of(core->game.mode)->shows_stress;
    show_sheet(&poi->sheet, out);
}

static void show_bowl(const struct bowl *bowl, uint32_t index, struct scene_bowl *out)
{
    CORE_ASSERT(index < POI_MAX);
    *out = (struct scene_bowl){
        .present = bowl->present,
        .owner = (uint8_t)index,
        .position_m = bowl->position_m,
        .angles = bowl_angles(bowl),
        .radius_m = BOWL_RADIUS_M,
        .depth_m = BOWL_DEPTH_M,
        .water_below_m = bowl_level_m(bowl),
        .fish_count = bowl->fish_count,
    };
}

static void show_fan(const struct shade *shade, uint32_t index, struct scene_fan *out)
{
    CORE_ASSERT(index < SHADE_MAX);
    const struct shade_cast *cast = &shade->cast;
    *out = (struct scene_fan){
        .present = cast->present,
        .owner = (uint8_t)index,
        .x_m = cast->x_m,
        .z_m = cast->z_m,
        .radius_m = cast->radius_m,
        .dark = cast->dark,
    };
}

static void show_players(const struct core *core, struct scene *scene)
{
    for (uint32_t i = 0; i < POI_MAX; i++) {
        const struct player *player = &core->game.player[i];
        const bool in_round = core->game.phase == PHASE_ROUND;
        const struct leaderboard_place place = leaderboard_best_place(&core->game, (uint8_t)i);
        const uint32_t miss_tick = in_round ? core->world.near_miss[i].tick : 0;
        scene->caught[i] = player->caught;
        scene->player[i] = (struct scene_player){
            .plays = player->plays,
            .lost = in_round && player->plays && !player_has_poi(&core->world, i),
            .fouls = player->fouls,
            .foul = player->foul,
            .foul_s = (float)(core->game.tick - player->foul_tick) * CORE_TICK_S,
            .out = player->out,
            .has_pointer = player->has_pointer,
            .x = player->pointer.x,
            .y = player->pointer.y,
            .place = place.place,
            .period = place.period,
            .level = player->level,
            .miss_s = miss_tick == 0 ? 0.0f : (float)(core->game.tick - miss_tick) * CORE_TICK_S,
            .has_present = core->game.phase == PHASE_RESULT && album_has_present(&core->game, i),
        };
        lesson_show(&core->lessons, &core->game, &core->world, i, &scene->lesson[i]);
        scene->tear[i] = (struct scene_tear){ 0 };
        if (core->game.phase == PHASE_RESULT) {
            tear_clip_show(&core->world.tear_clip[i], core->game.tick - core->game.phase_tick,
                           &scene->tear[i]);
        }
    }
}

static void show_tags(const struct core *core, struct scene *scene)
{
    const bool has_levels = config_has_rules(&core->config, 9);
    scene->tags = (uint8_t)mode_tags_offered(scene->modes, has_levels);
    scene->upright = core->game.upright;
    scene->pointed_tags = 0;
    const uint32_t lead = game_mode_select_lead(&core->world);
    for (uint32_t i = 0; i < POI_MAX; i++) {
        if (i == lead || core->game.player[i].has_pointer) {
            scene->pointed_tags |= (uint8_t)(1u << game_mode_select_tag(&core->game, i));
        }
    }
}

/* Returns the paper grade of the players of the round, or 0 if these players have different grades.
 * Before the first dip, the players with a poi in use count. Without such a player, returns the
 * grade of the player who leads the selection. */
static uint8_t shown_grade(const struct core *core)
{
    const struct game *game = &core->game;
    const uint8_t base = table_setup_grade(&core->config, game->mode);
    for (uint32_t pass = 0; pass < 2u; pass++) {
        uint8_t grade = 0;
        for (uint32_t i = 0; i < POI_MAX; i++) {
            const uint8_t own = rules_grade_at_level(base, game->player[i].level);
            if (pass == 0 ? !game->player[i].plays : !player_has_poi(&core->world, i)) {
                continue;
            }
            if (grade != 0 && own != grade) {
                return 0;
            }
            grade = own;
        }
        if (grade != 0) {
            return grade;
        }
    }
    return rules_grade_at_level(base, game->player[game_mode_select_lead(&core->world)].level);
}

static void show_game(const struct core *core, struct scene *scene)
{
    const struct game *game = &core->game;
    CORE_ASSERT(game->phase <= PHASE_LEADERBOARD && game->mode < MODE_COUNT);
    CORE_ASSERT(game->language < LANGUAGE_COUNT);
    scene->phase = game->phase;
    scene->language = game->language;
    scene->text_size = (uint8_t)core->config.persistent.settings.value[SET_TEXT];
    scene->hint = lesson_screen_hint(game);
    scene->phase_s = (float)(core->game.tick - game->phase_tick) * CORE_TICK_S;
    scene->veil = session_fade(&core->game, &core->config);
    scene->seconds_left = game_seconds_left(game, core->game.tick);
    scene->best_today = game->accounts.ranking.row[leaderboard_board(game)][RANK_DAY][0].caught;
    scene->by_bot = game->bot_played;
    scene->mode = game->mode;
    scene->level = game_level(game);
    scene->choice = game->lab_chosen ? CHOICE_LAB : game->mode;
    scene->modes = table_setup_modes(&core->config);
    scene->grade = shown_grade(core);
    scene->paused = game->paused;
    scene->call = game->call;
    scene->call_s = (float)(core->game.tick - game->call_tick) * CORE_TICK_S;
    show_players(core, scene);
    show_tags(core, scene);
    for (uint32_t mode = 0; mode < MODE_COUNT; mode++) {
        scene->offer[mode].round_s = (uint16_t)table_setup_round_s(&core->config, (uint8_t)mode);
        scene->offer[mode].grade = table_setup_grade(&core->config, (uint8_t)mode);
    }
    credit_show(&core->game.accounts, &core->config, core->game.tick, &scene->credit);
    scene->is_confirming_menu = (uint8_t)menu_is_confirming(&core->game);
    menu_show(&core->game, &core->config, &scene->menu);
    if (game->phase == PHASE_LAB) {
        lab_show(&core->game.lab, &core->config.book, &scene->lab);
    }
    album_show(&core->game, &scene->album);
    name_show(&core->game, &scene->name);
    leaderboard_show(&core->game, &core->config, &scene->leaderboard);
}

void core_scene(const struct core *core, struct scene *scene)
{
    const struct tank *tank = &core->world.tank;
    CORE_ASSERT(tank->fish_count <= SCENE_FISH_MAX);
    const struct tank_preset *preset = tank_preset(tank->preset);
    scene->tick = core->game.tick;
    scene->view = tank_preset_view(preset, false);
    scene->turned_view = tank_preset_view(preset, true);
    scene->tank_size_m = tank->size_m;
    scene->wall_height_m = tank->wall_height_m;
    scene->fish_count = tank->fish_count;
    for (uint32_t i = 0; i < tank->fish_count; i++) {
        show_fish(&tank->fish[i], core->game.tick, &scene->fish[i]);
    }
    show_presents(&core->game, scene->fish);
    for (uint32_t i = 0; i < POI_MAX; i++) {
        show_thrash(&core->world.poi[i], core->game.tick, scene->fish);
        show_poi(core, i, &scene->poi[i]);
        show_bowl(&core->world.bowl[i], i, &scene->bowl[i]);
    }
    for (uint32_t i = 0; i < SHADE_MAX; i++) {
        show_fan(&tank->shade[i], i, &scene->fan[i]);
    }
    scene->pump = (struct scene_pump){
        .present = preset->pump,
        .runs = tank->oxygen.pump,
        .stone_m = tank_stone_m(tank->size_m),
    };
    surface_splash_show(&core->world.splashes, core->game.tick, scene);
    water_slopes(&tank->water, tank->size_m, scene->slope);
    show_game(core, scene);
}
