/* run_common.h -- opens, starts and ends the parts of the program that surround the frame loop
 * (recording, replay, species files, pictures), with or without a screen. */
#pragma once

#include <signal.h>
#include <stdbool.h>

#include "platform/config/options.h"
#include "platform/hal.h"
#include "platform/kiosk/kiosk.h"
#include "platform/kiosk/recorder/panic_recovery.h"
#include "platform/kiosk/recorder/replayer.h"
#include "platform/kiosk/recorder/score_playback.h"
#include "platform/kiosk/recorder/session_recorder.h"
#include "platform/kiosk/status.h"
#include "platform/species/library.h"
#include "platform/system_health.h"
#include "platform/update_link.h"

struct run_common {
    struct options options;
    struct hal hal;
    struct kiosk kiosk;
    struct recorder recorder;
    struct replayer replayer;
    struct score_playback playback;   /* Playback of a score's replay on the screen. */
    struct session_recorder sessions; /* Session recorder for the replays of scores and panics. */
    /* Panic handler, which after a panic writes the replay and increases the count of panics. */
    struct evidence evidence;
    struct library library; /* Installed species files, read at program start. */
    /* Messages about species files and other files that were read at program start. */
    struct operator_notes notes;
    /* Totals of the recording that --replay plays, set by run_common_check(). */
    struct replay_totals replayed;
    struct system_health machine; /* System health monitor. */
    struct update_link update;    /* Link to the update service. */
    /* For the self-test of a board: the time of the first picture since power on in milliseconds,
     * and the temperature margin before that picture (thermal_read()). */
    uint64_t first_picture_ms;
    int32_t margin_begin_mdeg;
    struct status status; /* Writer of the status file for monitoring tools. */
    uint8_t *rgb;         /* Buffer for pictures. The buffer grows with the window. */
    size_t rgb_size;
    const volatile sig_atomic_t *stop; /* Nonzero after SIGINT or SIGTERM. */
};

/* Validates the whole recording of --replay before any device is opened. Returns an exit code. */
enum exit_code run_common_check(struct run_common *session);

/* Starts the kiosk on the devices of session->hal. The option --record also starts a recording, and
 * the option --replay starts a replay. Reads species files from the data folder. The caller owns
 * `config`. A replay replaces config->core. Returns an exit code. Reports all errors before it
 * returns. */
enum exit_code run_common_begin(struct run_common *session, struct kiosk_config *config);

/* Adds a rejected file, "FILE: reason", to the operator's messages. `self` is a struct
 * run_common. */
void run_common_note_refused(void *self, const char *line);

/* Reports each species file. Prints loaded files to standard output, and logs rejected files with
 * the reason. */
void run_common_print_library(const struct run_common *session);

/* Reports CORE_ERR_FLOAT in one line. Returns EXIT_NOT_SO. */
enum exit_code run_common_print_float(void);

/* Ends the recording or the replay and reports the result. Returns an exit code. */
enum exit_code run_common_end(struct run_common *session);

/* Creates a folder with file_make_folder() and reports an error. Returns an exit code. */
enum exit_code run_common_make_folder(const char *path);

/* Allocates the buffer for pictures of `width` x `height` pixels. Returns an exit code. Reports an
 * error before it returns. */
enum exit_code run_common_make_room(struct run_common *session, uint32_t width, uint32_t height);

/* Copies the newest presented frame to session->rgb. If `path` is not null, also writes a PNG file.
 * Returns 0 and fills `image`. After an error reports the error and returns -1. */
int run_common_shot(struct run_common *session, const char *path, struct hal_image *image);

/* ---- run_interactive.c: the kiosk on a screen ---------------------------------------------- */

/* Returns true if a service manager started the kiosk ($NOTIFY_SOCKET is set). A kiosk that runs
 * as a service starts without a screen and waits until a screen is connected, because no user
 * would read an error message. */
bool run_interactive_waits_for_screen(void);

/* Opens the board's devices. Returns true if the display is open, or if the kiosk waits until a
 * screen is connected. */
bool run_interactive_open(struct run_common *session);

/* Runs frames until the kiosk ends (enum kiosk_end). Returns an exit code. Reports all errors
 * before it returns. */
enum exit_code run_interactive_run(struct run_common *session);
