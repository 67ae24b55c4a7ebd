/* run_common.c -- starts and ends the recording, the replay and the pictures of the frame loop; see
 * run_common.h. */
#include "platform/kiosk/run_common.h"

#include <dirent.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/panic.h"
#include "platform/cpu.h"
#include "platform/os/file.h"
#include "platform/os/log.h"
#include "platform/os/png.h"
#include "platform/os/print.h"
#include "platform/store/graph_file.h"

enum exit_code run_common_check(struct run_common *session)
{
    struct replay_reader *reader = &session->replayer.reader;
    const char *path = session->options.replay;
    if (path[0] && replay_scan(reader, path, &session->replayed)) {
        return replayer_print_problem("kingyo", path, &reader->problem);
    }
    return EXIT_OK;
}

void run_common_note_refused(void *self, const char *line)
{
    struct run_common *session = self;
    operator_notes_refused(&session->notes, session->options.data, line);
}

/* Reports a rejected line of a graph file in the log, in the operator's menu and in the growth lab
 * (the mode in which growth curves of the fish are edited). */
static void run_common_warn(void *context, const char *line)
{
    struct run_common *session = context;
    const size_t folder = strlen(session->options.data) + 1u;
    log_print(LOG_LEVEL_WARNING, "%s", line);
    run_common_note_refused(session, line);
    library_note_graph(&session->library, line + (folder < strlen(line) ? folder : 0u));
}

/* Returns the text that describes a quarantined file in the log and in the operator's menu. */
static const char *quarantine_words(const char *data, const char *name)
{
    static const char *const words[] = {
        [SYSTEM_HEALTH_QUARANTINE_DAMAGED] =
            "damaged, and set aside: what could be read took its place",
        [SYSTEM_HEALTH_QUARANTINE_MISSING] = "was missing: what could be read took its place",
        [SYSTEM_HEALTH_QUARANTINE_LEFT] =
            "a copy from before a part was left out, because of panics",
        [SYSTEM_HEALTH_QUARANTINE_OTHER] =
            "of another list or damaged, and set aside: nothing was read from it",
    };
    char path[PATH_MAX + 1u];
    const enum system_health_quarantine kind = system_health_quarantine_of(name);
    const int length = snprintf(path, sizeof path, "%s/%s", data, name);
    const bool has_path = length > 0 && (size_t)length < sizeof path;
    return kind == SYSTEM_HEALTH_QUARANTINE_OTHER && has_path && file_is_other(path)
               ? "was not a regular file, and was set aside"
               : words[kind];
}

/* Adds the quarantined files to the operator's messages, and logs the files that the operator has
 * not acknowledged. The messages remain after an acknowledgement, but the warning on the menu page
 * "ready for opening" disappears. */
static void note_damaged(struct run_common *session)
{
    DIR *folder = session->options.data[0] ? opendir(session->options.data) : NULL;
    const struct dirent *entry;
    while (folder && (entry = readdir(folder))) {
        const enum system_health_quarantine kind = system_health_quarantine_of(entry->d_name);
        if (kind != SYSTEM_HEALTH_QUARANTINE_NONE) {
            const char *words = quarantine_words(session->options.data, entry->d_name);
            if (!system_health_is_seen(session->options.data, entry->d_name)) {
                log_print(LOG_LEVEL_WARNING, "%s/%s: %s", session->options.data, entry->d_name,
                          words);
            }
            operator_notes_add(&session->notes, FILE_ASIDE, entry->d_name, words);
        }
    }
    if (folder) {
        closedir(folder);
    }
}

/* Fills the growth lab's catalog with the installed species, and loads the saved growth graphs. */
static void load_species(struct run_common *session, struct lab_book *book)
{
    book->card_count = (uint8_t)session->library.species_count;
    for (uint32_t i = 0; i < session->library.species_count; i++) {
        book->cards[i] = session->library.slots[i].species.card;
    }
    uint32_t rejected = session->library.unread_count;
    for (uint32_t i = 0; i < session->library.line_count; i++) {
        rejected += session->library.lines[i].slot == LIBRARY_SLOT_NONE;
    }
    book->refused = (uint8_t)(rejected < UINT8_MAX ? rejected : UINT8_MAX);
    graph_file_load(session->options.data, book,
                    (struct graph_file_warn){ run_common_warn, session });
    char name[sizeof GRAPH_FILE_FOLDER + SPECIES_NAME_SIZE + sizeof GRAPH_FILE_SUFFIX];
    for (uint32_t i = 0; i < lab_book_count(book); i++) {
        if (book->has_edit[i]) {
            const char *id = lab_book_card(book, i)->id;
            snprintf(name, sizeof name, GRAPH_FILE_FOLDER "/%.*s" GRAPH_FILE_SUFFIX,
                     (int)SPECIES_NAME_SIZE, id);
            operator_notes_add(&session->notes, FILE_USED, name, id);
        }
    }
}

enum exit_code run_common_begin(struct run_common *session, struct kiosk_config *config)
{
    const char *record = session->options.record;
    const char *replay = session->options.replay;
    if (replay[0]) {
        if (replayer_begin(&session->replayer, replay, &config->core)) {
            return replayer_print_problem("kingyo", replay, &session->replayer.reader.problem);
        }
        config->source = replayer_source(&session->replayer);
        config->tap = replayer_tap(&session->replayer);
    } else if (record[0]) {
        config->tap = recorder_tap(&session->recorder);
    }
    config->core.lanes = cpu_lanes();
    library_fill(&session->library, session->options.data);
    const struct library *library = &session->library;
    char words[SCENE_LINE_SIZE];
    for (uint32_t i = 0; i < library->line_count; i++) {
        const struct library_line *line = &library->lines[i];
        const bool is_used = line->slot != LIBRARY_SLOT_NONE;
        operator_notes_add(&session->notes, is_used ? FILE_USED : FILE_REFUSED, line->file,
                           is_used ? library->slots[line->slot].species.card.id : line->why);
    }
    if (library->unread_count > 0) {
        snprintf(words, sizeof words, "%u more files, and no room for them", library->unread_count);
        operator_notes_add(&session->notes, FILE_REFUSED, LIBRARY_FOLDER, words);
    }
    note_damaged(session);
    config->notes = &session->notes;
    config->machine = &session->machine;
    if (!replay[0]) {
        config->sessions = &session->sessions;
        config->playback = &session->playback;
        update_link_begin(&session->update, getenv("RUNTIME_DIRECTORY"), UPDATE_LINK_STATUS);
        config->update = &session->update;
        load_species(session, &config->core.book);
    }
    const enum core_error refused = kiosk_init(&session->kiosk, &session->hal, config);
    if (refused == CORE_ERR_FLOAT) {
        return run_common_print_float();
    }
    if (refused != CORE_OK) {
        log_print(LOG_LEVEL_ERROR, "%s: the preset, the number of fish or the time is out of range",
                  replay[0] ? replay : "options");
        return replay[0] ? EXIT_BAD_DATA : EXIT_USAGE;
    }
    const int error =
        record[0] ? recorder_begin(&session->recorder, record, &session->kiosk.core) : 0;
    if (error) {
        return log_fail(EXIT_IO, LOG_LEVEL_ERROR, "%s: cannot record: %s", record,
                        strerror(-error));
    }
    session->machine.data = session->options.data;
    system_health_start(&session->machine);
    return EXIT_OK;
}

enum exit_code run_common_print_float(void)
{
    return log_fail(EXIT_NOT_SO, LOG_LEVEL_CRITICAL, "the kiosk stops: " CPU_FLOAT_WRONG);
}

void run_common_print_library(const struct run_common *session)
{
    const struct library *library = &session->library;
    const char *data = session->options.data;
    for (uint32_t i = 0; i < library->line_count; i++) {
        const struct library_line *line = &library->lines[i];
        if (line->slot != LIBRARY_SLOT_NONE) {
            print_line(stdout, "  %-9s %s: %s", "species", line->file,
                       library->slots[line->slot].species.card.id);
        } else {
            log_print(LOG_LEVEL_WARNING, "%s/%s: %s", data, line->file, line->why);
        }
    }
    if (library->unread_count > 0) {
        log_print(LOG_LEVEL_WARNING, "%s/" LIBRARY_FOLDER ": %u more files, and no room for them",
                  data, library->unread_count);
    }
}

enum exit_code run_common_end(struct run_common *session)
{
    system_health_stop(&session->machine);
    update_link_end(&session->update);
    free(session->rgb);
    session->rgb = NULL;
    const char *record = session->options.record, *replay = session->options.replay;
    if (record[0]) {
        const int error = recorder_end(&session->recorder);
        const uint32_t ticks = session->recorder.writer.saved.ticks;
        if (error) {
            return log_fail(EXIT_IO, LOG_LEVEL_ERROR, "%s: recording stopped after %u s: %s",
                            record, ticks / CORE_TICK_HZ, strerror(-error));
        }
        print_line(stdout, "recorded %.1f s to %s", (double)ticks / CORE_TICK_HZ, record);
    } else if (replay[0]) {
        struct replayer *replayer = &session->replayer;
        const uint32_t ticks = replayer->totals.ticks;
        replayer_end(replayer);
        if (replayer->damaged) {
            return replayer_print_problem("kingyo", replay, &replayer->reader.problem);
        }
        if (replayer->difference.found) {
            return log_fail(EXIT_NOT_SO, LOG_LEVEL_ERROR,
                            "%s: the simulation differs from the recording from tick %u on; "
                            "'kingyoctl replay verify' shows the difference",
                            replay, replayer->difference.tick);
        }
        print_line(stdout, "replayed %u of %u ticks (%.1f s) of %s, each as recorded", ticks,
                   session->replayed.ticks, (double)ticks / CORE_TICK_HZ, replay);
    }
    return EXIT_OK;
}

/* ---- Folders and pictures ------------------------------------------------------------------ */

enum exit_code run_common_make_folder(const char *path)
{
    const int error = file_make_folder(path);
    if (error) {
        return log_fail(EXIT_IO, LOG_LEVEL_ERROR, "%s: cannot write to the folder: %s", path,
                        strerror(-error));
    }
    return EXIT_OK;
}

enum exit_code run_common_make_room(struct run_common *session, uint32_t width, uint32_t height)
{
    CORE_ASSERT(width > 0 && height > 0);
    free(session->rgb);
    session->rgb_size = (size_t)width * height * 3;
    session->rgb = malloc(session->rgb_size);
    if (!session->rgb) {
        session->rgb_size = 0;
        return log_fail(EXIT_NOT_SO, LOG_LEVEL_ERROR, "no memory for pictures of %ux%u", width,
                        height);
    }
    return EXIT_OK;
}

static int capture_display_image(struct run_common *session, struct hal_image *image)
{
    const struct hal_display *display = &session->hal.display;
    *image = (struct hal_image){ .rgb = session->rgb, .size = session->rgb_size };
    return display->ops->capture(display->self, image);
}

int run_common_shot(struct run_common *session, const char *path, struct hal_image *image)
{
    int result = capture_display_image(session, image);
    const size_t needed = (size_t)image->width * image->height * 3;
    /* The window has become larger since the last picture, so the buffer is enlarged. */
    if (result != HAL_OK && needed > session->rgb_size) {
        result = run_common_make_room(session, image->width, image->height) == EXIT_OK
                     ? capture_display_image(session, image)
                     : HAL_ERR_IO;
    }
    if (result != HAL_OK) {
        log_print(LOG_LEVEL_ERROR, "the display returned no picture");
        return -1;
    }
    const int error = path ? png_write(path, image->rgb, image->width, image->height) : 0;
    if (error) {
        log_print(LOG_LEVEL_ERROR, "%s: cannot write: %s", path, strerror(-error));
    }
    return error ? -1 : 0;
}
