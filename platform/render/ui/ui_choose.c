/* ui_choose.c -- draws the mode selection: wooden tags that hang from a pole. The large tags have
 * the pictures of the levels of the festival mode, and the small tags have the other modes. */
#include <math.h>
#include <stdio.h>

#include "core/base/panic.h"
#include "core/game/accounting/accounts.h"
#include "core/game/mode_tags.h"
#include "core/game/rules.h"
#include "platform/render/ui/ui_widgets.h"

#define SECONDS_SHOWN 99.0f
#define RAISE_S 0.16f
#define LINE_INK 0x3a2418ffu
/* Rise of the upper line of a tag, in layout units, for an increase of the text scale by 1. */
#define LINE_RISE 20.0f

static const struct {
    enum text_key name, ends;
} modes[CHOICE_COUNT] = {
    [MODE_FESTIVAL] = { TEXT_FESTIVAL, TEXT_FESTIVAL_ENDS },
    [MODE_CHAMPIONSHIP] = { TEXT_CHAMPIONSHIP, TEXT_CHAMPIONSHIP_ENDS },
    [MODE_PRACTICE] = { TEXT_PRACTICE, TEXT_PRACTICE_ENDS },
    [CHOICE_LAB] = { TEXT_LAB, TEXT_LAB_ENDS },
};

const char *ui_mode_name(uint8_t language, uint8_t mode)
{
    return text_words(language, modes[mode < CHOICE_COUNT ? mode : MODE_FESTIVAL].name);
}

/* Writes the duration of a round, such as "3 minutes" or "90 seconds". Minutes are used only if the
 * duration is a whole number of at least two minutes. */
static void duration_words(const struct ui_frame *frame, uint32_t round_s, char *out, size_t size)
{
    const bool is_even = round_s >= 120u && round_s % 60u == 0;
    text_number(out, size, ui_words(frame, is_even ? TEXT_MINUTES : TEXT_SECONDS),
                is_even ? round_s / 60u : round_s);
}

/* Layout of the texts on a tag in layout units. `name_y` and `line_y` are distances from the tag's
 * lower edge, and the other fields are text sizes. `name_size` is the size in Japanese, and
 * `name_size_stall` the size in other languages. */
struct tag_layout {
    float name_y, name_size, name_size_stall, line_y[2], line_size;
};

static const struct tag_layout large = { 128.0f, 74.0f, 46.0f, { 60.0f, 26.0f }, 23.0f };
static const struct tag_layout small = { 92.0f, 41.0f, 33.0f, { 52.0f, 23.0f }, 22.0f };

/* Returns how much higher the upper line of a tag is than at the normal size of small texts, in
 * layout units. Larger letters need a larger distance between the lines. */
static float line_rise(const struct ui_frame *frame)
{
    return LINE_RISE * (frame->text_scale - 1.0f);
}

/* Draws the name of a tag and two lines below the name. */
static void tag_words(const struct ui_frame *frame, const struct tag_layout *at, struct ui_box box,
                      const char *name, const char *const lines[2])
{
    const float u = frame->unit, x = box.x + 0.5f * box.width, bottom = box.y + box.height;
    const float room = box.width - 14.0f * u;
    struct ui_text brush = ui_brush(frame, at->name_size, at->name_size_stall, -0.06f, UI_INK);
    brush.align = 0.5f;
    brush.fit_px = room;
    const float rise = line_rise(frame);
    ui_text_at(frame, brush, x, bottom - (at->name_y + 0.5f * rise) * u, name);
    for (uint32_t i = 0; i < 2u; i++) {
        ui_text_at(frame, ui_style(frame, FONT_BODY, at->line_size, 0.5f, LINE_INK, room), x,
                   bottom - (at->line_y[i] + (i == 0 ? rise : 0.0f)) * u, lines[i]);
    }
}

/* Draws the content of a large tag: the picture, the name and the paper of a level. */
static void level_tag(const struct ui_frame *frame, uint8_t level, struct ui_box box)
{
    const float u = frame->unit, bottom = box.y + box.height;
    const float rule_y = 84.0f + line_rise(frame);
    const struct ui_box rule = { box.x + 34.0f * u, bottom - rule_y * u, box.width - 68.0f * u,
                                 2.5f * u };
    char paper[TEXT_LINE_MAX];
    text_number(paper, sizeof paper, ui_words(frame, TEXT_PAPER),
                rules_grade_at_level(frame->scene->offer[MODE_FESTIVAL].grade, level));
    ui_level_figure(frame, box.x + 0.5f * box.width - 6.0f * u, bottom - 176.0f * u,
                    box.height - 196.0f * u, level);
    ui_panel(frame, UI_PANEL, rule, 1.2f * u, 0.0f, 0x5a3a20a0u, 0);
    tag_words(frame, &large, box, ui_level_name(frame->language, level),
              (const char *[]){ paper, ui_words(frame, modes[MODE_FESTIVAL].ends) });
}

/* Draws the content of a small tag: the name and the duration of a mode, or of the growth lab. */
static void mode_tag(const struct ui_frame *frame, uint8_t mode, struct ui_box box)
{
    char duration[TEXT_LINE_MAX];
    const char *lines[2] = { duration, ui_words(frame, modes[mode].ends) };
    if (mode == CHOICE_LAB) {
        lines[0] = ui_words(frame, TEXT_LAB_SHAPES);
    } else {
        duration_words(frame, frame->scene->offer[mode].round_s, duration, sizeof duration);
    }
    tag_words(frame, &small, box, ui_mode_name(frame->language, mode), lines);
}

/* Draws the numbers of the players who have selected `level`, one below the other. Draws nothing if
 * there is only one player. */
static void player_marks(const struct ui_frame *frame, uint8_t level, struct ui_box box)
{
    const struct scene *const scene = frame->scene;
    const float radius = 18.0f * frame->unit;
    float y = box.y + 1.3f * radius;
    for (uint32_t i = 0; i < POI_MAX && ui_bowl_count(scene) > 1u; i++) {
        if (scene->player[i].has_pointer && scene->player[i].level == level) {
            ui_player_mark(frame, box.x + 1.3f * radius, y, radius, i);
            y += 2.3f * radius;
        }
    }
}

/* Draws the time that remains for the selection as a ring. */
static void seconds_ring(const struct ui_frame *frame, float x, float y)
{
    const float u = frame->unit, radius = 36.0f * u;
    const float left = fminf(fmaxf(frame->scene->seconds_left, 0.0f), SECONDS_SHOWN);
    const float part = left / ((float)RULES_MODE_SELECT_TICKS * CORE_TICK_S);
    ui_disc(frame, x, y, radius, 0.0f, UI_NIGHT, 0);
    ui_ring(frame, x, y, radius, 6.0f * u, f_clamp(part, 0.0f, 1.0f), UI_GOLD, 0xffffff28u);
    ui_number_at(frame, ui_style(frame, FONT_STALL, 34.0f, 0.5f, 0xfff8eaffu, 52.0f * u), x, y,
                 (uint32_t)ceilf(left));
}

/* Draws the best score of the day in the selected mode and the line about the keys. */
static void draw_choose_foot(const struct ui_frame *frame)
{
    const struct scene *const scene = frame->scene;
    const float u = frame->unit;
    if (scene->choice != CHOICE_LAB && rules_of(scene->mode)->keeps_score) {
        ui_best_ribbon(frame, frame->height - 118.0f * u, 25.0f * u);
    }
    ui_ribbon(frame, (struct ui_ribbon){ FONT_BODY, 0xc8341ff2u, UI_GOLD, 0 },
              frame->height - 52.0f * u, 29.0f * u,
              ui_words(frame, scene->credit.warnings & WARN_NO_POI ? TEXT_START_NO_POI
                                                                   : TEXT_CHOOSE_KEYS));
}

/* Draws the tags. The tags descend when the screen appears, and `in` in [0, 1] is the completed
 * fraction of this motion. */
static void draw_tags(const struct ui_frame *frame, float in)
{
    const struct scene *const scene = frame->scene;
    const struct ui_memory *const memory = frame->memory;
    const float u = frame->unit;
    /* When the selection changes, the selected tag rises and the previously selected tag sinks. */
    const float age_s = (float)(scene->tick - memory->pointed_tick) * CORE_TICK_S;
    const float moved = f_smoothstep(0.0f, RAISE_S, age_s);
    for (uint32_t tag = 0; tag < MODE_TAG_COUNT; tag++) {
        if (!(scene->tags >> tag & 1u)) {
            continue;
        }
        const bool is_pointed = scene->pointed_tags >> tag & 1u;
        const float raised = is_pointed                           ? moved
                             : memory->pointed_before >> tag & 1u ? 1.0f - moved
                                                                  : 0.0f;
        struct ui_box box = ui_place(frame, mode_tag_box(frame->is_upright, scene->tags, tag));
        box.y -= (12.0f * raised + 60.0f * (1.0f - in)) * u;
        ui_wooden_tag(frame, box, is_pointed);
        if (tag < MODE_TAG_LEVELS) {
            level_tag(frame, mode_tags[tag].level, box);
            player_marks(frame, mode_tags[tag].level, box);
        } else {
            mode_tag(frame, mode_tags[tag].mode, box);
        }
    }
}

void ui_choose(const struct ui_frame *frame)
{
    const struct scene *const scene = frame->scene;
    const struct ui_frame canvas = ui_canvas(frame, scene->upright);
    const float u = canvas.unit, in = f_smoothstep(0.0f, 0.35f, scene->phase_s);
    frame->batch->opacity = in;
    ui_veil(frame, 0x080a2078u);
    const struct ui_text title = ui_style(&canvas, FONT_STALL, 44.0f, 0.0f, UI_CREAM, 0.0f);
    ui_words_in(
        &canvas,
        ui_place_either(&canvas, canvas_box(240, 14, 800, 56), canvas_box(60, 190, 734, 90)),
        ui_outlined(title, 0.03f, 0.1f, UI_WORD_SHADE), ui_words(frame, TEXT_CHOOSE));
    if (scene->tags & MODE_TAG_LEVEL_MASK) {
        const struct ui_box at =
            ui_place_either(&canvas, canvas_box(476, 104, 0, 0), canvas_box(427, 322, 0, 0));
        char duration[TEXT_LINE_MAX], festival[2u * TEXT_LINE_MAX + 4u];
        duration_words(frame, scene->offer[MODE_FESTIVAL].round_s, duration, sizeof duration);
        snprintf(festival, sizeof festival, "%s   %s", ui_mode_name(frame->language, MODE_FESTIVAL),
                 duration);
        ui_ribbon_at(&canvas, (struct ui_ribbon){ FONT_STALL, UI_NIGHT, UI_GOLD_DIM, UI_GOLD },
                     at.x, at.y, 26.0f * u, 600.0f * u, festival);
    }
    draw_tags(&canvas, in);
    draw_choose_foot(frame);
    seconds_ring(frame, frame->width - 66.0f * frame->unit, 62.0f * frame->unit);
    ui_credits(frame, 128.0f * frame->unit, 62.0f * frame->unit);
    for (uint32_t i = 0; i < POI_MAX; i++) {
        const struct scene_player *const player = &scene->player[i];
        if (player->has_pointer) {
            ui_pointer(&canvas, player->x, player->y, false, ui_player_colours[i]);
        }
    }
    frame->batch->opacity = 1.0f;
}
