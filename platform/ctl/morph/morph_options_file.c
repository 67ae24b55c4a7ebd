/* morph_options_file.c -- opens a built-in species by its name, or a species file by its path. */
#include <stdio.h>
#include <string.h>

#include "platform/ctl/morph/morph_options.h"
#include "platform/os/print.h"
#include "platform/species/text_file.h"

/* Maximum size of a species text in bytes, about fifty times the longest built-in species text. */
#define TEXT_SIZE_MAX (1u << 20)

static const struct species *built_in(const char *word)
{
    for (uint32_t i = 0; i < species_table_count; i++) {
        if (strcmp(word, species_table[i]->card.id) == 0) {
            return species_table[i];
        }
    }
    return NULL;
}

static bool ends_with(const char *word, const char *suffix)
{
    const size_t length = strlen(word), tail = strlen(suffix);
    return length >= tail && strcmp(word + length - tail, suffix) == 0;
}

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
    if (!ends_with(path, PACK_SUFFIX)) {
        return read_text(path, command, slot);
    }
    const enum pack_result result = pack_read(path, slot, why);
    if (result != PACK_OK) {
        print_error("%s: %s", path, why);
    }
    return result == PACK_OK ? EXIT_OK : result == PACK_BAD ? EXIT_BAD_DATA : EXIT_IO;
}

static enum exit_code morph_options_read_file(struct morph_options *pick, const char *command)
{
    static struct species_slot slot;
    const enum exit_code code = morph_options_file(pick->word, command, &slot);
    pick->drawn = &slot.species;
    return code;
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
    pick->drawn = built_in(pick->word);
    if (pick->drawn) {
        return EXIT_OK;
    }
    if (!strpbrk(pick->word, "/.")) {
        return morph_options_unknown(command, pick->word);
    }
    return morph_options_read_file(pick, command);
}
