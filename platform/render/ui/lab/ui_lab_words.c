/* ui_lab_words.c -- returns the names of species and keys for the growth lab, in both languages. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "platform/render/ui/lab/ui_lab.h"
#include "platform/render/ui/text.h"

#define DAYS_PER_YEAR 365.25f
#define DAYS_TO_TELL 700.0f /* Minimum age in days that is written in years. */

struct known {
    const char *id;
    enum text_key words;
};

static const char *look_up(uint8_t language, const struct known *known, size_t count,
                           const char *id)
{
    for (size_t i = 0; i < count; i++) {
        if (strcmp(known[i].id, id) == 0) {
            return text_words(language, known[i].words);
        }
    }
    return id;
}

const char *lab_species_name(uint8_t language, const char *id)
{
    static const struct known known[] = {
        { "wakin", TEXT_FISH_WAKIN },         { "kurodai", TEXT_FISH_KURODAI },
        { "shimafugu", TEXT_FISH_SHIMAFUGU }, { "kuroanago", TEXT_FISH_KUROANAGO },
        { "hirame", TEXT_FISH_HIRAME },       { "ray", TEXT_FISH_RAY },
        { "mebachi", TEXT_FISH_MEBACHI },
    };
    return look_up(language, known, sizeof known / sizeof *known, id);
}

const char *lab_key_name(uint8_t language, const char *name)
{
    /* clang-format off */
    static const struct known known[] = {
        { "hatchling", TEXT_KEY_HATCHLING }, { "larva", TEXT_KEY_LARVA },
        { "juvenile", TEXT_KEY_JUVENILE },   { "juvenile_b", TEXT_KEY_JUVENILE_B },
        { "juvenile_c", TEXT_KEY_JUVENILE_C }, { "young", TEXT_KEY_YOUNG },
        { "adult", TEXT_KEY_ADULT },         { "aoko", TEXT_KEY_AOKO },
        { "kuroko", TEXT_KEY_KUROKO },       { "koaka", TEXT_KEY_KOAKA },
        { "upright", TEXT_KEY_UPRIGHT },     { "crossing", TEXT_KEY_CROSSING },
        { "settling", TEXT_KEY_SETTLING },   { "settled", TEXT_KEY_SETTLED },
        { "leaf", TEXT_KEY_LEAF },           { "long_leaf", TEXT_KEY_LONG_LEAF },
        { "shrinking", TEXT_KEY_SHRINKING }, { "newborn", TEXT_KEY_NEWBORN },
    };
    /* clang-format on */
    return look_up(language, known, sizeof known / sizeof *known, name);
}

static void put_in(const char *words, const char *number, char *out, size_t out_size)
{
    const char *gap = strstr(words, "{}");
    if (gap == NULL) {
        snprintf(out, out_size, "%s", words);
    } else {
        snprintf(out, out_size, "%.*s%s%s", (int)(gap - words), words, number, gap + 2);
    }
}

void lab_age_words(uint8_t language, float age_days, char *out, size_t out_size)
{
    char number[16];
    const int in_days = age_days < DAYS_TO_TELL;
    const float value = in_days ? age_days : age_days / DAYS_PER_YEAR;
    snprintf(number, sizeof number, in_days ? "%.0f" : "%.1f", (double)value);
    put_in(text_words(language, in_days ? TEXT_DAYS_OLD : TEXT_YEARS_OLD), number, out, out_size);
}

void lab_length_words(float length_m, char *out, size_t out_size)
{
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
