/* operator_view.c -- copies the names and texts of the devices to the operator's menu; see
 * operator_view.h. */
#include "platform/kiosk/operator_view.h"

#include <stdio.h>
#include <string.h>

#include "core/base/panic.h"

/* Returns the length, at most `limit`, to which a long line is cut. The line is cut after its last
 * complete remark, which ends with ';', because the menu can translate only complete remarks. A
 * line without a ';' is cut at the end of a word. */
static size_t end_before(const char *line, size_t limit)
{
    for (size_t at = limit; at > 1u; at--) {
        if (line[at - 1u] == ';' && line[at] == ' ') {
            return at;
        }
    }
    while (limit > 0 && line[limit] != ' ') {
        limit--;
    }
    return limit;
}

static void copy_line(char *out, size_t out_size, const char *line)
{
    CORE_ASSERT(out_size > sizeof " ...");
    static const char more[] = " ...";
    line = line ? line : "";
    const size_t length = strlen(line);
    if (length < out_size) {
        memcpy(out, line, length + 1u);
        return;
    }
    const size_t kept = end_before(line, out_size - sizeof more);
    memcpy(out, line, kept);
    memcpy(out + kept, more, sizeof more);
}

/* Returns the row of the store. The state is read in each frame because the memory card may become
 * full while the kiosk runs. */
static struct scene_file store_row(const struct hal_storage *store)
{
    struct scene_file row = {
        .state = store->ledger.ops->is_healthy(store->ledger.self) &&
                         !store->edits.ops->has_failed(store->edits.self)
                     ? FILE_USED
                     : FILE_REFUSED,
    };
    copy_line(row.words, sizeof row.words, store->ledger.ops->describe(store->ledger.self));
    return row;
}

uint8_t operator_view_file_count(const struct operator_notes *notes)
{
    return (uint8_t)(1u + (notes ? notes->count + (notes->beyond > 0) : 0u));
}

void operator_view_lines_add(struct operator_view_lines *book, const struct button_sample *sample)
{
    book->raw = sample->raw;
    book->missing = sample->missing;
    for (uint32_t i = 0; i < HAL_LINE_COUNT; i++) {
        book->line[i].edges += sample->line[i].edges;
        book->line[i].faults += sample->line[i].faults;
    }
    for (uint32_t i = 0; i < COIN_LINE_COUNT; i++) {
        book->coins[i] += sample->coin_count[i];
    }
}

/* Copies the names of the controllers and the describe() text of each device. */
static void copy_texts(struct scene_devices *devices, const struct hal *hal)
{
    const struct hal_controllers *controllers = &hal->controllers;
    for (uint32_t i = 0; i < CONTROLLER_MAX; i++) {
        copy_line(devices->controller[i], sizeof devices->controller[i],
                  controllers->ops->name(controllers->self, i));
    }
    const char *const lines[ABOUT_COUNT] = {
        [ABOUT_DISPLAY] = hal->display.ops->describe(hal->display.self),
        [ABOUT_SOUND] = hal->audio.ops->describe(hal->audio.self),
        [ABOUT_STORE] = hal->storage.ledger.ops->describe(hal->storage.ledger.self),
        [ABOUT_CONTROLLERS] = controllers->ops->describe(controllers->self),
        [ABOUT_BUTTONS] = hal->buttons.ops->describe(hal->buttons.self),
        [ABOUT_SWITCHES] = hal->switches.ops->describe(hal->switches.self),
        [ABOUT_WATCHDOG] = hal->watchdog.ops->describe(hal->watchdog.self),
    };
    copy_line(devices->controllers, sizeof devices->controllers, lines[ABOUT_CONTROLLERS]);
    copy_line(devices->lines, sizeof devices->lines, lines[ABOUT_SWITCHES]);
    for (uint32_t i = 0; i < ABOUT_COUNT; i++) {
        copy_line(devices->about[i], sizeof devices->about[i], lines[i]);
    }
}

void operator_view_fill(struct scene *scene, const struct hal *hal,
                        const struct operator_view *operator_view)
{
    struct scene_devices *devices = &scene->devices;
    for (uint32_t i = 0; i < SCENE_LEADERBOARD_ROWS && scene->leaderboard.shown; i++) {
        struct scene_row *scored = &scene->leaderboard.row[i];
        scored->is_sealed = scored->caught > 0 && hal->storage.replays.ops->has(
                                                      hal->storage.replays.self, scored->round_id);
    }
    if (scene->phase != PHASE_MENU) {
        return;
    }
    devices->machine = *operator_view->machine;
    devices->update = operator_view->update ? *operator_view->update : (struct scene_update){ 0 };
    copy_texts(devices, hal);
    for (uint32_t i = 0; i < SCENE_FILE_MAX; i++) {
        const uint32_t row = scene->menu.file_first + i;
        struct scene_file *file = &scene->devices.file[i];
        *file = row == 0               ? store_row(&hal->storage)
                : operator_view->notes ? operator_notes_row(operator_view->notes, row - 1u)
                                       : (struct scene_file){ .state = FILE_UNKNOWN };
        if (file->state == FILE_ASIDE && devices->machine.is_checked &&
            devices->machine.quarantined == 0) {
            file->state = FILE_SEEN;
        }
    }
    for (uint32_t i = 0; i < POI_MAX; i++) {
        devices->axes[i] = (struct scene_axes){
            .link = operator_view->input->poi[i].link,
            .position_m = operator_view->input->poi[i].target.position_m,
            .angles = operator_view->input->poi[i].target.angles,
            .report_count = operator_view->samplers[i].pace.shown_count,
            .gap_ms = (float)operator_view->samplers[i].pace.shown_gap_ns * 1e-6f,
        };
    }
    devices->button_faults = operator_view->button_faults;
    devices->files_refused = operator_view->notes ? operator_view->notes->refused_count : 0u;
    const uint64_t frame_ns = operator_view->frame_ns;
    devices->frames_a_second =
        frame_ns > 0 ? (uint32_t)((1000000000ull + frame_ns / 2u) / frame_ns) : 0u;
    devices->line_raw = operator_view->lines->raw;
    devices->buttons_missing = operator_view->lines->missing;
    memcpy(devices->coins, operator_view->lines->coins, sizeof devices->coins);
    for (uint32_t i = 0; i < HAL_LINE_COUNT; i++) {
        devices->line[i] = (struct scene_line){ operator_view->lines->line[i].edges,
                                                operator_view->lines->line[i].faults };
    }
}

/* ---- Messages about files ------------------------------------------------------------------ */

/* `note` contains first the notes about files that were not used, then the notes about files that
 * were used. */

_Static_assert(OPERATOR_NOTES_MAX + 2u <= UINT8_MAX,
               "struct controller_status counts rows in a byte");

void operator_notes_add(struct operator_notes *notes, enum scene_file_state state, const char *name,
                        const char *words)
{
    CORE_ASSERT(notes->count <= OPERATOR_NOTES_MAX);
    CORE_ASSERT(notes->first_count <= notes->count);
    CORE_ASSERT(state == FILE_USED || state == FILE_REFUSED || state == FILE_ASIDE);
    if (notes->count == OPERATOR_NOTES_MAX) {
        notes->beyond++;
        return;
    }
    const uint32_t at = state == FILE_USED ? notes->count : notes->first_count++;
    notes->refused_count += state == FILE_REFUSED;
    struct scene_file *note = &notes->note[at];
    memmove(note + 1, note, (notes->count - at) * sizeof *note);
    notes->count++;
    note->state = (uint8_t)state;
    /* A path that is too long is cut at its beginning, because its end is more specific. */
    const size_t length = strlen(name), room = sizeof note->name - 1u;
    if (length <= room) {
        memcpy(note->name, name, length + 1u);
    } else {
        snprintf(note->name, sizeof note->name, "...%s", name + length - (room - 3u));
    }
    snprintf(note->words, sizeof note->words, "%s", words);
}

void operator_notes_refused(struct operator_notes *notes, const char *data, const char *line)
{
    char name[1024];
    const size_t length = strlen(data);
    const bool is_below = length > 0 && strncmp(line, data, length) == 0 && line[length] == '/';
    const char *from = is_below ? line + length + 1u : line;
    const char *gap = strstr(from, ": ");
    if (gap == NULL) {
        operator_notes_add(notes, FILE_REFUSED, "", line);
        return;
    }
    snprintf(name, sizeof name, "%.*s", (int)(gap - from), from);
    operator_notes_add(notes, FILE_REFUSED, name, gap + 2);
}

struct scene_file operator_notes_row(const struct operator_notes *notes, uint32_t row)
{
    CORE_ASSERT(notes->count <= OPERATOR_NOTES_MAX);
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
