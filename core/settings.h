/* settings.h -- the operator's settings: name, range, step and default of each.
 *
 * Each setting is one number, and its properties are a row of one table. The menu, the
 * configuration file, the store and the manual therefore always agree. A value comes from four
 * sources: the table's default, the configuration file, the value saved by the menu, and the
 * command line. Each later source overrides the earlier ones. */
#ifndef KINGYO_CORE_SETTINGS_H
#define KINGYO_CORE_SETTINGS_H

#include <stdint.h>

#include "core/input.h"

enum setting_id {
    /* Money. A unit is the value of the smallest coin. */
    SET_PLAY = 0, /* enum play_kind */
    SET_PRICE,    /* Units per credit. */
    SET_COIN_1,   /* Units per pulse of each coin line. */
    SET_COIN_2,
    SET_COIN_3,
    SET_BONUS_UNITS,   /* Units inserted in a row that earn the bonus; 0: no bonus. */
    SET_BONUS_CREDITS, /* Credits that the bonus adds. */
    SET_CREDIT_MAX,
    SET_CREDIT_EXPIRY_MIN, /* Minutes without activity after which credits expire; 0: never. */
    SET_TICKET_FISH,       /* Fish per ticket; 0: no tickets. */
    /* Game. */
    SET_MODES,   /* Modes on offer, one bit each (1 << enum game_mode, or 1 << CHOICE_LAB). */
    SET_GRADE,   /* Paper grade; 0: the mode's default. */
    SET_ROUND_S, /* Round length in seconds; 0: the mode's default. */
    SET_FISH,    /* Number of fish; 0: the tank's default. */
    SET_PLAYERS,
    SET_LANGUAGE,
    SET_NAMES, /* 1: ranked players are prompted for a name. */
    /* Sound. */
    SET_VOLUME,        /* Volume in per cent. */
    SET_ATTRACT_SOUND, /* Every n-th loop of attract mode plays sound; 0: no sound. */
    /* Picture. */
    SET_ROTATION,       /* Quarter turns clockwise. */
    SET_OVERSCAN_X,     /* Per mille of the width that is lost at each side. */
    SET_OVERSCAN_Y,     /* Per mille of the height that is lost at the top and at the bottom. */
    SET_BRIGHTNESS,     /* Brightness in per cent. */
    SET_DIM,            /* Per cent of SET_BRIGHTNESS while the kiosk is idle. */
    SET_DIM_AFTER_MIN,  /* Idle minutes before dimming; 0: never. */
    SET_NIGHT_FROM_MIN, /* Minute of the day at which the picture turns dark. */
    SET_NIGHT_TO_MIN,   /* Minute of the day at which the picture returns; equal to
                           SET_NIGHT_FROM_MIN: never dark. */
    /* Operator. */
    SET_PIN, /* PIN in the form of core/pin.h; 0: no PIN is required. */
    /* Calibration of each slot's controller, nine values per slot: see
     * core/game/control/calibration.h. The menu does not show these as numbers. */
    SET_CALIBRATION,
    SET_CALIBRATION_END = SET_CALIBRATION + 9 * (int)POI_MAX,
    /* Check value per slot, written after the nine values. The nine values are valid only if the
     * check value matches. */
    SET_CALIBRATION_CHECK = SET_CALIBRATION_END,
    SETTING_COUNT = SET_CALIBRATION_CHECK + (int)POI_MAX,
};

enum play_kind {
    PLAY_FREE = 0,
    PLAY_PAID,
    PLAY_EVENT, /* Free play; coins are returned, and the price plate announces an event. */
    PLAY_KIND_COUNT,
};

enum setting_group {
    GROUP_MONEY = 0,
    GROUP_GAME,
    GROUP_SOUND,
    GROUP_PICTURE,
    GROUP_OPERATOR,
    GROUP_CALIBRATION,
    SETTING_GROUP_COUNT,
};

/* How the menu displays and steps a setting. */
enum setting_kind {
    KIND_NUMBER = 0,
    KIND_CHOICE, /* Each value has a text. */
    KIND_BITS,   /* Each bit has a text. */
    KIND_MINUTE, /* Minute of the day, HH:MM. */
};

struct setting {
    const char *name; /* Key in the configuration file and in the store; never changes. */
    uint8_t group;    /* enum setting_group */
    uint8_t kind;     /* enum setting_kind */
    int32_t min, max, step, standard;
};

struct settings {
    int32_t value[SETTING_COUNT];
};

/* Returns the table row of setting `id`. `id` must be < SETTING_COUNT, else the function
 * asserts. */
const struct setting *settings_entry(uint32_t id);

/* Returns 1 if setting `id` may have `value`: in range, on a step, and with at least one bit set
 * for KIND_BITS. A hashed PIN (core/pin.h) is allowed although the range covers only its digits. */
int settings_allows(uint32_t id, int32_t value);

/* Sets every setting to its default. */
void settings_reset(struct settings *settings);

/* Resets every out-of-range setting to its default. Resets all settings if all values are 0,
 * because a price of 0 is invalid and the struct was therefore never set. */
void settings_sanitize(struct settings *settings);

/* Returns `hash` continued over the settings. The PIN counts as 0 unless `rules_7` (core/config.h),
 * so that the replay of a score verifies without the PIN. */
uint64_t settings_hash(uint64_t hash, const struct settings *settings, int rules_7);

/* Replaces a PIN in plain digits by its hashed form (core/pin.h). */
void settings_hide_pin(struct settings *settings, uint32_t salt);

#endif
