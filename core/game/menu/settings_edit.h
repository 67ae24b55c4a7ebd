/* settings_edit.h -- changes settings while the kiosk runs. A change takes effect immediately. The
 * ledger entry is written when the value has not changed for SETTINGS_EDIT_REST_TICKS.
 *
 * A caller, such as a page of the operator's menu, only calls settings_edit_set(). A later
 * settings_edit_tick() logs each changed value. A setting is therefore not lost if the ledger's
 * ring buffer is full or the menu is closed quickly. A value that is stepped twenty times produces
 * one entry. */
#ifndef KINGYO_CORE_GAME_MENU_SETTINGS_EDIT_H
#define KINGYO_CORE_GAME_MENU_SETTINGS_EDIT_H

#include <stdint.h>

#include "core/output.h"
#include "core/settings.h"

/* Ticks without a change after which a setting is logged. */
#define SETTINGS_EDIT_REST_TICKS (CORE_TICK_HZ / 2u)

struct settings_edit {
    struct settings told; /* Settings as logged in the ledger. */
    uint32_t turn_tick;   /* Tick of the last change. */
    uint32_t entry_id;    /* Id of the newest entry that logged a setting; 0 means none since the
                             kiosk started. */
    uint32_t pin_wrong;   /* Number of wrong PINs since the last correct PIN, 0 .. 255. */
    uint32_t pin_tick;    /* Tick of the last wrong PIN. If the database contained wrong PINs at
                             startup, the tick of the kiosk's start. The field is not in struct
                             menu, because that struct is reset when the menu opens. */
};

struct game;
struct ledger;
struct core_config;

/* Initializes `settings_edit` with the settings in `config`. Invalid values are replaced by
 * defaults. The resulting settings count as already logged. */
void settings_edit_init(struct settings_edit *settings_edit, const struct core_config *config);

/* Returns the highest value that setting `id` can have in this kiosk. The tank's capacity limits
 * the number of fish. */
int32_t settings_edit_max(const struct core_config *config, uint32_t id);

/* Sets setting `id` to `value`. settings_allows() must permit the value, which must not exceed
 * settings_edit_max(). A new number of fish or players takes effect when attract mode next
 * begins. */
void settings_edit_set(struct game *game, struct core_config *config, uint32_t id, int32_t value);

/* Moves setting `id` up or down by `step_count` steps, at most to the end of its range. A step
 * beyond the end continues at the opposite end. Returns 1 if the new value is at the end, otherwise
 * 0. */
int settings_edit_step(struct game *game, struct core_config *config, uint32_t id, int is_down,
                       uint32_t step_count);

/* Resets every setting to its default, empties the balance, and logs both changes in one entry.
 * Returns 1. If the ledger's ring buffer has no room, changes nothing and returns 0. */
int settings_edit_factory_reset(struct game *game, struct core_config *config,
                                struct output *output);

/* Logs changed settings after SETTINGS_EDIT_REST_TICKS without a further change. Call once per tick
 * in every phase. */
void settings_edit_tick(struct game *game, struct settings *settings, struct output *output);

/* Returns 1 if every change of a setting is on disk, otherwise 0. */
int settings_edit_is_saved(const struct ledger *ledger, const struct settings_edit *settings_edit,
                           const struct settings *settings);

/* Returns `hash` continued over `settings_edit`. The PIN is included only if `rules_7` (struct
 * core_config) is 1, as in recordings of format 7. */
uint64_t settings_edit_hash(uint64_t hash, const struct settings_edit *settings_edit, int rules_7);

#endif
