/* library.c -- reads the files of the species library, and stores the reason for each rejected
 * file. */
#include "platform/species/library.h"

#include <dirent.h>
#include <errno.h>
#include <stdio.h>
#include <string.h>

#include "core/base/panic.h"
#include "core/base/printable.h"

#define PATH_SIZE 1024u

struct listing {
    char names[LIBRARY_LINE_MAX][NAME_MAX + 1];
    uint32_t count, beyond;
};

/* Inserts a name in alphabetical order, because the order of a directory's entries is undefined. If
 * there are more than LIBRARY_LINE_MAX names, keeps only the first LIBRARY_LINE_MAX names. */
static void insert(struct listing *l, const char *name)
{
    uint32_t at = l->count;
    while (at > 0 && strcmp(name, l->names[at - 1]) < 0) {
        at--;
    }
    if (l->count == LIBRARY_LINE_MAX) {
        l->beyond++;
    }
    if (at == LIBRARY_LINE_MAX) {
        return;
    }
    l->count += l->count < LIBRARY_LINE_MAX;
    memmove(&l->names[at] + 1, &l->names[at], (l->count - at - 1) * sizeof l->names[0]);
    memcpy(l->names[at], name, strlen(name) + 1);
}

/* Lists the names of the files in `folder`. Returns 0 on success or if the folder does not exist,
 * and an errno value if the folder cannot be read. */
static int list_pack_files(const char *folder, struct listing *l)
{
    DIR *directory = opendir(folder);
    if (!directory) {
        return errno == ENOENT ? 0 : errno;
    }
    for (const struct dirent *entry = readdir(directory); entry; entry = readdir(directory)) {
        const size_t length = strlen(entry->d_name), suffix = strlen(PACK_SUFFIX);
        if (length > suffix && entry->d_name[0] != '.' &&
            strcmp(entry->d_name + length - suffix, PACK_SUFFIX) == 0) {
            insert(l, entry->d_name);
        }
    }
    closedir(directory);
    return 0;
}

/* Reads one file into the next free slot of the library. If the species is invalid, returns false
 * and writes the reason to `why`. The slot then stays free. */
static bool library_read_file(struct library *library, const char *path,
                              char why[VALIDATE_WHY_SIZE])
{
    CORE_ASSERT(library->species_count <= SPECIES_EXTRA_MAX);
    if (library->species_count == SPECIES_EXTRA_MAX) {
        snprintf(why, VALIDATE_WHY_SIZE, "no room: %u species are loaded", SPECIES_EXTRA_MAX);
        return false;
    }
    struct species_slot *slot = &library->slots[library->species_count];
    if (pack_read_data(path, slot, why) != PACK_OK) {
        return false;
    }
    char id[SPECIES_NAME_SIZE];
    memcpy(id, slot->species.card.id, sizeof id);
    for (uint32_t i = 0; i < library_count(library); i++) {
        if (strcmp(library_species(library, i)->card.id, id) == 0) {
            snprintf(why, VALIDATE_WHY_SIZE, "id: there is a '%s' already", id);
            return false;
        }
    }
    library->species_count++;
    return true;
}

void library_fill(struct library *library, const char *data)
{
    struct listing listing = { .count = 0 };
    char folder[PATH_SIZE];
    library->species_count = library->line_count = library->unread_count = library->graph_count = 0;
    const int length = snprintf(folder, sizeof folder, "%s/" LIBRARY_FOLDER, data ? data : "");
    if (!data || !data[0] || length < 0 || (size_t)length >= sizeof folder) {
        return;
    }
    const int error = list_pack_files(folder, &listing);
    if (error != 0) {
        struct library_line *line = &library->lines[library->line_count++];
        *line = (struct library_line){ .file = LIBRARY_FOLDER, .slot = LIBRARY_SLOT_NONE };
        snprintf(line->why, sizeof line->why, "%s", strerror(error));
    }
    for (uint32_t i = 0; i < listing.count; i++) {
        char path[PATH_SIZE];
        struct library_line *line = &library->lines[library->line_count++];
        *line = (struct library_line){ .slot = LIBRARY_SLOT_NONE };
        snprintf(line->file, sizeof line->file, "%.*s", (int)sizeof line->file - 1,
                 listing.names[i]);
        printable(line->file);
        const int path_size = snprintf(path, sizeof path, "%s/%s", folder, listing.names[i]);
        if (path_size < 0 || (size_t)path_size >= sizeof path) {
            snprintf(line->why, sizeof line->why, "%s", strerror(ENAMETOOLONG));
        } else if (library_read_file(library, path, line->why)) {
            line->slot = (uint8_t)(library->species_count - 1);
        }
    }
    library->unread_count = listing.beyond;
}

/* ---- Rejected files and graphs that the operator's screens show ------------------------------ */

void library_note_graph(struct library *library, const char *line)
{
    const char *gap = strstr(line, ": ");
    if (gap == NULL || library->graph_count == SPECIES_MAX) {
        return;
    }
    struct library_line *note = &library->graphs[library->graph_count++];
    note->slot = LIBRARY_SLOT_NONE;
    snprintf(note->file, sizeof note->file, "%.*s", (int)(gap - line), line);
    snprintf(note->why, sizeof note->why, "%s", gap + 2);
}

uint32_t library_fault_count(const struct library *library)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < library->line_count; i++) {
        count += library->lines[i].slot == LIBRARY_SLOT_NONE;
    }
    CORE_ASSERT(library->line_count >= library->species_count);
    return count + (library->unread_count > 0) + library->graph_count;
}

struct library_line library_fault(const struct library *library, uint32_t index)
{
    struct library_line unread = { .file = LIBRARY_FOLDER, .slot = LIBRARY_SLOT_NONE };
    CORE_ASSERT(index < library_fault_count(library));
    for (uint32_t i = 0; i < library->line_count; i++) {
        if (library->lines[i].slot == LIBRARY_SLOT_NONE && index-- == 0) {
            return library->lines[i];
        }
    }
    if (library->unread_count > 0 && index-- == 0) {
        snprintf(unread.why, sizeof unread.why, "%u more files, and no room for them",
                 library->unread_count);
        return unread;
    }
    return library->graphs[index];
}

uint32_t library_count(const struct library *library)
{
    return species_table_count + library->species_count;
}

const struct species *library_species(const struct library *library, uint32_t index)
{
    CORE_ASSERT(index < library_count(library));
    return index < species_table_count ? species_table[index]
                                       : &library->slots[index - species_table_count].species;
}
