/* panic_recovery.c -- writes the evidence of a panic and evaluates it at the next start; see
 * panic_recovery.h. */
#include "platform/kiosk/recorder/panic_recovery.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <pthread.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "platform/os/file.h"
#include "platform/os/log.h"
#include "platform/os/panic.h"
#include "platform/os/thread.h"
#include "platform/store/sqlite/ledger_backup.h"

#define NAME_SIZE 16u
#define EVIDENCE_WAIT_MS 200

/* ---- Program start ------------------------------------------------------------------------- */

static int write_count(const struct evidence *evidence)
{
    const int error = panics_write(&evidence->panics, evidence->folder - 1);
    if (error) {
        log_print(LOG_LEVEL_ERROR, "%s/" PANICS_FILE ": cannot write: %s", evidence->data,
                  panics_error(error));
    }
    return error;
}

static void *clear_count_later(void *self)
{
    struct evidence *evidence = self;
    struct timespec left = { .tv_sec = PANICS_WITHIN_S };
    pthread_setname_np(pthread_self(), "evidence");
    while (clock_nanosleep(CLOCK_MONOTONIC, 0, &left, &left) == EINTR) {
    }
    /* Clears the count of panics after ten minutes without a panic, because such a long run shows
     * that the stored data are not the cause. If a panic occurs at the same time, the count is not
     * cleared. */
    atomic_store(&evidence->is_clearing, true);
    if (atomic_load(&evidence->has_frame) && !atomic_load(&evidence->has_panicked)) {
        panics_clear(&evidence->panics);
        write_count(evidence);
    }
    atomic_store(&evidence->is_clearing, false);
    return NULL;
}

/* Removes a part of the stored data from use (ledger_leave_out()). The function first records the
 * attempt on disk, because the attempt may cause another panic. */
static void leave_out(struct evidence *evidence)
{
    struct panics *panics = &evidence->panics;
    char words[LEDGER_LEAVE_WORDS] = "nothing was changed, because the attempt cannot be noted";
    const char *cause =
        panics->is_early ? "a panic before the first frame" : "three panics within ten minutes";
    const enum panics_left left = panics_try(panics);
    const int result = write_count(evidence) ? -1 : ledger_leave_out(evidence->data, left, words);
    if (result == 0) {
        panics_set_left_out(panics, evidence->boot);
    } else if (result == LEDGER_LEAVE_NONE) {
        panics_clear(panics);
    }
    panics->attempt = LEFT_NOTHING;
    write_count(evidence);
    if (panics_is_due(panics)) {
        /* Starts the thread that clears the count of panics after ten minutes. If no thread can be
         * created, the count stays, and the next program start leaves out the same part of the data
         * once more. */
        pthread_t thread;
        if (thread_start(&thread, clear_count_later, evidence) == 0) {
            pthread_detach(thread);
        }
    }
    log_print(LOG_LEVEL_ERROR, "after %s this start %s %s: %s", cause,
              result == 0 ? "leaves out" : "cannot leave out", panics_left_name(left), words);
}

/* Locks the data folder. If the count of panics requires it, removes a part of the stored data
 * from use. If the file system has no locks, the function continues without a lock. The count of
 * panics is read again, because another process may have changed the count before the folder was
 * locked. */
static void hold_and_leave_out(struct evidence *evidence)
{
    struct panics *panics = &evidence->panics;
    const int hold = file_lock_folder(evidence->data);
    if (hold == -EWOULDBLOCK) {
        log_print(LOG_LEVEL_ERROR,
                  "%s: another kiosk has the folder open; no data are left out after the panics",
                  evidence->data);
        return;
    }
    const bool is_read = panics_read(panics, evidence->folder - 1) == 0;
    if (is_read && panics->attempt != LEFT_NOTHING) {
        /* Clears the count of panics and keeps all data, because the previous program start ended
         * while it tried to leave out data. */
        log_print(LOG_LEVEL_ERROR,
                  "the last start ended while it left out %s; this start leaves out no data",
                  panics_left_name(evidence->panics.attempt));
        panics_clear(&evidence->panics);
        write_count(evidence);
    } else if (is_read && panics_is_due(panics)) {
        leave_out(evidence);
    }
    if (hold >= 0) {
        close(hold);
    }
}

void panic_evidence_open(struct evidence *evidence, const char *data,
                         struct session_recorder *sessions, const struct core *core)
{
    const int folder = data && data[0] ? open(data, O_RDONLY | O_DIRECTORY | O_CLOEXEC) : -1;
    *evidence = (struct evidence){ .folder = folder + 1,
                                   .data = data,
                                   .sessions = sessions,
                                   .core = core,
                                   .thread = gettid(),
                                   .boot = panics_boot(),
                                   .begun_s = panics_up_s() };
    if (folder < 0) {
        return;
    }
    const int error = panics_read(&evidence->panics, folder);
    if (error) {
        log_print(LOG_LEVEL_WARNING, "%s/" PANICS_FILE ": %s; panics are counted from zero", data,
                  panics_error(error));
    }
    if (evidence->panics.attempt != LEFT_NOTHING || panics_is_due(&evidence->panics)) {
        hold_and_leave_out(evidence);
    }
}

void panic_evidence_note_frame(struct evidence *evidence)
{
    atomic_store(&evidence->has_frame, true);
}

/* ---- Panic handler: async-signal-safe calls only ------------------------------------------- */

/* Writes the recorded session to the new file `name`, which replaces an old file. Returns 0 or a
 * negative errno; -ENODATA means that no session was recorded. */
static int write_replay(const struct evidence *evidence, const char *name, bool is_sound)
{
    if (!evidence->sessions || !session_recorder_has_begun(evidence->sessions)) {
        return -ENODATA;
    }
    const int folder = evidence->folder - 1;
    if (unlinkat(folder, name, 0) != 0 && errno != ENOENT) {
        return -errno;
    }
    const int file =
        openat(folder, name, O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0600);
    if (file < 0) {
        return -errno;
    }
    int error = session_recorder_dump(evidence->sessions, evidence->core, is_sound, file);
    if (!error && fsync(file) != 0) {
        error = -errno;
    }
    close(file);
    return error;
}

/* Logs the panic, its reason, and the result of writing the replay `name`. `is_sound` is the value
 * that session_recorder_freeze() returned. */
static void log_evidence(const struct evidence *evidence, const char *reason, const char *name,
                         int error, bool is_sound)
{
    struct panic_text text = { 0 };
    panic_put(&text, "panic: ");
    panic_put(&text, reason);
    if (!error) {
        const uint32_t tick = core_status(evidence->core).tick;
        const uint32_t end_tick = session_recorder_end_tick(evidence->sessions, tick, is_sound);
        panic_put(&text, ": the game before tick ");
        panic_put_number(&text, end_tick);
        panic_put(&text, " is in ");
        panic_put(&text, evidence->data);
        panic_put(&text, "/");
        panic_put(&text, name);
        if (end_tick < tick) {
            panic_put(&text, "; the panic came in tick ");
            panic_put_number(&text, tick);
        }
    } else if (error == -ENODATA) {
        panic_put(&text, ": no game was recorded");
    } else {
        panic_put(&text, ": the game could not be written, error ");
        panic_put_number(&text, (uint32_t)-error);
    }
    log_print_raw(LOG_LEVEL_CRITICAL, text.out);
}

bool panic_evidence_write(struct evidence *evidence, const char *reason)
{
    /* Waits until no other thread writes the count of panics, at most EVIDENCE_WAIT_MS
     * milliseconds. */
    atomic_store(&evidence->has_panicked, true);
    for (int i = 0; i < EVIDENCE_WAIT_MS && atomic_load(&evidence->is_clearing); i++) {
        poll(NULL, 0, 1);
    }
    /* Stops the thread that runs the ticks. Before panic_evidence_open() was called, this thread is
     * the main thread. */
    const bool is_own = gettid() == (evidence->thread != 0 ? evidence->thread : getpid());
    const bool is_sound =
        evidence->sessions ? session_recorder_freeze(evidence->sessions, is_own) : is_own;
    struct panics *panics = &evidence->panics;
    char name[NAME_SIZE] = "";
    int error = -ENODATA;
    if (evidence->folder > 0) {
        const uint32_t up_s = panics_up_s();
        static const char pattern[NAME_SIZE] = "panic-0.kgr";
        _Static_assert(PANICS_FILES == 10u, "a digit is enough");
        memcpy(name, pattern, NAME_SIZE);
        name[6] = (char)('0' + panics->total % PANICS_FILES);
        panics_add(panics, evidence->boot, up_s, up_s - evidence->begun_s,
                   atomic_load(&evidence->has_frame));
        panics_write(panics, evidence->folder - 1);
        error = write_replay(evidence, name, is_sound);
    }
    log_evidence(evidence, reason, name, error, is_sound);
    return is_sound;
}
