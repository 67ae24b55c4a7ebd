/* ctl.h -- what the commands of `kingyoctl` share. One file per command. */
#ifndef KINGYO_PLATFORM_CTL_CTL_H
#define KINGYO_PLATFORM_CTL_CTL_H

#include <stdint.h>

#include "platform/kiosk/options.h"

struct ctl_command {
    const char *name;
    const char *summary;
    const char *usage; /* What `kingyoctl NAME --help` prints, without the summary. */
    void (*tell_more)(void); /* Prints what is behind the usage; may be null. */
    uint8_t helps_itself;    /* Its subcommands have words of their own: --help is left to it. */
    /* argv[0] is the first word behind the command's name; --help was already answered. */
    enum exit_code (*run)(int argc, const char *const *argv);
};

extern const struct ctl_command ctl_play, ctl_replay, ctl_tank, ctl_hid, ctl_paper, ctl_morph,
    ctl_lines, ctl_doctor, ctl_config, ctl_status, ctl_scores, ctl_audits,
    ctl_backup;

/* One line on standard error, "kingyoctl COMMAND: ...", and EXIT_USAGE. */
__attribute__((format(printf, 2, 3)))
enum exit_code ctl_usage(const char *command, const char *format, ...);

/* For a core that returned CORE_ERR_FLOAT: one line on standard error, and EXIT_NOT_SO. */
enum exit_code ctl_float(const char *command);

#endif
