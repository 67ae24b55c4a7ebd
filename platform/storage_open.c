/* storage_open.c -- from a path to a file that can be written. */
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include <sqlite3.h>

#include "platform/storage_parts.h"

#define SET_ASIDE_MAX 1000u /* Damaged files that may lie beside the good one. */
#define ASIDE_SIZE (STORAGE_PATH_SIZE + 48u)

static void name_aside(const struct storage *storage, unsigned number, const char *suffix,
                       char out[ASIDE_SIZE])
{
    snprintf(out, ASIDE_SIZE, "%s.damaged-%u%s", storage->path, number, suffix);
}

/* A journal belongs to its file: left behind, it would be played into the fresh one. It goes first,
 * so that a power cut in between leaves a file that is still found damaged. */
static void set_journal_aside(const struct storage *storage, unsigned number)
{
    char from[ASIDE_SIZE], to[ASIDE_SIZE];
    snprintf(from, sizeof from, "%s-journal", storage->path);
    name_aside(storage, number, "-journal", to);
    rename(from, to);
}

/* Renames the damaged file to the first free kingyo.db.damaged-N. */
static bool set_aside(struct storage *storage)
{
    char to[ASIDE_SIZE];
    unsigned number = 1;
    name_aside(storage, number, "", to);
    while (number < SET_ASIDE_MAX && access(to, F_OK) == 0) {
        name_aside(storage, ++number, "", to);
    }
    if (access(to, F_OK) == 0) {
        return false;
    }
    set_journal_aside(storage, number);
    if (rename(storage->path, to) != 0) {
        return false;
    }
    atomic_store(&storage->aside, number);
    return true;
}

int storage_open_file(struct storage *storage)
{
    int code = ledger_file_open(&storage->file, storage->path, storage->vfs);
    if ((code == SQLITE_CORRUPT || code == SQLITE_NOTADB) && !storage->vfs && set_aside(storage)) {
        code = ledger_file_open(&storage->file, storage->path, storage->vfs);
    }
    return code;
}
