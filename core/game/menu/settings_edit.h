/* settings_edit.h -- changes of settings while the kiosk runs. A change takes effect at once and is
 * logged in the ledger when the value has not changed for a while.
 *
 * A caller (a page of the operator's menu, calibration) only calls settings_edit_set(). A later
 * settings_edit_tick() logs each value that the ledger does not have yet. Neither a full ring nor a
 * quickly closed menu can therefore lose a setting. A knob turned through twenty values produces
 * one entry. */
#ifndef KINGYO_CORE_GAME_MENU_SETTINGS_EDIT_H
#define KINGYO_CORE_GAME_MENU_SETTINGS_EDIT_H

#include <stdint.h>

#include "core/output.h"
#include "core/settings.h"

/* Ticks without a change after which a setting is logged. */
#define SETTINGS_EDIT_REST_TICKS (CORE_TICK_HZ / 2u)

struct settings_edit {
    struct settings told; /* The settings as logged in the ledger. */
    uint32_t turn_tick;   /* Tick of the last change. */
    uint32_t entry_id;    /* Id of the newest entry that logged a setting; 0: none in this run. */
    uint32_t pin_wrong;   /* Number of wrong PINs in a row, 0 .. 255. */
    uint32_t pin_tick;    /* Tick of the last wrong PIN, or of the kiosk's start if wrong PINs were
                             stored. The field is here and not in struct menu, because a closed menu
                             loses its state. */
};

struct game;
struct ledger;
struct core_config;

/* Initializes `settings_edit`: the settings in `config`, with invalid values replaced, count as
 * logged. */
void settings_edit_init(struct settings_edit *settings_edit, const struct core_config *config);

/* Returns the highest value that setting `id` can have in this kiosk. The fish count is limited by
 * the capacity of the tank. */
int32_t settings_edit_max(const struct core_config *config, uint32_t id);

/* Sets setting `id` to `value`, which settings_allows() and settings_edit_max() must permit. A new
 * number of fish or players takes effect at the next attract mode. */
void settings_edit_set(struct game *game, struct core_config *config, uint32_t id, int32_t value);

/* Moves setting `id` up or down by `step_count` steps, at most to the end of its range. A step from
 * the end leads to the opposite end. Returns 1 if the value is at the end, else 0. */
int settings_edit_step(struct game *game, struct core_config *config, uint32_t id, int is_down,
                       uint32_t step_count);

/* Resets every setting to its default, empties the balance, and logs both in one entry. Returns 1,
 * or 0 without any change if the ledger ring has no room. */
int settings_edit_factory_reset(struct game *game, struct core_config *config,
                                struct output *output);

/* Logs changed settings that have not changed for SETTINGS_EDIT_REST_TICKS. Call once per tick in
 * every phase. */
void settings_edit_tick(struct game *game, struct settings *settings, struct output *output);

/* Returns 1 if every change is on disk. */
int settings_edit_is_saved(const struct ledger *ledger, const struct settings_edit *settings_edit,
                           const struct settings *settings);

/* Returns `hash` continued over `settings_edit`. The PIN counts only if `rules_7` (struct
 * core_config), as in recordings of format 7. */
uint64_t settings_edit_hash(uint64_t hash, const struct settings_edit *settings_edit, int rules_7);

#endif
