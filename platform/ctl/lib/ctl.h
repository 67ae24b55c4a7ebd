/* ctl.h -- declarations that all commands of `kingyoctl` share: the description of a command, the
 * parser of its options, its error messages, and the opening of files that the user names.
 *
 * `kingyoctl` is the command-line tool of Kingyo. Each command is implemented in its own source
 * file. */
#pragma once

#include <signal.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

#include "platform/config/options.h"

/* Description of one command of `kingyoctl`, for example `kingyoctl hid`. */
struct ctl_command {
    const char *name;
    const char *summary;
    /* Forms of the command line, which `kingyoctl NAME --help` prints after the summary. Null if
     * the command has options only. */
    const char *usage;
    const struct option_table *options; /* Options that --help lists after `usage`. May be null. */
    const char *notes;                  /* Help text after the list of options. May be null. */
    void (*print_more_help)(void);      /* Prints further help at the end. May be null. */
    /* True if the command itself handles --help for its subcommands. False if main() handles
     * --help. */
    bool helps_itself;
    /* Runs the command. argv[0] is the first argument after the command's name. Returns the exit
     * code of the program. main() has already handled --help unless `helps_itself` is true. */
    enum exit_code (*run)(int argc, const char *const *argv);
};

extern const struct ctl_command ctl_play, ctl_replay, ctl_tank, ctl_hid, ctl_paper, ctl_morph,
    ctl_lines, ctl_doctor, ctl_config, ctl_status, ctl_scores, ctl_audits, ctl_backup;

/* Prints one line, "kingyoctl COMMAND: ...", on standard error. Returns EXIT_USAGE. */
__attribute__((format(printf, 2, 3))) enum exit_code ctl_usage(const char *command,
                                                               const char *format, ...);

/* Parses the words of the command line with option_table_parse(). Returns EXIT_OK. If the words are
 * wrong, prints one line, "kingyoctl COMMAND: ...", to standard error and returns EXIT_USAGE. */
enum exit_code ctl_options(const char *command, const struct option_table *table, uint32_t groups,
                           void *target, int argc, const char *const *argv);

/* Returns true if the argument `word` requests help: --help or -h. */
bool ctl_is_help(const char *word);

/* Installs handlers of SIGINT, SIGTERM and SIGHUP that set `*flag` to 1, so that the command ends
 * by its normal exit path. */
void ctl_stop_at_signals(volatile sig_atomic_t *flag);

/* Returns the monotonic time in ns. */
uint64_t ctl_now_ns(void);

/* Prints an error line for CORE_ERR_FLOAT, which the core returns if the floating-point settings
 * are unsuitable. Returns EXIT_NOT_SO. */
enum exit_code ctl_float(const char *command);

/* Opens the regular file `path` for reading. The caller closes the file. Returns EXIT_OK.
 *
 * After an error, sets `*out` to null and prints one line, "PREFIX: PATH: reason", to standard
 * error. Returns EXIT_BAD_DATA if the file has more than `size_max` bytes. Returns EXIT_IO if the
 * file is missing or is not a regular file. */
enum exit_code ctl_file_open(const char *prefix, const char *path, uint32_t size_max, FILE **out);

/* Reads the whole file `path` into `bytes`, and sets `*size` to its size. Opens the file and
 * reports errors as ctl_file_open() does. */
enum exit_code ctl_file_read(const char *prefix, const char *path, void *bytes, uint32_t size_max,
                             size_t *size);

/* Appends `word` to the comma-separated `list` in a buffer of `size` bytes. */
void ctl_list_word(char *list, size_t size, const char *word);

/* Prints the error line for a read that failed with the errno `error`. Returns the exit code that
 * ctl_file_open() returns for this error. */
enum exit_code ctl_file_error(const char *prefix, const char *path, uint32_t size_max, int error);
