/* null.c -- implements the null drivers, which do nothing and report HAL_ERR_ABSENT. */
#include "drivers/null.h"

#include "core/base/panic.h"

/* A null driver ignores the arguments of most of its functions. */
#pragma GCC diagnostic ignored "-Wunused-parameter"

/* Returns the description, which is the `self` pointer of every null device. The text is never
 * written. */
static const char *null_describe(void *self)
{
    CORE_ASSERT(self);
    return self;
}

/* Defines the function `name`, which ignores its parameters and returns `result`. */
#define RETURNS(type, name, result, parameters)                                                    \
    static type name parameters                                                                    \
    {                                                                                              \
        return result;                                                                             \
    }
#define ABSENT(name, parameters) RETURNS(int, name, HAL_ERR_ABSENT, parameters)
/* Defines the function `name`, which fills `*out` with zeros and returns HAL_ERR_ABSENT. */
#define ABSENT_SAMPLE(name, type)                                                                  \
    static int name(void *self, struct type *out)                                                  \
    {                                                                                              \
        CORE_ASSERT(out);                                                                          \
        *out = (struct type){ 0 };                                                                 \
        return HAL_ERR_ABSENT;                                                                     \
    }

/* clang-format off */
ABSENT(null_open, (void *self))
ABSENT_SAMPLE(null_display_poll, display_events)
ABSENT(null_present, (void *self, const struct scene *scene))
ABSENT(null_capture, (void *self, struct hal_image *image))
ABSENT(null_poi_poll, (void *self, struct poi_sample *out, uint32_t max))
ABSENT(null_set_force, (void *self, const struct poi_force *force))
ABSENT(null_shade_poll, (void *self, struct shade_input *out))
ABSENT_SAMPLE(null_buttons_poll, button_sample)
ABSENT(null_set, (void *self, enum hal_switch which, bool active))
ABSENT(null_pulse, (void *self, enum hal_switch which, uint32_t count))
ABSENT_SAMPLE(null_controllers_poll, controller_status)
ABSENT(null_command, (void *self, const struct controller_command *order))
ABSENT(null_play, (void *self, const struct sound_event *event))
ABSENT(null_load, (void *self, struct persistent_state *out))
ABSENT(null_append, (void *self, const struct ledger_entry *entry))
ABSENT(null_store_replay, (void *self, uint32_t round_id, const uint8_t *bytes, size_t size))
ABSENT(null_fetch_replay, (void *self, uint32_t round_id, uint8_t *bytes, size_t size,
                           struct ledger_entry *round))
ABSENT(null_store_edit, (void *self, const struct graph_edit_record *edit))
ABSENT(null_merge_offline, (void *self, const struct balance_change *step,
                            const struct ledger_entry *entries, uint32_t count))
RETURNS(uint32_t, null_arrange, 0, (void *self, bool may_move))
RETURNS(uint32_t, null_pending, 0, (void *self, enum hal_switch which))
RETURNS(const char *, null_name, "", (void *self, uint32_t row))
RETURNS(bool, null_has_replay, false, (void *self, uint32_t round_id))
RETURNS(bool, null_edits_failed, true, (void *self))
RETURNS(bool, null_is_healthy, false, (void *self))
/* The null storage uses this function for ids and counts. These are always 0, because the null
 * storage never stores, refuses or queues an entry. */
RETURNS(uint32_t, null_none, 0, (void *self))
RETURNS(uint8_t, null_watches, WATCH_NONE, (void *self))
RETURNS(uint64_t, null_now_ns, 0, (void *self))
/* clang-format on */

static void null_close(void *self)
{
}

static void null_set_transform(void *self, const struct display_settings *display_settings)
{
}

static void null_set_levels(void *self, const struct sound_levels *levels)
{
}

static void null_set_view(void *self, const struct view *view,
                          const struct display_settings *display_settings, bool scoops)
{
}

static const struct hal_display_ops display_ops = {
    .open = null_open,
    .poll = null_display_poll,
    .present = null_present,
    .set_transform = null_set_transform,
    .toggle_full_screen = null_open,
    .capture = null_capture,
    .close = null_close,
    .describe = null_describe,
};

static const struct hal_poi_ops poi_ops = {
    .open = null_open,
    .poll = null_poi_poll,
    .set_force = null_set_force,
    .set_view = null_set_view,
    .describe = null_describe,
};

static const struct hal_fan_ops fan_ops = {
    .open = null_open,
    .poll = null_shade_poll,
    .describe = null_describe,
};

static const struct hal_slots_ops slots_ops = { .arrange = null_arrange };

static const struct hal_buttons_ops buttons_ops = {
    .poll = null_buttons_poll,
    .describe = null_describe,
};

static const struct hal_switches_ops switches_ops = {
    .set = null_set,
    .pulse = null_pulse,
    .pending = null_pending,
    .describe = null_describe,
};

static const struct hal_controllers_ops controllers_ops = {
    .poll = null_controllers_poll,
    .name = null_name,
    .command = null_command,
    .describe = null_describe,
};

static const struct hal_audio_ops audio_ops = {
    .open = null_open,
    .play = null_play,
    .set_levels = null_set_levels,
    .describe = null_describe,
    .close = null_close,
};

static const struct hal_ledger_ops ledger_ops = {
    .open = null_open,
    .load = null_load,
    .append = null_append,
    .committed_id = null_none,
    .failed_count = null_none,
    .is_healthy = null_is_healthy,
    .needs_restart = null_is_healthy,
    .merge_offline = null_merge_offline,
    .offline_merged = null_open,
    .describe = null_describe,
    .close = null_none,
};

static const struct hal_replay_store_ops replay_store_ops = {
    .store = null_store_replay,
    .stored_id = null_none,
    .fetch = null_fetch_replay,
    .fetched = null_open,
    .has = null_has_replay,
};

static const struct hal_edit_store_ops edit_store_ops = {
    .store = null_store_edit,
    .stored_id = null_none,
    .has_failed = null_edits_failed,
};

static const struct hal_watchdog_ops watchdog_ops = {
    .kick = null_close,
    .watches = null_watches,
    .describe = null_describe,
};

static const struct hal_clock_ops clock_ops = { .now_ns = null_now_ns };

struct hal null_hal(const char *line)
{
    void *self = (void *)(uintptr_t)(line ? line : "");
    struct hal hal = {
        .clock = { .ops = &clock_ops },
        .display = { &display_ops, self },
        .slots = { .ops = &slots_ops },
        .buttons = { &buttons_ops, self },
        .switches = { &switches_ops, self },
        .controllers = { &controllers_ops, self },
        .audio = { &audio_ops, self },
        .storage = { .ledger = { &ledger_ops, self },
                     .replays = { &replay_store_ops, self },
                     .edits = { &edit_store_ops, self } },
        .watchdog = { &watchdog_ops, self },
    };
    for (uint32_t i = 0; i < POI_MAX; i++) {
        hal.poi[i] = (struct hal_poi){ &poi_ops, self };
    }
    for (uint32_t i = 0; i < SHADE_MAX; i++) {
        hal.fan[i] = (struct hal_fan){ &fan_ops, self };
    }
    return hal;
}
