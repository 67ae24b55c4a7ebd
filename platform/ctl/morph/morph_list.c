/* morph_list.c -- `kingyoctl morph list`, which lists the built-in species. */
#include <stdio.h>
#include <string.h>

#include "platform/ctl/morph/morph_options.h"

static const char name[] = "list";

static const char *const measure_names[] = { "total", "standard", "fork", "disc" };
static const char *const motion_names[] = { "tail", "eel", "fins", "tuna", "wing" };
static const char *const form_names[] = { "fusiform", "compressed", "depressed", "eel", "puffer" };

static void list_json(const struct species *species)
{
    const struct species_card *card = &species->card;
    printf("{\"id\": \"%s\", \"form\": \"%s\", \"motion\": \"%s\", \"measure\": \"%s\", "
           "\"vertices\": [%u, %u], \"anchors\": %u, \"keys\": [",
           card->id, form_names[card->form], motion_names[card->motion],
           measure_names[card->measure], species->lod[0].vertex_count, species->lod[1].vertex_count,
           species->lod[0].anchor_count);
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
    printf("%-10s %-10s  ", card->id, form_names[card->form]);
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
            return morph_usage(name, "'%.100s' is not --json", argv[i]);
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
    .name = name,
    .words = "[--json]",
    .summary = "the built-in species: body form, key shapes and how long a fish of each is",
    .usage = "With --json also ages, measure (which length is meant), swimming, curves, and\n"
             "chapter 4's keys and template of the 2005 thesis.\n",
    .run = morph_list_run,
};
