/* session_state.h -- the state that one session passes to the next session. A session is the time
 * between two initializations of the core (phases.h). The functions are in session.c, health_log.c
 * and menu/settings_edit.c. */
#pragma once

#include <stdint.h>

#include "core/game/accounting/accounts.h"
#include "core/input.h"
#include "core/settings.h"

/* Interval between two LEDGER_HEALTH entries, which log uptime and faults. A power cut loses at
 * most the data of one interval. */
#define HEALTH_LOG_TICKS (120u * CORE_TICK_HZ)

struct health_log {
    /* 1 if the entry LEDGER_BOOT, which logs this start of the kiosk, is written; otherwise 0. */
    uint8_t is_written;
    uint32_t written_tick; /* Tick at which the last LEDGER_HEALTH was written. */
    /* Values of the counters `dropped_ticks` and `device_faults` in the input when the last
     * LEDGER_HEALTH was written. */
    uint32_t dropped_ticks, device_faults;
    uint32_t written_shakes;
    /* Number of ticks for which each slot in play has been without its controller. */
    uint32_t away_ticks[POI_MAX];
    /* Tick at which each slot last lost its controller in a round; 0 means never. */
    uint32_t loss_tick[POI_MAX];
};

/* Time for which a slot must be without its controller to count as a loss. A shorter interruption
 * is treated as a glitch. */
#define HEALTH_LOG_LOSS_TICKS CORE_TICK_HZ
/* Time after a loss of a slot's controller within which another loss counts as a repeated loss and
 * is logged (LEDGER_LOSS). */
#define HEALTH_LOG_LOSS_AGAIN_TICKS (600u * CORE_TICK_HZ)

/* Number of ticks without a further change after which a changed setting is logged. */
#define SETTINGS_EDIT_REST_TICKS (CORE_TICK_HZ / 2u)

struct settings_edit {
    struct settings logged; /* Values of all settings as they were last logged in the ledger. */
    uint32_t turn_tick;     /* Tick at which a setting last changed. */
    /* Id of the newest entry that logged a setting; 0 means that no setting was logged since the
     * kiosk started. */
    uint32_t entry_id;
    uint32_t pin_wrong; /* Number of wrong PINs since the last correct PIN, 0 .. 255. */
    /* Tick of the last wrong PIN. If the database contained wrong PINs at startup, the value is the
     * tick of the kiosk's start. The field is not in struct menu, because struct menu is reset when
     * the menu opens. */
    uint32_t pin_tick;
};

/* Time after which a language that a visitor chose in attract mode expires. The time is the length
 * of one loop of attract mode and equals AUDIO_OUTPUT_SHOW_S. */
#define LANGUAGE_TICKS (60u * CORE_TICK_HZ)

/* Language chosen by a visitor, carried over to the next session. All fields are 0 if no visitor
 * chose a language. */
struct language_choice {
    uint32_t chosen; /* Chosen language (enum language); 0 unless `until_tick` is set. */
    /* Tick in attract mode at which the visitor's choice expires; 0 means that no visitor chose a
     * language. */
    uint32_t until_tick;
};

/* Longest time in attract mode before a new session starts. A running game is never interrupted. */
#define SESSION_TICKS_MAX (600u * CORE_TICK_HZ)
/* Duration of the fade to dark before a session starts, and of the fade back after the start. */
#define SESSION_FADE_TICKS (CORE_TICK_HZ / 2u)

/* State carried over from the previous session. All fields are 0 if the kiosk has just started. */
struct game_session {
    uint32_t tick; /* First tick of this session; 0 at the kiosk's start. */
    /* Copies of members of the game's state: `command_count` of struct menu, and `save_id` and
     * `saved_id` of struct lab. */
    uint32_t command_count, edit_save_id, edit_saved_id;
    struct ledger ledger;
    struct credit credit;
    struct health_log health_log;
    struct settings_edit settings_edit;
    struct language_choice language;
};
