/* screens.c -- implementation of screens.h: the players' screens, the pages of the operator's menu,
 * and pages of the growth lab and of the album. */
#include "tests/golden/screens.h"

#include <stdio.h>
#include <string.h>

#include "core/core.h"
#include "core/game/accounting/accounts.h"
#include "core/game/lab/lab.h"
#include "core/game/menu/menu_pages.h"
#include "core/game/mode_tags.h"
#include "core/tank/preset.h"
#include "tests/render/shot_menu.h"

static struct core core;

/* Content of a screen for players. */
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

static void fill_name(struct scene *scene, const struct shot *shot, bool upright)
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
    scene->poi[player].position_m = v3(0.24f * (float)player - 0.36f, 0.05f, 0.2f);
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
    static const char *const names[PLAYBACK_COUNT] = { "", "", "playback", "genuine", "doubted" };
    for (uint8_t i = 0; i < PLAYBACK_NONE; i++) {
        scene->playback = strcmp(names[i], name) == 0 ? i : scene->playback;
    }
    scene->is_confirming_quit = strcmp(name, "quit") == 0;
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

static void fill_player_screen(const struct shot *shot, uint8_t language, bool upright,
                               struct scene *scene, struct ui_memory *memory)
{
    fill_scene(scene, shot, language);
    scene->upright = upright;
    if (shot->phase == PHASE_NAME) {
        fill_name(scene, shot, upright);
    }
    fill_ranking(scene, shot);
    fill_places(scene, shot);
    *memory = (struct ui_memory){ .hint = shot->hint, .hint_tick = 800 };
    memcpy(memory->caught, scene->caught, sizeof scene->caught);
}

/* ---- The operator's menu -------------------------------------------------------------------- */

/* Number of pictures of the menu page `page`: one, or one for each step of a wizard. The test card
 * has no picture, because no reduced picture shows its lines of one pixel. */
static uint32_t menu_step_count(uint8_t page)
{
    if (page == MENU_CARD || shot_menu_name_of(page) == NULL) {
        return 0;
    }
    return page == MENU_LEARN ? LEARN_STEP_COUNT : page == MENU_CALIBRATION ? CALIBRATE_STEPS : 1u;
}

static void start_core(uint32_t fish_count, uint8_t language)
{
    struct core_config config = { .seed = 2013, .fish_count = fish_count, .language = language };
    settings_reset(&config.persistent.settings);
    core_init(&core, &config);
}

static void fill_menu_page(uint8_t page, uint8_t step, uint8_t language, bool upright,
                           struct scene *scene)
{
    start_core(1, language);
    shot_menu_open(&core, shot_menu_name_of(page), step, upright);
    core_scene(&core, scene);
    scene->language = language;
    scene->phase_s = 1.0f; /* The page has faded in. */
    shot_menu_name(&scene->devices, scene->menu.file_first);
}

/* Ribbons of a score playback that are drawn over the menu page from which the playback starts. */
static const struct {
    const char *name;
    uint8_t playback;
} menu_playbacks[] = { { "seeks", PLAYBACK_SEEKS }, { "unrecorded", PLAYBACK_NONE } };
#define MENU_PLAYBACK_COUNT ((uint32_t)(sizeof menu_playbacks / sizeof *menu_playbacks))

/* ---- The growth lab and the album ----------------------------------------------------------- */

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

static void open_lab_page(const struct page *page, bool upright)
{
    static struct output output;
    if (page->species) {
        struct lab *const lab = &core.game.lab;
        while (strcmp(species_table[lab->species]->card.id, page->species) != 0) {
            lab->species++;
        }
        lab_begin(&core.game, &core.world, &core.config, &output);
        lab->playing = 0;
        lab->upright = upright;
        lab->progress = page->progress;
        lab->compare = page->compare;
        lab->path = page->path;
        return;
    }
    for (uint32_t i = 0; i < page->fish; i++) {
        core.world.tank.fish[i].gait = GAIT_BOWL;
        core.world.tank.fish[i].holder = 0;
    }
    core.game.player[0].caught = page->fish;
    album_note(&core.game.album, &core.world, 0, page->fish);
    core.game.tick = 100000u;
    core.game.phase = PHASE_ALBUM;
    core.game.phase_tick =
        core.game.tick -
        (uint32_t)(page->progress * (float)album_ticks(core.game.album.fish_count));
}

static void fill_lab_page(const struct page *page, uint8_t language, bool upright,
                          struct scene *scene)
{
    start_core(40, language);
    open_lab_page(page, upright);
    core_scene(&core, scene);
    scene->language = language;
    scene->upright = upright;
}

/* ---- The list of all screens ---------------------------------------------------------------- */

#define SHOT_COUNT ((uint32_t)(sizeof shots / sizeof *shots))
#define PAGE_COUNT ((uint32_t)(sizeof lab_pages / sizeof *lab_pages))

uint32_t screens_count(void)
{
    uint32_t count = SHOT_COUNT + MENU_PLAYBACK_COUNT + PAGE_COUNT;
    for (uint32_t page = 0; page < MENU_PAGE_COUNT; page++) {
        count += menu_step_count((uint8_t)page);
    }
    return count;
}

struct screen screens_fill(uint32_t index, uint8_t language, bool upright, struct scene *scene,
                           struct ui_memory *memory)
{
    struct screen screen = { .kind = SCREEN_PLAYER };
    if (index < SHOT_COUNT) {
        fill_player_screen(&shots[index], language, upright, scene, memory);
        snprintf(screen.name, sizeof screen.name, "%s", shots[index].name);
        return screen;
    }
    *memory = (struct ui_memory){ 0 };
    memset(scene, 0, sizeof *scene);
    index -= SHOT_COUNT;
    uint8_t page = 0;
    while (page < MENU_PAGE_COUNT && index >= menu_step_count(page)) {
        index -= menu_step_count(page++);
    }
    if (page < MENU_PAGE_COUNT) {
        fill_menu_page(page, (uint8_t)index, language, upright, scene);
        screen.kind = SCREEN_MENU;
        snprintf(screen.name, sizeof screen.name, menu_step_count(page) > 1u ? "%.16s %u" : "%.16s",
                 shot_menu_name_of(page), index);
        return screen;
    }
    if (index < MENU_PLAYBACK_COUNT) {
        fill_menu_page(MENU_SCORE, 0, language, upright, scene);
        scene->playback = menu_playbacks[index].playback;
        scene->playback_progress = 0.4f;
        screen.kind = SCREEN_MENU;
        snprintf(screen.name, sizeof screen.name, "%s", menu_playbacks[index].name);
        return screen;
    }
    index -= MENU_PLAYBACK_COUNT;
    fill_lab_page(&lab_pages[index], language, upright, scene);
    screen.kind = lab_pages[index].species ? SCREEN_LAB : SCREEN_ALBUM;
    snprintf(screen.name, sizeof screen.name, "%s", lab_pages[index].name);
    return screen;
}
