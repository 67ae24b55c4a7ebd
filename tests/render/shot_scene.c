/* shot_scene.c -- implementation of shot_scene.h: plays the game and fills the scene. */
#include "tests/render/shot_scene.h"

#include <stdlib.h>

#include "core/core.h"
#include "core/game/lab/lab.h"
#include "platform/kiosk/output_devices.h"
#include "tests/render/shot_menu.h"

#define PUSH_M_S 0.80f

static struct core core;

/* Creates the tank with the number and the stamina of the fish and the oxygen content that the
 * options give. */
static void set_water(const struct shot_options *options)
{
    struct tank_config config = tank_config_of(options->preset);
    config.seed = core.config.seed;
    config.fish_count = core.world.tank.fish_count;
    if (options->stamina >= 0.0f) {
        config.stamina_min = config.stamina_max = 0.01f * options->stamina;
    }
    if (options->oxygen_mg_l >= 0.0f) {
        config.oxygen_mg_l = options->oxygen_mg_l;
        config.time_compression = 0.0f;
    }
    if (!tank_open(&core.world.tank, &config)) {
        exit(2);
    }
}

/* Returns the pose of a careless player who tears the paper. The player dips one half of the paper
 * at a steep angle, and then pushes the half-wet paper flat through the water. */
static struct poi_input careless_pose(float time_s)
{
    const float sinks = f_smoothstep(4.0f, 4.6f, time_s);
    const float turns = f_smoothstep(3.6f, 4.0f, time_s);
    const float pushes_s = f_max(time_s - 5.0f, 0.0f);
    return (struct poi_input){
        .link = POI_SOURCE_LIVE,
        .has_wrist = 1,
        .target = { .position_m = v3(-0.22f + PUSH_M_S * pushes_s, 0.055f - 0.056f * sinks, 0.05f),
                    .angles = { .roll_rad = -40.0f * F_DEG * turns } },
    };
}

static void open_lab(const struct shot_options *options, struct output *output)
{
    struct lab *lab = &core.game.lab;
    lab->species = (uint8_t)options->species;
    lab_begin(&core.game, &core.world, &core.config, output);
    lab->playing = 0;
    lab->upright = shot_is_upright(options);
    lab->progress = options->progress;
    lab->compare = options->compare;
    lab->path = options->path;
    lab->layer = options->size_layer ? LAB_LAYER_SIZE : 0;
}

/* Opens the album as if the first `album` fish of the tank had been caught. The page shows the fish
 * at the growth progress of the options. */
static void open_album(const struct shot_options *options)
{
    struct album *album = &core.game.album;
    *album = (struct album){ 0 };
    for (uint32_t i = 0; i < options->album; i++) {
        core.world.tank.fish[i].gait = GAIT_BOWL;
        core.world.tank.fish[i].holder = 0;
    }
    core.game.player[0].caught = options->album;
    album_note(&core.game.album, &core.world, 0, options->album);
    core.game.phase = PHASE_ALBUM;
    core.game.phase_tick =
        core.game.tick - (uint32_t)(options->progress * (float)album_ticks(album->fish_count));
}

/* Number of ticks that were played, 0 before the first call of play(). A later call continues. */
static uint32_t played;

static void open_game(const struct shot_options *options)
{
    const struct core_config config = { .seed = options->seed ? options->seed : 2013u,
                                        .preset = options->preset,
                                        .fish_count = options->fish,
                                        .players = options->players,
                                        .modes = options->modes,
                                        .credit_coins = options->coins,
                                        .language = options->english ? LANGUAGE_EN : LANGUAGE_JA };
    if (core_init(&core, &config) != CORE_OK) {
        exit(2);
    }
    set_water(options);
}

static void play(const struct shot_options *options, struct output *output)
{
    if (played == 0) {
        open_game(options);
    }
    const uint32_t ticks = (uint32_t)(options->seconds * (float)CORE_TICK_HZ);
    for (uint32_t i = played; i < ticks; i++) {
        struct input input = { 0 };
        for (uint32_t k = 0; k < POI_MAX && k <= options->players; k++) {
            input.poi[k].link = k == 0 || k < options->players ? POI_SOURCE_BOT : POI_SOURCE_ABSENT;
        }
        if (options->careless) {
            input.poi[0] = careless_pose((float)i * CORE_TICK_S);
        }
        input.shade[0] = options->fan;
        if (options->start && i == 60u) {
            input.pressed = INPUT_START;
        }
        output->sound_count = 0;
        core_tick(&core, &input, output);
    }
    played = ticks;
}

/* Opens the page that the options select: the growth lab, the album or the operator's menu. */
static void open_page(const struct shot_options *options, struct output *output,
                      struct scene_devices *devices)
{
    if (options->lab) {
        open_lab(options, output);
    } else if (options->album > 0) {
        open_album(options);
    } else if (options->menu) {
        shot_menu_open(&core, options->menu, options->step, shot_is_upright(options));
        shot_menu_name(devices, core.game.menu.file_first);
    }
}

static void come_close(const struct shot_options *options, struct scene *scene)
{
    scene->view.target_m = v3(options->close_x_m, -0.01f, options->close_z_m);
    scene->view.eye_m = v3(options->close_x_m, 0.75f * options->close_m,
                           options->close_z_m + 0.66f * options->close_m);
}

static void follow(const struct shot_options *options, struct scene *scene)
{
    const vec3 at = scene->poi[0].position_m;
    scene->view.target_m = at;
    scene->view.eye_m = v3_add(at, v3(0.0f, 0.75f * options->follow_m, 0.66f * options->follow_m));
}

/* Moves the camera to the place that it reaches in a round with one player. */
static void come_closer(const struct shot_options *options, struct scene *scene)
{
    static const struct output_dimmer dimmer;
    struct output_camera camera = { 0 };
    struct scene round = *scene;
    round.phase = PHASE_ROUND;
    const vec3 at_m = v3_flat(scene->poi[0].position_m);
    for (uint32_t i = 0; i < 600u; i++) {
        round.tick += 2u;
        round.poi[0].position_m = v3_add(at_m, v3(0.0f, 0.035f, 0.0f));
        round.view = scene->view;
        output_camera_step(&camera, &dimmer, &round, shot_is_upright(options), true, &round.view);
    }
    scene->view = round.view;
}

void shot_move_camera(const struct shot_options *options, struct scene *scene)
{
    if (options->closer) {
        come_closer(options, scene);
    }
    if (options->drift) {
        /* The largest motion of output_camera_step(). */
        scene->view.eye_m = v3_add(
            scene->view.eye_m, view_to_world(shot_is_upright(options), v3(0.045f, 0.020f, 0.030f)));
    }
}

/* Fills the paper of a poi for a picture. The paper is half wet and has two holes, with stress
 * around the holes. */
static void fill_sheet(struct scene_poi *poi)
{
    for (uint32_t z = 0; z < SHEET_SIDE; z++) {
        for (uint32_t x = 0; x < SHEET_SIDE; x++) {
            const float u = ((float)x - 15.5f) / 16.0f;
            const float v = ((float)z - 15.5f) / 16.0f;
            const float hole = f_sqrt((u - 0.3f) * (u - 0.3f) + (v + 0.2f) * (v + 0.2f) * 0.5f);
            const float small = f_sqrt((u + 0.4f) * (u + 0.4f) + (v - 0.3f) * (v - 0.3f));
            const uint32_t cell = z * SHEET_SIDE + x;
            const float load = f_max(0.5f - 0.6f * f_abs(v - 0.1f), 0.28f - f_min(hole, small));
            poi->stress[cell] = (uint8_t)(255.0f * f_clamp(1.8f * load, 0.0f, 1.0f));
            poi->wetness[cell] =
                (uint8_t)(255.0f * (1.0f - f_smoothstep(-0.3f, 0.3f, v + 0.4f * u)));
            poi->integrity[cell] =
                hole < 0.22f || small < 0.12f
                    ? 0
                    : (uint8_t)(60.0f + 195.0f * f_smoothstep(0.2f, 0.5f, f_min(hole, small)));
        }
    }
}

/* Places a poi in front of the camera. */
static void show_paper(const struct shot_options *options, struct scene *scene)
{
    struct scene_poi *const poi = &scene->poi[0];
    poi->present = 1;
    poi->owner = options->owner;
    poi->shows_stress = options->stress;
    poi->water_m = options->water_m;
    poi->position_m = v3(0.02f, 0.035f, 0.02f);
    poi->angles = (struct angles){ 0.3f, 0.35f, 0.1f };
    poi->sag_m = 0.006f;
    if (options->tilt_rad != 0.0f) {
        poi->angles = (struct angles){ 0.3f, 0.0f, options->tilt_rad };
        poi->sag_m = options->tilt_rad > 0.5f * F_PI ? -0.003f : 0.003f;
    }
    poi->ring_radius_m = 0.04f;
    fill_sheet(poi);
    scene->view.eye_m = v3(0.0f, 0.32f, 0.22f);
    scene->view.target_m = v3(0.01f, 0.0f, 0.03f);
}

void shot_scene(const struct shot_options *options, struct scene *scene)
{
    struct output output = { 0 };
    play(options, &output);
    open_page(options, &output, &scene->devices);
    core_scene(&core, scene);
    if (shot_is_upright(options)) {
        scene_use_turned(scene);
    }
    if (options->plain) {
        scene->phase = PHASE_WORDLESS;
        scene->poi[0].present = scene->bowl[0].present = 0;
    }
    if (options->close_m > 0.0f) {
        come_close(options, scene);
    }
    if (options->paper) {
        show_paper(options, scene);
    }
    if (options->follow_m > 0.0f) {
        follow(options, scene);
    }
    for (uint32_t i = 0; i < POI_MAX && options->heel_rad != 0.0f; i++) {
        scene->bowl[i].angles.roll_rad = options->heel_rad;
    }
}
