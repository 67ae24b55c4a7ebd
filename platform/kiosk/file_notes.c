/* file_notes.c -- stores the notes in one array: first the files that were not used, then the files
 * that were used. */
#include "platform/kiosk/file_notes.h"

#include <assert.h>
#include <stdio.h>
#include <string.h>

_Static_assert(FILE_NOTES_MAX + 2u <= UINT8_MAX, "struct desk_input counts rows in a byte");

/* Copies `name` to `note`. A path that is too long is cut at its beginning, because its end is more
 * specific. */
static void set_name(struct scene_file *note, const char *name)
{
    const size_t length = strlen(name), room = sizeof note->name - 1u;
    if (length <= room) {
        memcpy(note->name, name, length + 1u);
    } else {
        snprintf(note->name, sizeof note->name, "...%s", name + length - (room - 3u));
    }
}

void file_notes_add(struct file_notes *notes, enum scene_file_state state, const char *name,
                    const char *words)
{
    assert(state == FILE_USED || state == FILE_REFUSED || state == FILE_ASIDE);
    if (notes->count == FILE_NOTES_MAX) {
        notes->beyond++;
        return;
    }
    const uint32_t at = state == FILE_USED ? notes->count : notes->first_count++;
    notes->refused_count += state == FILE_REFUSED;
    struct scene_file *note = &notes->note[at];
    memmove(note + 1, note, (notes->count - at) * sizeof *note);
    notes->count++;
    note->state = (uint8_t)state;
    set_name(note, name);
    snprintf(note->words, sizeof note->words, "%s", words);
}

static const char *below(const char *data, const char *path)
{
    const size_t length = strlen(data);
    const int is_below = length > 0 && strncmp(path, data, length) == 0 && path[length] == '/';
    return is_below ? path + length + 1u : path;
}

void file_notes_refused(struct file_notes *notes, const char *data, const char *line)
{
    char name[1024];
    const char *from = below(data, line);
    const char *gap = strstr(from, ": ");
    if (gap == NULL) {
        file_notes_add(notes, FILE_REFUSED, "", line);
        return;
    }
    snprintf(name, sizeof name, "%.*s", (int)(gap - from), from);
    file_notes_add(notes, FILE_REFUSED, name, gap + 2);
}

uint32_t file_notes_rows(const struct file_notes *notes)
{
    return notes->count + (notes->beyond > 0);
}

struct scene_file file_notes_row(const struct file_notes *notes, uint32_t row)
{
    struct scene_file beyond = { .state = FILE_UNKNOWN };
    if (row < notes->count) {
        return notes->note[row];
    }
    if (row == notes->count && notes->beyond > 0) {
        beyond.state = FILE_REFUSED;
        snprintf(beyond.name, sizeof beyond.name, "...");
        snprintf(beyond.words, sizeof beyond.words, "%u more lines, and no room for them",
                 notes->beyond);
    }
    return beyond;
}
