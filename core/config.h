/* config.h -- the configuration of a session, which core_init() reads. A session is the time
 * between two initializations of the core.
 *
 * During a session the game reads the configuration. Only two functions of the game change it.
 * settings_edit_set() changes the settings for a page of the operator's menu. session_restart()
 * writes the configuration of the next session at the end of a session. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "core/game/lab/lab_edit.h"
#include "core/game/session_state.h"
#include "core/persistent_state.h"

struct core_config {
    uint32_t seed;  /* Seed of the random numbers; any value. */
    uint8_t preset; /* Preset of the tank (enum tank_preset_id). */
    /* Number of fish, 1 .. tank_preset_fish_max(); 0 means the preset's default. */
    uint32_t fish_count;
    uint8_t language; /* Display language (enum language). */
    uint32_t round_s; /* Length of a round, 10 .. 600 s; 0 means the mode's default. */
    /* Modes that players can choose, one bit each (1 << enum game_mode, or 1 << CHOICE_LAB); 0
     * means only the festival mode. With a single mode the selection screen is skipped. */
    uint8_t modes;
    /* Paper grade, 4 .. 7, used if the mode's rules leave the grade open or if `modes` has only one
     * bit set. 0 means the grade of the mode's rules, or 6 if the rules have none. */
    uint8_t grade;
    /* Level that players have until they choose another level (enum level). */
    uint8_t level;
    uint8_t players;      /* Number of bowls at the tank, 1 .. POI_MAX; 0 counts as 1. */
    uint8_t credit_coins; /* Price of a round in units, 1 .. CREDIT_COINS_MAX; 0 means free play. */
    uint8_t ticket_fish;  /* Fish per ticket, 1 .. CREDIT_TICKET_FISH_MAX; 0 means no tickets. */
    /* 0 for the current rules. In the replay of an older recording, the format version of the
     * recording, whose rules the core then uses (config_has_rules()). Hashes exclude this field
     * because the recordings have hashes without the field. */
    uint8_t rules;
    /* Number of floats in a SIMD vector: 4, or 8 on x86-64 with AVX2; 0 counts as 4. The number
     * changes no result, so hashes and recordings exclude it. */
    uint8_t lanes;
    /* Persistent state that the store loaded at startup. The settings in `persistent` do not
     * override the fields above; see config_apply_settings(). */
    struct persistent_state persistent;
    /* State that the core carries over when it reinitializes itself for a new session; all zero at
     * the start of the kiosk. */
    struct game_session session;
    /* Custom species and saved growth graphs, as loaded from the data folder. */
    struct lab_book book;
};

/* Returns true if the core uses rules that were introduced with the recording format `version`.
 * Returns false only in the replay of an older recording. replay.h lists what each format
 * introduced. */
static inline bool config_has_rules(const struct core_config *config, uint32_t version)
{
    return config->rules == 0 || config->rules >= version;
}

/* Copies the settings to the fields of `config`. The fish count is limited to the capacity of the
 * preset's tank. The level is LEVEL_MASTER in the replay of a recording without levels. */
void config_apply_settings(struct core_config *config, const struct settings *settings);
