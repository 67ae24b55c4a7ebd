/* ui_lab_keys.c -- draws the key shapes (modelled growth stages) of the species, the weight of each
 * key at the current age, and the lifeline. Also writes the growth lab's names, ages and lengths in
 * both languages. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "core/base/panic.h"
#include "core/game/lab/lab.h"
#include "platform/render/ui/lab/ui_lab.h"
#include "platform/render/ui/text.h"

#define DAYS_PER_YEAR 365.25f
#define DAYS_TO_TELL 700.0f /* Minimum age in days from which an age is written in years. */

const char *lab_name(uint8_t language, const char *id)
{
    /* clang-format off */
    static const struct {
        const char *id;
        enum text_key words;
    } known[] = {
        { "wakin", TEXT_FISH_WAKIN },          { "kurodai", TEXT_FISH_KURODAI },
        { "shimafugu", TEXT_FISH_SHIMAFUGU },  { "kuroanago", TEXT_FISH_KUROANAGO },
        { "hirame", TEXT_FISH_HIRAME },        { "ray", TEXT_FISH_RAY },
        { "mebachi", TEXT_FISH_MEBACHI },
        { "hatchling", TEXT_KEY_HATCHLING },   { "larva", TEXT_KEY_LARVA },
        { "juvenile", TEXT_KEY_JUVENILE },     { "juvenile_b", TEXT_KEY_JUVENILE_B },
        { "juvenile_c", TEXT_KEY_JUVENILE_C }, { "young", TEXT_KEY_YOUNG },
        { "adult", TEXT_KEY_ADULT },           { "aoko", TEXT_KEY_AOKO },
        { "kuroko", TEXT_KEY_KUROKO },         { "koaka", TEXT_KEY_KOAKA },
        { "upright", TEXT_KEY_UPRIGHT },       { "crossing", TEXT_KEY_CROSSING },
        { "settling", TEXT_KEY_SETTLING },     { "settled", TEXT_KEY_SETTLED },
        { "leaf", TEXT_KEY_LEAF },             { "long_leaf", TEXT_KEY_LONG_LEAF },
        { "shrinking", TEXT_KEY_SHRINKING },   { "newborn", TEXT_KEY_NEWBORN },
    };
    /* clang-format on */
    for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
        if (strcmp(known[i].id, id) == 0) {
            return text_words(language, known[i].words);
        }
    }
    return id;
}

void lab_age_words(uint8_t language, float age_days, char *out, size_t out_size)
{
    CORE_ASSERT(out_size > 0);
    char number[16];
    const bool in_days = age_days < DAYS_TO_TELL;
    const float value = in_days ? age_days : age_days / DAYS_PER_YEAR;
    snprintf(number, sizeof number, in_days ? "%.0f" : "%.1f", (double)value);
    const char *words = text_words(language, in_days ? TEXT_DAYS_OLD : TEXT_YEARS_OLD);
    const char *gap = strstr(words, "{}");
    CORE_ASSERT(gap);
    snprintf(out, out_size, "%.*s%s%s", (int)(gap - words), words, number, gap + 2);
}

void lab_length_words(float length_m, char *out, size_t out_size)
{
    CORE_ASSERT(out_size > 0);
    const float mm = 1000.0f * length_m;
    const bool in_mm = mm < 99.5f;
    /* True if the length is short enough to be shown with one decimal place. */
    const bool is_fine = in_mm ? mm < 9.95f : mm < 399.5f;
    snprintf(out, out_size, "%.*f %s", is_fine ? 1 : 0, (double)(in_mm ? mm : 0.1f * mm),
             in_mm ? "mm" : "cm");
}

struct specimen lab_fish(const struct ui_frame *frame, float progress, float x, float y,
                         float width, float height, float share)
{
    const struct ui_lab_preview *const bench = &frame->memory->bench;
    CORE_ASSERT(bench->is_shown);
    const struct specimen_bounds *const reach = &bench->bounds;
    struct specimen fish = { .species = bench->species,
                             .edition = bench->edition,
                             .progress = progress };
    specimen_portrait(&fish);
    fish.length_px = share * fminf(width / fmaxf(reach->left + reach->right, 0.1f),
                                   height / fmaxf(reach->up + reach->down, 0.1f));
    fish.x_px = x + 0.5f * (reach->left - reach->right) * fish.length_px;
    fish.y_px = y + 0.5f * (reach->up - reach->down) * fish.length_px;
    return fish;
}

/* ---- Pictures of the key shapes ------------------------------------------------------------- */

static void key_card(const struct ui_frame *frame, uint32_t key)
{
    const struct scene_lab *const lab = &frame->scene->lab;
    const uint32_t count = lab->card.key_count;
    CORE_ASSERT(key < count);
    const float u = frame->unit;
    /* The parts between LAB_KEY and LAB_KEY_LAST have no names.
     * NOLINTNEXTLINE(clang-analyzer-optin.core.EnumCastOutOfRange) */
    const enum lab_part part = (enum lab_part)(LAB_KEY + key);
    const struct ui_box box = lab_place(frame, part), inner = ui_inset(box, 8.0f * u);
    const uint32_t colour = lab_key_colour(count, key);
    const bool is_edited = lab->layer == key;
    if (is_edited || lab_is_pointed(frame, part)) {
        const float out = (is_edited ? 4.0f : 2.0f) * u;
        const struct ui_box halo = { box.x - out, box.y - out, box.width + 2.0f * out,
                                     box.height + 2.0f * out };
        ui_panel(frame, UI_PANEL, halo, 12.0f * u, 0.0f, colour, 0);
    }
    ui_panel(frame, UI_WASHI, box, 9.0f * u, 2.0f * u, LAB_PAPER, ui_fade(colour, 0.7f));
    if (frame->memory->bench.is_shown) {
        const float height = box.height - 66.0f * u;
        const struct specimen fish =
            lab_fish(frame, (float)key / (float)(count - 1u), inner.x + 0.5f * inner.width,
                     box.y + 26.0f * u + 0.5f * height, inner.width, height, 0.90f);
        ui_specimen(frame->batch, &fish);
    }
    ui_words_in(frame, (struct ui_box){ inner.x, box.y + 6.0f * u, inner.width, 20.0f * u },
                ui_body(frame, 18.5f, LAB_INK),
                lab_name(frame->language, lab->card.key_names[key]));
    char percent[12];
    snprintf(percent, sizeof percent, "%.0f %%", (double)(100.0f * lab->weight[key]));
    ui_words_in(frame,
                (struct ui_box){ inner.x, box.y + box.height - 40.0f * u, inner.width, 20.0f * u },
                ui_body(frame, 20.0f, colour), percent);
    struct ui_box bar = { box.x + 10.0f * u, box.y + box.height - 17.0f * u, box.width - 20.0f * u,
                          8.0f * u };
    ui_panel(frame, UI_PANEL, bar, 0.5f * bar.height, 0.0f, ui_fade(colour, 0.22f), 0);
    bar.width *= lab->weight[key];
    if (bar.width > bar.height) {
        ui_panel(frame, UI_PANEL, bar, 0.5f * bar.height, 0.0f, colour, 0);
    }
}

/* ---- Lifeline: axis of progress from hatching to adult -------------------------------------- */

/* Returns the x coordinate on the screen of `progress` on the lifeline, in pixels. */
static float life_x(const struct ui_frame *frame, float progress)
{
    const uint32_t count = frame->scene->lab.card.key_count;
    return frame->x + lab_age_x(frame->is_upright, count, progress) * frame->unit;
}

void lab_keys(const struct ui_frame *frame)
{
    const struct scene_lab *const lab = &frame->scene->lab;
    const struct species_card *const card = &lab->card;
    for (uint32_t key = 0; key < card->key_count; key++) {
        key_card(frame, key);
    }
    const float u = frame->unit, y = lab_place(frame, LAB_AGE).y + 20.0f * u;
    const float now[2] = { life_x(frame, lab->progress), y };
    const float from[2] = { life_x(frame, 0.0f), y }, to[2] = { life_x(frame, 1.0f), y };
    ui_segment(frame->batch, from, to, 7.0f * u, 0x3c4888ffu);
    ui_segment(frame->batch, from, now, 7.0f * u, UI_VERMILION);
    for (uint32_t key = 0; key < card->key_count; key++) {
        const float x = life_x(frame, (float)key / (float)(card->key_count - 1u));
        char words[TEXT_LINE_MAX];
        ui_disc(frame, x, y, 8.0f * u, 2.0f * u, lab_key_colour(card->key_count, key), 0xfff4deffu);
        lab_age_words(frame->language, card->key_age_days[key], words, sizeof words);
        ui_text(frame->batch, ui_style(frame, FONT_BODY, 19.0f, 0.5f, 0xd9def2ffu, 130.0f * u), x,
                y + 32.0f * u, words);
    }
    const bool is_lit = lab->holds == HOLD_AGE || lab_is_pointed(frame, LAB_AGE);
    const float radius = (is_lit ? 17.0f : 14.5f) * u;
    ui_glow(frame, ui_around(now[0], y, 2.4f * radius), is_lit ? 0xffb050b0u : 0xffb05060u);
    ui_disc(frame, now[0], y, radius, 3.0f * u, UI_VERMILION, 0xfff4deffu);
}
