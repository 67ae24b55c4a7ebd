/* morph.c -- `kingyoctl morph`, which shows and converts fish of any age for authors of species and
 * for researchers. */
#include "platform/ctl/morph/morph.h"

#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "core/base/panic.h"
#include "platform/ctl/morph/morph_options.h"
#include "platform/os/json.h"
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

static void list_json(struct json *json, const struct species *species)
{
    CORE_ASSERT(species->card.key_count <= MORPH_KEY_MAX);
    const struct species_card *card = &species->card;
    json_open(json, NULL, '{');
    json_text(json, "id", card->id);
    json_text(json, "form", species_form_names[card->form]);
    json_text(json, "motion", species_motion_names[card->motion]);
    json_text(json, "measure", species_measure_names[card->measure]);
    json_value(json, "vertices", "[%u, %u]", species->lod[0].vertex_count,
               species->lod[1].vertex_count);
    json_value(json, "anchors", "%u", species->lod[0].anchor_count);
    json_open(json, "keys", '[');
    for (uint32_t i = 0; i < card->key_count; i++) {
        json_open(json, NULL, '{');
        json_text(json, "name", card->key_names[i]);
        json_value(json, "age_days", "%.2f", (double)card->key_age_days[i]);
        json_value(json, "length_mm", "%.3f", 1e3 * (double)card->key_length_m[i]);
        json_close(json, '}');
    }
    json_close(json, ']');
    json_open(json, "curves", '[');
    for (uint32_t i = 0; i < card->curve_count; i++) {
        json_text(json, NULL, card->curve_names[i]);
    }
    json_close(json, ']');
    json_open(json, "thesis", '{');
    json_text(json, "template", morph_template_name((enum graph_template)card->thesis_template));
    json_open(json, "keys", '[');
    for (uint32_t i = 0; i < 3; i++) {
        json_text(json, NULL, card->key_names[card->thesis_key[i]]);
    }
    json_close(json, ']');
    json_close(json, '}');
    json_close(json, '}');
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

static const struct option list_options[] = {
    { "json", NULL,
      "print JSON, also with ages, measure (which length is meant), swimming, curves, and the keys "
      "and the template of chapter 4 of the 2005 thesis",
      OPTION_FLAG, .offset = 0 },
};

static const struct option_table list_table = { list_options, 1, NULL };

static enum exit_code morph_list_run(int argc, const char *const *argv)
{
    struct json json = { .file = stdout };
    uint8_t as_json = 0;
    const enum exit_code code = ctl_options("morph list", &list_table, 0, &as_json, argc, argv);
    if (code != EXIT_OK) {
        return code;
    }
    if (as_json) {
        json_open(&json, NULL, '[');
    }
    for (uint32_t i = 0; i < species_table_count; i++) {
        if (!as_json) {
            list_text(species_table[i]);
            continue;
        }
        if (i > 0) {
            json_line(&json, 1);
        }
        list_json(&json, species_table[i]);
    }
    if (as_json) {
        json_close(&json, ']');
        json_end(&json);
    }
    return EXIT_OK;
}

const struct morph_command ctl_morph_list = {
    .name = "list",
    .words = "[--json]",
    .summary = "the built-in species: body form, key shapes and how long a fish of each is",
    .options = &list_table,
    .usage = "",
    .run = morph_list_run,
};
