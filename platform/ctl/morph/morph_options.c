/* morph_options.c -- parses the options that select a fish, opens the species, and applies the
 * options to the species. */
#include "platform/ctl/morph/morph_options.h"

#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>

#include "core/base/panic.h"
#include "platform/os/file.h"
#include "platform/os/print.h"

#define LENGTH_SAMPLES 1000u
/* Relative tolerance for a value outside the range, because the user may enter a value that was
 * rounded for printing. */
#define ROUNDED 1e-3

static const char *const template_names[TEMPLATE_COUNT + 1] = {
    "own", "ordinary", "pairwise", "simultaneous", "smooth", NULL,
};

enum place { PLACE_PROGRESS, PLACE_AGE_DAYS, PLACE_LENGTH_MM };

static const char *const place_names[3] = { "--progress", "--age-days", "--length-mm" };

#define AT(member) .offset = offsetof(struct morph_options, member)

static const struct option options[] = {
    { NULL, "SPECIES|FILE", "built-in species, or species file NAME.txt or NAME.kfish",
      OPTION_ARGUMENT, AT(word) },
    { "template", "T", "template of the deformation graph", OPTION_CHOICE, AT(template_id),
      .choices = template_names, .groups = MORPH_REQUIRES_CURVES },
    { "thesis", NULL, "use the method of the thesis", OPTION_FLAG, AT(thesis),
      .groups = MORPH_REQUIRES_CURVES },
    { "progress", "P", "progress of the life", OPTION_DECIMAL, AT(place[PLACE_PROGRESS]), 0, 1,
      .groups = MORPH_REQUIRES_PLACE },
    /* The largest age is 40 years (14,610 days), as in core/morph/growth.c. */
    { "age-days", "D", "age in days", OPTION_DECIMAL, AT(place[PLACE_AGE_DAYS]), 0, 14610,
      .groups = MORPH_REQUIRES_PLACE },
    { "length-mm", "L", "length in mm", OPTION_DECIMAL, AT(place[PLACE_LENGTH_MM]), 1e-3, 10000,
      .groups = MORPH_REQUIRES_PLACE },
};

const struct option_table morph_options_table = OPTION_TABLE(options, NULL);

const char *morph_template_name(enum graph_template template_id)
{
    CORE_ASSERT(template_id < TEMPLATE_COUNT);
    return template_names[template_id];
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
 * drew no shape there. For example, if the first key is at an age of 22 days, the age of one day is
 * rejected. */
static enum exit_code check_drawn(const struct species_card *card, enum place place, double given,
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
    if (given >= (double)from * (1.0 - ROUNDED) && given <= (double)to * (1.0 + ROUNDED)) {
        return EXIT_OK;
    }
    return morph_usage(command,
                       "%s: %.10g is outside the drawn life: %s is drawn from %.6g to "
                       "%.6g %s",
                       place_names[place], given, card->id, (double)from, (double)to,
                       place == PLACE_AGE_DAYS ? "days" : "mm");
}

/* ---- Complete command line ------------------------------------------------------------------- */

enum exit_code morph_options_read(struct morph_options *pick, const char *command, uint32_t groups,
                                  const struct option_table *table, int argc,
                                  const char *const *argv)
{
    char error[OPTIONS_ERROR_MAX];
    *pick = (struct morph_options){ .place = { NAN, NAN, NAN } };
    if (option_table_parse(table, groups, pick, argc, argv, error)) {
        return morph_usage(command, "%s", error);
    }
    enum exit_code code = morph_options_open(pick, command);
    if (code != EXIT_OK) {
        return code;
    }
    /* The options --thesis and --template ordinary replace the drawn species by a reduced one. */
    static struct straight_memory memory;
    static struct species made;
    const bool ordinary = pick->template_id == TEMPLATE_ORDINARY;
    pick->fish = pick->thesis || ordinary ? &made : pick->drawn;
    if (pick->thesis) {
        straight_thesis(pick->drawn, &memory, &made);
    } else if (ordinary) {
        straight_species(pick->drawn, &memory, &made);
    }
    morph_rig_init(&pick->rig, &pick->fish->card, pick->template_id);
    const struct species_card *card = &pick->fish->card;
    for (size_t i = 0; i < 3; i++) {
        const double value = pick->place[i];
        if (isnan(value)) {
            continue;
        }
        if (pick->has_place) {
            return morph_usage(command, "write only one of --progress, --age-days and --length-mm");
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
    char why[VALIDATE_WHY_SIZE], prefix[64];
    FILE *file;
    snprintf(prefix, sizeof prefix, "kingyoctl morph %s", command);
    const enum exit_code opened = ctl_file_open(prefix, path, TEXT_SIZE_MAX, &file);
    if (opened != EXIT_OK) {
        return opened;
    }
    const bool good = species_read(file, path, stderr, &text);
    const bool broken = ferror(file) != 0;
    fclose(file);
    if (!good) {
        return broken ? EXIT_IO : EXIT_BAD_DATA;
    }
    pack_text(&text, slot);
    if (!species_validate(&slot->species, why)) {
        return print_fail(EXIT_BAD_DATA, "%s: %s", path, why);
    }
    return EXIT_OK;
}

enum exit_code morph_options_file(const char *path, const char *command, struct species_slot *slot)
{
    char why[VALIDATE_WHY_SIZE];
    if (!file_has_suffix(path, PACK_SUFFIX)) {
        return read_text(path, command, slot);
    }
    const enum pack_result result = pack_read(path, slot, why);
    if (result != PACK_OK) {
        print_error("%s: %s", path, why);
    }
    return result == PACK_OK ? EXIT_OK : result == PACK_BAD ? EXIT_BAD_DATA : EXIT_IO;
}

enum exit_code morph_options_open(struct morph_options *pick, const char *command)
{
    if (!pick->word) {
        return morph_usage(command,
                           "a species is missing; 'kingyoctl morph list' lists the species");
    }
    char list[SPECIES_BUILT_IN * (SPECIES_NAME_SIZE + 2u)] = "";
    for (uint32_t i = 0; i < species_table_count; i++) {
        if (strcmp(pick->word, species_table[i]->card.id) == 0) {
            pick->drawn = species_table[i];
            return EXIT_OK;
        }
        ctl_list_word(list, sizeof list, species_table[i]->card.id);
    }
    if (!strpbrk(pick->word, "/.")) {
        return morph_usage(command,
                           "'%.100s' is not a species; write %s, or a file (NAME.txt or "
                           "NAME.kfish)",
                           pick->word, list);
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
        ctl_list_word(list, sizeof list, card->curve_names[i]);
    }
    return morph_usage(command, "--curve: '%.40s' is not a curve; the curves are %s", curve_name,
                       list);
}
