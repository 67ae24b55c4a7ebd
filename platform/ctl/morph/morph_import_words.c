/* morph_import_words.c -- parses the options of `kingyoctl morph import`. */
#include "platform/ctl/morph/morph_import_words.h"

#include <stdio.h>
#include <string.h>

#include "core/base/panic.h"
#include "core/morph/morph.h"
#include "platform/ctl/morph/morph_options.h"
#include "platform/os/number.h"

static const char name[] = "import";

/* Calls `take` for each item of a comma-separated list. Returns the number of items, or
 * IMPORT_UNSET if an item is invalid. */
static uint32_t each_piece(const char *list, uint32_t count_max, void *out,
                           bool (*take)(const char *piece, uint32_t index, void *out))
{
    uint32_t count = 0;
    while (*list) {
        char piece[IMPORT_PATH_SIZE];
        const size_t length = strcspn(list, ",");
        if (length >= sizeof piece || count == count_max) {
            return IMPORT_UNSET;
        }
        memcpy(piece, list, length);
        piece[length] = '\0';
        if (!take(piece, count++, out)) {
            return IMPORT_UNSET;
        }
        list += length + (list[length] == ',');
    }
    return count > 0 ? count : IMPORT_UNSET;
}

/* Parses a length in mm. The allowed range is the range of a species text (text_life.c), so that
 * the core receives no other value. */
static bool take_length(const char *piece, uint32_t index, void *out)
{
    CORE_ASSERT(index < MORPH_KEY_MAX);
    return number_parse_decimal(piece, 0.5, 20000.0, (double *)out + index);
}

static bool take_age(const char *piece, uint32_t index, void *out)
{
    return number_parse_decimal(piece, 0.0, 14610.0, (double *)out + index);
}

static bool take_growth(const char *piece, uint32_t index, void *out)
{
    CORE_ASSERT(index < 5);
    static const double ranges[5][2] = {
        { 10.0, 20000.0 }, { 0.001, 10.0 }, { -20.0, 20.0 }, { 0.5, 2000.0 }, { 0.001, 5.0 }
    };
    return number_parse_decimal(piece, ranges[index][0], ranges[index][1], (double *)out + index);
}

bool morph_import_words_take_name(const char *piece, uint32_t index, void *out)
{
    CORE_ASSERT(index < MORPH_KEY_MAX);
    char(*names)[SPECIES_NAME_SIZE] = out;
    const size_t length = strlen(piece);
    if (length >= SPECIES_NAME_SIZE) {
        return false;
    }
    memset(names[index], 0, SPECIES_NAME_SIZE);
    memcpy(names[index], piece, length);
    return species_name_is_good(names[index]);
}

static bool take_path(const char *piece, uint32_t index, void *out)
{
    CORE_ASSERT(index < MORPH_KEY_MAX);
    char(*paths)[IMPORT_PATH_SIZE] = out;
    snprintf(paths[index], IMPORT_PATH_SIZE, "%s", piece);
    return true;
}

static bool take_colour(const char *piece, uint32_t index, void *out)
{
    uint32_t value = 0;
    if (strlen(piece) != 6) {
        return false;
    }
    for (; *piece; piece++) {
        const char *digit = strchr("0123456789abcdef", *piece);
        if (!digit) {
            return false;
        }
        value = value << 4 | (uint32_t)(digit - "0123456789abcdef");
    }
    ((uint32_t *)out)[index] = value;
    return true;
}

static bool take_axis(const char *value, uint8_t *out)
{
    for (uint8_t axis = 0; axis < AXIS_NONE; axis++) {
        if (strcmp(value, import_axis_names[axis]) == 0 ||
            strcmp(value, import_axis_names[axis] + 1) == 0) {
            *out = axis;
            return axis < AXIS_MINUS_X || value[0] == '-';
        }
    }
    return false;
}

static bool take_choice(const char *value, const char *const *words, uint32_t count, uint8_t *out)
{
    for (uint32_t i = 0; i < count; i++) {
        if (strcmp(value, words[i]) == 0) {
            *out = (uint8_t)i;
            return true;
        }
    }
    return false;
}

static const char *const measures[] = { "total", "standard", "fork", "disc" };
static const char *const motions[] = { "tail", "eel", "fins", "tuna", "wing" };
static const char *const forms[] = { "fusiform", "compressed", "depressed", "eel", "puffer" };

/* Parses an option with a single value. Returns false if the value is invalid. Sets `*known` to
 * true if the option exists, otherwise to false. */
static bool take_value(struct morph_import_words *words, const char *option, const char *value,
                       bool *known)
{
    struct import_options *plan = &words->plan;
    *known = true;
    if (strcmp(option, "--id") == 0) {
        words->id = value;
        return value[0] != '\0';
    }
    if (strcmp(option, "--like") == 0) {
        words->like = value;
        return value[0] != '\0';
    }
    if (strcmp(option, "--fit") == 0) {
        words->fit = value;
        return value[0] != '\0';
    }
    if (strcmp(option, "--front") == 0) {
        return take_axis(value, &plan->front);
    }
    if (strcmp(option, "--up") == 0) {
        return take_axis(value, &plan->up);
    }
    if (strcmp(option, "--unit-m") == 0) {
        return number_parse_decimal(value, 1e-6, 1e3, &plan->unit_m) != 0;
    }
    if (strcmp(option, "--measure") == 0) {
        return take_choice(value, measures, 4, &plan->measure);
    }
    if (strcmp(option, "--motion") == 0) {
        return take_choice(value, motions, 5, &plan->motion);
    }
    if (strcmp(option, "--form") == 0) {
        return take_choice(value, forms, 5, &plan->form);
    }
    if (strcmp(option, "--graph") == 0) {
        for (enum graph_template i = TEMPLATE_ORDINARY; i < TEMPLATE_COUNT; i++) {
            if (strcmp(value, morph_template_name(i)) == 0) {
                plan->template_id = (uint8_t)i;
                return true;
            }
        }
        return false;
    }
    *known = false;
    return false;
}

/* Parses an option whose value is a comma-separated list. Returns false if the value is invalid.
 * Sets `*known` to true if the option exists, otherwise to false. */
static bool take_list(struct morph_import_words *words, const char *option, const char *value,
                      bool *known)
{
    struct import_options *plan = &words->plan;
    const struct {
        const char *name;
        uint32_t *count;
        uint32_t least, most;
        void *out;
        bool (*take)(const char *piece, uint32_t index, void *out);
    } lists[] = {
        { "--names", &plan->name_count, 3, MORPH_KEY_MAX, plan->names,
          morph_import_words_take_name },
        { "--marks", &words->mark_count, 3, MORPH_KEY_MAX, words->marks, take_path },
        { "--lengths-mm", &plan->length_count, 2, MORPH_KEY_MAX, plan->lengths_mm, take_length },
        { "--ages-days", &plan->age_count, 2, MORPH_KEY_MAX, plan->ages_days, take_age },
        { "--growth", &plan->growth_count, 5, 5, plan->growth, take_growth },
        { "--colours", &plan->colour_count, 5, 5, plan->colours, take_colour },
    };
    for (size_t i = 0; i < sizeof lists / sizeof lists[0]; i++) {
        if (strcmp(option, lists[i].name) == 0) {
            const uint32_t got = each_piece(value, lists[i].most, lists[i].out, lists[i].take);
            *known = true;
            *lists[i].count = got;
            return got != IMPORT_UNSET && got >= lists[i].least;
        }
    }
    *known = false;
    return false;
}

enum exit_code morph_import_words_read(struct morph_import_words *words, int argc,
                                       const char *const *argv)
{
    *words = (struct morph_import_words){
        .plan = { .front = AXIS_NONE,
                  .up = AXIS_Y,
                  .measure = IMPORT_UNSET,
                  .motion = IMPORT_UNSET,
                  .form = IMPORT_UNSET,
                  .template_id = TEMPLATE_OWN,
                  .unit_m = 1.0 },
    };
    for (int i = 0; i < argc; i++) {
        if (strncmp(argv[i], "--", 2) == 0) {
            bool known;
            const char *value = i + 1 < argc ? argv[i + 1] : "";
            bool good = take_value(words, argv[i], value, &known);
            if (!known) {
                good = take_list(words, argv[i], value, &known);
            }
            if (!good) {
                return known ? morph_usage(name, "%s: '%.60s' will not do; --help says what will",
                                           argv[i], value)
                             : morph_usage(name, "unknown option '%.100s'; --help lists them",
                                           argv[i]);
            }
            i++;
        } else if (!words->out) {
            words->out = argv[i];
        } else if (words->file_count == MORPH_KEY_MAX) {
            return morph_usage(name, "more than %u files", MORPH_KEY_MAX);
        } else {
            words->files[words->file_count++] = argv[i];
        }
    }
    if (words->file_count == 0) {
        return morph_usage(name, "write: OUT.kfish and what to make it of");
    }
    return EXIT_OK;
}
