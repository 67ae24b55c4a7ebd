/* settings.h -- everything that an operator may set: its name, its range, and where it began.
 *
 * Each setting is one number. What it means, its range and its standard are rows of one table, so
 * that the menu, the configuration file, the store and the manual can never differ. A value comes
 * from the table's standard, then from the configuration file, then from what the menu has saved,
 * then from the command line; each later one wins. */
#ifndef KINGYO_CORE_SETTINGS_H
#define KINGYO_CORE_SETTINGS_H

#include <stdint.h>

#include "core/input.h"

enum setting_id {
    /* Money. A unit is what the smallest coin is worth. */
    SET_PLAY = 0,       /* enum play_kind */
    SET_PRICE,          /* Units a credit. */
    SET_COIN_1,         /* Units a pulse of each coin line. */
    SET_COIN_2,
    SET_COIN_3,
    SET_BONUS_UNITS,    /* So many units in a row ... 0: there is no bonus. */
    SET_BONUS_CREDITS,  /* ... give so many credits more. */
    SET_CREDIT_MAX,
    SET_CREDIT_EXPIRY_MIN, /* Untouched so long, credits lapse; 0: never. */
    SET_TICKET_FISH,    /* A ticket for so many fish; 0: none. */
    /* Game. */
    SET_MODES,          /* A bit (1 << enum game_mode, or CHOICE_LAB) each. */
    SET_GRADE,          /* Of the paper; 0: the mode's own. */
    SET_ROUND_S,        /* 0: the mode's own. */
    SET_FISH,           /* 0: the tank's own. */
    SET_PLAYERS,
    SET_LANGUAGE,
    SET_NAMES,          /* 1: whoever is ranked is asked for a name. */
    /* Sound. */
    SET_VOLUME,         /* Per cent. */
    SET_ATTRACT_SOUND,  /* Every n-th loop of attract is heard; 0: none. */
    /* Picture. */
    SET_ROTATION,       /* Quarter turns clockwise. */
    SET_OVERSCAN_X,     /* Per mille of the width that is lost at each side, ... */
    SET_OVERSCAN_Y,     /* ... of the height. */
    SET_BRIGHTNESS,     /* Per cent. */
    SET_DIM,            /* Per cent of that, while nobody plays for ... */
    SET_DIM_AFTER_MIN,  /* ... so long; 0: never. */
    SET_NIGHT_FROM_MIN, /* Minute of the day from which the picture is dark ... */
    SET_NIGHT_TO_MIN,   /* ... to which; equal: never. */
    /* The operator's own. */
    SET_PIN,            /* As core/pin.h keeps it; 0: none is asked for. */
    /* What is right for one controller's seat: see core/game/calibrate.h. Not shown as numbers. */
    SET_CALIBRATION,
    SET_CALIBRATION_END = SET_CALIBRATION + 9 * (int)POI_MAX,
    /* One a seat, written after its nine: only where it agrees with them are they whole. */
    SET_CALIBRATION_CHECK = SET_CALIBRATION_END,
    SETTING_COUNT = SET_CALIBRATION_CHECK + (int)POI_MAX,
};

enum play_kind {
    PLAY_FREE = 0,
    PLAY_PAID,
    PLAY_EVENT, /* Free, and coins are sent back; told as an event on the plate. */
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

/* How it is shown and stepped through. */
enum setting_kind {
    KIND_NUMBER = 0,
    KIND_CHOICE, /* Each value has a word. */
    KIND_BITS,   /* Each bit has a word. */
    KIND_MINUTE, /* Of the day, HH:MM. */
};

struct setting {
    const char *name; /* In the configuration file and in the store; never changes. */
    uint8_t group;    /* enum setting_group */
    uint8_t kind;     /* enum setting_kind */
    int32_t min, max, step, standard;
};

struct settings {
    int32_t value[SETTING_COUNT];
};

/* `id` < SETTING_COUNT, else it asserts. */
const struct setting *setting_of(uint32_t id);

/* Whether it may have this value: in range, on a step, and at least one bit of KIND_BITS. A hidden
 * PIN (core/pin.h) is allowed although it is out of the range, which is that of its digits. */
int setting_allows(uint32_t id, int32_t value);

/* Every setting at its standard. */
void settings_reset(struct settings *settings);

/* Every one that has a value which it may not have, at its standard; and all of them where all are
 * 0, since those were never set: there is no price of 0. */
void settings_mend(struct settings *settings);

/* The PIN counts as 0 unless `rules_7` (core/core.h): the replay of a score verifies without it. */
uint64_t settings_hash(uint64_t hash, const struct settings *settings, int rules_7);

/* Hides a PIN that is kept in plain digits (core/pin.h). */
void settings_hide_pin(struct settings *settings, uint32_t salt);

struct core_config;

/* Writes what they ask of the stall into the config's own fields; of the fish as many as its
 * preset's tank holds. */
void settings_apply(const struct settings *settings, struct core_config *config);

#endif
