/* ui_lab_keys.c -- draws the key shapes (modelled growth stages) as their maker drew them, the
 * weight of each key at the current age, and the lifeline. Also returns the growth lab's names and
 * figures in both languages. */
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
    const int in_days = age_days < DAYS_TO_TELL;
    const float value = in_days ? age_days : age_days / DAYS_PER_YEAR;
    snprintf(number, sizeof number, in_days ? "%.0f" : "%.1f", (double)value);
    const char *words = text_words(language, in_days ? TEXT_DAYS_OLD : TEXT_YEARS_OLD);
    const char *gap = strstr(words, "{}");
    if (gap == NULL) {
        snprintf(out, out_size, "%s", words);
    } else {
        snprintf(out, out_size, "%.*s%s%s", (int)(gap - words), words, number, gap + 2);
    }
}

void lab_length_words(float length_m, char *out, size_t out_size)
{
    CORE_ASSERT(out_size > 0);
    const float mm = 1000.0f * length_m;
    if (mm < 9.95f) {
        snprintf(out, out_size, "%.1f mm", (double)mm);
    } else if (mm < 99.5f) {
        snprintf(out, out_size, "%.0f mm", (double)mm);
    } else if (mm < 399.5f) {
        snprintf(out, out_size, "%.1f cm", (double)(0.1f * mm));
    } else {
        snprintf(out, out_size, "%.0f cm", (double)(0.1f * mm));
    }
}

static enum lab_part part_of_key(uint32_t key)
{
    return (enum lab_part)(LAB_KEY + key);
}

/* ---- Pictures of the key shapes ------------------------------------------------------------- */

static void key_card(const struct lab_page *page, uint32_t key)
{
    CORE_ASSERT(key < page->lab->card.key_count);
    const float u = page->frame.unit;
    const struct scene_lab *lab = page->lab;
    const struct ui_box box = lab_place(page, part_of_key(key));
    const uint32_t colour = lab_key_colour(lab->card.key_count, key);
    const int in_hand = lab->layer == key, pointed = lab_is_pointed(page, part_of_key(key));
    char percent[12];
    if (in_hand || pointed) {
        const float out = (in_hand ? 4.0f : 2.0f) * u;
        const struct ui_box halo = { box.x - out, box.y - out, box.width + 2.0f * out,
                                     box.height + 2.0f * out };
        ui_panel(&page->frame, UI_PANEL, halo, 12.0f * u, 0.0f, colour, 0);
    }
    ui_panel(&page->frame, UI_WASHI, box, 9.0f * u, 2.0f * u, LAB_PAPER, ui_fade(colour, 0.7f));
    const struct ui_box picture = { box.x + 8.0f * u, box.y + 26.0f * u, box.width - 16.0f * u,
                                    box.height - 66.0f * u };
    if (page->bench != NULL) {
        const struct ui_lab_preview *bench = page->bench;
        const struct specimen_bounds *reach = &bench->bounds;
        const uint32_t last = page->lab->card.key_count - 1u;
        struct specimen fish = { .species = bench->species,
                                 .edition = bench->edition,
                                 .progress = (float)key / (float)last };
        specimen_portrait(&fish);
        const float wide = picture.width / fmaxf(reach->left + reach->right, 0.1f);
        const float high = picture.height / fmaxf(reach->up + reach->down, 0.1f);
        fish.length_px = 0.90f * fminf(wide, high);
        fish.x_px =
            picture.x + 0.5f * picture.width + 0.5f * (reach->left - reach->right) * fish.length_px;
        fish.y_px =
            picture.y + 0.5f * picture.height + 0.5f * (reach->up - reach->down) * fish.length_px;
        ui_specimen(page->frame.batch, &fish);
    }
    const struct ui_text name = lab_text(page, 18.5f, LAB_INK);
    const struct ui_box title = { box.x + 8.0f * u, box.y + 6.0f * u, box.width - 16.0f * u,
                                  20.0f * u };
    ui_words_in(&page->frame, title, &name,
                lab_name(page->frame.language, lab->card.key_names[key]));
    snprintf(percent, sizeof percent, "%.0f %%", (double)(100.0f * lab->weight[key]));
    const struct ui_text number = lab_text(page, 20.0f, colour);
    const struct ui_box amount = { box.x + 8.0f * u, box.y + box.height - 40.0f * u,
                                   box.width - 16.0f * u, 20.0f * u };
    ui_words_in(&page->frame, amount, &number, percent);
    struct ui_box bar = { box.x + 10.0f * u, box.y + box.height - 17.0f * u, box.width - 20.0f * u,
                          8.0f * u };
    ui_panel(&page->frame, UI_PANEL, bar, 0.5f * bar.height, 0.0f, ui_fade(colour, 0.22f), 0);
    bar.width *= lab->weight[key];
    if (bar.width > bar.height) {
        ui_panel(&page->frame, UI_PANEL, bar, 0.5f * bar.height, 0.0f, colour, 0);
    }
}

/* ---- Lifeline: axis of progress from hatching to adult -------------------------------------- */

void lab_keys(const struct lab_page *page)
{
    for (uint32_t key = 0; key < page->lab->card.key_count; key++) {
        key_card(page, key);
    }
    const float u = page->frame.unit;
    const struct scene_lab *lab = page->lab;
    const struct ui_box box = lab_place(page, LAB_AGE);
    const uint32_t count = lab->card.key_count;
    const float y = box.y + 20.0f * u;
    const float from[2] = { lab_px_x(page, lab_age_x(lab->upright, count, 0.0f)), y };
    const float to[2] = { lab_px_x(page, lab_age_x(lab->upright, count, 1.0f)), y };
    const float now[2] = { lab_px_x(page, lab_age_x(lab->upright, count, lab->progress)), y };
    ui_segment(page->frame.batch, from, to, 7.0f * u, 0x3c4888ffu);
    ui_segment(page->frame.batch, from, now, 7.0f * u, UI_VERMILION);
    for (uint32_t key = 0; key < count; key++) {
        const struct species_card *card = &page->lab->card;
        const uint32_t last = card->key_count - 1u;
        const float x = lab_px_x(
            page, lab_age_x(page->lab->upright, card->key_count, (float)key / (float)last));
        const float r = 8.0f * u;
        char words[TEXT_LINE_MAX];
        ui_disc(&page->frame, x, y, r, 2.0f * u, lab_key_colour(card->key_count, key), 0xfff4deffu);
        lab_age_words(page->frame.language, card->key_age_days[key], words, sizeof words);
        struct ui_text style = lab_text(page, 19.0f, 0xd9def2ffu);
        style.align = 0.5f;
        style.fit_px = 130.0f * u;
        ui_text(page->frame.batch, &style, x, y + 32.0f * u, words);
    }
    const float handle_x =
        lab_px_x(page, lab_age_x(lab->upright, lab->card.key_count, lab->progress));
    const int lit = lab->holds == HOLD_AGE || lab_is_pointed(page, LAB_AGE);
    const float handle_r = (lit ? 17.0f : 14.5f) * u;
    const struct ui_box glow = { handle_x - 2.4f * handle_r, y - 2.4f * handle_r, 4.8f * handle_r,
                                 4.8f * handle_r };
    ui_glow(&page->frame, glow, lit ? 0xffb050b0u : 0xffb05060u);
    ui_disc(&page->frame, handle_x, y, handle_r, 3.0f * u, UI_VERMILION, 0xfff4deffu);
}
