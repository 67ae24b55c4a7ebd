/* ctl.h -- declarations that all commands of `kingyoctl` share.
 *
 * `kingyoctl` is the command-line tool of Kingyo. Each command is implemented in its own source
 * file. */
#ifndef KINGYO_PLATFORM_CTL_LIB_CTL_H
#define KINGYO_PLATFORM_CTL_LIB_CTL_H

#include <stdint.h>

#include "platform/config/options.h"

/* Description of one command of `kingyoctl`, for example `kingyoctl hid`. */
struct ctl_command {
    const char *name;
    const char *summary;
    const char *usage;       /* Help text that `kingyoctl NAME --help` prints after the summary. */
    void (*tell_more)(void); /* Prints further help after the usage text. May be null. */
    uint8_t helps_itself;    /* 1 if the command itself handles --help for its subcommands. 0 if
                                main() handles --help. */
    /* Runs the command. argv[0] is the first argument after the command's name. Returns the exit
     * code of the program. main() has already handled --help unless `helps_itself` is 1. */
    enum exit_code (*run)(int argc, const char *const *argv);
};

extern const struct ctl_command ctl_play, ctl_replay, ctl_tank, ctl_hid, ctl_paper, ctl_morph,
    ctl_lines, ctl_doctor, ctl_config, ctl_status, ctl_scores, ctl_audits, ctl_backup;

/* Prints one line, "kingyoctl COMMAND: ...", on standard error. Returns EXIT_USAGE. */
__attribute__((format(printf, 2, 3))) enum exit_code ctl_usage(const char *command,
                                                               const char *format, ...);

/* Prints an error line for CORE_ERR_FLOAT, which the core returns if the floating-point settings
 * are unsuitable. Returns EXIT_NOT_SO. */
enum exit_code ctl_float(const char *command);

#endif
