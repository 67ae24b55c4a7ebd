/* operator_view.c -- copies the names and texts of the devices to the operator's menu; see
 * operator_view.h. */
#include "platform/kiosk/operator_view.h"

#include <string.h>

/* Returns the position, at most `limit`, at which a long line is cut. The line is cut after the
 * last remark that ends with ';', because the menu can translate only complete remarks. Without a
 * ';', the line is cut at the end of a word. */
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
    static const char more[] = " ...";
    size_t length = line ? strlen(line) : 0;
    if (length < out_size) {
        memcpy(out, line ? line : "", length);
        out[length] = 0;
        return;
    }
    length = end_before(line, out_size - sizeof more);
    memcpy(out, line, length);
    memcpy(out + length, more, sizeof more);
}

static void name_devices(struct scene_devices *devices, const struct hal *hal)
{
    const struct hal_controllers *controllers = &hal->controllers;
    for (uint32_t i = 0; i < CONTROLLER_MAX; i++) {
        copy_line(devices->controller[i], sizeof devices->controller[i],
                  controllers->ops->name(controllers->self, i));
    }
    copy_line(devices->controllers, sizeof devices->controllers,
              controllers->ops->describe(controllers->self));
    copy_line(devices->lines, sizeof devices->lines,
              hal->switches.ops->describe(hal->switches.self));
}

/* Returns the row of the store. The state is read in each frame because a card may become full
 * while the kiosk runs. */
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

static void name_files(struct scene *scene, const struct hal *hal, const struct file_notes *notes)
{
    const struct scene_machine *machine = &scene->devices.machine;
    for (uint32_t i = 0; i < SCENE_FILE_MAX; i++) {
        const uint32_t row = scene->menu.file_first + i;
        struct scene_file *file = &scene->devices.file[i];
        *file = row == 0 ? store_row(&hal->storage)
                : notes  ? file_notes_row(notes, row - 1u)
                         : (struct scene_file){ .state = FILE_UNKNOWN };
        if (file->state == FILE_ASIDE && machine->has_looked && machine->aside == 0) {
            file->state = FILE_SEEN;
        }
    }
}

uint8_t operator_view_file_count(const struct file_notes *notes)
{
    return (uint8_t)(1u + (notes ? file_notes_rows(notes) : 0u));
}

/* Copies the describe() text of each device. */
static void tell_about(struct scene_devices *devices, const struct hal *hal)
{
    const char *const lines[ABOUT_COUNT] = {
        [ABOUT_DISPLAY] = hal->display.ops->describe(hal->display.self),
        [ABOUT_SOUND] = hal->audio.ops->describe(hal->audio.self),
        [ABOUT_STORE] = hal->storage.ledger.ops->describe(hal->storage.ledger.self),
        [ABOUT_CONTROLLERS] = hal->controllers.ops->describe(hal->controllers.self),
        [ABOUT_BUTTONS] = hal->buttons.ops->describe(hal->buttons.self),
        [ABOUT_SWITCHES] = hal->switches.ops->describe(hal->switches.self),
        [ABOUT_WATCHDOG] = hal->watchdog.ops->describe(hal->watchdog.self),
    };
    for (uint32_t i = 0; i < ABOUT_COUNT; i++) {
        copy_line(devices->about[i], sizeof devices->about[i], lines[i]);
    }
}

static struct scene_axes axes_of(const struct poi_input *says, const struct poi_sampler *hand)
{
    return (struct scene_axes){
        .link = says->link,
        .position_m = says->target.position_m,
        .angles = says->target.angles,
        .report_count = hand->pace.shown_count,
        .gap_ms = (float)hand->pace.shown_gap_ns * 1e-6f,
    };
}

static void seal_scores(struct scene_leaderboard *board, const struct hal_storage *store)
{
    for (uint32_t i = 0; i < SCENE_LEADERBOARD_ROWS && board->shown; i++) {
        struct scene_row *row = &board->row[i];
        row->is_sealed =
            row->caught > 0 && store->replays.ops->has(store->replays.self, row->round_id);
    }
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

static void tell_lines(struct scene_devices *devices, const struct operator_view_lines *book)
{
    devices->line_raw = book->raw;
    devices->buttons_missing = book->missing;
    memcpy(devices->coins, book->coins, sizeof devices->coins);
    for (uint32_t i = 0; i < HAL_LINE_COUNT; i++) {
        devices->line[i] = (struct scene_line){ book->line[i].edges, book->line[i].faults };
    }
}

static uint32_t frames_a_second(uint64_t frame_ns)
{
    return frame_ns > 0 ? (uint32_t)((1000000000ull + frame_ns / 2u) / frame_ns) : 0u;
}

void operator_view_fill(struct scene *scene, const struct hal *hal,
                        const struct operator_view *operator_view)
{
    struct scene_devices *devices = &scene->devices;
    seal_scores(&scene->leaderboard, &hal->storage);
    if (scene->phase != PHASE_MENU) {
        return;
    }
    devices->machine = *operator_view->machine;
    name_devices(devices, hal);
    name_files(scene, hal, operator_view->notes);
    tell_about(devices, hal);
    for (uint32_t i = 0; i < POI_MAX; i++) {
        devices->axes[i] = axes_of(&operator_view->input->poi[i], &operator_view->hands[i]);
    }
    devices->button_faults = operator_view->button_faults;
    devices->files_refused = operator_view->notes ? operator_view->notes->refused_count : 0u;
    devices->frames_a_second = frames_a_second(operator_view->frame_ns);
    tell_lines(devices, operator_view->lines);
}
