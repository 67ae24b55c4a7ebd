/* specimen.c -- draws species at any stage of growth for visual review: one fish, or a sheet of
 * many fish.
 *
 * --species NAME: only this species. By default each built-in species has a row.
 *
 * --progress A,B,..: stages of growth to draw, 0 .. 1. The default is six values from 0 to 1.
 *
 * --keys: draws the key shapes.
 *
 * --template NAME: replaces the species' own blend curves by the growth template ordinary,
 * pairwise, simultaneous or smooth.
 *
 * --thesis: morphs as in chapter 4 of the 2005 thesis.
 *
 * --yaw --pitch --roll DEGREES: view direction. The default is the side view.
 *
 * --amplitude A --phase RADIANS: the swimming motion. --cell WxH: size of one fish in px. -o FILE:
 * output.
 *
 * --water RRGGBB: colour of the water.
 *
 * --time: also prints the time to draw a sheet.
 *
 * A developer tool: `make specimen ARGS="--species hirame --progress 0.5 --cell 1200x700"`. */
#include <GLES3/gl3.h>
#include <SDL.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "fonts.h"
#include "platform/os/png.h"
#include "platform/render/pass/specimen_pass.h"
#include "platform/render/ui/ui.h"

#define STEPS_MAX 12u
#define COST_DRAWS 40u
#define SIDE_MAX 8192u
#define PIXELS_MAX (SIDE_MAX * 2048u)

struct options {
    const char *species, *out;
    float progress[STEPS_MAX];
    uint32_t step_count, width, height;
    uint32_t water; /* Colour of the water as 0xRRGGBBAA. */
    uint8_t keys, thesis, template_id, turned, time;
    float yaw_rad, pitch_rad, roll_rad, amplitude, phase_rad;
};

static struct specimen_pass pass;
static struct textures textures;
static struct ui ui;
static struct straight_memory straight[SPECIES_MAX];
static struct species straightened[SPECIES_MAX];
static uint8_t rgba[PIXELS_MAX * 4u], rgb[PIXELS_MAX * 3u];

static void fail(const char *what, const char *why)
{
    fprintf(stderr, "specimen: %s: %s\n", what, why);
    exit(2);
}

static uint8_t template_named(const char *name)
{
    static const char *const names[] = { "own", "ordinary", "pairwise", "simultaneous", "smooth" };
    for (uint8_t i = 0; i < TEMPLATE_COUNT; i++) {
        if (!strcmp(name, names[i])) {
            return i;
        }
    }
    fail("no such template", name);
    return 0;
}

static void read_steps(struct options *o, const char *text)
{
    char *rest = NULL;
    for (o->step_count = 0; *text && o->step_count < STEPS_MAX; text = *rest ? rest + 1 : rest) {
        o->progress[o->step_count++] = f_clamp(strtof(text, &rest), 0.0f, 1.0f);
    }
}

static void read_size(struct options *o, const char *text)
{
    char *rest = NULL;
    o->width = (uint32_t)strtoul(text, &rest, 10);
    o->height = *rest ? (uint32_t)strtoul(rest + 1, NULL, 10) : o->width;
}

static bool read_flag(struct options *o, const char *name)
{
    if (!strcmp(name, "--keys")) {
        o->keys = 1;
    } else if (!strcmp(name, "--thesis")) {
        o->thesis = 1;
    } else if (!strcmp(name, "--time")) {
        o->time = 1;
    } else {
        return false;
    }
    return true;
}

static void read_value(struct options *o, const char *name, const char *value)
{
    const float number = strtof(value, NULL);
    if (!strcmp(name, "--species")) {
        o->species = value;
    } else if (!strcmp(name, "-o")) {
        o->out = value;
    } else if (!strcmp(name, "--progress")) {
        read_steps(o, value);
    } else if (!strcmp(name, "--template")) {
        o->template_id = template_named(value);
    } else if (!strcmp(name, "--cell")) {
        read_size(o, value);
    } else if (!strcmp(name, "--amplitude")) {
        o->amplitude = number;
    } else if (!strcmp(name, "--phase")) {
        o->phase_rad = number;
    } else if (!strcmp(name, "--yaw")) {
        o->yaw_rad = number * F_DEG;
        o->turned = 1;
    } else if (!strcmp(name, "--pitch")) {
        o->pitch_rad = number * F_DEG;
        o->turned = 1;
    } else if (!strcmp(name, "--water")) {
        o->water = (uint32_t)strtoul(value, NULL, 16) << 8u | 255u;
    } else if (!strcmp(name, "--roll")) {
        o->roll_rad = number * F_DEG;
    } else {
        fail("no such option", name);
    }
}

static struct options parse(int count, char **words)
{
    struct options o = { .out = "out/specimen.png",
                         .width = 420,
                         .height = 260,
                         .amplitude = 0.6f,
                         .phase_rad = 1.0f,
                         .water = 0x2f6c7cffu };
    for (int i = 1; i < count; i++) {
        if (!read_flag(&o, words[i])) {
            read_value(&o, words[i], i + 1 < count ? words[i + 1] : "");
            i++;
        }
    }
    if (o.step_count == 0 && !o.keys) {
        read_steps(&o, "0,0.2,0.4,0.6,0.8,1");
    }
    return o;
}

static void open_context(void)
{
    SDL_setenv("SDL_VIDEODRIVER", "offscreen", 0);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_PROFILE_MASK, SDL_GL_CONTEXT_PROFILE_ES);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MAJOR_VERSION, 3);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MINOR_VERSION, 0);
    SDL_Window *window = NULL;
    if (SDL_Init(SDL_INIT_VIDEO) != 0 ||
        !(window = SDL_CreateWindow("specimen", 0, 0, 64, 64, SDL_WINDOW_OPENGL)) ||
        !SDL_GL_CreateContext(window)) {
        fail("no OpenGL ES 3 context", SDL_GetError());
    }
}

static uint32_t steps_of(const struct options *o, const struct species *species)
{
    return o->keys ? species->card.key_count : o->step_count;
}

static void label(const struct options *o, const struct species *species,
                  const struct specimen *fish, float x_px, float y_px)
{
    char words[96];
    const float size_px = (float)o->height / 20.0f;
    const float mm = 1e3f * life_length_m(&species->card, fish->progress);
    snprintf(words, sizeof words, mm < 1000.0f ? "%s %.3g mm" : "%s %.4g mm", species->card.id,
             (double)mm);
    const struct ui_text style = {
        .font = FONT_BODY, .size_px = size_px, .align = 0.5f, .fill = 0xffffffd0u
    };
    ui_text(&ui.batch, style, x_px, y_px, words);
}

/* Prints the CPU time of drawing a sheet. The time includes all threads of the process, because a
 * software renderer works in its own threads. */
static void print_cost(const float sheet[2], uint32_t fish_count)
{
    const struct display_transform transform =
        display_transform_of(&(struct display_settings){ .light = 1.0f }, sheet[0], sheet[1]);
    const clock_t start = clock();
    for (uint32_t i = 0; i < COST_DRAWS; i++) {
        for (uint32_t k = 0; k < ui.batch.specimen_count; k++) {
            specimen_pass_draw(&pass, &ui.batch.specimens[k], &transform);
        }
        glFinish();
    }
    const double used_s = (double)(clock() - start) / CLOCKS_PER_SEC;
    printf("a fish of %.0f px: %.2f ms of processor time\n",
           (double)ui.batch.specimens[0].length_px, 1e3 * used_s / COST_DRAWS / fish_count);
}

static void show(const struct options *o, const struct species *species, uint32_t row,
                 const float sheet[2])
{
    struct morph_rig rig;
    const uint32_t steps = steps_of(o, species);
    ui_batch_clear(&ui.batch);
    ui_shape(&ui.batch, &(struct ui_shape){
                            .box = { 0.0f, (float)(row * o->height), sheet[0], (float)o->height },
                            .kind = UI_WATER,
                            .fill = o->water,
                            .line = 0x0f2c36ff });
    morph_rig_init(&rig, &species->card, (enum graph_template)o->template_id);
    for (uint32_t i = 0; i < steps; i++) {
        struct specimen fish = {
            .species = species,
            .rig = &rig,
            .progress = o->keys ? (float)i / (float)(steps - 1u) : o->progress[i],
            .phase_rad = o->phase_rad,
            .amplitude = o->amplitude,
            .shadow = 0.35f,
        };
        specimen_portrait(&fish);
        if (o->turned) {
            fish.yaw_rad = o->yaw_rad;
            fish.pitch_rad = o->pitch_rad;
        }
        fish.roll_rad = o->roll_rad;
        specimen_fit(&fish, ((float)i + 0.06f) * (float)o->width,
                     ((float)row + 0.06f) * (float)o->height, 0.88f * (float)o->width,
                     0.80f * (float)o->height);
        specimen_pass_finish(&pass, &fish);
        ui_specimen(&ui.batch, &fish);
        label(o, species, &fish, ((float)i + 0.5f) * (float)o->width,
              ((float)row + 0.955f) * (float)o->height);
    }
    const struct display_transform transform =
        display_transform_of(&(struct display_settings){ .light = 1.0f }, sheet[0], sheet[1]);
    ui_show(&ui, &pass, &transform);
    if (o->time) {
        print_cost(sheet, ui.batch.specimen_count);
    }
}

static const struct species *variant(const struct options *o, const struct species *species,
                                     uint32_t index)
{
    if (o->thesis) {
        straight_thesis(species, &straight[index], &straightened[index]);
        return &straightened[index];
    }
    if (o->template_id == TEMPLATE_ORDINARY) {
        straight_species(species, &straight[index], &straightened[index]);
        return &straightened[index];
    }
    return species;
}

static int keep(const char *path, uint32_t width, uint32_t height)
{
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, (GLsizei)width, (GLsizei)height, GL_RGBA, GL_UNSIGNED_BYTE, rgba);
    for (uint32_t i = 0; i < width * height; i++) {
        const uint32_t from = (height - 1u - i / width) * width + i % width;
        memcpy(rgb + i * 3u, rgba + from * 4u, 3);
    }
    return png_write(path, rgb, width, height);
}

int main(int count, char **words)
{
    const struct options options = parse(count, words);
    const struct species *chosen[SPECIES_MAX];
    uint32_t rows = 0, columns = 1;
    for (uint32_t i = 0; i < species_table_count; i++) {
        if (!options.species || !strcmp(options.species, species_table[i]->card.id)) {
            chosen[rows] = variant(&options, species_table[i], i);
            const uint32_t steps = steps_of(&options, chosen[rows++]);
            columns = steps > columns ? steps : columns;
        }
    }
    const uint32_t width = columns * options.width, height = rows * options.height;
    if (rows == 0 || width > SIDE_MAX || height > SIDE_MAX || width * height > PIXELS_MAX) {
        fail("no such species, or too large a sheet", options.species ? options.species : "all");
    }
    open_context();
    struct gl_status status = { 0 };
    struct gl_target target;
    textures_open(&status, &textures);
    specimen_pass_open(&status, &pass, &textures);
    gl_target_open(&status, "sheet", &target,
                   &(struct gl_target_desc){ .internal_format = GL_RGBA8,
                                             .width = width,
                                             .height = height,
                                             .samples = options.time ? 1 : 4,
                                             .depth = true });
    if (!gl_is_well(&status)) {
        fail("OpenGL", status.text);
    }
    char why[256];
    if (!ui_init(&ui, why, sizeof why)) {
        fail("words", why);
    }
    gl_target_bind(&target);
    glClearColor(0.72f, 0.82f, 0.84f, 1.0f);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glDepthFunc(GL_LEQUAL);
    for (uint32_t row = 0; row < rows; row++) {
        show(&options, chosen[row], row, (const float[2]){ (float)width, (float)height });
    }
    gl_target_resolve(&target);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, target.resolve);
    return keep(options.out, width, height) == 0 ? 0 : 74;
}
