/* morph.c -- `kingyoctl morph`, which shows and converts fish of any age for authors of species and
 * for researchers. */
#include "platform/ctl/morph/morph.h"

#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "platform/os/print.h"

static const char name[] = "morph";

static const struct morph_command *const table[] = {
    &ctl_morph_list,  &ctl_morph_weights, &ctl_morph_growth, &ctl_morph_path,
    &ctl_morph_graph, &ctl_morph_check,   &ctl_morph_export, &ctl_morph_import,
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
    va_list arguments;
    va_start(arguments, format);
    morph_print_error(command, format, arguments);
    va_end(arguments);
    return EXIT_USAGE;
}

enum exit_code morph_fail(enum exit_code code, const char *command, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    morph_print_error(command, format, arguments);
    va_end(arguments);
    return code;
}

static enum exit_code help(void)
{
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

static int is_help(const char *word)
{
    return strcmp(word, "--help") == 0 || strcmp(word, "-h") == 0;
}

static enum exit_code run_one(const struct morph_command *command, int argc,
                              const char *const *argv)
{
    for (int i = 0; i < argc; i++) {
        if (is_help(argv[i])) {
            printf("kingyoctl %s %s %s\n%s\n\n%s", name, command->name, command->words,
                   command->summary, command->usage);
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
        return help();
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
