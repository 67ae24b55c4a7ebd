/* morph_options.c -- parses the options that select a fish, opens the species, and applies the
 * options to the species. */
#include "platform/ctl/morph/morph_options.h"

#include <stdio.h>
#include <string.h>

#include "core/base/panic.h"
#include "platform/os/number.h"
#include "platform/os/print.h"
#include "platform/species/text.h"

#define LENGTH_SAMPLES 1000u
/* Relative tolerance for a value outside the range, because the user may enter a value that was
 * rounded for printing. */
#define ROUNDED 1e-3

static const char *const template_names[TEMPLATE_COUNT] = { "own", "ordinary", "pairwise",
                                                            "simultaneous", "smooth" };

/* Options as the user wrote them, before the species is opened. */
struct words {
    const char *template_id;
    const char *place[3]; /* Value of each option in `place_options`, or null if the option is
                             absent. */
};

enum place { PLACE_PROGRESS, PLACE_AGE_DAYS, PLACE_LENGTH_MM };

static const struct {
    const char *name;
    double min, max;
} place_options[3] = {
    { "--progress", 0.0, 1.0 },
    { "--age-days", 0.0, 14610.0 }, /* The maximum is 40 years, as in core/morph/growth.c. */
    { "--length-mm", 1e-3, 10000.0 },
};

const char *morph_template_name(enum graph_template template_id)
{
    CORE_ASSERT(template_id < TEMPLATE_COUNT);
    return template_names[template_id];
}

/* ---- Parsing the options --------------------------------------------------------------------- */

/* Parses an option that all subcommands share, with its value. Sets `*used` to the number of words
 * that were parsed, or to 0 if the option is not a shared option. */
static enum exit_code take_shared(struct morph_options *pick, struct words *words,
                                  const char *command, enum morph_requirement asks,
                                  const char *option, const char *value, int *used)
{
    *used = 2;
    if ((asks & MORPH_REQUIRES_CURVES) && strcmp(option, "--template") == 0) {
        for (enum graph_template i = TEMPLATE_OWN; value && i < TEMPLATE_COUNT; i++) {
            if (strcmp(value, template_names[i]) == 0) {
                pick->template_id = i;
                return EXIT_OK;
            }
        }
        return morph_usage(command,
                           "--template: '%.40s' is not own, ordinary, pairwise, simultaneous "
                           "or smooth",
                           value ? value : "");
    }
    for (size_t i = 0; (asks & MORPH_REQUIRES_PLACE) && i < 3; i++) {
        if (strcmp(option, place_options[i].name) == 0) {
            words->place[i] = value ? value : "";
            return EXIT_OK;
        }
    }
    *used = 1;
    if ((asks & MORPH_REQUIRES_CURVES) && strcmp(option, "--thesis") == 0) {
        pick->thesis = true;
        return EXIT_OK;
    }
    *used = 0;
    return EXIT_OK;
}

/* ---- Curves --------------------------------------------------------------------------------- */

const struct species *morph_options_ordinary(const struct morph_options *pick,
                                             struct morph_rig *rig)
{
    CORE_ASSERT(pick->fish && pick->fish->card.key_count >= 2);
    static struct straight_memory memory;
    static struct species made;
    straight_species(pick->fish, &memory, &made);
    morph_rig_init(rig, &made.card, TEMPLATE_ORDINARY);
    return &made;
}

/* ---- Moment of the life ---------------------------------------------------------------------- */

void morph_options_lengths(const struct species_card *card, float *min, float *max)
{
    CORE_ASSERT(card->key_count >= 2);
    *min = *max = life_length_m(card, 0.0f);
    for (uint32_t i = 1; i <= LENGTH_SAMPLES; i++) {
        const float length_m = life_length_m(card, (float)i / (float)LENGTH_SAMPLES);
        *min = f_min(*min, length_m);
        *max = f_max(*max, length_m);
    }
    for (uint32_t i = 0; i < card->scale_knot_count; i++) {
        *min = f_min(*min, card->scale_knots[i].length_m);
        *max = f_max(*max, card->scale_knots[i].length_m);
    }
}

/* Rejects a moment before the first key or after the last key, because the author of the species
 * drew no shape there. For example, the shape for one day is not shown if 22 days were
 * requested. */
static enum exit_code check_drawn(const struct species_card *card, enum place place, double asked,
                                  const char *command)
{
    CORE_ASSERT(card->key_count >= 2);
    float from = card->key_age_days[0], to = card->key_age_days[card->key_count - 1u];
    if (place == PLACE_PROGRESS) {
        return EXIT_OK;
    }
    if (place == PLACE_LENGTH_MM) {
        morph_options_lengths(card, &from, &to);
        from *= 1e3f;
        to *= 1e3f;
    }
    if (asked >= (double)from * (1.0 - ROUNDED) && asked <= (double)to * (1.0 + ROUNDED)) {
        return EXIT_OK;
    }
    return morph_usage(command,
                       "%s: %.10g is outside the drawn life: %s is drawn from %.6g to "
                       "%.6g %s",
                       place_options[place].name, asked, card->id, (double)from, (double)to,
                       place == PLACE_AGE_DAYS ? "days" : "mm");
}

/* ---- Complete command line ------------------------------------------------------------------- */

static enum exit_code take_any(struct morph_options *pick, struct words *words, const char *command,
                               enum morph_requirement asks, const struct morph_option *options,
                               size_t option_count, const char *word, const char *value, int *used)
{
    CORE_ASSERT(option_count == 0 || options);
    const enum exit_code code = take_shared(pick, words, command, asks, word, value, used);
    if (*used > 0) {
        return code;
    }
    *used = 1;
    for (size_t i = 0; i < option_count; i++) {
        if (strcmp(word, options[i].name) == 0) {
            *used = options[i].flag ? 1 : 2;
            if (options[i].flag) {
                *options[i].flag = true;
                return EXIT_OK;
            }
            if (options[i].text) {
                *options[i].text = value;
                return value && *value ? EXIT_OK
                                       : morph_usage(command, "%s needs a value", options[i].name);
            }
            if (options[i].count ? number_parse(value, (uint32_t)options[i].min,
                                                (uint32_t)options[i].max, options[i].count)
                                 : number_parse_decimal(value, options[i].min, options[i].max,
                                                        options[i].number)) {
                return EXIT_OK;
            }
            return morph_usage(command, "%s: '%.40s' is not a %snumber from %.10g to %.10g",
                               options[i].name, value ? value : "",
                               options[i].count ? "whole " : "", options[i].min, options[i].max);
        }
    }
    if (word[0] == '-') {
        return morph_usage(command, "unknown option '%.100s'; --help lists them", word);
    }
    if (pick->word) {
        return morph_usage(command, "'%.100s' is one species too many", word);
    }
    pick->word = word;
    return *word ? EXIT_OK : morph_usage(command, "a species has a name");
}

enum exit_code morph_options_read(struct morph_options *pick, const char *command,
                                  enum morph_requirement asks, const struct morph_option *options,
                                  size_t option_count, int argc, const char *const *argv)
{
    CORE_ASSERT(option_count == 0 || options);
    struct words words = { 0 };
    int used = 1;
    *pick = (struct morph_options){ .template_id = TEMPLATE_OWN };
    for (int i = 0; i < argc; i += used) {
        const enum exit_code code = take_any(pick, &words, command, asks, options, option_count,
                                             argv[i], i + 1 < argc ? argv[i + 1] : NULL, &used);
        if (code != EXIT_OK) {
            return code;
        }
    }
    enum exit_code code = morph_options_open(pick, command);
    if (code != EXIT_OK) {
        return code;
    }
    /* --thesis and --template ordinary change the drawn species. */
    static struct straight_memory memory;
    static struct species made;
    pick->fish = pick->drawn;
    if (pick->thesis) {
        straight_thesis(pick->drawn, &memory, &made);
        pick->fish = &made;
    } else if (pick->template_id == TEMPLATE_ORDINARY) {
        straight_species(pick->drawn, &memory, &made);
        pick->fish = &made;
    }
    morph_rig_init(&pick->rig, &pick->fish->card, pick->template_id);
    const struct species_card *card = &pick->fish->card;
    for (size_t i = 0; i < 3; i++) {
        double value;
        if (!words.place[i]) {
            continue;
        }
        if (pick->has_place) {
            return morph_usage(command, "--progress, --age-days and --length-mm: one of them");
        }
        if (!number_parse_decimal(words.place[i], place_options[i].min, place_options[i].max,
                                  &value)) {
            return morph_usage(command, "%s: '%.40s' is not a number from %.10g to %.10g",
                               place_options[i].name, words.place[i], place_options[i].min,
                               place_options[i].max);
        }
        code = check_drawn(card, (enum place)i, value, command);
        if (code != EXIT_OK) {
            return code;
        }
        pick->has_place = true;
        pick->progress = i == PLACE_PROGRESS   ? (float)value
                         : i == PLACE_AGE_DAYS ? life_progress(card, (float)value)
                                               : morph_progress(card, (float)(1e-3 * value));
    }
    return EXIT_OK;
}

/* ---- Species files --------------------------------------------------------------------------- */

/* This section opens a built-in species by its name, or a species file by its path. */

/* Maximum size of a species text in bytes, about fifty times the longest built-in species text. */
#define TEXT_SIZE_MAX (1u << 20)

/* Reads a species text and lofts the mesh of the species into `slot`. Returns EXIT_OK, or prints
 * one line and returns another exit code. The parser itself prints an error in the text. */
static enum exit_code read_text(const char *path, const char *command, struct species_slot *slot)
{
    static struct species_text text;
    char why[VALIDATE_WHY_SIZE], cannot[TEXT_FILE_WHY_SIZE];
    FILE *file;
    const enum text_file_open opened = text_file_open(path, TEXT_SIZE_MAX, &file, cannot);
    if (opened != TEXT_FILE_OPEN) {
        return morph_fail(opened == TEXT_FILE_LARGE ? EXIT_BAD_DATA : EXIT_IO, command,
                          "%.200s: %s", path, cannot);
    }
    const bool good = species_read(file, path, stderr, &text);
    const bool broken = ferror(file) != 0;
    fclose(file);
    if (!good) {
        return broken ? EXIT_IO : EXIT_BAD_DATA;
    }
    pack_text(&text, slot);
    if (!species_validate(&slot->species, why)) {
        print_error("%s: %s", path, why);
        return EXIT_BAD_DATA;
    }
    return EXIT_OK;
}

enum exit_code morph_options_file(const char *path, const char *command, struct species_slot *slot)
{
    char why[VALIDATE_WHY_SIZE];
    const size_t length = strlen(path), tail = strlen(PACK_SUFFIX);
    if (length < tail || strcmp(path + length - tail, PACK_SUFFIX) != 0) {
        return read_text(path, command, slot);
    }
    const enum pack_result result = pack_read(path, slot, why);
    if (result != PACK_OK) {
        print_error("%s: %s", path, why);
    }
    return result == PACK_OK ? EXIT_OK : result == PACK_BAD ? EXIT_BAD_DATA : EXIT_IO;
}

enum exit_code morph_options_unknown(const char *command, const char *word)
{
    char list[SPECIES_BUILT_IN * (SPECIES_NAME_SIZE + 2u)] = "";
    for (uint32_t i = 0; i < species_table_count; i++) {
        const size_t used = strlen(list);
        snprintf(list + used, sizeof list - used, "%s%s", used ? ", " : "",
                 species_table[i]->card.id);
    }
    return morph_usage(command,
                       "'%.100s' is no species; there are %s, and files (NAME.txt or "
                       "NAME.kfish)",
                       word, list);
}

enum exit_code morph_options_open(struct morph_options *pick, const char *command)
{
    if (!pick->word) {
        return morph_usage(command, "a species is missing; 'kingyoctl morph list' tells them");
    }
    for (uint32_t i = 0; i < species_table_count; i++) {
        if (strcmp(pick->word, species_table[i]->card.id) == 0) {
            pick->drawn = species_table[i];
            return EXIT_OK;
        }
    }
    if (!strpbrk(pick->word, "/.")) {
        return morph_options_unknown(command, pick->word);
    }
    static struct species_slot slot;
    const enum exit_code code = morph_options_file(pick->word, command, &slot);
    pick->drawn = &slot.species;
    return code;
}

/* ---- Curves ---------------------------------------------------------------------------------- */

/* This section finds a curve of a deformation graph by its name. */

enum exit_code morph_curve_find(const struct species_card *card, const char *command,
                                const char *curve_name, uint32_t *curve)
{
    CORE_ASSERT(card->curve_count >= 1 && card->curve_count <= MORPH_CURVE_MAX);
    char list[MORPH_CURVE_MAX * (SPECIES_NAME_SIZE + 2u)] = "";
    *curve = 0;
    if (!curve_name) {
        return EXIT_OK;
    }
    for (uint32_t i = 0; i < card->curve_count; i++) {
        if (strcmp(curve_name, card->curve_names[i]) == 0) {
            *curve = i;
            return EXIT_OK;
        }
        const size_t used = strlen(list);
        snprintf(list + used, sizeof list - used, "%s%s", used ? ", " : "", card->curve_names[i]);
    }
    return morph_usage(command, "--curve: '%.40s' is none of %s", curve_name, list);
}
