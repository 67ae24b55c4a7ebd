/* morph.c -- `kingyoctl morph`, which shows and converts fish of any age for authors of species and
 * for researchers. */
#include "platform/ctl/morph/morph.h"

#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "core/base/panic.h"
#include "platform/ctl/morph/morph_options.h"
#include "platform/os/print.h"
#include "platform/species/part.h"

static const char name[] = "morph";

static const struct morph_command *const table[] = {
    &ctl_morph_list,  &ctl_morph_weights, &ctl_morph_growth, &ctl_morph_path,  &ctl_morph_graph,
    &ctl_morph_check, &ctl_morph_export,  &ctl_morph_import, &ctl_morph_refit,
};

#define TABLE_COUNT (sizeof table / sizeof table[0])

static void morph_print_error(const char *command, const char *format, va_list arguments)
{
    char words[PRINT_LINE_MAX];
    vsnprintf(words, sizeof words, format, arguments);
    print_error("kingyoctl %s %s: %s", name, command, words);
}

enum exit_code morph_usage(const char *command, const char *format, ...)
{
    CORE_ASSERT(command);
    va_list arguments;
    va_start(arguments, format);
    morph_print_error(command, format, arguments);
    va_end(arguments);
    return EXIT_USAGE;
}

enum exit_code morph_fail(enum exit_code code, const char *command, const char *format, ...)
{
    CORE_ASSERT(code != EXIT_OK);
    va_list arguments;
    va_start(arguments, format);
    morph_print_error(command, format, arguments);
    va_end(arguments);
    return code;
}

static int is_help(const char *word)
{
    return strcmp(word, "--help") == 0 || strcmp(word, "-h") == 0;
}

static enum exit_code run_one(const struct morph_command *command, int argc,
                              const char *const *argv)
{
    for (int i = 0; i < argc; i++) {
        if (is_help(argv[i])) {
            printf("kingyoctl %s %s %s\n%s\n\n", name, command->name, command->words,
                   command->summary);
            if (command->options) {
                option_table_print(command->options, command->groups);
                putchar('\n');
            }
            fputs(command->usage, stdout);
            return EXIT_OK;
        }
    }
    return command->run(argc, argv);
}

static enum exit_code morph_run(int argc, const char *const *argv)
{
    if (argc < 1) {
        return ctl_usage(name, "a subcommand is missing; --help lists them");
    }
    if (is_help(argv[0])) {
        printf("kingyoctl %s: %s\n\n", name, ctl_morph.summary);
        for (size_t i = 0; i < TABLE_COUNT; i++) {
            printf("  %s %s\n      %s\n", table[i]->name, table[i]->words, table[i]->summary);
        }
        puts("\nSPECIES is a built-in one (`kingyoctl morph list`), FILE a maker's: NAME.txt\n"
             "as written, NAME.kfish as packed by 'import'.\n"
             "  --template T  own (the species' curves, the default), pairwise (figure 3.8 of the\n"
             "                2005 thesis), simultaneous (figure 3.9), smooth (no corner at any\n"
             "                key), or ordinary (the first and the last key alone: equation 3.1)\n"
             "  --thesis      the thesis' own method: chapter 4's three keys, straight paths, the\n"
             "                middle key exaggerated where it is never whole; at the same ages as\n"
             "                long as the shifted growth curve makes them (section 3.2)\n\n"
             "'kingyoctl morph SUBCOMMAND --help' says more.");
        return EXIT_OK;
    }
    for (size_t i = 0; i < TABLE_COUNT; i++) {
        if (strcmp(argv[0], table[i]->name) == 0) {
            return run_one(table[i], argc - 1, argv + 1);
        }
    }
    return ctl_usage(name, "unknown subcommand '%.100s'; --help lists them", argv[0]);
}

const struct ctl_command ctl_morph = {
    .name = name,
    .summary = "fish of any age from a few drawings: graphs, growth, export, check, import",
    .helps_itself = 1,
    .run = morph_run,
};

/* ---- List of the built-in species ------------------------------------------------------------ */

/* `kingyoctl morph list`, which lists the built-in species. */

static void list_json(const struct species *species)
{
    CORE_ASSERT(species->card.key_count <= MORPH_KEY_MAX);
    const struct species_card *card = &species->card;
    printf("{\"id\": \"%s\", \"form\": \"%s\", \"motion\": \"%s\", \"measure\": \"%s\", "
           "\"vertices\": [%u, %u], \"anchors\": %u, \"keys\": [",
           card->id, species_form_names[card->form], species_motion_names[card->motion],
           species_measure_names[card->measure], species->lod[0].vertex_count,
           species->lod[1].vertex_count, species->lod[0].anchor_count);
    for (uint32_t i = 0; i < card->key_count; i++) {
        printf("%s{\"name\": \"%s\", \"age_days\": %.2f, \"length_mm\": %.3f}", i > 0 ? ", " : "",
               card->key_names[i], (double)card->key_age_days[i],
               1e3 * (double)card->key_length_m[i]);
    }
    fputs("], \"curves\": [", stdout);
    for (uint32_t i = 0; i < card->curve_count; i++) {
        printf("%s\"%s\"", i > 0 ? ", " : "", card->curve_names[i]);
    }
    printf("], \"thesis\": {\"template\": \"%s\", \"keys\": [\"%s\", \"%s\", \"%s\"]}}",
           morph_template_name((enum graph_template)card->thesis_template),
           card->key_names[card->thesis_key[0]], card->key_names[card->thesis_key[1]],
           card->key_names[card->thesis_key[2]]);
}

/* Prints one species. Lengths of a few millimetres are printed with one decimal, and lengths of
 * large fish without decimals. */
static void list_text(const struct species *species)
{
    const struct species_card *card = &species->card;
    printf("%-10s %-10s  ", card->id, species_form_names[card->form]);
    for (uint32_t i = 0; i < card->key_count; i++) {
        const double mm = 1e3 * (double)card->key_length_m[i];
        printf("%s%s %.*f mm", i > 0 ? ", " : "", card->key_names[i], mm < 100.0 ? 1 : 0, mm);
    }
    putchar('\n');
}

static enum exit_code morph_list_run(int argc, const char *const *argv)
{
    bool as_json = false;
    for (int i = 0; i < argc; i++) {
        if (strcmp(argv[i], "--json") != 0) {
            return morph_usage("list", "'%.100s' is not --json", argv[i]);
        }
        as_json = true;
    }
    fputs(as_json ? "[" : "", stdout);
    for (uint32_t i = 0; i < species_table_count; i++) {
        if (as_json) {
            fputs(i > 0 ? ",\n " : "", stdout);
        }
        (as_json ? list_json : list_text)(species_table[i]);
    }
    fputs(as_json ? "]\n" : "", stdout);
    return EXIT_OK;
}

const struct morph_command ctl_morph_list = {
    .name = "list",
    .words = "[--json]",
    .summary = "the built-in species: body form, key shapes and how long a fish of each is",
    .usage = "With --json also ages, measure (which length is meant), swimming, curves, and\n"
             "chapter 4's keys and template of the 2005 thesis.\n",
    .run = morph_list_run,
};
