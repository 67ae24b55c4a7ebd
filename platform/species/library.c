/* library.c -- reads the files of the species library, and stores the reason for each rejected
 * file. */
#include "platform/species/library.h"

#include <dirent.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/panic.h"
#include "core/base/printable.h"
#include "platform/os/file.h"

#define PATH_SIZE 1024u

static int is_pack_file(const struct dirent *entry)
{
    return entry->d_name[0] != '.' && file_has_suffix(entry->d_name, PACK_SUFFIX);
}

/* Compares the names of two folder entries by their bytes, so that their order does not depend on
 * the locale. */
static int compare_names(const struct dirent **a, const struct dirent **b)
{
    return strcmp((*a)->d_name, (*b)->d_name);
}

/* Reads one file into the next free slot of the library. If the species is invalid, returns false
 * and writes the reason to `why`. The slot then stays free. */
static bool library_read_file(struct library *library, const char *path,
                              char why[VALIDATE_WHY_SIZE])
{
    CORE_ASSERT(library->species_count <= SPECIES_EXTRA_MAX);
    if (library->species_count == SPECIES_EXTRA_MAX) {
        snprintf(why, VALIDATE_WHY_SIZE, "%u species are loaded, which is the maximum",
                 SPECIES_EXTRA_MAX);
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
            snprintf(why, VALIDATE_WHY_SIZE, "id: the species '%s' exists already", id);
            return false;
        }
    }
    library->species_count++;
    return true;
}

/* Appends an entry for the file `name` of the species folder to library->lines and returns the
 * entry. If `name` is null, the entry is for the folder itself. The library slot of the entry and
 * its reason for a rejection are still empty. */
static struct library_line *add_line(struct library *library, const char *name)
{
    CORE_ASSERT(library->line_count < LIBRARY_LINE_MAX);
    struct library_line *line = &library->lines[library->line_count++];
    *line = (struct library_line){ .slot = LIBRARY_SLOT_NONE };
    snprintf(line->file, sizeof line->file, LIBRARY_FOLDER "%s%.*s", name ? "/" : "",
             (int)sizeof line->file - 1, name ? name : "");
    printable(line->file);
    return line;
}

void library_fill(struct library *library, const char *data)
{
    char folder[PATH_SIZE], path[PATH_SIZE];
    struct dirent **entries = NULL;
    library->species_count = library->line_count = library->unread_count = library->graph_count = 0;
    const int length = snprintf(folder, sizeof folder, "%s/" LIBRARY_FOLDER, data ? data : "");
    if (!data || !data[0] || length < 0 || (size_t)length >= sizeof folder) {
        return;
    }
    const int count = scandir(folder, &entries, is_pack_file, compare_names);
    if (count < 0 && errno != ENOENT) {
        const int error = errno;
        struct library_line *line = add_line(library, NULL);
        snprintf(line->why, sizeof line->why, "%s", strerror(error));
    }
    for (int i = 0; i < count; i++) {
        if (library->line_count < LIBRARY_LINE_MAX) {
            struct library_line *line = add_line(library, entries[i]->d_name);
            const int size = snprintf(path, sizeof path, "%s/%s", folder, entries[i]->d_name);
            if (size < 0 || (size_t)size >= sizeof path) {
                snprintf(line->why, sizeof line->why, "%s", strerror(ENAMETOOLONG));
            } else if (library_read_file(library, path, line->why)) {
                line->slot = (uint8_t)(library->species_count - 1);
            }
        } else {
            library->unread_count++;
        }
        free(entries[i]);
    }
    free(entries);
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
