/* ui_shots.c -- writes pictures of every screen of the user interface for visual review.
 *
 * Usage: build/tests/golden/ui_shots OUT TEXT [BACKDROP.png]
 *        build/tests/golden/ui_shots OUT --compare GOLDEN
 *        build/tests/golden/ui_shots OUT --keep GOLDEN
 *
 * The program draws each screen off screen in both languages and in several sizes over a backdrop.
 * TEXT is the setting SET_TEXT, the size of small texts: 0 (normal) to 2 (largest). The backdrop is
 * the picture BACKDROP.png of the tank, or plain water by default. The pictures are
 * written to OUT/NAME_LANGUAGE_WIDTHxHEIGHT.png. The program also prints the time to draw one
 * screen.
 *
 * With --compare the program draws every screen, every page of the operator's menu, and pages of
 * the growth lab and of the album. It writes one contact sheet for each size to
 * OUT/ui-WIDTHxHEIGHT.png, and compares the screens with the golden sheets in the folder GOLDEN.
 * The exit status is 1 if a screen differs. --keep writes the golden sheets. */
#include <GLES3/gl3.h>
#include <SDL.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb/stb_image.h>
#include <stb/stb_image_write.h>

#include "core/core.h"
#include "core/game/accounting/accounts.h"
#include "core/game/lab/lab.h"
#include "core/game/menu/menu_pages.h"
#include "core/game/mode_tags.h"
#include "core/tank/preset.h"
#include "platform/render/ui/ui.h"
#include "tests/golden/golden_sheet.h"
#include "tests/render/shot_menu.h"

#define WIDTH_MAX 3840
#define HEIGHT_MAX 2160
#define COST_DRAWS 20

static struct specimen_pass specimens;
static struct textures textures;
static uint8_t text_size; /* Value of SET_TEXT in all pictures. */

struct shot {
    const char *name;
    uint8_t phase, hint;
    float phase_s, seconds_left;
    uint32_t caught, best;
    float paper_left;
    uint8_t players, mode, call, foul;
    uint8_t paused, shows_stress, two_modes;
};

static const struct shot shots[] = {
    { "attract", PHASE_ATTRACT, HINT_START, 9.0f, 0.0f, 0, 12, 0.9f, 1, 0, 0, 0, 0, 0, 0 },
    { "choose", PHASE_MODE_SELECT, HINT_CHOOSE, 4.0f, 11.0f, 0, 46, 1.0f, 1, MODE_CHAMPIONSHIP, 0,
      0, 0, 0, 0 },
    { "choose4", PHASE_MODE_SELECT, HINT_CHOOSE, 4.0f, 11.0f, 0, 46, 1.0f, 4, MODE_FESTIVAL, 0, 0,
      0, 0, 0 },
    { "choose2", PHASE_MODE_SELECT, HINT_CHOOSE, 4.0f, 11.0f, 0, 12, 1.0f, 1, MODE_FESTIVAL, 0, 0,
      0, 0, 1 },
    { "ready", PHASE_READY, HINT_NO_SHADE, 0.85f, 2.15f, 0, 12, 1.0f, 1, MODE_CHAMPIONSHIP, 0, 0, 0,
      0, 0 },
    { "go", PHASE_ROUND, HINT_DIP, 0.4f, 59.6f, 0, 12, 1.0f, 1, 0, 0, 0, 0, 0, 0 },
    { "round", PHASE_ROUND, HINT_TILT, 30.0f, 30.0f, 7, 12, 0.66f, 4, 0, 0, 0, 0, 0, 0 },
    { "torn", PHASE_ROUND, HINT_TORN, 52.0f, 7.5f, 13, 12, 0.0f, 1, 0, 0, 0, 0, 0, 0 },
    { "minute", PHASE_ROUND, HINT_NONE, 60.4f, 119.6f, 21, 46, 0.93f, 1, MODE_CHAMPIONSHIP,
      CALL_ONE_MINUTE, FOUL_WALL, 0, 0, 0 },
    { "contest", PHASE_ROUND, HINT_CLEAR_RIM, 100.0f, 80.0f, 21, 46, 0.93f, 4, MODE_CHAMPIONSHIP, 0,
      FOUL_POURED, 0, 0, 0 },
    { "lastten", PHASE_ROUND, HINT_NONE, 170.4f, 9.6f, 21, 46, 0.93f, 2, MODE_CHAMPIONSHIP,
      CALL_TEN_SECONDS, 0, 0, 0, 0 },
    { "last", PHASE_ROUND, HINT_NONE, 176.7f, 3.3f, 21, 46, 0.93f, 2, MODE_CHAMPIONSHIP,
      CALL_COUNTDOWN, 0, 0, 0, 0 },
    { "time", PHASE_RESULT, HINT_NONE, 0.7f, 0.0f, 21, 46, 0.93f, 1, MODE_CHAMPIONSHIP, CALL_TIME,
      0, 0, 0, 0 },
    { "paused", PHASE_ROUND, HINT_LOST_POI, 100.0f, 80.0f, 21, 46, 0.93f, 3, MODE_CHAMPIONSHIP, 0,
      0, 1, 0, 0 },
    { "practice", PHASE_ROUND, HINT_WET_ALL, 40.0f, 140.0f, 3, 0, 0.8f, 1, MODE_PRACTICE, 0, 0, 0,
      1, 0 },
    { "coin", PHASE_ATTRACT, HINT_COIN, 9.0f, 0.0f, 0, 12, 0.9f, 1, 0, 0, 0, 0, 0, 0 },
    { "paid", PHASE_MODE_SELECT, HINT_CHOOSE, 4.0f, 11.0f, 0, 46, 1.0f, 1, MODE_FESTIVAL, 0, 0, 0,
      0, 0 },
    { "warned", PHASE_ATTRACT, HINT_START, 9.0f, 0.0f, 0, 12, 0.9f, 1, 0, 0, 0, 0, 0, 0 },
    { "quit", PHASE_ATTRACT, HINT_START, 9.0f, 0.0f, 0, 12, 0.9f, 1, 0, 0, 0, 0, 0, 0 },
    { "ask", PHASE_ROUND, HINT_DIP, 20.0f, 40.0f, 3, 12, 0.8f, 1, 0, 0, 0, 0, 0, 0 },
    { "paidback", PHASE_RESULT, HINT_PAID_BACK, 6.2f, 0.0f, 4, 12, 0.4f, 1, 0, 0, 0, 0, 0, 0 },
    { "result", PHASE_RESULT, HINT_NONE, 2.4f, 0.0f, 13, 13, 0.0f, 1, 0, 0, 0, 0, 0, 0 },
    { "fast", PHASE_RESULT, HINT_START, 6.2f, 0.0f, 2, 13, 0.0f, 1, 0, 0, 0, 0, 0, 0 },
    { "present", PHASE_RESULT, HINT_NONE, 2.3f, 0.0f, 0, 13, 0.0f, 1, 0, 0, 0, 0, 0, 0 },
    { "soaked", PHASE_RESULT, HINT_START, 6.2f, 0.0f, 5, 13, 0.0f, 1, 0, 0, 0, 0, 0, 0 },
    { "weight", PHASE_RESULT, HINT_START, 6.2f, 0.0f, 7, 13, 0.0f, 1, MODE_CHAMPIONSHIP, 0, 0, 0, 0,
      0 },
    { "again", PHASE_RESULT, HINT_START, 6.2f, 0.0f, 4, 12, 0.4f, 1, MODE_PRACTICE, 0, 0, 0, 0, 0 },
    { "winner", PHASE_RESULT, HINT_START, 6.2f, 0.0f, 47, 47, 0.4f, 1, MODE_CHAMPIONSHIP, 0,
      FOUL_WALL, 0, 0, 0 },
    { "ranking", PHASE_RESULT, HINT_START, 6.2f, 0.0f, 21, 46, 0.4f, 4, MODE_CHAMPIONSHIP, 0,
      FOUL_WALL, 0, 0, 0 },
    { "board", PHASE_LEADERBOARD, HINT_START, 4.0f, 0.0f, 13, 13, 0.4f, 2, 0, 0, 0, 0, 0, 0 },
    { "wall", PHASE_ATTRACT, HINT_START, 26.0f, 0.0f, 0, 47, 0.9f, 1, MODE_CHAMPIONSHIP, 0, 0, 0, 0,
      0 },
    { "name", PHASE_NAME, HINT_NONE, 4.0f, 12.0f, 13, 13, 0.4f, 2, 0, 0, 0, 0, 0, 0 },
    { "dusk", PHASE_ATTRACT, HINT_START, 0.2f, 0.0f, 0, 12, 0.9f, 1, 0, 0, 0, 0, 0, 0 },
    { "seeks", PHASE_ATTRACT, HINT_START, 9.0f, 0.0f, 0, 12, 0.9f, 1, 0, 0, 0, 0, 0, 0 },
    { "playback", PHASE_ROUND, HINT_TILT, 30.0f, 30.0f, 7, 12, 0.66f, 1, 0, 0, 0, 0, 0, 0 },
    { "genuine", PHASE_RESULT, HINT_NONE, 6.2f, 0.0f, 13, 13, 0.0f, 1, 0, 0, 0, 0, 0, 0 },
    { "doubted", PHASE_RESULT, HINT_NONE, 6.2f, 0.0f, 13, 13, 0.0f, 1, 0, 0, 0, 0, 0, 0 },
    { "latin", PHASE_NAME, HINT_NONE, 4.0f, 40.0f, 13, 13, 0.4f, 1, 0, 0, 0, 0, 0, 0 },
};

/* Fills a leaderboard with names in different scripts. The rows with the indices 2 and 9 have an
 * empty name, because a player may enter no name. */
static void fill_ranking(struct scene *scene, const struct shot *shot)
{
    static const char *const names[SCENE_LEADERBOARD_ROWS] = {
        "きんぎょ", "KINGYO", "", "たろうとはなこ", "マリー", "A-1", "さくら", "Bob", "ゆ", ""
    };
    const uint32_t rows = shot->phase == PHASE_LEADERBOARD ? 3u : 10u;
    scene->leaderboard = (struct scene_leaderboard){ .shown = shot->phase == PHASE_LEADERBOARD ||
                                                              strcmp(shot->name, "wall") == 0,
                                                     .mode = shot->mode,
                                                     .shown_s = 3.0f,
                                                     .left_s = 5.0f };
    scene->leaderboard.period = shot->phase == PHASE_LEADERBOARD ? 0 : 2;
    for (uint32_t i = 0; i < rows; i++) {
        scene->leaderboard.row[i].caught = shot->best - i;
        scene->leaderboard.row[i].is_sealed = i != 2u;
        scene->leaderboard.row[i].is_new = shot->phase == PHASE_LEADERBOARD && i == 1;
        snprintf(scene->leaderboard.row[i].name, sizeof scene->leaderboard.row[i].name, "%s",
                 names[i]);
    }
}

/* Sets the player's rank on the leaderboards for the screens that are shown after a round. */
static void fill_places(struct scene *scene, const struct shot *shot)
{
    const int is_first = strcmp(shot->name, "result") == 0;
    if (is_first || strcmp(shot->name, "ranking") == 0) {
        scene->player[0].place = is_first ? 1 : 3;
        scene->player[0].period = is_first ? 0 : 2;
        scene->name.waits = 1;
    }
}

static void fill_name(struct scene *scene, const struct shot *shot, int upright)
{
    static const uint16_t letters[SCENE_NAME_LETTERS] = u"きんぎょ";
    scene->player[0].place = 2;
    scene->player[0].period = 1;
    scene->name = (struct scene_name){ .waits = 1,
                                       .key = 23,
                                       .letter_count = 4,
                                       .upright = (uint8_t)upright,
                                       .has_pointer = 1,
                                       .x = 420.0f,
                                       .y = 400.0f };
    memcpy(scene->name.letter, letters, sizeof letters);
    if (strcmp(shot->name, "latin") == 0) {
        scene->name.alphabet = 2;
        scene->name.was_refused = 1;
        scene->name.letter_count = 0;
    }
}

static const int sizes[][2] = {
    { 1280, 720 }, { 1920, 1080 }, { 720, 1280 }, { 1024, 768 }, { 640, 360 }
};

static void fill_player(struct scene *scene, const struct shot *shot, uint8_t player)
{
    struct scene_player *const out = &scene->player[player];
    out->plays = 1;
    out->level = shot->mode == MODE_CHAMPIONSHIP ? (uint8_t)LEVEL_MASTER
                                                 : (uint8_t)((1u + player) % LEVEL_COUNT);
    out->has_pointer = shot->phase == PHASE_MODE_SELECT;
    out->x = 520.0f - 298.0f * (float)(out->level - LEVEL_NORMAL) + 44.0f * (player == 3);
    out->y = 420.0f;
    scene->poi[player].present = 1;
    scene->poi[player].shows_stress = shot->shows_stress;
    scene->poi[player].paper_left = player == 0 ? shot->paper_left : 0.9f - 0.2f * (float)player;
    scene->caught[player] = shot->caught * (4u - player) / 4u;
    out->foul = player == 0 ? shot->foul : FOUL_NONE;
    out->foul_s = 0.8f;
    out->fouls = shot->mode != MODE_CHAMPIONSHIP ? 0 : player == 0 ? shot->foul != 0 : player;
    out->out = player == 3 && shot->mode == MODE_CHAMPIONSHIP;
    out->lost = player == 1 && shot->paused;
}

/* Sets the number of credits and the hardware faults for the screens that show them. */
static void fill_cabinet(struct scene *scene, const char *name)
{
    static const struct {
        const char *name;
        struct scene_credit credit;
        uint8_t is_confirming_menu;
    } cabinets[] = {
        { "coin", { .price = 3, .unpaid = 1, .units = 1, .coin_s = 60.0f, .request_s = 0.2f }, 0 },
        { "paid", { .price = 3, .credits = 2, .coin_s = 0.1f, .request_s = 60.0f }, 0 },
        { "warned", { .warnings = WARN_TILT | WARN_DOOR | WARN_NO_POI }, 0 },
        { "ask", { .price = 1 }, 1 },
        { "paidback",
          { .price = 1, .credits = 1, .came_back = 1, .coin_s = 60.0f, .request_s = 60.0f },
          0 },
    };
    for (size_t i = 0; i < sizeof cabinets / sizeof *cabinets; i++) {
        if (strcmp(cabinets[i].name, name) == 0) {
            scene->credit = cabinets[i].credit;
            scene->is_confirming_menu = cabinets[i].is_confirming_menu;
        }
    }
}

static void fill_playback(struct scene *scene, const char *name)
{
    static const char *const names[PLAYBACK_COUNT] = { "",        "seeks",   "playback",
                                                       "genuine", "doubted", "" };
    for (uint8_t i = 0; i < PLAYBACK_COUNT; i++) {
        scene->playback = strcmp(names[i], name) == 0 ? i : scene->playback;
    }
    scene->is_confirming_quit = strcmp(name, "quit") == 0;
    scene->playback_progress = 0.4f;
    scene->veil = strcmp(name, "dusk") == 0 ? 0.7f : 0.0f;
}

/* Sets the cause and the load of the first tear for the pictures of a result screen with torn
 * paper. */
static void fill_tear(struct scene *scene, const char *name)
{
    static const struct {
        const char *name;
        uint8_t cause;
    } torn[] = {
        { "result", TEAR_FLAT },   { "ranking", TEAR_SLAP },  { "fast", TEAR_FAST },
        { "soaked", TEAR_SOAKED }, { "weight", TEAR_WEIGHT }, { "present", TEAR_FAST },
    };
    for (size_t i = 0; i < sizeof torn / sizeof *torn; i++) {
        if (strcmp(torn[i].name, name) != 0) {
            continue;
        }
        struct scene_tear *tear = &scene->tear[0];
        *tear = (struct scene_tear){ .cause = torn[i].cause,
                                     .time_s = -0.1f,
                                     .position_m = { 0.0f, -0.012f, 0.0f },
                                     .velocity_m_s = { 0.12f, -0.25f, 0.0f },
                                     .angles = { 0.4f, 0.15f, 0.3f } };
        for (uint32_t k = 0; k < TEAR_CELL_COUNT; k++) {
            const float x = ((float)(k % TEAR_SIDE) + 0.5f) / 8.0f - 1.0f;
            const float z = ((float)(k / TEAR_SIDE) + 0.5f) / 8.0f - 1.0f;
            const float r2 = x * x + z * z;
            tear->load[k] =
                r2 > 1.05f || (k >= 100 && k < 103) ? 0 : (uint8_t)(230.0f - 200.0f * r2 + 0.5f);
        }
    }
}

static void fill_scene(struct scene *scene, const struct shot *shot, uint8_t language)
{
    memset(scene, 0, sizeof *scene);
    scene->tick = 1000;
    scene->view = tank_preset(TANK_PRESET_FESTIVAL)->view;
    scene->phase = shot->phase;
    scene->hint = shot->hint;
    scene->phase_s = shot->phase_s;
    scene->seconds_left = shot->seconds_left;
    scene->best_today = shot->best;
    scene->language = language;
    scene->text_size = text_size;
    scene->mode = shot->mode;
    scene->modes =
        shot->two_modes ? 1u << MODE_FESTIVAL | 1u << MODE_PRACTICE : (1u << CHOICE_COUNT) - 1u;
    scene->tags = (uint8_t)mode_tags_offered(scene->modes, true);
    scene->choice = shot->mode;
    scene->pointed_tags = shot->mode != MODE_FESTIVAL ? 1u << (MODE_TAG_LEVELS - 1u + shot->mode)
                          : shot->players > 1u        ? MODE_TAG_LEVEL_MASK
                                                      : 1u << 1;
    scene->offer[MODE_FESTIVAL] = (struct scene_offer){ 60, 6 };
    scene->offer[MODE_CHAMPIONSHIP] = (struct scene_offer){ 180, 5 };
    scene->offer[MODE_PRACTICE] = (struct scene_offer){ 180, 6 };
    scene->grade = scene->offer[shot->mode].grade;
    scene->paused = shot->paused;
    fill_cabinet(scene, shot->name);
    fill_playback(scene, shot->name);
    fill_tear(scene, shot->name);
    scene->player[0].has_present = strcmp(shot->name, "present") == 0;
    scene->call = shot->call;
    scene->call_s = 0.6f;
    for (uint8_t i = 0; i < shot->players; i++) {
        fill_player(scene, shot, i);
    }
}

static int open_context(void)
{
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_PROFILE_MASK, SDL_GL_CONTEXT_PROFILE_ES);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MAJOR_VERSION, 3);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MINOR_VERSION, 0);
    if (SDL_Init(SDL_INIT_VIDEO) != 0) {
        return 0;
    }
    SDL_Window *window = SDL_CreateWindow("ui", 0, 0, 64, 64, SDL_WINDOW_OPENGL);
    return window != NULL && SDL_GL_CreateContext(window) != NULL;
}

static GLuint make_target(GLsizei width, GLsizei height)
{
    GLuint framebuffer, colour, depth;
    glGenFramebuffers(1, &framebuffer);
    glGenTextures(1, &colour);
    glBindTexture(GL_TEXTURE_2D, colour);
    glTexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA8, width, height);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, colour, 0);
    glGenRenderbuffers(1, &depth);
    glBindRenderbuffer(GL_RENDERBUFFER, depth);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, width, height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth);
    return framebuffer;
}

/* Fills the render target with the middle of the backdrop, scaled to the size of the target. */
static void draw_backdrop(GLuint source, int source_width, int source_height, int width, int height)
{
    glClearColor(0.10f, 0.42f, 0.52f, 1.0f);
    glClear(GL_COLOR_BUFFER_BIT);
    if (source == 0) {
        return;
    }
    const float scale = (float)height / (float)source_height;
    const int used =
        (int)((float)width / scale) < source_width ? (int)((float)width / scale) : source_width;
    const int left = (source_width - used) / 2;
    glBindFramebuffer(GL_READ_FRAMEBUFFER, source);
    glBlitFramebuffer(left, 0, left + used, source_height, 0, 0, width, height, GL_COLOR_BUFFER_BIT,
                      GL_LINEAR);
}

static GLuint load_backdrop(const char *path, int *width, int *height)
{
    stbi_set_flip_vertically_on_load(1);
    unsigned char *pixels = path != NULL ? stbi_load(path, width, height, NULL, 4) : NULL;
    if (pixels == NULL) {
        return 0;
    }
    const GLuint framebuffer = make_target(*width, *height);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, *width, *height, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
    stbi_image_free(pixels);
    return framebuffer;
}

/* The render target and the backdrop texture, with their sizes in pixels. */
struct canvas {
    GLuint target, backdrop;
    int width, height, back_width, back_height;
    /* Sheet for eyes and sheet that is compared. Null if the pictures are written instead. */
    struct golden_sheet *large, *small;
};

static uint8_t pixels[WIDTH_MAX * HEIGHT_MAX * 4];

/* Draws `scene` and adds the picture to the contact sheets. Returns 0 if a font lacks a letter. */
static int add_to_sheets(struct ui *ui, const struct scene *scene, const char *name,
                         const struct canvas *canvas)
{
    char title[GOLDEN_NAME_SIZE];
    const int width = canvas->width, height = canvas->height;
    const struct display_transform transform = display_transform_of(
        &(struct display_settings){ .light = 1.0f }, (float)width, (float)height);
    glBindFramebuffer(GL_FRAMEBUFFER, canvas->target);
    glClearColor(0.10f, 0.42f, 0.52f, 1.0f);
    glClear(GL_COLOR_BUFFER_BIT);
    ui_draw(ui, &specimens, scene, &transform);
    glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
    snprintf(title, sizeof title, "%.20s %s", name, scene->language == LANGUAGE_JA ? "ja" : "en");
    golden_sheet_add(canvas->large, title, pixels, width, height);
    golden_sheet_add(canvas->small, title, pixels, width, height);
    if (ui->batch.unbaked_count > 0 || ui->batch.dropped_count > 0) {
        fprintf(stderr, "ui_shots: %s has %u letters without a glyph and %u dropped shapes\n",
                title, ui->batch.unbaked_count, ui->batch.dropped_count);
        return 0;
    }
    return 1;
}

static int write_picture(const char *path, int width, int height)
{
    glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
    for (int i = 0; i < width * height; i++) {
        pixels[i * 4 + 3] = 255;
    }
    stbi_flip_vertically_on_write(1);
    return stbi_write_png(path, width, height, 4, pixels, width * 4);
}

static void print_cost(struct ui *ui, const struct scene *scene, const char *name, int width,
                       int height)
{
    const struct display_transform transform = display_transform_of(
        &(struct display_settings){ .light = 1.0f }, (float)width, (float)height);
    /* Draws once without measurement, because drivers complete the compilation of a shader only
     * when the shader is first used. */
    ui_draw(ui, &specimens, scene, &transform);
    glFinish();
    /* Start of the CPU time of the process, which includes all threads of a software renderer. */
    const clock_t start = clock();
    for (int i = 0; i < COST_DRAWS; i++) {
        ui_draw(ui, &specimens, scene, &transform);
    }
    glFinish();
    const double used_s = (double)(clock() - start) / CLOCKS_PER_SEC;
    printf("%-8s %4dx%-4d %3u quads %6.2f ms of processor time\n", name, width, height,
           ui->batch.quad_count, 1e3 * used_s / COST_DRAWS);
}

static int shoot(struct ui *ui, const struct shot *shot, uint8_t language, const char *out,
                 const struct canvas *canvas)
{
    static struct scene scene;
    char path[512];
    const int width = canvas->width, height = canvas->height;
    const struct display_transform transform = display_transform_of(
        &(struct display_settings){ .light = 1.0f }, (float)width, (float)height);
    fill_scene(&scene, shot, language);
    scene.upright = height > width;
    if (shot->phase == PHASE_NAME) {
        fill_name(&scene, shot, height > width);
    }
    fill_ranking(&scene, shot);
    fill_places(&scene, shot);
    ui->memory = (struct ui_memory){ .hint = shot->hint, .hint_tick = 800 };
    memcpy(ui->memory.caught, scene.caught, sizeof scene.caught);
    if (canvas->small) {
        return add_to_sheets(ui, &scene, shot->name, canvas);
    }
    glBindFramebuffer(GL_FRAMEBUFFER, canvas->target);
    if (language == 0) {
        print_cost(ui, &scene, shot->name, width, height);
    }
    draw_backdrop(canvas->backdrop, canvas->back_width, canvas->back_height, width, height);
    glBindFramebuffer(GL_FRAMEBUFFER, canvas->target);
    ui_draw(ui, &specimens, &scene, &transform);
    if (ui->batch.unbaked_count > 0) {
        fprintf(stderr, "ui_shots: %s draws %u letters that their font was baked without\n",
                shot->name, ui->batch.unbaked_count);
        return 0;
    }
    snprintf(path, sizeof path, "%s/%s_%s_%dx%d.png", out, shot->name, language == 0 ? "ja" : "en",
             width, height);
    if (!write_picture(path, width, height)) {
        fprintf(stderr, "ui_shots: cannot write %s\n", path);
        return 0;
    }
    return 1;
}

/* Draws every screen in every size and language. Returns 1 if all pictures were drawn completely
 * and written. */
static int shoot_all(struct ui *ui, const char *out, struct canvas canvas)
{
    int all = 1;
    for (size_t s = 0; s < sizeof sizes / sizeof *sizes && all; s++) {
        canvas.width = sizes[s][0];
        canvas.height = sizes[s][1];
        canvas.target = make_target(canvas.width, canvas.height);
        for (size_t i = 0; i < sizeof shots / sizeof *shots; i++) {
            for (uint8_t language = 0; language < LANGUAGE_COUNT && all; language++) {
                all = shoot(ui, &shots[i], language, out, &canvas);
            }
        }
    }
    return all;
}

/* ---- Comparison with golden sheets ----------------------------------------------------------- */

/* Sizes of the compared screens, and sizes of their tiles on the golden sheet and on the sheet for
 * eyes. A golden tile has 1/16 of the width of a screen of 720 pixels. */
static const struct compared {
    int width, height, small[2], large[2];
} compared[] = {
    { 1280, 720, { 80, 45 }, { 320, 180 } },
    { 1920, 1080, { 80, 45 }, { 320, 180 } },
    { 720, 1280, { 45, 80 }, { 180, 320 } },
    { 1024, 768, { 64, 48 }, { 256, 192 } },
};

/* Adds every named page of the operator's menu to the sheets. Returns 0 if a font lacks a
 * letter. */
static int shoot_menu(struct ui *ui, const struct canvas *canvas)
{
    static struct core core;
    static struct scene scene;
    int all = 1;
    for (uint8_t page = 0; page < MENU_PAGE_COUNT; page++) {
        /* The test card has lines of one pixel, which no reduced picture shows. */
        const char *const name = page == MENU_CARD ? NULL : shot_menu_name_of(page);
        for (uint8_t language = 0; name && language < LANGUAGE_COUNT; language++) {
            struct core_config config = { .seed = 1, .fish_count = 1, .language = language };
            settings_reset(&config.persistent.settings);
            core_init(&core, &config);
            shot_menu_open(&core, name, 0, canvas->height > canvas->width);
            core_scene(&core, &scene);
            scene.language = language;
            scene.phase_s = 1.0f; /* The page has faded in. */
            shot_menu_name(&scene.devices, scene.menu.file_first);
            ui->memory = (struct ui_memory){ 0 };
            all &= add_to_sheets(ui, &scene, name, canvas);
        }
    }
    return all;
}

/* Calls of specimen_pass_work() after which the textures of all specimens are complete. */
#define SKIN_CALLS 1500

/* A page of the growth lab or of the album, at a progress of the growth. */
static const struct page {
    const char *name;
    const char *species; /* Species of the lab, or null for the album. */
    uint8_t fish;        /* Number of fish of the album. */
    uint8_t compare, path;
    float progress;
} lab_pages[] = {
    { "lab", "wakin", 0, 0, 0, 0.5f },
    { "lab compare", "hirame", 0, 1, 1, 0.3f },
    { "album 1", NULL, 1, 0, 0, 0.6f },
    { "album 6", NULL, 6, 0, 0, 0.9f },
};

static void open_lab_page(struct core *core, const struct page *page, bool upright)
{
    static struct output output;
    if (page->species) {
        struct lab *const lab = &core->game.lab;
        while (strcmp(species_table[lab->species]->card.id, page->species) != 0) {
            lab->species++;
        }
        lab_begin(&core->game, &core->world, &core->config, &output);
        lab->playing = 0;
        lab->upright = upright;
        lab->progress = page->progress;
        lab->compare = page->compare;
        lab->path = page->path;
        return;
    }
    for (uint32_t i = 0; i < page->fish; i++) {
        core->world.tank.fish[i].gait = GAIT_BOWL;
        core->world.tank.fish[i].holder = 0;
    }
    core->game.player[0].caught = page->fish;
    album_note(&core->game.album, &core->world, 0, page->fish);
    core->game.tick = 100000u;
    core->game.phase = PHASE_ALBUM;
    core->game.phase_tick =
        core->game.tick -
        (uint32_t)(page->progress * (float)album_ticks(core->game.album.fish_count));
}

/* Adds pages of the growth lab and of the album to the sheets, with complete textures. Returns 0 if
 * a font lacks a letter. */
static int shoot_lab(struct ui *ui, const struct canvas *canvas)
{
    static struct core core;
    static struct scene scene;
    const struct display_transform transform = display_transform_of(
        &(struct display_settings){ .light = 1.0f }, (float)canvas->width, (float)canvas->height);
    int all = 1;
    for (size_t i = 0; i < sizeof lab_pages / sizeof *lab_pages; i++) {
        for (uint8_t language = 0; language < LANGUAGE_COUNT; language++) {
            struct core_config config = { .seed = 2013, .fish_count = 40, .language = language };
            settings_reset(&config.persistent.settings);
            core_init(&core, &config);
            open_lab_page(&core, &lab_pages[i], canvas->height > canvas->width);
            core_scene(&core, &scene);
            scene.language = language;
            scene.upright = canvas->height > canvas->width;
            ui->memory = (struct ui_memory){ 0 };
            glBindFramebuffer(GL_FRAMEBUFFER, canvas->target);
            ui_draw(ui, &specimens, &scene, &transform);
            for (uint32_t k = 0; k < SKIN_CALLS; k++) {
                specimen_pass_work(&specimens, false);
            }
            glClear(GL_DEPTH_BUFFER_BIT);
            all &= add_to_sheets(ui, &scene, lab_pages[i].name, canvas);
        }
    }
    return all;
}

/* Draws all screens of one size. Writes the sheet for eyes to the folder `out`. Compares the other
 * sheet with the golden sheet in the folder `golden`, or writes the golden sheet if `keeps` is
 * true. Both sizes of 16:9 have the same layout and therefore share a golden sheet. Returns 1 if
 * all screens are as they must be. */
static int compare_size(struct ui *ui, const struct compared *size, const char *out,
                        const char *golden, bool keeps)
{
    static struct golden_sheet large, small;
    char path[512], golden_path[512];
    struct canvas canvas = {
        .width = size->width, .height = size->height, .large = &large, .small = &small
    };
    const bool is_shared = size->width == 1920;
    if (!golden_sheet_open(&large, size->large[0], size->large[1]) ||
        !golden_sheet_open(&small, size->small[0], size->small[1])) {
        return 0;
    }
    canvas.target = make_target(canvas.width, canvas.height);
    int all = 1;
    for (size_t i = 0; i < sizeof shots / sizeof *shots; i++) {
        for (uint8_t language = 0; language < LANGUAGE_COUNT; language++) {
            all &= shoot(ui, &shots[i], language, out, &canvas);
        }
    }
    all &= shoot_menu(ui, &canvas);
    all &= shoot_lab(ui, &canvas);
    snprintf(path, sizeof path, "%s/ui-%dx%d.png", out, size->width, size->height);
    snprintf(golden_path, sizeof golden_path, "%s/ui-%dx%d.png", golden,
             is_shared ? compared[0].width : size->width,
             is_shared ? compared[0].height : size->height);
    all &= golden_sheet_write(&large, path);
    if (keeps && !is_shared) {
        all &= golden_sheet_write(&small, golden_path);
    } else {
        const int different = golden_sheet_compare(&small, golden_path);
        printf("%s: %u screens, %d differ from %s\n", path, small.count, different, golden_path);
        all &= different == 0;
    }
    golden_sheet_close(&large);
    golden_sheet_close(&small);
    return all;
}

static int compare_all(struct ui *ui, const char *out, const char *golden, bool keeps)
{
    int all = 1;
    for (size_t i = 0; i < sizeof compared / sizeof *compared; i++) {
        all &= compare_size(ui, &compared[i], out, golden, keeps);
    }
    return all;
}

int main(int count, char **arguments)
{
    static struct ui ui;
    char why[256];
    SDL_setenv("SDL_VIDEODRIVER", "offscreen", 0);
    const bool keeps = count == 4 && strcmp(arguments[2], "--keep") == 0;
    const bool compares = keeps || (count == 4 && strcmp(arguments[2], "--compare") == 0);
    const bool has_size =
        count > 2 && strlen(arguments[2]) == 1 && arguments[2][0] >= '0' && arguments[2][0] <= '2';
    if (!compares && (!has_size || count > 4)) {
        fputs("usage: ui_shots OUT TEXT [BACKDROP.png], with a TEXT from 0 to 2\n"
              "       ui_shots OUT --compare|--keep GOLDEN\n",
              stderr);
        return 2;
    }
    text_size = compares ? 0 : (uint8_t)(arguments[2][0] - '0');
    if (!open_context()) {
        fprintf(stderr, "ui_shots: no OpenGL ES 3 context: %s\n", SDL_GetError());
        return 1;
    }
    struct gl_status status = { 0 };
    textures_open(&status, &textures);
    specimen_pass_open(&status, &specimens, &textures);
    if (!gl_is_well(&status)) {
        fprintf(stderr, "ui_shots: %s\n", status.text);
        return 1;
    }
    if (!ui_init(&ui, why, sizeof why)) {
        fprintf(stderr, "ui_shots: %s\n", why);
        return 1;
    }
    if (compares) {
        return compare_all(&ui, arguments[1], arguments[3], keeps) ? 0 : 1;
    }
    struct canvas canvas = { 0 };
    canvas.backdrop =
        load_backdrop(count > 3 ? arguments[3] : NULL, &canvas.back_width, &canvas.back_height);
    if (!shoot_all(&ui, arguments[1], canvas)) {
        return 74;
    }
    ui_close(&ui);
    specimen_pass_close(&specimens);
    return 0;
}
