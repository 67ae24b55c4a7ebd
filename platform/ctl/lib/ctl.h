/* ctl.h -- declarations that the commands of `kingyoctl` share.
 *
 * Each command has a source file of its own. */
#ifndef KINGYO_PLATFORM_CTL_LIB_CTL_H
#define KINGYO_PLATFORM_CTL_LIB_CTL_H

#include <stdint.h>

#include "platform/config/options.h"

/* Description of a command of kingyoctl. */
struct ctl_command {
    const char *name;
    const char *summary;
    const char *usage;       /* Text that `kingyoctl NAME --help` prints after the summary. */
    void (*tell_more)(void); /* Prints more help after the usage text. May be null. */
    uint8_t helps_itself;    /* 1 if the command handles --help for its subcommands, and 0 if main()
                                handles --help. */
    /* Runs the command. argv[0] is the first word after the command's name. Returns the exit code
     * of the program. main() has already handled --help. */
    enum exit_code (*run)(int argc, const char *const *argv);
};

extern const struct ctl_command ctl_play, ctl_replay, ctl_tank, ctl_hid, ctl_paper, ctl_morph,
    ctl_lines, ctl_doctor, ctl_config, ctl_status, ctl_scores, ctl_audits, ctl_backup;

/* Prints one line, "kingyoctl COMMAND: ...", on standard error. Returns EXIT_USAGE. */
__attribute__((format(printf, 2, 3))) enum exit_code ctl_usage(const char *command,
                                                               const char *format, ...);

/* Prints one line on standard error because the core returned CORE_ERR_FLOAT. Returns
 * EXIT_NOT_SO. */
enum exit_code ctl_float(const char *command);

#endif
