/* settings.h -- the operator's settings: name, range, step and default of each setting.
 *
 * Each setting is one number, and its properties are a row of one table. The menu, the
 * configuration file, the store and the manual therefore always agree. A value comes from four
 * sources: the table's default, the configuration file, the value saved by the menu, and the
 * command line. Each later source overrides the earlier sources. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "core/input.h"

enum setting_id {
    /* Money settings. A unit is the value of the smallest coin. */
    SET_PLAY = 0, /* Kind of payment (enum play_kind). */
    SET_PRICE,    /* Units per credit. */
    SET_COIN_1,   /* Value in units of one pulse of the first coin line. */
    SET_COIN_2,
    SET_COIN_3,
    /* Coin units that a player must insert before a round to receive the bonus; 0 means no
     * bonus. */
    SET_BONUS_UNITS,
    SET_BONUS_CREDITS, /* Number of credits that the bonus adds. */
    SET_CREDIT_MAX,
    SET_CREDIT_EXPIRY_MIN, /* Minutes without activity after which credits expire; 0 means never. */
    SET_TICKET_FISH,       /* Fish per ticket; 0 means no tickets. */
    /* Game settings. */
    SET_MODES,   /* Modes that players can choose, one bit each (1 << enum game_mode, or 1 <<
                    CHOICE_LAB). */
    SET_GRADE,   /* Paper grade; 0 means the mode's default. */
    SET_ROUND_S, /* Round length in seconds; 0 means the mode's default. */
    SET_FISH,    /* Number of fish; 0 means the tank's default. */
    SET_PLAYERS,
    SET_LANGUAGE,
    SET_NAMES, /* 1 if ranked players are prompted for a name, otherwise 0. */
    /* Sound settings. */
    SET_VOLUME, /* Volume in per cent. */
    /* Every n-th loop of attract mode plays sound, where n is the value; 0 means no sound. */
    SET_ATTRACT_SOUND,
    /* Picture settings. */
    SET_ROTATION, /* Clockwise rotation of the picture on the screen, in quarter turns. */
    /* Margin at the left and at the right that the screen does not show, in per mille of the
     * width. */
    SET_OVERSCAN_X,
    /* Margin at the top and at the bottom that the screen does not show, in per mille of the
     * height. */
    SET_OVERSCAN_Y,
    SET_BRIGHTNESS,     /* Brightness in per cent. */
    SET_DIM,            /* Brightness while the kiosk is idle, in per cent of SET_BRIGHTNESS. */
    SET_DIM_AFTER_MIN,  /* Idle minutes before the picture is dimmed; 0 means never. */
    SET_NIGHT_FROM_MIN, /* Minute of the day at which the picture turns dark. */
    /* Minute of the day at which the picture becomes bright again. If the value equals
     * SET_NIGHT_FROM_MIN, the picture is never dark. */
    SET_NIGHT_TO_MIN,
    /* Operator settings. */
    SET_PIN, /* Stored form of the operator's PIN (core/pin.h); 0 means that no PIN is required. */
    /* First of the calibration values: nine values for each slot's controller
     * (core/game/control/input_pose.h). The menu does not show the values as numbers. */
    SET_CALIBRATION,
    SET_CALIBRATION_END = SET_CALIBRATION + 9 * (int)POI_MAX,
    /* First of the check values, one for each slot, written after the slot's nine calibration
     * values. The calibration values are valid only if the check value matches. */
    SET_CALIBRATION_CHECK = SET_CALIBRATION_END,
    /* Level that players have until they choose another level (enum level_choice). The setting
     * belongs to the game settings. Recordings have the setting since format 9. */
    SET_LEVEL = SET_CALIBRATION_CHECK + (int)POI_MAX,
    /* Settings that adapt the kiosk to the bodies of the players. SET_TEXT belongs to the picture
     * settings, the others belong to the game settings. Recordings have them since format 10. */
    SET_DIP, /* 1 if one click dips the poi and the next click lifts it, otherwise 0. */
    /* Lower part of the picture that stands for the whole picture, in per cent of its height; 0
     * means the whole picture. */
    SET_REACH,
    SET_SIDE, /* Side of the bowl of a player who plays alone (enum bowl_side). */
    SET_TEXT, /* Size of small texts on the pages for players: 0 normal, 1 large, 2 largest. */
    /* Sound settings, which recordings have since format 11. SET_MUSIC and SET_EFFECTS are relative
     * to SET_VOLUME: 0 is full, 1 to 3 are 75, 50 and 25 per cent, and 4 is silent. SET_MUSIC also
     * applies to the sounds around the stall. */
    SET_MUSIC,
    SET_EFFECTS,
    SET_QUIET_VOLUME,   /* Volume in the quiet hours (enum quiet_volume). */
    SET_QUIET_FROM_MIN, /* Minute of the day at which the quiet hours begin. */
    /* Minute of the day at which the quiet hours end. If the value equals SET_QUIET_FROM_MIN, no
     * hour is quiet. */
    SET_QUIET_TO_MIN,
    /* Light of the stall: 0 is night with bulbs and lanterns, and 1 is day. The setting belongs to
     * the picture settings. Recordings have it since format 11. */
    SET_TIME,
    /* Camera in a round with one player: 0 if it comes closer around the poi, 1 if it rests. The
     * setting belongs to the picture settings. Recordings have it since format 12. */
    SET_CAMERA,
    /* Bowls of the players: 0 with a band in the player's colour, 1 classic white. The setting
     * belongs to the picture settings. Recordings have it since format 12. */
    SET_BOWL,
    SETTING_COUNT,
};

/* Values of SET_LEVEL. The default has the value 0, so that the hashes of recordings without this
 * setting stay the same. */
enum level_choice {
    LEVEL_CHOICE_NORMAL = 0,
    LEVEL_CHOICE_EASY,
    LEVEL_CHOICE_MASTER,
    LEVEL_CHOICE_COUNT,
};

/* Values of SET_SIDE. */
enum bowl_side {
    BOWL_BY_FIRST_DIP = 0, /* The dip that ends attract mode chooses the side. */
    BOWL_RIGHT,
    BOWL_LEFT,
    BOWL_SIDE_COUNT,
};

/* Number of values of SET_MUSIC and SET_EFFECTS. */
#define SETTING_SOUND_STEPS 5

/* Values of SET_QUIET_VOLUME: shares of SET_VOLUME in per cent. */
enum quiet_volume {
    QUIET_VOLUME_50 = 0,
    QUIET_VOLUME_30,
    QUIET_VOLUME_15,
    QUIET_VOLUME_SILENT,
    QUIET_VOLUME_COUNT,
};

/* Smallest value of SET_REACH except 0. */
#define SETTING_REACH_MIN 40

enum play_kind {
    PLAY_FREE = 0,
    PLAY_PAID,
    PLAY_EVENT, /* Play is free and coins are returned. The price plate announces an event. */
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
    KIND_CHOICE, /* The menu shows a text for each value. */
    KIND_BITS,   /* The menu shows a text for each bit. */
    KIND_MINUTE, /* The value is a minute of the day, shown as HH:MM. */
};

struct setting {
    /* Key of the setting in the configuration file and in the store. A key never changes. */
    const char *name;
    uint8_t group; /* Group of the setting in the menu (enum setting_group). */
    uint8_t kind;  /* How the menu displays the setting (enum setting_kind). */
    int32_t min, max, step, standard;
    /* First format of recordings that contains the setting; 0 means every format. A setting with a
     * format has the default 0, so that hashes without the setting stay the same. */
    uint8_t since;
};

struct field_table;

struct settings {
    int32_t value[SETTING_COUNT];
};

/* Returns the table row of setting `id`. Asserts that `id` < SETTING_COUNT. */
const struct setting *settings_entry(uint32_t id);

/* Returns true if setting `id` may have `value`: in range, on a step, and with at least one bit set
 * for KIND_BITS. Also returns true for a hashed PIN (core/pin.h), although the range of SET_PIN
 * covers only plain digits. */
bool settings_allows(uint32_t id, int32_t value);

/* Sets every setting to its default. */
void settings_reset(struct settings *settings);

/* Resets every out-of-range setting to its default. If all values are 0, the struct was never
 * filled, because a price of 0 is invalid. All settings are then reset. */
void settings_sanitize(struct settings *settings);

/* Table of the members of struct settings (core/base/field.h). */
extern const struct field_table settings_fields;

/* Returns `hash` continued over the settings. The PIN counts as 0 unless `hashes_pin` is true,
 * which only recordings of format 7 require. The replay of a score can therefore be verified
 * without the PIN. */
uint64_t settings_hash(uint64_t hash, const struct settings *settings, bool hashes_pin);

/* Replaces a PIN in plain digits by its hashed form (core/pin.h). */
void settings_hide_pin(struct settings *settings, uint32_t salt);
