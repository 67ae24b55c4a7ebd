/* morph_import_words.c -- parses the options of `kingyoctl morph import` and `kingyoctl morph
 * refit`. */
#include "platform/ctl/morph/morph_import_words.h"

#include <stdio.h>
#include <string.h>

#include "core/base/panic.h"
#include "core/morph/morph.h"
#include "platform/ctl/morph/morph_options.h"
#include "platform/os/number.h"
#include "platform/species/part.h"

/* ---- Parsers of one value -------------------------------------------------------------------- */

/* Parses a length in mm. The allowed range is the range of a species text (text_life.c), so that
 * the core receives no other value. */
static bool take_length(const char *piece, uint32_t index, void *out)
{
    CORE_ASSERT(index < MORPH_KEY_MAX);
    return number_parse_decimal(piece, 0.5, 20000.0, (double *)out + index);
}

static bool take_age(const char *piece, uint32_t index, void *out)
{
    CORE_ASSERT(index < MORPH_KEY_MAX);
    return number_parse_decimal(piece, 0.0, 14610.0, (double *)out + index);
}

static bool take_growth(const char *piece, uint32_t index, void *out)
{
    static const double ranges[5][2] = {
        { 10.0, 20000.0 }, { 0.001, 10.0 }, { -20.0, 20.0 }, { 0.5, 2000.0 }, { 0.001, 5.0 }
    };
    CORE_ASSERT(index < 5);
    return number_parse_decimal(piece, ranges[index][0], ranges[index][1], (double *)out + index);
}

static bool take_unit(const char *piece, uint32_t index, void *out)
{
    (void)index;
    return number_parse_decimal(piece, 1e-6, 1e3, out);
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

/* Stores a text that is not empty. `out` points to a pointer to the text. */
static bool take_text(const char *piece, uint32_t index, void *out)
{
    (void)index;
    *(const char **)out = piece;
    return piece[0] != '\0';
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

static bool take_axis(const char *value, uint32_t index, void *out)
{
    (void)index;
    for (uint8_t axis = 0; axis < AXIS_NONE; axis++) {
        if (strcmp(value, import_axis_names[axis]) == 0 ||
            strcmp(value, import_axis_names[axis] + 1) == 0) {
            *(uint8_t *)out = axis;
            return axis < AXIS_MINUS_X || value[0] == '-';
        }
    }
    return false;
}

static bool take_template(const char *value, uint32_t index, void *out)
{
    (void)index;
    for (enum graph_template i = TEMPLATE_ORDINARY; i < TEMPLATE_COUNT; i++) {
        if (strcmp(value, morph_template_name(i)) == 0) {
            *(uint8_t *)out = (uint8_t)i;
            return true;
        }
    }
    return false;
}

/* ---- Options --------------------------------------------------------------------------------- */

/* An option and its value. Exactly one of `take` and `choices` is not null. */
struct word_option {
    const char *name;
    enum import_command command; /* Commands that accept the option: one command or both. */
    void *out;
    bool (*take)(const char *piece, uint32_t index, void *out); /* Callback that parses one item of
                                                                   the option's value. Null if
                                                                   `choices` is not null. */
    const char *const *choices; /* Words that the option accepts, `most` words in number. Null if
                                   `take` is not null. `out` points to the index of the chosen
                                   word. */
    uint32_t *count;            /* Number of parsed items of a comma-separated list. Null if the
                                   option has a single value. */
    uint32_t least, most;       /* Allowed number of items of a list. */
};

/* Parses the value of an option. Returns false if the value is invalid. */
static bool take_value(const struct word_option *option, const char *value)
{
    if (option->choices) {
        uint8_t choice = 0;
        while (choice < option->most && strcmp(option->choices[choice], value) != 0) {
            choice++;
        }
        *(uint8_t *)option->out = choice;
        return choice < option->most;
    }
    if (!option->count) {
        return option->take(value, 0, option->out);
    }
    for (*option->count = 0; *value; (*option->count)++) {
        char piece[IMPORT_PATH_SIZE];
        const size_t length = strcspn(value, ",");
        if (length >= sizeof piece || *option->count == option->most) {
            return false;
        }
        memcpy(piece, value, length);
        piece[length] = '\0';
        if (!option->take(piece, *option->count, option->out)) {
            return false;
        }
        value += length + (value[length] == ',');
    }
    return *option->count >= option->least;
}

static const char *command_name(enum import_command command)
{
    return command == IMPORT_REFIT ? "refit" : "import";
}

/* Parses one option with its value. Returns EXIT_OK, or prints one line and returns EXIT_USAGE. */
static enum exit_code take_option(struct morph_import_words *words, enum import_command command,
                                  const char *option, const char *value)
{
    struct import_options *plan = &words->plan;
    /* clang-format off */
    const struct word_option options[] = {
        { "--id", IMPORT_BOTH, &words->id, take_text, 0, 0, 0, 0 },
        { "--like", IMPORT_MESHES, &words->like, take_text, 0, 0, 0, 0 },
        { "--front", IMPORT_BOTH, &plan->front, take_axis, 0, 0, 0, 0 },
        { "--up", IMPORT_BOTH, &plan->up, take_axis, 0, 0, 0, 0 },
        { "--unit-m", IMPORT_MESHES, &plan->unit_m, take_unit, 0, 0, 0, 0 },
        { "--measure", IMPORT_BOTH, &plan->measure, 0, species_measure_names, 0, 0, 4 },
        { "--motion", IMPORT_MESHES, &plan->motion, 0, species_motion_names, 0, 0, 5 },
        { "--form", IMPORT_MESHES, &plan->form, 0, species_form_names, 0, 0, 5 },
        { "--graph", IMPORT_MESHES, &plan->template_id, take_template, 0, 0, 0, 0 },
        { "--names", IMPORT_BOTH, plan->names, morph_import_words_take_name, 0,
          &plan->name_count, 3, MORPH_KEY_MAX },
        { "--marks", IMPORT_REFIT, words->marks, take_path, 0,
          &words->mark_count, 3, MORPH_KEY_MAX },
        { "--lengths-mm", IMPORT_BOTH, plan->lengths_mm, take_length, 0,
          &plan->length_count, 2, MORPH_KEY_MAX },
        { "--ages-days", IMPORT_BOTH, plan->ages_days, take_age, 0,
          &plan->age_count, 2, MORPH_KEY_MAX },
        { "--growth", IMPORT_BOTH, plan->growth, take_growth, 0, &plan->growth_count, 5, 5 },
        { "--colours", IMPORT_MESHES, plan->colours, take_colour, 0, &plan->colour_count, 5, 5 },
    };
    /* clang-format on */
    for (size_t i = 0; i < sizeof options / sizeof options[0]; i++) {
        if ((options[i].command & command) && strcmp(option, options[i].name) == 0) {
            return take_value(&options[i], value)
                       ? EXIT_OK
                       : morph_usage(command_name(command),
                                     "%s: '%.60s' will not do; --help says what will", option,
                                     value);
        }
    }
    return morph_usage(command_name(command), "unknown option '%.100s'; --help lists them", option);
}

enum exit_code morph_import_words_read(struct morph_import_words *words,
                                       enum import_command command, int argc,
                                       const char *const *argv)
{
    CORE_ASSERT(command == IMPORT_MESHES || command == IMPORT_REFIT);
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
            const enum exit_code code =
                take_option(words, command, argv[i], i + 1 < argc ? argv[i + 1] : "");
            if (code != EXIT_OK) {
                return code;
            }
            i++;
        } else if (!words->out) {
            words->out = argv[i];
        } else if (command == IMPORT_REFIT && !words->like) {
            words->like = argv[i];
        } else if (words->file_count == MORPH_KEY_MAX) {
            return morph_usage(command_name(command), "more than %u files", MORPH_KEY_MAX);
        } else {
            words->files[words->file_count++] = argv[i];
        }
    }
    if (words->file_count == 0) {
        return morph_usage(command_name(command),
                           command == IMPORT_REFIT
                               ? "write: OUT.kfish, the species to bend, and a mesh for each key"
                               : "write: OUT.kfish and what to make it of");
    }
    char id[1][SPECIES_NAME_SIZE];
    if (words->id && !morph_import_words_take_name(words->id, 0, id)) {
        return morph_usage(command_name(command), "--id: '%.60s' is no name of a-z, 0-9 and _",
                           words->id);
    }
    return EXIT_OK;
}

void morph_import_words_name(const char *path, char out[SPECIES_NAME_SIZE])
{
    CORE_ASSERT(path);
    const char *slash = strrchr(path, '/');
    const char *base = slash ? slash + 1 : path;
    uint32_t length = 0;
    memset(out, 0, SPECIES_NAME_SIZE);
    for (; *base && *base != '.' && length + 1 < SPECIES_NAME_SIZE; base++) {
        const bool upper = *base >= 'A' && *base <= 'Z';
        const char c = upper ? (char)(*base - 'A' + 'a') : *base;
        const bool fits = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
        out[length++] = fits ? c : '_';
    }
}

enum exit_code morph_import_words_open_like(struct morph_import_words *words,
                                            enum import_command command)
{
    static struct morph_options like;
    static char id[SPECIES_NAME_SIZE];
    morph_import_words_name(words->out, id);
    words->plan.id = words->id ? words->id : id;
    if (!words->like) {
        return EXIT_OK;
    }
    like.word = words->like;
    const enum exit_code code = morph_options_open(&like, command_name(command));
    words->plan.like = code == EXIT_OK ? like.drawn : NULL;
    return code;
}
