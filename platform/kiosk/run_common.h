/* run_common.h -- one run of the program, with or without a screen: the state and functions around
 * the frame loop. */
#ifndef KINGYO_PLATFORM_KIOSK_RUN_COMMON_H
#define KINGYO_PLATFORM_KIOSK_RUN_COMMON_H

#include <signal.h>

#include "platform/config/options.h"
#include "platform/hal.h"
#include "platform/kiosk/kiosk.h"
#include "platform/kiosk/panic_recovery.h"
#include "platform/kiosk/recorder.h"
#include "platform/kiosk/replayer.h"
#include "platform/kiosk/score_playback.h"
#include "platform/kiosk/session_recorder.h"
#include "platform/kiosk/status.h"
#include "platform/species/library.h"
#include "platform/system_health.h"

struct run_common {
    struct options options;
    struct hal hal;
    struct kiosk kiosk;
    struct recorder recorder;
    struct replayer replayer;
    struct score_playback playback;   /* Score playback. */
    struct session_recorder chapters; /* Session recorder, for the replays of scores and panics. */
    struct evidence evidence;         /* Writes the replay and the count in a panic. */
    struct library library;           /* Species files of makers, read at start. */
    struct file_notes notes;          /* Results of reading species and all other files. */
    struct replay_totals replayed;    /* Totals that run_common_check() found in the file to
                                         replay. */
    struct system_health machine;     /* System health. */
    struct status status;             /* Status file for monitoring tools. */
    uint8_t *rgb;                     /* Buffer for pictures; grows with the window. */
    size_t rgb_size;
    const volatile sig_atomic_t *stop; /* Set by SIGINT and SIGTERM. */
};

/* Validates the whole replay before anything is opened. Returns an exit code. */
enum exit_code run_common_check(struct run_common *session);

/* Starts the kiosk on session->hal, with the requested recording or replay, and reads species files
 * from the data folder. `config` is the caller's; a replay replaces its core_config. Returns an
 * exit code; errors were reported. */
enum exit_code run_common_begin(struct run_common *session, struct kiosk_config *config);

/* Records a rejected file, "FILE: reason", for the operator's menu. `self` is a session. */
void run_common_note_refused(void *self, const char *line);

/* Reports each species file: loaded files on standard output, rejected files with the reason on
 * standard error. */
void run_common_print_library(const struct run_common *session);

/* Reports CORE_ERR_FLOAT in one line and returns EXIT_NOT_SO. */
enum exit_code run_common_print_float(void);

/* Ends the recording or the replay and reports the result. Returns an exit code. */
enum exit_code run_common_end(struct run_common *session);

/* Calls directory_make() and reports an error. Returns an exit code. */
enum exit_code run_common_make_folder(const char *path);

/* Reallocates the buffer for pictures up to `width` x `height`. Returns an exit code; errors were
 * reported. */
enum exit_code run_common_make_room(struct run_common *session, uint32_t width, uint32_t height);

/* Copies the picture presented last to session->rgb and, if `path` is not null, writes it to that
 * file. Returns 0 with `image` filled, or -1 after the error was reported. */
int run_common_shot(struct run_common *session, const char *path, struct hal_image *image);

#endif
