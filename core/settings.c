/* settings.c -- the table of settings and its functions. */
#include "core/settings.h"

#include "core/base/field.h"
#include "core/base/panic.h"
#include "core/pin.h"
#include "core/scene.h"

#define MICRO 10000000 /* Range of a calibration value, in millionths: 10 m, or a factor of 10. */

#define CALIBRATION(slot, name)                                                                    \
    { "seat" #slot "-" name, GROUP_CALIBRATION, KIND_NUMBER, -MICRO, MICRO, 1, 0, 0 }
/* The nine calibration values of one slot (core/game/control/input_pose.h). If all nine are 0, the
 * controller's pose is used unchanged. */
#define SLOT(slot)                                                                                 \
    CALIBRATION(slot, "xx"), CALIBRATION(slot, "xz"), CALIBRATION(slot, "x0"),                     \
        CALIBRATION(slot, "zx"), CALIBRATION(slot, "zz"), CALIBRATION(slot, "z0"),                 \
        CALIBRATION(slot, "y0"), CALIBRATION(slot, "pitch"), CALIBRATION(slot, "roll")

/* clang-format off */
static const struct setting table[SETTING_COUNT] = {
    [SET_PLAY] = { "play", GROUP_MONEY, KIND_CHOICE, 0, PLAY_KIND_COUNT - 1, 1, PLAY_FREE, 0 },
    [SET_PRICE] = { "price", GROUP_MONEY, KIND_NUMBER, 1, 20, 1, 1, 0 },
    [SET_COIN_1] = { "coin-1", GROUP_MONEY, KIND_NUMBER, 1, 20, 1, 1, 0 },
    [SET_COIN_2] = { "coin-2", GROUP_MONEY, KIND_NUMBER, 1, 20, 1, 1, 0 },
    [SET_COIN_3] = { "coin-3", GROUP_MONEY, KIND_NUMBER, 1, 20, 1, 5, 0 },
    [SET_BONUS_UNITS] = { "bonus-units", GROUP_MONEY, KIND_NUMBER, 0, 100, 1, 0, 0 },
    [SET_BONUS_CREDITS] = { "bonus-credits", GROUP_MONEY, KIND_NUMBER, 1, 5, 1, 1, 0 },
    [SET_CREDIT_MAX] = { "credit-max", GROUP_MONEY, KIND_NUMBER, 1, 99, 1, 99, 0 },
    [SET_CREDIT_EXPIRY_MIN] = { "credit-expiry", GROUP_MONEY, KIND_NUMBER, 0, 240, 5, 0, 0 },
    [SET_TICKET_FISH] = { "ticket-fish", GROUP_MONEY, KIND_NUMBER, 0, 20, 1, 0, 0 },
    [SET_MODES] = { "modes", GROUP_GAME, KIND_BITS, 1, (1 << CHOICE_COUNT) - 1, 1,
                    (1 << CHOICE_COUNT) - 1, 0 },
    [SET_GRADE] = { "grade", GROUP_GAME, KIND_CHOICE, 0, 7, 1, 0, 0 },
    [SET_ROUND_S] = { "round", GROUP_GAME, KIND_NUMBER, 0, 600, 10, 0, 0 },
    [SET_FISH] = { "fish", GROUP_GAME, KIND_NUMBER, 0, 2048, 1, 0, 0 },
    [SET_PLAYERS] = { "players", GROUP_GAME, KIND_NUMBER, 1, (int32_t)POI_MAX, 1, 1, 0 },
    [SET_LANGUAGE] = { "language", GROUP_GAME, KIND_CHOICE, 0, LANGUAGE_COUNT - 1, 1,
                       LANGUAGE_JA, 0 },
    [SET_NAMES] = { "names", GROUP_GAME, KIND_CHOICE, 0, 1, 1, 1, 0 },
    [SET_VOLUME] = { "volume", GROUP_SOUND, KIND_NUMBER, 0, 100, 5, 80, 0 },
    [SET_ATTRACT_SOUND] = { "attract-sound", GROUP_SOUND, KIND_NUMBER, 0, 10, 1, 1, 0 },
    [SET_ROTATION] = { "rotation", GROUP_PICTURE, KIND_CHOICE, 0, 3, 1, 0, 0 },
    [SET_OVERSCAN_X] = { "overscan-x", GROUP_PICTURE, KIND_NUMBER, 0, 100, 5, 0, 0 },
    [SET_OVERSCAN_Y] = { "overscan-y", GROUP_PICTURE, KIND_NUMBER, 0, 100, 5, 0, 0 },
    [SET_BRIGHTNESS] = { "brightness", GROUP_PICTURE, KIND_NUMBER, 20, 100, 5, 100, 0 },
    [SET_DIM] = { "dim", GROUP_PICTURE, KIND_NUMBER, 10, 100, 10, 50, 0 },
    [SET_DIM_AFTER_MIN] = { "dim-after", GROUP_PICTURE, KIND_NUMBER, 0, 240, 5, 15, 0 },
    [SET_NIGHT_FROM_MIN] = { "night-from", GROUP_PICTURE, KIND_MINUTE, 0, 1425, 15, 0, 0 },
    [SET_NIGHT_TO_MIN] = { "night-to", GROUP_PICTURE, KIND_MINUTE, 0, 1425, 15, 0, 0 },
    [SET_PIN] = { "pin", GROUP_OPERATOR, KIND_NUMBER, 0, 9999, 1, 0, 0 },
    [SET_CALIBRATION] = SLOT(1), SLOT(2), SLOT(3), SLOT(4),
    [SET_CALIBRATION_CHECK] = CALIBRATION(1, "check"), CALIBRATION(2, "check"),
    CALIBRATION(3, "check"), CALIBRATION(4, "check"),
    [SET_LEVEL] = { "level", GROUP_GAME, KIND_CHOICE, 0, LEVEL_CHOICE_COUNT - 1, 1,
                    LEVEL_CHOICE_NORMAL, 9 },
    [SET_DIP] = { "dip", GROUP_GAME, KIND_CHOICE, 0, 1, 1, 0, 10 },
    [SET_REACH] = { "reach", GROUP_GAME, KIND_NUMBER, 0, 100, 1, 0, 10 },
    [SET_SIDE] = { "side", GROUP_GAME, KIND_CHOICE, 0, BOWL_SIDE_COUNT - 1, 1,
                   BOWL_BY_FIRST_DIP, 10 },
    [SET_TEXT] = { "text", GROUP_PICTURE, KIND_CHOICE, 0, 2, 1, 0, 10 },
    [SET_MUSIC] = { "music", GROUP_SOUND, KIND_CHOICE, 0, SETTING_SOUND_STEPS - 1, 1, 0, 11 },
    [SET_EFFECTS] = { "effects", GROUP_SOUND, KIND_CHOICE, 0, SETTING_SOUND_STEPS - 1, 1, 0, 11 },
    [SET_QUIET_VOLUME] = { "quiet-volume", GROUP_SOUND, KIND_CHOICE, 0, QUIET_VOLUME_COUNT - 1, 1,
                           QUIET_VOLUME_50, 11 },
    [SET_QUIET_FROM_MIN] = { "quiet-from", GROUP_SOUND, KIND_MINUTE, 0, 1425, 15, 0, 11 },
    [SET_QUIET_TO_MIN] = { "quiet-to", GROUP_SOUND, KIND_MINUTE, 0, 1425, 15, 0, 11 },
    [SET_TIME] = { "time", GROUP_PICTURE, KIND_CHOICE, 0, 1, 1, 0, 11 },
    [SET_CAMERA] = { "camera", GROUP_PICTURE, KIND_CHOICE, 0, 1, 1, 0, 12 },
    [SET_BOWL] = { "bowl", GROUP_PICTURE, KIND_CHOICE, 0, 1, 1, 0, 12 },
};
/* clang-format on */

const struct setting *settings_entry(uint32_t id)
{
    CORE_ASSERT(id < SETTING_COUNT);
    return &table[id];
}

bool settings_allows(uint32_t id, int32_t value)
{
    const struct setting *setting = settings_entry(id);
    CORE_ASSERT(setting->step > 0 && setting->min <= setting->max);
    if (id == SET_PIN && value < 0) {
        return true;
    }
    /* These settings have no values between 0 (the default) and their smallest value. */
    const int32_t least = id == SET_GRADE   ? (int32_t)SHEET_GRADE_MIN
                          : id == SET_REACH ? SETTING_REACH_MIN
                                            : setting->min;
    return value >= setting->min && value <= setting->max &&
           (value - setting->min) % setting->step == 0 && (value == 0 || value >= least);
}

void settings_reset(struct settings *settings)
{
    CORE_ASSERT(settings);
    for (uint32_t id = 0; id < SETTING_COUNT; id++) {
        settings->value[id] = table[id].standard;
    }
}

void settings_sanitize(struct settings *settings)
{
    CORE_ASSERT(settings);
    /* If all values are 0, the settings were never filled, so reset all settings. */
    int32_t any = 0;
    for (uint32_t id = 0; id < SETTING_COUNT; id++) {
        any |= settings->value[id];
    }
    if (any == 0) {
        settings_reset(settings);
    }
    for (uint32_t id = 0; id < SETTING_COUNT; id++) {
        if (!settings_allows(id, settings->value[id])) {
            settings->value[id] = table[id].standard;
        }
    }
}

#define STRUCT settings
const struct field_table settings_fields =
    FIELD_TABLE(settings, FIELD_RANGE(value[0], SET_LEVEL), FIELD_SINCE(9, value[SET_LEVEL], 1),
                FIELD_RANGE_SINCE(10, value[SET_DIP], SET_MUSIC - SET_DIP, 2),
                FIELD_RANGE_SINCE(11, value[SET_MUSIC], SET_CAMERA - SET_MUSIC, 6),
                FIELD_RANGE_SINCE(12, value[SET_CAMERA], SETTING_COUNT - SET_CAMERA, 2));
#undef STRUCT

uint64_t settings_hash(uint64_t hash, const struct settings *settings, bool hashes_pin)
{
    struct settings hashed = *settings;
    if (!hashes_pin) {
        hashed.value[SET_PIN] = 0;
    }
    return field_hash(hash, &settings_fields, &hashed);
}

void settings_hide_pin(struct settings *settings, uint32_t salt)
{
    const int32_t kept = settings->value[SET_PIN];
    settings->value[SET_PIN] = pin_is_plain(kept) ? pin_hide((uint32_t)kept, salt) : kept;
    CORE_ASSERT(!pin_is_plain(settings->value[SET_PIN]));
}
