/* ui_fixture.h -- test fixture of the user interface. The interface is laid out without a
 * display. */
#ifndef KINGYO_TESTS_UNIT_SUPPORT_UI_FIXTURE_H
#define KINGYO_TESTS_UNIT_SUPPORT_UI_FIXTURE_H

#include <string.h>

#include "core/game/accounting/accounts.h"
#include "core/game/mode_tags.h"
#include "core/game/ranking/name_keyboard.h"
#include "core/game/ranking/ranking.h"
#include "platform/render/ui/ui_screens.h"
#include "tests/unit/support/glyphs.h"

#define SETTLED_TICK 100000u

/* Size of a screen, in pixels. */
struct size {
    float width, height;
};

/* Screen sizes of the tests, in pixels. */
static const struct size sizes[] = {
    { 1280, 720 }, { 1920, 1080 }, { 3840, 2160 }, { 720, 1280 },  { 1080, 1920 }, { 640, 480 },
    { 1024, 768 }, { 3440, 1440 }, { 480, 800 },   { 1280, 1280 }, { 640, 360 },
};
#define SIZE_COUNT (sizeof sizes / sizeof *sizes)

static struct scene scene;
static struct ui_batch batch;
static struct ui_memory memory;

/* Sides of a rectangle, in pixels. */
struct bounds {
    float left, top, right, bottom;
};

/* Returns the rectangle of quad number `quad` of the layout. */
static inline struct bounds bounds_of(uint32_t quad)
{
    const struct ui_vertex *v = &batch.vertices[quad * 4u];
    struct bounds bounds = { v[0].x, v[0].y, v[0].x, v[0].y };
    for (uint32_t i = 1; i < 4u; i++) {
        bounds.left = v[i].x < bounds.left ? v[i].x : bounds.left;
        bounds.right = v[i].x > bounds.right ? v[i].x : bounds.right;
        bounds.top = v[i].y < bounds.top ? v[i].y : bounds.top;
        bounds.bottom = v[i].y > bounds.bottom ? v[i].y : bounds.bottom;
    }
    return bounds;
}

/* Sets up a scene in the phase `phase` with four players and every possible element. */
static inline void set_scene(uint8_t phase, uint8_t language, uint8_t hint, float phase_s)
{
    memset(&scene, 0, sizeof scene);
    scene.tick = SETTLED_TICK + (uint32_t)(phase_s * 120.0f);
    scene.phase = phase;
    scene.view = (struct view){ .eye_m = v3(0.0f, 1.0f, 0.1f), .half_height_tan = 0.5f };
    scene.language = language;
    scene.hint = hint;
    scene.phase_s = phase_s;
    scene.seconds_left = phase == PHASE_READY ? 3.0f - phase_s : 600.0f - phase_s;
    scene.best_today = 9999;
    scene.modes = (1u << CHOICE_COUNT) - 1u;
    scene.tags = (uint8_t)mode_tags_offered(scene.modes, true);
    scene.pointed_tags = 1u;
    scene.grade = 7;
    for (uint32_t i = 0; i < MODE_COUNT; i++) {
        scene.offer[i] = (struct scene_offer){ .round_s = 90, .grade = 7 };
    }
    for (uint32_t i = 0; i < POI_MAX; i++) {
        scene.poi[i].present = scene.player[i].plays = 1;
        scene.poi[i].paper_left = 0.5f;
        scene.caught[i] = 1000u + i;
        scene.player[i].foul_s = 60.0f;
    }
    scene.call_s = 60.0f;
}

/* Sets the mode and the number of players. `variant` selects the announcement, and the fouls and
 * the state of each player. */
static inline void set_match(uint8_t mode, uint32_t players, uint8_t variant)
{
    scene.mode = mode;
    scene.call = variant % (CALL_TIME + 1u);
    scene.call_s = 0.15f * (float)(variant % 11u);
    scene.paused = variant % 5u == 4u;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        scene.poi[i].present = scene.player[i].plays = i < players;
        scene.poi[i].shows_stress = mode == MODE_PRACTICE;
        scene.player[i].fouls = (uint8_t)((variant + i) % (FOUL_MAX + 1u));
        scene.player[i].foul = (uint8_t)((variant + i) % FOUL_COUNT);
        scene.player[i].foul_s = 0.3f * (float)(variant % 10u);
        scene.player[i].miss_s = variant % 3u == 2u ? 0.1f * (float)(variant % 13u) : 0.0f;
        scene.poi[i].position_m = v3(0.2f * (float)variant - 2.0f, 0.05f, 0.4f * (float)i - 0.6f);
        scene.player[i].lost = (variant + i) % 3u == 0;
        scene.player[i].out = (variant + i) % 4u == 1;
    }
}

/* Lays out the scene on a screen of the size `size`. */
static inline void lay_out(struct size size)
{
    ui_screens(&batch, &memory, &scene, size.width, size.height);
    assert_int_equal(batch.unbaked_count, 0); /* Every drawn letter must be in the font. */
}

/* Returns how many letters the layout has. */
static inline uint32_t glyph_quads(void)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < batch.quad_count; i++) {
        count += batch.kinds[i] == UI_GLYPH;
    }
    return count;
}

#endif
