/* status_text.c -- formats a status report as JSON; see status.h. */
#include "platform/kiosk/status.h"

#include <assert.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "platform/os/json_char.h"
#include "platform/panic_count.h"

struct text_out {
    char *out;
    size_t used;
};

__attribute__((format(printf, 2, 3))) static void status_text_put(struct text_out *text,
                                                                  const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    const int length =
        vsnprintf(text->out + text->used, STATUS_TEXT_MAX - text->used, format, arguments);
    va_end(arguments);
    text->used += (size_t)length;
    assert(text->used < STATUS_TEXT_MAX);
}

static void put_string(struct text_out *text, const char *words)
{
    char one[JSON_CHAR_SIZE];
    status_text_put(text, "\"");
    while (*words) {
        words = json_char(words, one);
        status_text_put(text, "%s", one);
    }
    status_text_put(text, "\"");
}

static const char *phase_name(uint8_t phase)
{
    static const char *const names[] = {
        [PHASE_ATTRACT] = "attract",   [PHASE_READY] = "ready",        [PHASE_ROUND] = "round",
        [PHASE_RESULT] = "result",     [PHASE_MODE_SELECT] = "choose", [PHASE_LAB] = "lab",
        [PHASE_ALBUM] = "album",       [PHASE_MENU] = "menu",          [PHASE_NAME] = "name",
        [PHASE_LEADERBOARD] = "board",
    };
    const int is_known = phase < sizeof names / sizeof names[0] && names[phase];
    return is_known ? names[phase] : "other";
}

static const char *boolean(int is_so)
{
    return is_so ? "true" : "false";
}

static void put_stall(struct text_out *text, const struct status_report *report)
{
    const struct balance *balance = &report->balance;
    status_text_put(text,
                    "  \"version\": \"" KINGYO_VERSION
                    "\",\n  \"pid\": %u,\n  \"written_ms\": %llu,\n"
                    "  \"up_s\": %u,\n  \"boot\": %u,\n  \"phase\": \"%s\",\n  \"players\": %u,\n",
                    report->pid, (unsigned long long)report->written_ms, report->up_s, report->boot,
                    phase_name(report->phase), report->players);
    status_text_put(text,
                    "  \"credits\": {\"paid\": %u, \"service\": %u, \"units\": %u, \"untold\": %u, "
                    "\"round_open\": %s},\n",
                    balance->paid, balance->service, balance->units, balance->unlogged,
                    boolean(balance->open != PAYMENT_NONE));
    status_text_put(text, "  \"tickets\": {\"owed\": %u, \"dispensed\": %u},\n", balance->tickets,
                    report->tickets_out);
    status_text_put(
        text, "  \"store\": {\"well\": %s, \"entry_id\": %u, \"saved_id\": %u, \"waiting\": %u},\n",
        boolean(report->store_well), report->entry_id, report->saved_id,
        report->entry_id - report->saved_id);
}

static void put_figures(struct text_out *text, const struct status_report *report)
{
    const struct kiosk_faults *faults = &report->faults;
    status_text_put(text,
                    "  \"frames\": {\"count\": %llu, \"median_ms\": %.1f, \"p99_ms\": %.1f},\n"
                    "  \"ticks\": {\"count\": %u, \"dropped\": %llu},\n",
                    (unsigned long long)report->frames, (double)report->frame_median_ns * 1e-6,
                    (double)report->frame_p99_ns * 1e-6, report->ticks,
                    (unsigned long long)report->dropped_ticks);
    status_text_put(text,
                    "  \"faults\": {\"poi\": %u, \"fan\": %u, \"display\": %u, \"sound\": %u, "
                    "\"store\": %u, \"buttons\": %u, \"switches\": %u, \"buttons_missing\": %u, "
                    "\"float\": %u},\n",
                    faults->poi, faults->shade, faults->display, faults->audio, faults->storage,
                    faults->buttons, faults->switches,
                    (unsigned)__builtin_popcount(report->buttons_missing), report->float_resets);
}

static const char *keeps_name(uint8_t keeps)
{
    static const char *const names[] = {
        [KEEPS_UNKNOWN] = "unknown", [KEEPS_PROVEN] = "proven", [KEEPS_FOLDER] = "folder",
        [KEEPS_MEMORY] = "memory",   [KEEPS_NOT] = "not",       [KEEPS_NOWHERE] = "nowhere",
    };
    return keeps < sizeof names / sizeof names[0] ? names[keeps] : "unknown";
}

static const char *watch_name(uint8_t watch)
{
    static const char *const names[] = { [WATCH_NONE] = "none",
                                         [WATCH_NO_LIMIT] = "no-limit",
                                         [WATCH_FED] = "fed",
                                         [WATCH_DEAF] = "deaf" };
    return watch < sizeof names / sizeof names[0] ? names[watch] : "none";
}

/* Writes `name` and a number, or null if the value is unknown. */
static void put_known(struct text_out *text, const char *name, int is_known, int64_t value)
{
    if (is_known) {
        status_text_put(text, "\"%s\": %lld", name, (long long)value);
    } else {
        status_text_put(text, "\"%s\": null", name);
    }
}

/* Writes the values that the page "ready for opening" of the operator's menu shows. */
static void put_machine(struct text_out *text, const struct status_report *report)
{
    const struct scene_machine *machine = &report->machine;
    status_text_put(text, "  \"machine\": {\"data\": \"%s\", ", keeps_name(machine->keeps));
    put_known(text, "backup_min", machine->has_backup, machine->backup_min);
    status_text_put(text, ", ");
    put_known(text, "free_mib", machine->has_looked, machine->room_mib);
    status_text_put(text, ", ");
    put_known(text, "heat_margin_c", machine->has_heat, machine->heat_margin_c);
    status_text_put(text, ", \"watchdog\": \"%s\", ", watch_name(machine->watch));
    put_known(text, "clock_day", report->day != 0, report->day);
    status_text_put(text, ", ");
    put_known(text, "clock_minute", report->day != 0, report->minute);
    status_text_put(text, ", \"clock_went_back\": %s},\n", boolean(machine->is_clock_back));
    status_text_put(text,
                    "  \"files\": {\"refused\": %u, \"set_aside\": %u, \"replays_missed\": %u},\n",
                    report->files_refused, machine->aside, machine->missed);
    status_text_put(text, "  \"panics\": {\"count\": %u, \"left_out\": \"%s\"},\n", machine->panics,
                    panics_left_name(machine->left_out));
}

size_t status_format(const struct status_report *report, char out[STATUS_TEXT_MAX])
{
    struct text_out text = { .out = out };
    status_text_put(&text, "{\n");
    put_stall(&text, report);
    put_figures(&text, report);
    put_machine(&text, report);
    status_text_put(&text, "  \"devices\": [");
    for (uint32_t i = 0; i < report->device_count; i++) {
        status_text_put(&text, "%s\n    {\"part\": \"%s\", \"text\": ", i ? "," : "",
                        report->device[i].part);
        put_string(&text, report->device[i].text);
        status_text_put(&text, "}");
    }
    status_text_put(&text, "\n  ]\n}\n");
    return text.used;
}
