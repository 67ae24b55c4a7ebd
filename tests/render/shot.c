/* shot.c -- plays the stall for a while without a screen and keeps a picture, or times the passes.
 *
 * A developer's eye: `make shot ARGS="--seconds 12 --size 1920x1080 -o shot.png"`. */
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "core/core.h"
#include "platform/png.h"
#include "platform/render/display_gl.h"
#include "tests/render/shot_menu.h"

#define PIXELS_MAX (3840u * 2160u)
#define SKIN_FRAMES 150u /* Until the skins of all keys that are shown are painted finely. */
#define PASS_FRAMES 40u
#define PUSH_M_S 0.80f

struct options {
    float seconds, scale;
    float stamina, oxygen_mg_l;  /* < 0: the preset's own. */
    uint8_t plain;
    float close_x_m, close_z_m, close_m; /* A camera so near to a point of the surface; 0: none. */
    uint32_t width, height, samples, fish, seed;
    uint8_t start, english, passes, paper, preset;
    uint8_t stress, owner;       /* Of --paper: coloured as in practice; whose it is, ... */
    float water_m, tilt_rad, heel_rad; /* ... what lies on it, how it lies; and how bowls lie. */
    uint8_t careless;
    float follow_m;              /* A camera so near to the first poi; 0: none. */
    uint8_t players, mode, modes; /* Who plays, what is pointed at, and what is offered. */
    uint8_t lab, compare, path, size_layer; /* The growth lab, and what is shown there: ... */
    uint8_t album;                          /* (or so many fish in the album) */
    const char *menu;                       /* (or a page of the operator's menu, at a step) */
    uint8_t step, coins;                    /* What a round costs. */
    uint8_t rotation;                       /* How the picture lies on the screen, ... */
    float inset, light, shift;              /* ... as struct showing has it. */
    uint32_t species;
    float progress;                         /* ... this species, so far in its life. */

    struct shade_input fan; /* X_CM,Z_CM on the command line. */
    const char *out;
};

static struct core core;
static struct scene scene;
static struct display_gl display;
static uint8_t pixels[PIXELS_MAX * 3u];

static double clock_ms(clockid_t clock)
{
    struct timespec time;
    clock_gettime(clock, &time);
    return (double)time.tv_sec * 1e3 + (double)time.tv_nsec * 1e-6;
}

static double now_ms(void)
{
    return clock_ms(CLOCK_MONOTONIC);
}

/* Of all threads together; steadier than the wall clock where others work on the same cores. */
static double cpu_ms(void)
{
    return clock_ms(CLOCK_PROCESS_CPUTIME_ID);
}

static uint8_t preset_named(const char *name)
{
    for (uint8_t id = 0; id < TANK_PRESET_COUNT; id++) {
        if (!strcmp(tank_preset(id)->name, name)) {
            return id;
        }
    }
    fprintf(stderr, "no tank '%s': festival, thesis or official\n", name);
    exit(2);
}

static uint8_t mode_named(const char *name)
{
    for (uint8_t mode = 0; mode < MODE_COUNT; mode++) {
        if (!strcmp(rules_of(mode)->name, name)) {
            return mode;
        }
    }
    fprintf(stderr, "no mode '%s': festival, championship or practice\n", name);
    exit(2);
}

static uint32_t species_named(const char *name)
{
    for (uint32_t i = 0; i < species_table_count; i++) {
        if (!strcmp(species_table[i]->card.id, name)) {
            return i;
        }
    }
    fprintf(stderr, "no species '%s'\n", name);
    exit(2);
}

enum kind { OPTION_FLAG, OPTION_BYTE, OPTION_NUMBER, OPTION_FLOAT, OPTION_TEXT };

/* An option that sets one member as it stands. */
static const struct plain_option {
    const char *name;
    enum kind kind;
    size_t offset;
    float unit; /* Of a float. */
} plain_options[] = {
    { "--start", OPTION_FLAG, offsetof(struct options, start), 0.0f },
    { "--compare", OPTION_FLAG, offsetof(struct options, compare), 0.0f },
    { "--path", OPTION_FLAG, offsetof(struct options, path), 0.0f },
    { "--size-layer", OPTION_FLAG, offsetof(struct options, size_layer), 0.0f },
    { "--progress", OPTION_FLOAT, offsetof(struct options, progress), 1.0f },
    { "--album", OPTION_BYTE, offsetof(struct options, album), 0.0f },
    { "--menu", OPTION_TEXT, offsetof(struct options, menu), 0.0f },
    { "--step", OPTION_BYTE, offsetof(struct options, step), 0.0f },
    { "--coins", OPTION_BYTE, offsetof(struct options, coins), 0.0f },
    { "--rotation", OPTION_BYTE, offsetof(struct options, rotation), 0.0f },
    { "--inset", OPTION_FLOAT, offsetof(struct options, inset), 0.001f },
    { "--light", OPTION_FLOAT, offsetof(struct options, light), 0.01f },
    { "--shift", OPTION_FLOAT, offsetof(struct options, shift), 0.001f },
    { "--en", OPTION_FLAG, offsetof(struct options, english), 0.0f },
    { "--passes", OPTION_FLAG, offsetof(struct options, passes), 0.0f },
    { "--paper", OPTION_FLAG, offsetof(struct options, paper), 0.0f },
    { "--stress", OPTION_FLAG, offsetof(struct options, stress), 0.0f },
    { "--careless", OPTION_FLAG, offsetof(struct options, careless), 0.0f },
    { "--plain", OPTION_FLAG, offsetof(struct options, plain), 0.0f },
    { "--players", OPTION_BYTE, offsetof(struct options, players), 0.0f },
    { "--samples", OPTION_NUMBER, offsetof(struct options, samples), 0.0f },
    { "--fish", OPTION_NUMBER, offsetof(struct options, fish), 0.0f },
    { "--seed", OPTION_NUMBER, offsetof(struct options, seed), 0.0f },
    { "--water", OPTION_FLOAT, offsetof(struct options, water_m), 0.001f },
    { "--tilt", OPTION_FLOAT, offsetof(struct options, tilt_rad), F_DEG },
    { "--heel", OPTION_FLOAT, offsetof(struct options, heel_rad), F_DEG },
    { "--follow", OPTION_FLOAT, offsetof(struct options, follow_m), 1.0f },
    { "--stamina", OPTION_FLOAT, offsetof(struct options, stamina), 1.0f },
    { "--oxygen", OPTION_FLOAT, offsetof(struct options, oxygen_mg_l), 1.0f },
    { "--seconds", OPTION_FLOAT, offsetof(struct options, seconds), 1.0f },
    { "--scale", OPTION_FLOAT, offsetof(struct options, scale), 1.0f },
    { "-o", OPTION_TEXT, offsetof(struct options, out), 0.0f },
};

static void set_member(void *member, const struct plain_option *option, const char *value)
{
    switch (option->kind) {
    case OPTION_FLAG:
        *(uint8_t *)member = 1;
        break;
    case OPTION_BYTE:
        *(uint8_t *)member = (uint8_t)strtoul(value, NULL, 10);
        break;
    case OPTION_NUMBER:
        *(uint32_t *)member = (uint32_t)strtoul(value, NULL, 10);
        break;
    case OPTION_FLOAT:
        *(float *)member = option->unit * strtof(value, NULL);
        break;
    case OPTION_TEXT:
        *(const char **)member = value;
        break;
    }
}

static void read_plain(struct options *o, const char *name, const char *value)
{
    for (size_t i = 0; i < sizeof plain_options / sizeof *plain_options; i++) {
        if (!strcmp(name, plain_options[i].name)) {
            set_member((char *)o + plain_options[i].offset, &plain_options[i], value);
        }
    }
}

static void read_named(struct options *o, const char *name, const char *value)
{
    if (!strcmp(name, "--mode")) {
        o->mode = mode_named(value);
        o->modes = (uint8_t)(1u << o->mode);
    } else if (!strcmp(name, "--choose")) {
        o->modes = (1u << CHOICE_COUNT) - 1u;
        o->start = 1;
    } else if (!strcmp(name, "--lab")) {
        o->lab = 1;
        o->species = species_named(value);
    } else if (!strcmp(name, "--owner")) {
        o->owner = (uint8_t)(strtoul(value, NULL, 10) % POI_MAX);
    } else if (!strcmp(name, "--preset")) {
        o->preset = preset_named(value);
    } else if (!strcmp(name, "--close")) {
        sscanf(value, "%f,%f,%f", &o->close_x_m, &o->close_z_m, &o->close_m);
    } else if (!strcmp(name, "--fan")) {
        float x_cm = 0.0f, z_cm = 0.0f;
        const int is_there = sscanf(value, "%f,%f", &x_cm, &z_cm) == 2;
        o->fan = (struct shade_input){ (uint8_t)is_there, 0.01f * x_cm, 0.01f * z_cm, 0.10f };
    } else if (!strcmp(name, "--size")) {
        sscanf(value, "%ux%u", &o->width, &o->height);
    }
}

static struct options parse(int argc, char **argv)
{
    struct options o = { .seconds = 8.0f, .width = 1280, .height = 720, .out = "out/shot.png",
                         .light = 1.0f, .stamina = -1.0f, .oxygen_mg_l = -1.0f };
    for (int i = 1; i < argc; i++) {
        const char *const value = i + 1 < argc ? argv[i + 1] : "";
        read_plain(&o, argv[i], value);
        read_named(&o, argv[i], value);
    }
    return o;
}

/* Fish and water as an experiment wants them. */
static void set_water(const struct options *options)
{
    struct tank_config config = tank_config_of(options->preset);
    config.seed = core.config.seed;
    config.fish_count = core.tank.fish_count;
    if (options->stamina >= 0.0f) {
        config.stamina_min = config.stamina_max = 0.01f * options->stamina;
    }
    if (options->oxygen_mg_l >= 0.0f) {
        config.oxygen_mg_l = options->oxygen_mg_l;
        config.time_compression = 0.0f;
    }
    if (!tank_open(&core.tank, &config)) {
        exit(2);
    }
}

static void come_close(const struct options *options)
{
    scene.view.target_m = v3(options->close_x_m, -0.01f, options->close_z_m);
    scene.view.eye_m = v3(options->close_x_m, 0.75f * options->close_m,
                          options->close_z_m + 0.66f * options->close_m);
}

static void follow(const struct options *options)
{
    const vec3 at = scene.poi[0].position_m;
    scene.view.target_m = at;
    scene.view.eye_m = v3_add(at, v3(0.0f, 0.75f * options->follow_m, 0.66f * options->follow_m));
}

/* A hand that does it wrong: it wets one half of the paper, steeply, and pushes it flat through the
 * water. */
static struct poi_input careless_hand(float time_s)
{
    const float sinks = f_smoothstep(4.0f, 4.6f, time_s);
    const float turns = f_smoothstep(3.6f, 4.0f, time_s);
    const float pushes_s = f_max(time_s - 5.0f, 0.0f);
    return (struct poi_input){
        .link = POI_LINK_LIVE,
        .has_wrist = 1,
        .target = { .position_m = v3(-0.22f + PUSH_M_S * pushes_s, 0.055f - 0.056f * sinks, 0.05f),
                    .angles = { .roll_rad = -40.0f * F_DEG * turns } },
    };
}

static uint8_t is_upright(const struct options *options)
{
    const float width = (float)options->width, height = (float)options->height;
    return options->rotation & 1u ? height < OVERLAY_UPRIGHT_ASPECT * width
                                  : width < OVERLAY_UPRIGHT_ASPECT * height;
}

static void open_lab(const struct options *options, struct output *output)
{
    struct lab *lab = &core.game.lab;
    lab->species = (uint8_t)options->species;
    lab_begin(&core, output);
    lab->playing = 0;
    lab->upright = is_upright(options);
    lab->progress = options->progress;
    lab->compare = options->compare;
    lab->path = options->path;
    lab->layer = options->size_layer ? LAB_LAYER_SIZE : 0;
}

/* As if the tank's first fish had been caught, so far in the album's page. */
static void open_album(const struct options *options)
{
    struct album *album = &core.game.album;
    album_clear(album);
    for (uint32_t i = 0; i < options->album; i++) {
        core.tank.fish[i].gait = GAIT_BOWL;
        core.tank.fish[i].holder = 0;
    }
    album_note(&core, 0, options->album);
    core.game.phase = PHASE_ALBUM;
    core.game.phase_tick =
        core.tick - (uint32_t)(options->progress * (float)album_ticks(album->fish_count));
}

static void play(const struct options *options)
{
    const struct core_config config = { .seed = options->seed ? options->seed : 2013u,
                                        .preset = options->preset,
                                        .fish_count = options->fish,
                                        .players = options->players,
                                        .modes = options->modes,
                                        .credit_coins = options->coins,
                                        .language = options->english ? LANGUAGE_EN : LANGUAGE_JA };
    struct output output = { 0 };
    if (core_init(&core, &config) != CORE_OK) {
        exit(2);
    }
    set_water(options);
    const uint32_t ticks = (uint32_t)(options->seconds * (float)CORE_TICK_HZ);
    for (uint32_t i = 0; i < ticks; i++) {
        struct input input = { 0 };
        for (uint32_t k = 0; k < POI_MAX && k <= options->players; k++) {
            input.poi[k].link = k == 0 || k < options->players ? POI_LINK_BOT : POI_LINK_ABSENT;
        }
        if (options->careless) {
            input.poi[0] = careless_hand((float)i * CORE_TICK_S);
        }
        input.shade[0] = options->fan;
        if (options->start && i == 60u) {
            input.pressed = INPUT_START;
        }
        output.sound_count = 0;
        core_tick(&core, &input, &output);
    }
    if (options->lab) {
        open_lab(options, &output);
    } else if (options->album > 0) {
        open_album(options);
    } else if (options->menu) {
        shot_menu_open(&core, options->menu, options->step, is_upright(options));
        shot_menu_name(&scene.devices, core.game.menu.file_first);
    }
    core_scene(&core, &scene);
}

/* A half wet, torn poi held close to the eye. */
static void show_paper(const struct options *options)
{
    struct scene_poi *const poi = &scene.poi[0];
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
    scene.view.eye_m = v3(0.0f, 0.32f, 0.22f);
    scene.view.target_m = v3(0.01f, 0.0f, 0.03f);
}

struct meter {
    double last, last_cpu, sums[STEP_COUNT], cpu_sums[STEP_COUNT];
};

static void on_step(void *context, enum render_step step)
{
    struct meter *const meter = context;
    glFinish();
    const double now = now_ms();
    meter->sums[step] += now - meter->last;
    meter->last = now;
    const double cpu = cpu_ms();
    meter->cpu_sums[step] += cpu - meter->last_cpu;
    meter->last_cpu = cpu;
}

static int by_value(const void *a, const void *b)
{
    const double x = *(const double *)a;
    const double y = *(const double *)b;
    return (x > y) - (x < y);
}

static void time_passes(const struct hal_display *device)
{
    static const char *const names[STEP_COUNT] = { "prepare", "light", "ground", "life",
                                                   "surface", "above", "ui" };
    struct meter meter = { 0 };
    double frames[PASS_FRAMES];
    for (uint32_t i = 0; i < PASS_FRAMES; i++) {
        const double start = now_ms();
        device->ops->present(device->self, &scene);
        glFinish();
        frames[i] = now_ms() - start;
    }
    qsort(frames, PASS_FRAMES, sizeof *frames, by_value);
    display.renderer.on_step = on_step;
    display.renderer.on_step_context = &meter;
    for (uint32_t i = 0; i < PASS_FRAMES; i++) {
        glFinish();
        meter.last = now_ms();
        meter.last_cpu = cpu_ms();
        device->ops->present(device->self, &scene);
    }
    display.renderer.on_step = NULL;
    for (uint32_t i = 0; i < STEP_COUNT; i++) {
        printf("%-8s %6.2f ms, %6.2f ms of CPU\n", names[i], meter.sums[i] / PASS_FRAMES,
               meter.cpu_sums[i] / PASS_FRAMES);
    }
    printf("%-8s %6.2f ms median, %.2f best, %.2f worst of %u\n", "frame", frames[PASS_FRAMES / 2],
           frames[0], frames[PASS_FRAMES - 1], PASS_FRAMES);
}

int main(int argc, char **argv)
{
    const struct options options = parse(argc, argv);
    display.config = (struct display_gl_config){ .width = options.width,
                                                 .height = options.height,
                                                 .off_screen = true,
                                                 .scene_scale = options.scale,
                                                 .samples = options.samples };
    const struct hal_display device = display_gl_device(&display);
    if (options.menu && !shot_menu_knows(options.menu, options.step)) {
        fprintf(stderr, "shot: --menu '%s' --step %u: no such page or step\n", options.menu,
                options.step);
        return 2;
    }
    play(&options);
    if (options.plain) {
        scene.phase = PHASE_WORDLESS;
        scene.poi[0].present = scene.bowl[0].present = 0;
    }
    if (options.close_m > 0.0f) {
        come_close(&options);
    }
    if (options.paper) {
        show_paper(&options);
    }
    if (options.follow_m > 0.0f) {
        follow(&options);
    }
    for (uint32_t i = 0; i < POI_MAX && options.heel_rad != 0.0f; i++) {
        scene.bowl[i].angles.roll_rad = options.heel_rad;
    }
    const double before = now_ms();
    if (device.ops->open(device.self) != HAL_OK) {
        fprintf(stderr, "%s\n", device.ops->describe(device.self));
        return 1;
    }
    const struct showing showing = { .rotation = options.rotation,
                                     .inset_x = options.inset, .inset_y = options.inset,
                                     .shift_x = options.shift, .shift_y = options.shift,
                                     .light = options.light };
    device.ops->place(device.self, &showing);
    printf("%s (opened in %.0f ms)\n", device.ops->describe(device.self), now_ms() - before);
    for (uint32_t i = 0; i < (options.lab || options.album > 0 ? SKIN_FRAMES : 1u); i++) {
        device.ops->present(device.self, &scene);
    }
    if (options.passes) {
        time_passes(&device);
    }
    struct hal_image image = { .rgb = pixels, .size = sizeof pixels };
    if (device.ops->capture(device.self, &image) != HAL_OK ||
        png_write(options.out, pixels, image.width, image.height) != 0) {
        fprintf(stderr, "no picture at %s\n", options.out);
        return 1;
    }
    device.ops->close(device.self);
    return 0;
}
