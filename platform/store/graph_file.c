/* graph_file.c -- writes graph edits of the growth lab to text files atomically and loads the files
 * at program start; see graph_file.h. */
#include "platform/store/graph_file.h"

#include <errno.h>
#include <fcntl.h>
#include <string.h>
#include <unistd.h>

#include "core/base/panic.h"
#include "platform/os/file.h"

#define PATH_SIZE 1200u

/* Returns true if the species name consists of letters, digits and '_' only, so that it cannot form
 * another path. */
static bool is_plain_name(const char id[SPECIES_NAME_SIZE])
{
    const size_t length = strnlen(id, SPECIES_NAME_SIZE);
    return length > 0 && length < SPECIES_NAME_SIZE &&
           strspn(id, "abcdefghijklmnopqrstuvwxyz0123456789_") == length;
}

int graph_file_write(const char *data, const struct graph_edit_record *record)
{
    CORE_ASSERT(data && record);
    char folder[PATH_SIZE], path[PATH_SIZE + SPECIES_NAME_SIZE + 16u], text[GRAPH_FILE_TEXT_MAX];
    const int length = snprintf(folder, sizeof folder, "%s/" GRAPH_FILE_FOLDER, data);
    if (!is_plain_name(record->species) || length < 0 || (size_t)length >= sizeof folder) {
        return -ENAMETOOLONG;
    }
    int error = file_make_folder(folder);
    if (error != 0) {
        return error;
    }
    snprintf(path, sizeof path, "%s/%s" GRAPH_FILE_SUFFIX, folder, record->species);
    if (record->is_own) {
        error = unlink(path) != 0 && errno != ENOENT ? -errno : file_sync_parent(path);
    } else {
        error = file_replace(path, text, graph_file_format(record, text), FILE_REPLACE_DURABLE);
    }
    return error;
}

static void graph_file_print_warning(struct graph_file_warn warn, const char *path, const char *why)
{
    char line[PATH_SIZE + GRAPH_FILE_WHY_SIZE];
    if (warn.report != NULL) {
        snprintf(line, sizeof line, "%s:%s", path, why);
        warn.report(warn.context, line);
    }
}

/* Loads the graph of one species from `path`. Rejects a file longer than GRAPH_FILE_TEXT_MAX. */
static void fill_one(const char *path, const struct species_card *card, uint8_t *has,
                     struct lab_edit *edit, struct graph_file_warn warn)
{
    char text[GRAPH_FILE_TEXT_MAX + 1u], why[GRAPH_FILE_WHY_SIZE];
    const int fd = file_handle(path, O_RDONLY, 0);
    if (fd < 0) {
        if (errno != ENOENT && errno != ENOTDIR) {
            snprintf(why, sizeof why, " cannot open: %.80s", file_error(errno));
            graph_file_print_warning(warn, path, why);
        }
        return;
    }
    const ssize_t size = read(fd, text, sizeof text);
    close(fd);
    if (size < 0 || (size_t)size > GRAPH_FILE_TEXT_MAX) {
        graph_file_print_warning(warn, path, size < 0 ? " cannot read" : " longer than any graph");
    } else if (graph_file_parse(text, (size_t)size, card, edit, why)) {
        *has = 1;
    } else {
        graph_file_print_warning(warn, path, why);
    }
}

void graph_file_load(const char *data, struct lab_book *book, struct graph_file_warn warn)
{
    char path[PATH_SIZE];
    for (uint32_t i = 0; i < lab_book_count(book) && data != NULL && data[0] != 0; i++) {
        const struct species_card *card = lab_book_card(book, i);
        const int length = snprintf(
            path, sizeof path, "%s/" GRAPH_FILE_FOLDER "/%s" GRAPH_FILE_SUFFIX, data, card->id);
        if (length > 0 && (size_t)length < sizeof path && is_plain_name(card->id)) {
            fill_one(path, card, &book->has_edit[i], &book->edits[i], warn);
        }
    }
}
