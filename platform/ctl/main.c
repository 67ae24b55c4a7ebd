/* main.c -- the program `kingyoctl`, a command-line tool for operators, authors of fish species and
 * researchers. */
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include "core/base/float_env.h"
#include "core/core.h"
#include "platform/cpu.h"
#include "platform/ctl/lib/ctl.h"
#include "platform/os/print.h"

static const struct ctl_command *const commands[] = {
    &ctl_tank,   &ctl_paper,  &ctl_play,   &ctl_morph,  &ctl_replay, &ctl_hid,   &ctl_lines,
    &ctl_doctor, &ctl_config, &ctl_status, &ctl_scores, &ctl_audits, &ctl_backup
};

static void print_help(void)
{
    puts("kingyoctl COMMAND: inspects the goldfish-scooping kiosk without starting it.\n");
    for (size_t i = 0; i < sizeof commands / sizeof commands[0]; i++) {
        printf("  %-8s %s\n", commands[i]->name, commands[i]->summary);
    }
    puts(
        "\n'kingyoctl COMMAND --help' explains a command. Exit code: 0 success; 1 a check failed;\n"
        "2 wrong usage; 65 invalid data; 74 a path that cannot be read or written, or standard\n"
        "output that is full or closed.");
}

static void print_command_help(const struct ctl_command *command)
{
    printf("kingyoctl %s: %s\n\n%s", command->name, command->summary,
           command->usage ? command->usage : "");
    if (command->options) {
        fputs(command->usage ? "\n" : "", stdout);
        option_table_print(command->options, UINT32_MAX);
    }
    if (command->notes) {
        printf("\n%s", command->notes);
    }
    if (command->print_more_help) {
        command->print_more_help();
    }
}

static enum exit_code run_command(const struct ctl_command *command, int argc,
                                  const char *const *argv)
{
    for (int i = 0; i < argc && !command->helps_itself; i++) {
        if (ctl_is_help(argv[i])) {
            print_command_help(command);
            return EXIT_OK;
        }
    }
    cpu_set_float();
    return float_env_is_standard() ? command->run(argc, argv) : ctl_float(command->name);
}

static enum exit_code run_words(int argc, char **argv)
{
    if (argc < 2) {
        return print_fail(EXIT_USAGE, "kingyoctl: a command is missing; --help lists them");
    }
    if (ctl_is_help(argv[1])) {
        print_help();
        return EXIT_OK;
    }
    if (strcmp(argv[1], "--version") == 0) {
        printf("kingyoctl %s\n", KINGYO_VERSION);
        return EXIT_OK;
    }
    for (size_t i = 0; i < sizeof commands / sizeof commands[0]; i++) {
        if (strcmp(commands[i]->name, argv[1]) == 0) {
            return run_command(commands[i], argc - 2, (const char *const *)argv + 2);
        }
    }
    return print_fail(EXIT_USAGE, "kingyoctl: unknown command '%.100s'; --help lists them",
                      argv[1]);
}

/* Runs the command that the first argument names. A command prints without checking for write
 * errors. main() detects lost output for all commands after the command has run. A command that
 * failed has already printed one error line. */
int main(int argc, char **argv)
{
    const int closed = print_open_streams();
    if (closed) {
        return print_fail(EXIT_IO, "kingyoctl: /dev/null: %s", strerror(-closed));
    }
    const enum exit_code code = run_words(argc, argv);
    const int lost = print_finish();
    if (lost && (code == EXIT_OK || code == EXIT_NOT_SO)) {
        return print_fail(EXIT_IO, "kingyoctl%s%s: standard output: %s",
                          argv[1][0] == '-' ? "" : " ", argv[1][0] == '-' ? "" : argv[1],
                          strerror(-lost));
    }
    return (int)code;
}
