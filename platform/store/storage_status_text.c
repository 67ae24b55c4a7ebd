/* storage_status_text.c -- describes the state of the store in one line for the operator's menu,
 * the status file and the log. */
#include <stdio.h>
#include <string.h>

#include <sqlite3.h>

#include "platform/store/storage_internal.h"

void storage_log(struct storage *storage, const char *what, const char *why, const char *advice)
{
    snprintf(storage->text, sizeof storage->text, "%.68s: %.44s; %.40s", what, why, advice);
}

void storage_log_no_file(struct storage *storage, const char *why)
{
    char what[HAL_TEXT_SIZE / 2];
    snprintf(what, sizeof what, "no store: %.56s", storage->path);
    storage_log(storage, what, why, "nothing is kept");
}

void storage_log_refused(struct storage *storage, int error, const char *advice)
{
    char what[HAL_TEXT_SIZE / 2];
    snprintf(what, sizeof what, "store: %u entries not written", storage_unwritten(storage));
    storage_log(storage, what, ledger_file_error(error), advice);
}

static const char *advice_for(int error)
{
    switch (error) {
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
        return "another program holds it; it is retried";
    case SQLITE_FULL:
        return "free some space; it is retried";
    case SQLITE_READONLY:
        return "the card is read-only; it is retried";
    case LEDGER_FILE_FOREIGN:
        return "restart to use this one";
    default:
        return "it is retried each second";
    }
}

static void say_rebuilt(struct storage *storage, unsigned number)
{
    char what[80] = "missing", lost[24] = "unknown how many";
    if (!storage->was_missing) {
        snprintf(what, sizeof what,
                 "damaged and is now " STORAGE_FILE STORAGE_QUARANTINE_SUFFIX "%u", number);
    }
    if (!storage->salvaged.is_open_ended) {
        snprintf(lost, sizeof lost, "%u", storage->salvaged.lost);
    }
    snprintf(storage->text, sizeof storage->text,
             STORAGE_FILE " was %s: %u entries from the backup, %u later ones, %s lost", what,
             storage->from_backup, storage->salvaged.entries, lost);
}

const char *storage_describe(void *self)
{
    struct storage *storage = self;
    const int error = atomic_load(&storage->error);
    const int edit_error = atomic_load(&storage->edit_error);
    const unsigned aside = atomic_load(&storage->aside);
    if (!atomic_load(&storage->has_file)) {
        if (error == LEDGER_FILE_FOREIGN) {
            storage_log(storage, "no store", "the card is there now, and not empty",
                        "a restart, once nobody plays");
        }
        return storage->text[0] ? storage->text : "no store: not opened";
    }
    if (storage_stuck_ms(storage) > 0) {
        snprintf(storage->text, sizeof storage->text,
                 "store: the card has not answered for %u s; %u entries wait",
                 (unsigned)(storage_stuck_ms(storage) / 1000), storage_unwritten(storage));
    } else if (error == LEDGER_FILE_MOVED) {
        storage_log(storage, "store: the data folder or " STORAGE_FILE " was removed or replaced",
                    "nothing is kept", "put it back, or restart the kiosk");
    } else if (error != SQLITE_OK) {
        storage_log_refused(storage, error, advice_for(error));
    } else if (edit_error != 0) {
        storage_log(storage, "store: a graph was not written", strerror(edit_error),
                    "it is retried");
    } else if (atomic_load(&storage->tail_error) != 0) {
        storage_log(storage, "store: the second copy is not written",
                    strerror(atomic_load(&storage->tail_error)), "it is retried");
    } else if (aside > 0) {
        say_rebuilt(storage, aside);
    } else if (atomic_load(&storage->strange) > 0) {
        snprintf(storage->text, sizeof storage->text,
                 STORAGE_FILE "%s was not a regular file and was set aside",
                 storage_suffixes[atomic_load(&storage->strange) - 1u]);
    } else {
        snprintf(storage->text, sizeof storage->text, "%.150s", storage->path);
    }
    return storage->text;
}
