/* session.h -- one run of the stall, with or without a screen: what both need around the loop. */
#ifndef KINGYO_PLATFORM_KIOSK_SESSION_H
#define KINGYO_PLATFORM_KIOSK_SESSION_H

#include <signal.h>

#include "platform/hal.h"
#include "platform/kiosk/chapters.h"
#include "platform/kiosk/encore.h"
#include "platform/kiosk/evidence.h"
#include "platform/kiosk/kiosk.h"
#include "platform/kiosk/options.h"
#include "platform/kiosk/recorder.h"
#include "platform/kiosk/replayer.h"
#include "platform/kiosk/status.h"
#include "platform/machine.h"
#include "platform/species/shelf.h"

struct session {
    struct options options;
    struct hal hal;
    struct kiosk kiosk;
    struct recorder recorder;
    struct replayer replayer;
    struct encore encore;                /* To show scores again. */
    struct chapters chapters;            /* For the replays of scores, and of panics. */
    struct evidence evidence;            /* Writes the replay and the count in a panic. */
    struct shelf shelf;                  /* Makers' species, read as the kiosk begins. */
    struct file_notes notes;             /* What became of these, and of all other files. */
    struct replay_totals replayed;       /* What session_check found in the file to replay. */
    struct machine machine;              /* What the stall stands on. */
    struct status status;                /* For who watches over the machine. */
    uint8_t *rgb;                        /* For pictures; grows with the window. */
    size_t rgb_size;
    const volatile sig_atomic_t *stop;   /* Set by SIGINT and SIGTERM. */
};

/* Checks the replay, wholly, before anything is opened. Returns an exit code. */
enum exit_code session_check(struct session *session);

/* Begins the kiosk on session->hal, with the recording or the replay asked for, and reads makers'
 * species from the data folder. `config` is what the caller wants; a replay brings its own
 * core_config. Returns an exit code, the reason is told. */
enum exit_code session_begin(struct session *session, struct kiosk_config *config);

/* Notes a file, "FILE: why", that was refused, for the operator's menu. `self` is a session. */
void session_note_refused(void *self, const char *line);

/* Tells of each file on the shelf: what was loaded on standard output, what was not, and why, on
 * standard error. */
void session_tell_shelf(const struct session *session);

/* For a core that returned CORE_ERR_FLOAT: one line, and EXIT_NOT_SO. */
enum exit_code session_tell_float(void);

/* Ends the recording or the replay and tells how it went. Returns an exit code. */
enum exit_code session_end(struct session *session);

/* folder_make, and tells. Returns an exit code. */
enum exit_code session_make_folder(const char *path);

/* Room for pictures up to `width` x `height`, in place of what there was. An exit code, told. */
enum exit_code session_make_room(struct session *session, uint32_t width, uint32_t height);

/* Takes the picture last presented into session->rgb and, where `path` is not null, writes it
 * there. 0 with `image` filled, -1 and told. */
int session_shot(struct session *session, const char *path, struct hal_image *image);

#endif
