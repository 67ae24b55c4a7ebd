/* morph.c -- `kingyoctl morph`, which shows and converts fish of any age for authors of species and
 * for researchers. */
#include "platform/ctl/morph/morph.h"

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

enum exit_code morph_fail(enum exit_code code, const char *command, const char *format, ...)
{
    CORE_ASSERT(code != EXIT_OK && command);
    char words[PRINT_LINE_MAX];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(words, sizeof words, format, arguments);
    va_end(arguments);
    return print_fail(code, "kingyoctl %s %s: %s", name, command, words);
}

enum exit_code morph_written(const char *command, const char *path, int error)
{
    CORE_ASSERT(error <= 0);
    return error ? morph_fail(EXIT_IO, command, "%.900s: %s", path, strerror(-error)) : EXIT_OK;
}

static enum exit_code run_one(const struct morph_command *command, int argc,
                              const char *const *argv)
{
    for (int i = 0; i < argc; i++) {
        if (ctl_is_help(argv[i])) {
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
    if (!command->plan) {
        return command->run(argc, argv);
    }
    const enum exit_code code = morph_options_read(command->plan, command->name, command->groups,
                                                   command->options, argc, argv);
    return code == EXIT_OK ? command->run_fish() : code;
}

static enum exit_code morph_run(int argc, const char *const *argv)
{
    if (argc < 1) {
        return ctl_usage(name, "a subcommand is missing; --help lists them");
    }
    if (ctl_is_help(argv[0])) {
        printf("kingyoctl %s: %s\n\n", name, ctl_morph.summary);
        for (size_t i = 0; i < TABLE_COUNT; i++) {
            printf("  %s %s\n      %s\n", table[i]->name, table[i]->words, table[i]->summary);
        }
        puts(
            "\nSPECIES is a built-in species ('kingyoctl morph list' lists them). FILE is a\n"
            "species text NAME.txt, or a species NAME.kfish that 'import' has packed.\n"
            "  --template T  own (the species' curves, the default), pairwise (figure 3.8 of the\n"
            "                2005 thesis), simultaneous (figure 3.9), smooth (no corner at any\n"
            "                key), or ordinary (only the first and the last key, equation 3.1)\n"
            "  --thesis      the method of the 2005 thesis: the three keys of chapter 4, straight\n"
            "                paths, an exaggerated middle key if the key never has the weight 1,\n"
            "                and the lengths of the shifted growth curve (section 3.2)\n\n"
            "'kingyoctl morph SUBCOMMAND --help' prints the options of a subcommand.");
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
    .summary = "shows and converts fish of any age: graphs, growth, export, check, import",
    .helps_itself = 1,
    .run = morph_run,
};

/* ---- `kingyoctl morph list`: the built-in species -------------------------------------------- */

static void list_json(struct json *json, const struct species *species)
{
    CORE_ASSERT(species->card.key_count <= MORPH_KEY_MAX);
    const struct species_card *card = &species->card;
    json_print(json,
               "{id: %s, form: %s, motion: %s, measure: %s, vertices: [%u, %u], anchors: %u,"
               " keys: [",
               card->id, species_form_names[card->form], species_motion_names[card->motion],
               species_measure_names[card->measure], species->lod[0].vertex_count,
               species->lod[1].vertex_count, species->lod[0].anchor_count);
    for (uint32_t i = 0; i < card->key_count; i++) {
        json_print(json, "{name: %s, age_days: %.2f, length_mm: %.3f}", card->key_names[i],
                   (double)card->key_age_days[i], 1e3 * (double)card->key_length_m[i]);
    }
    json_print(json, "], curves: [");
    for (uint32_t i = 0; i < card->curve_count; i++) {
        json_text(json, NULL, card->curve_names[i]);
    }
    const uint8_t *keys = card->thesis_key;
    json_print(json, "], thesis: {template: %s, keys: [%s, %s, %s]}}",
               morph_template_name((enum graph_template)card->thesis_template),
               card->key_names[keys[0]], card->key_names[keys[1]], card->key_names[keys[2]]);
}

static const struct option list_options[] = {
    { "json", NULL,
      "print JSON, which also contains the ages, the kind of length, the kind of swimming, the "
      "curves, and the keys and the template of chapter 4 of the 2005 thesis",
      OPTION_FLAG, .offset = 0 },
};

static const struct option_table list_table = OPTION_TABLE(list_options, NULL);

static enum exit_code list(int argc, const char *const *argv)
{
    struct json json = { .file = stdout };
    bool as_json = false;
    const enum exit_code code = ctl_options("morph list", &list_table, 0, &as_json, argc, argv);
    if (code != EXIT_OK) {
        return code;
    }
    for (uint32_t i = 0; !as_json && i < species_table_count; i++) {
        const struct species_card *card = &species_table[i]->card;
        printf("%-10s %-10s  ", card->id, species_form_names[card->form]);
        for (uint32_t key = 0; key < card->key_count; key++) {
            /* Lengths of a few millimetres are printed with one decimal, and lengths of large fish
             * without decimals. */
            const double mm = 1e3 * (double)card->key_length_m[key];
            printf("%s%s %.*f mm", key > 0 ? ", " : "", card->key_names[key], mm < 100.0 ? 1 : 0,
                   mm);
        }
        putchar('\n');
    }
    if (as_json) {
        json_open(&json, NULL, '[');
        for (uint32_t i = 0; i < species_table_count; i++) {
            if (i > 0) {
                json_line(&json, 1);
            }
            list_json(&json, species_table[i]);
        }
        json_close(&json, ']');
        json_end(&json);
    }
    return EXIT_OK;
}

const struct morph_command ctl_morph_list = {
    .name = "list",
    .words = "[--json]",
    .summary = "lists the built-in species with their body form, key shapes and lengths",
    .options = &list_table,
    .usage = "",
    .run = list,
};
