/* status_text.c -- formats a status report as JSON; see status.h. */
#include "platform/kiosk/status.h"

#include "platform/os/json.h"
#include "platform/panic_count.h"

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

static void put_stall(struct json *json, const struct status_report *report)
{
    const struct balance *balance = &report->balance;
    json_line(json, 2);
    json_text(json, "version", KINGYO_VERSION);
    json_line(json, 2);
    json_value(json, "pid", "%u", report->pid);
    json_line(json, 2);
    json_value(json, "written_ms", "%llu", (unsigned long long)report->written_ms);
    json_line(json, 2);
    json_value(json, "up_s", "%u", report->up_s);
    json_line(json, 2);
    json_value(json, "boot", "%u", report->boot);
    json_line(json, 2);
    json_text(json, "phase", phase_name(report->phase));
    json_line(json, 2);
    json_value(json, "players", "%u", report->players);
    json_line(json, 2);
    json_open(json, "credits", '{');
    json_value(json, "paid", "%u", balance->paid);
    json_value(json, "service", "%u", balance->service);
    json_value(json, "units", "%u", balance->units);
    json_value(json, "untold", "%u", balance->unlogged);
    json_bool(json, "round_open", balance->open != PAYMENT_NONE);
    json_close(json, '}');
    json_line(json, 2);
    json_open(json, "tickets", '{');
    json_value(json, "owed", "%u", balance->tickets);
    json_value(json, "dispensed", "%u", report->tickets_out);
    json_close(json, '}');
    json_line(json, 2);
    json_open(json, "store", '{');
    json_bool(json, "well", report->store_well);
    json_value(json, "entry_id", "%u", report->entry_id);
    json_value(json, "saved_id", "%u", report->saved_id);
    json_value(json, "waiting", "%u", report->entry_id - report->saved_id);
    json_close(json, '}');
}

static void put_figures(struct json *json, const struct status_report *report)
{
    const struct kiosk_faults *faults = &report->faults;
    json_line(json, 2);
    json_open(json, "frames", '{');
    json_value(json, "count", "%llu", (unsigned long long)report->frames);
    json_value(json, "median_ms", "%.1f", (double)report->frame_median_ns * 1e-6);
    json_value(json, "p99_ms", "%.1f", (double)report->frame_p99_ns * 1e-6);
    json_close(json, '}');
    json_line(json, 2);
    json_open(json, "ticks", '{');
    json_value(json, "count", "%u", report->ticks);
    json_value(json, "dropped", "%llu", (unsigned long long)report->dropped_ticks);
    json_close(json, '}');
    json_line(json, 2);
    json_open(json, "faults", '{');
    json_value(json, "poi", "%u", faults->poi);
    json_value(json, "fan", "%u", faults->shade);
    json_value(json, "display", "%u", faults->display);
    json_value(json, "sound", "%u", faults->audio);
    json_value(json, "store", "%u", faults->storage);
    json_value(json, "buttons", "%u", faults->buttons);
    json_value(json, "switches", "%u", faults->switches);
    json_value(json, "buttons_missing", "%d", __builtin_popcount(report->buttons_missing));
    json_value(json, "float", "%u", report->float_resets);
    json_close(json, '}');
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
static void put_known(struct json *json, const char *name, int is_known, int64_t value)
{
    if (is_known) {
        json_value(json, name, "%lld", (long long)value);
    } else {
        json_value(json, name, "null");
    }
}

/* Writes the values that the page "ready for opening" of the operator's menu shows. */
static void put_machine(struct json *json, const struct status_report *report)
{
    const struct scene_machine *machine = &report->machine;
    json_line(json, 2);
    json_open(json, "machine", '{');
    json_text(json, "data", keeps_name(machine->keeps));
    put_known(json, "backup_min", machine->has_backup, machine->backup_min);
    put_known(json, "free_mib", machine->has_looked, machine->room_mib);
    put_known(json, "heat_margin_c", machine->has_heat, machine->heat_margin_c);
    json_text(json, "watchdog", watch_name(machine->watch));
    put_known(json, "clock_day", report->day != 0, report->day);
    put_known(json, "clock_minute", report->day != 0, report->minute);
    json_bool(json, "clock_went_back", machine->is_clock_back);
    json_close(json, '}');
    json_line(json, 2);
    json_open(json, "files", '{');
    json_value(json, "refused", "%u", report->files_refused);
    json_value(json, "set_aside", "%u", machine->aside);
    json_value(json, "replays_missed", "%u", machine->missed);
    json_close(json, '}');
    json_line(json, 2);
    json_open(json, "panics", '{');
    json_value(json, "count", "%u", machine->panics);
    json_text(json, "left_out", panics_left_name(machine->left_out));
    json_close(json, '}');
}

size_t status_format(const struct status_report *report, char out[STATUS_TEXT_MAX])
{
    struct json json = { .buffer = out, .size = STATUS_TEXT_MAX };
    json_open(&json, NULL, '{');
    put_stall(&json, report);
    put_figures(&json, report);
    put_machine(&json, report);
    json_line(&json, 2);
    json_open(&json, "devices", '[');
    for (uint32_t i = 0; i < report->device_count; i++) {
        json_line(&json, 4);
        json_open(&json, NULL, '{');
        json_text(&json, "part", report->device[i].part);
        json_text(&json, "text", report->device[i].text);
        json_close(&json, '}');
    }
    json_line(&json, 2);
    json_close(&json, ']');
    json_line(&json, 0);
    json_close(&json, '}');
    json_end(&json);
    return json.used;
}
