/* shelf.c -- lists and reads the species library, and stores the reason for each rejected file. */
#include "platform/species/shelf.h"

#include <assert.h>
#include <dirent.h>
#include <errno.h>
#include <stdio.h>
#include <string.h>

#include "core/base/printable.h"

#define PATH_SIZE 1024u

struct listing {
    char names[SHELF_LINE_MAX][NAME_MAX + 1];
    uint32_t count, beyond;
};

static bool is_packed(const char *name)
{
    const size_t length = strlen(name), suffix = strlen(PACK_SUFFIX);
    return length > suffix && name[0] != '.' && strcmp(name + length - suffix, PACK_SUFFIX) == 0;
}

/* Inserts a name in order and keeps the first SHELF_LINE_MAX names, because a directory has no
 * fixed order. */
static void insert(struct listing *l, const char *name)
{
    uint32_t at = l->count;
    while (at > 0 && strcmp(name, l->names[at - 1]) < 0) {
        at--;
    }
    if (l->count == SHELF_LINE_MAX) {
        l->beyond++;
    }
    if (at == SHELF_LINE_MAX) {
        return;
    }
    l->count += l->count < SHELF_LINE_MAX;
    memmove(&l->names[at] + 1, &l->names[at], (l->count - at - 1) * sizeof l->names[0]);
    memcpy(l->names[at], name, strlen(name) + 1);
}

/* Returns 0, or the errno of a directory that exists but cannot be read. */
static int list(const char *folder, struct listing *l)
{
    DIR *directory = opendir(folder);
    if (!directory) {
        return errno == ENOENT ? 0 : errno;
    }
    for (const struct dirent *entry = readdir(directory); entry; entry = readdir(directory)) {
        if (is_packed(entry->d_name)) {
            insert(l, entry->d_name);
        }
    }
    closedir(directory);
    return 0;
}

static bool is_taken(const struct shelf *shelf, const char *id)
{
    for (uint32_t i = 0; i < shelf_count(shelf); i++) {
        if (strcmp(shelf_species(shelf, i)->card.id, id) == 0) {
            return true;
        }
    }
    return false;
}

/* Reads one file into the next free slot. The slot stays free if the species is rejected. */
static bool take(struct shelf *shelf, const char *path, char why[VET_WHY_SIZE])
{
    if (shelf->species_count == SPECIES_EXTRA_MAX) {
        snprintf(why, VET_WHY_SIZE, "no room: %u species are loaded", SPECIES_EXTRA_MAX);
        return false;
    }
    struct species_slot *slot = &shelf->slots[shelf->species_count];
    if (pack_read_data(path, slot, why) != PACK_OK) {
        return false;
    }
    char id[SPECIES_NAME_SIZE];
    memcpy(id, slot->species.card.id, sizeof id);
    if (is_taken(shelf, id)) {
        snprintf(why, VET_WHY_SIZE, "id: there is a '%s' already", id);
        return false;
    }
    shelf->species_count++;
    return true;
}

static void read_one(struct shelf *shelf, const char *folder, const char *name)
{
    char path[PATH_SIZE];
    struct shelf_line *line = &shelf->lines[shelf->line_count++];
    *line = (struct shelf_line){ .slot = SHELF_SLOT_NONE };
    snprintf(line->file, sizeof line->file, "%.*s", (int)sizeof line->file - 1, name);
    printable(line->file);
    const int length = snprintf(path, sizeof path, "%s/%s", folder, name);
    if (length < 0 || (size_t)length >= sizeof path) {
        snprintf(line->why, sizeof line->why, "%s", strerror(ENAMETOOLONG));
    } else if (take(shelf, path, line->why)) {
        line->slot = (uint8_t)(shelf->species_count - 1);
    }
}

void shelf_fill(struct shelf *shelf, const char *data)
{
    struct listing listing = { .count = 0 };
    char folder[PATH_SIZE];
    shelf->species_count = shelf->line_count = shelf->unread_count = shelf->graph_count = 0;
    const int length = snprintf(folder, sizeof folder, "%s/" SHELF_FOLDER, data ? data : "");
    if (!data || !data[0] || length < 0 || (size_t)length >= sizeof folder) {
        return;
    }
    const int error = list(folder, &listing);
    if (error != 0) {
        struct shelf_line *line = &shelf->lines[shelf->line_count++];
        *line = (struct shelf_line){ .file = SHELF_FOLDER, .slot = SHELF_SLOT_NONE };
        snprintf(line->why, sizeof line->why, "%s", strerror(error));
    }
    for (uint32_t i = 0; i < listing.count; i++) {
        read_one(shelf, folder, listing.names[i]);
    }
    shelf->unread_count = listing.beyond;
}

/* ---- Faults --------------------------------------------------------------------------------- */

void shelf_note_graph(struct shelf *shelf, const char *line)
{
    const char *gap = strstr(line, ": ");
    if (gap == NULL || shelf->graph_count == SPECIES_MAX) {
        return;
    }
    struct shelf_line *note = &shelf->graphs[shelf->graph_count++];
    note->slot = SHELF_SLOT_NONE;
    snprintf(note->file, sizeof note->file, "%.*s", (int)(gap - line), line);
    snprintf(note->why, sizeof note->why, "%s", gap + 2);
}

static uint32_t refused_count(const struct shelf *shelf)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < shelf->line_count; i++) {
        count += shelf->lines[i].slot == SHELF_SLOT_NONE;
    }
    return count;
}

uint32_t shelf_fault_count(const struct shelf *shelf)
{
    return refused_count(shelf) + (shelf->unread_count > 0) + shelf->graph_count;
}

struct shelf_line shelf_fault(const struct shelf *shelf, uint32_t index)
{
    struct shelf_line unread = { .file = SHELF_FOLDER, .slot = SHELF_SLOT_NONE };
    assert(index < shelf_fault_count(shelf));
    for (uint32_t i = 0; i < shelf->line_count; i++) {
        if (shelf->lines[i].slot == SHELF_SLOT_NONE && index-- == 0) {
            return shelf->lines[i];
        }
    }
    if (shelf->unread_count > 0 && index-- == 0) {
        snprintf(unread.why, sizeof unread.why, "%u more files, and no room for them",
                 shelf->unread_count);
        return unread;
    }
    return shelf->graphs[index];
}

uint32_t shelf_count(const struct shelf *shelf)
{
    return species_table_count + shelf->species_count;
}

const struct species *shelf_species(const struct shelf *shelf, uint32_t index)
{
    assert(index < shelf_count(shelf));
    return index < species_table_count ? species_table[index]
                                       : &shelf->slots[index - species_table_count].species;
}
