/* tank_options.c -- parses the options of `kingyoctl tank`, first each option in its own range, and
 * then checks the options against each other and against the tank preset. */
#include "platform/ctl/tank/tank_options.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "platform/ctl/lib/ctl.h"
#include "platform/os/number.h"

#define FIELD_MAX 48
/* Converts metres to whole centimetres by rounding, because the float 0.30f is not exactly 0.3. */
#define CM(metres) ((double)(int)(100.0f * (metres) + 0.5f))

static const char name[] = "tank";

/* Options whose value is a number, in the order of `ranges`. */
enum figure {
    FIGURE_AREA_SCALE,
    FIGURE_WALL_FOLLOW,
    FIGURE_SECONDS,
    FIGURE_SEED,
    FIGURE_STAMINA,
    FIGURE_TEMPERATURE_C,
    FIGURE_PRESSURE_HPA,
    FIGURE_OXYGEN_MG_L,
    FIGURE_TIME_COMPRESSION,
    FIGURE_TRACE_EVERY,
    FIGURE_OBSERVE_EVERY,
    FIGURE_COUNT,
};

struct range {
    const char *option; /* Name of the option, or of one number in the option's list. */
    double min, max;
    uint8_t is_whole;
};

static const struct range ranges[FIGURE_COUNT] = {
    [FIGURE_AREA_SCALE] = { "--area-scale", 0.05, 250, 0 },
    [FIGURE_WALL_FOLLOW] = { "--wall-follow", 0, 1, 0 },
    [FIGURE_SECONDS] = { "--seconds", 0.1, PLAN_SECONDS_MAX, 0 },
    [FIGURE_SEED] = { "--seed", 0, UINT32_MAX, 1 },
    [FIGURE_STAMINA] = { "--stamina", 0, 100, 0 },
    [FIGURE_TEMPERATURE_C] = { "--temperature-c", (double)OXYGEN_TEMPERATURE_MIN_C,
                               (double)OXYGEN_TEMPERATURE_MAX_C, 0 },
    [FIGURE_PRESSURE_HPA] = { "--pressure-hpa", (double)OXYGEN_PRESSURE_MIN_HPA,
                              (double)OXYGEN_PRESSURE_MAX_HPA, 0 },
    [FIGURE_OXYGEN_MG_L] = { "--oxygen-mg-l", 0, (double)OXYGEN_MAX_MG_L, 0 },
    [FIGURE_TIME_COMPRESSION] = { "--time-compression", 0, (double)OXYGEN_TIME_COMPRESSION_MAX, 0 },
    [FIGURE_TRACE_EVERY] = { "--trace-every", 1, PLAN_SECONDS_MAX *CORE_TICK_HZ, 1 },
    [FIGURE_OBSERVE_EVERY] = { "--observe-every", 1, PLAN_SECONDS_MAX *CORE_TICK_HZ, 1 },
};

enum pump {
    PUMP_AS_PRESET,
    PUMP_OFF,
    PUMP_ON,
};

/* Options as the user wrote them, before the tank preset is applied. */
struct words {
    uint8_t given[FIGURE_COUNT];
    double figure[FIGURE_COUNT];
    uint8_t preset;
    uint8_t pump;   /* Setting of the water pump (enum pump). */
    uint8_t search; /* Method of the pair search (enum pair_search). */
    uint8_t balls;  /* 1 if the option --spaces ball was given, otherwise 0. */
    /* Size of the tank in cm along x, y and z. The size along y is the depth of the water. 0
     * selects the size of the tank preset. */
    double size_cm[3];
    /* Value of --fish, or null if the option is absent. The allowed range depends on the tank
     * preset and on the floor area, so the value is parsed later. */
    const char *fish;
};

static enum exit_code tank_options_error(const char *option, const char *value,
                                         const char *expected)
{
    return ctl_usage(name, "%s: '%.100s' is not right; expected %s", option, value ? value : "",
                     expected);
}

/* ---- Parsing one option ---------------------------------------------------------------------- */

static enum exit_code take_figure(struct words *words, enum figure figure, const char *value)
{
    const struct range *range = &ranges[figure];
    double *out = &words->figure[figure];
    char expected[96];
    const int right = number_parse_decimal(value, range->min, range->max, out) &&
                      (!range->is_whole || floor(*out) == *out);
    if (!right) {
        snprintf(expected, sizeof expected, "%s from %.10g to %.10g",
                 range->is_whole ? "a whole number" : "a number", range->min, range->max);
        return tank_options_error(range->option, value, expected);
    }
    words->given[figure] = 1;
    return EXIT_OK;
}

static enum exit_code take_preset(struct tank_options *plan, struct words *words, const char *value)
{
    (void)plan;
    for (uint8_t id = 0; id < TANK_PRESET_COUNT; id++) {
        if (value && strcmp(value, tank_preset(id)->name) == 0) {
            words->preset = id;
            return EXIT_OK;
        }
    }
    return tank_options_error("--preset", value, "thesis, official or festival");
}

static enum exit_code take_fish(struct tank_options *plan, struct words *words, const char *value)
{
    (void)plan;
    words->fish = value ? value : "";
    return EXIT_OK;
}

/* Parses an option whose value is the word `first` or the word `second`. Sets `*is_second` to 1 for
 * the second word and to 0 for the first word. */
static enum exit_code take_choice(const char *option, const char *value, const char *first,
                                  const char *second, uint8_t *is_second)
{
    char expected[32];
    *is_second = value && strcmp(value, second) == 0;
    if (*is_second || (value && strcmp(value, first) == 0)) {
        return EXIT_OK;
    }
    snprintf(expected, sizeof expected, "%s or %s", first, second);
    return tank_options_error(option, value, expected);
}

static enum exit_code take_pump(struct tank_options *plan, struct words *words, const char *value)
{
    uint8_t is_off;
    (void)plan;
    const enum exit_code code = take_choice("--pump", value, "on", "off", &is_off);
    words->pump = is_off ? PUMP_OFF : PUMP_ON;
    return code;
}

static enum exit_code take_pairs(struct tank_options *plan, struct words *words, const char *value)
{
    uint8_t is_all;
    (void)plan;
    const enum exit_code code = take_choice("--pairs", value, "grid", "all", &is_all);
    words->search = is_all ? PAIR_SEARCH_ALL : PAIR_SEARCH_GRID;
    return code;
}

static enum exit_code take_spaces(struct tank_options *plan, struct words *words, const char *value)
{
    (void)plan;
    return take_choice("--spaces", value, "box", "ball", &words->balls);
}

static enum exit_code take_path(const char **path, const char *option, const char *value)
{
    *path = value;
    return value && *value ? EXIT_OK : tank_options_error(option, value, "a path");
}

static enum exit_code take_poi_path(struct tank_options *plan, struct words *words,
                                    const char *value)
{
    (void)words;
    return take_path(&plan->poi_path, "--poi-path", value);
}

static enum exit_code take_place(struct tank_options *plan, struct words *words, const char *value)
{
    (void)words;
    return take_path(&plan->place, "--place", value);
}

static enum exit_code take_trace(struct tank_options *plan, struct words *words, const char *value)
{
    (void)words;
    return take_path(&plan->trace, "--trace", value);
}

static enum exit_code take_json(struct tank_options *plan, struct words *words, const char *value)
{
    (void)words;
    (void)value;
    plan->as_json = 1;
    return EXIT_OK;
}

/* Parses `count` comma-separated numbers, each in its own range. Returns 1, or 0 if the list is
 * invalid. */
static int read_list(const char *text, const struct range *parts, int count, double *out)
{
    for (int i = 0; text && i < count; i++) {
        char field[FIELD_MAX];
        const size_t length = strcspn(text, ",");
        if (length >= sizeof field || (text[length] == ',') != (i + 1 < count)) {
            return 0;
        }
        memcpy(field, text, length);
        field[length] = '\0';
        if (!number_parse_decimal(field, parts[i].min, parts[i].max, &out[i])) {
            return 0;
        }
        text += length + (i + 1 < count);
    }
    return text != NULL;
}

static enum exit_code take_size(struct tank_options *plan, struct words *words, const char *value)
{
    (void)plan;
    static const struct range parts[3] = {
        { "width", CM(TANK_SIDE_MIN_M), CM(TANK_SIDE_MAX_M), 0 },
        { "depth", CM(TANK_DEPTH_MIN_M), CM(TANK_DEPTH_MAX_M), 0 },
        { "breadth", CM(TANK_SIDE_MIN_M), CM(TANK_SIDE_MAX_M), 0 },
    };
    if (!read_list(value, parts, 3, words->size_cm)) {
        return tank_options_error("--size-cm", value,
                                  "WIDTH,DEPTH,BREADTH of the water: 30 to 200 cm, "
                                  "5 to 50 cm, 30 to 200 cm");
    }
    return EXIT_OK;
}

static enum exit_code take_shade(struct tank_options *plan, struct words *words, const char *value)
{
    (void)words;
    static const struct range parts[5] = {
        { "x", -1000, 1000, 0 },
        { "z", -1000, 1000, 0 },
        { "radius", CM(SHADE_RADIUS_MIN_M), CM(SHADE_RADIUS_MAX_M), 0 },
        { "from", 0, PLAN_SECONDS_MAX, 0 },
        { "to", 0, PLAN_SECONDS_MAX, 0 },
    };
    double part[5];
    if (plan->shade_count == SHADE_MAX) {
        return ctl_usage(name, "--shade: at most %u shades", SHADE_MAX);
    }
    if (!read_list(value, parts, 5, part) || part[3] >= part[4]) {
        return tank_options_error(
            "--shade", value,
            "X_CM,Z_CM,R_CM,FROM_S,TO_S: centre -1000 to 1000 cm, radius 1 to 30 cm, "
            "0 <= FROM_S < TO_S <= 36000");
    }
    plan->shade[plan->shade_count++] = (struct plan_shade){
        0.01 * part[0], 0.01 * part[1], 0.01 * part[2], part[3], part[4],
    };
    return EXIT_OK;
}

/* Options whose value is not a number. */
struct option {
    const char *name;
    enum exit_code (*take)(struct tank_options *plan, struct words *words, const char *value);
    uint8_t word_count; /* Number of words on the command line: 2 for an option with a value, 1 for
                           an option without a value. */
};

static const struct option table[] = {
    { "--preset", take_preset, 2 }, { "--fish", take_fish, 2 },
    { "--pump", take_pump, 2 },     { "--pairs", take_pairs, 2 },
    { "--spaces", take_spaces, 2 }, { "--size-cm", take_size, 2 },
    { "--shade", take_shade, 2 },   { "--poi-path", take_poi_path, 2 },
    { "--place", take_place, 2 },   { "--trace", take_trace, 2 },
    { "--json", take_json, 1 },
};

/* Parses one option and its value. Sets `*used` to the number of command-line words that were
 * read. */
static enum exit_code tank_options_take_option(struct tank_options *plan, struct words *words,
                                               const char *option, const char *value, int *used)
{
    *used = 2;
    for (enum figure figure = 0; figure < FIGURE_COUNT; figure++) {
        if (strcmp(option, ranges[figure].option) == 0) {
            return take_figure(words, figure, value);
        }
    }
    for (size_t i = 0; i < sizeof table / sizeof table[0]; i++) {
        if (strcmp(option, table[i].name) == 0) {
            *used = table[i].word_count;
            return table[i].take(plan, words, value);
        }
    }
    return ctl_usage(name, "unknown option '%.100s'; --help lists them", option);
}

/* ---- Checking all options together ----------------------------------------------------------- */

/* Returns the ratio of the requested water volume to the water volume of the tank preset. */
static double waters(const struct tank_config *config)
{
    const vec3 own_m = tank_preset(config->preset)->size_m, size_m = config->size_m;
    const double x = size_m.x > 0.0f ? (double)(size_m.x / own_m.x) : 1.0;
    const double z = size_m.z > 0.0f ? (double)(size_m.z / own_m.z) : 1.0;
    const double y = size_m.y > 0.0f ? (double)(size_m.y / own_m.y) : 1.0;
    return x * y * z * (double)config->area_scale;
}

/* Sets the number of fish. Without --fish, the tank gets the same number of fish per volume as the
 * tank preset. */
static enum exit_code settle_fish(struct tank_options *plan, const struct words *words)
{
    struct tank_config *config = &plan->config;
    char tank[96];
    const uint32_t most = tank_config_fish_max(config);
    snprintf(tank, sizeof tank, "1 to %u fish in %.3g times the water of the %s tank", most,
             waters(config), tank_preset(config->preset)->name);
    if (words->fish) {
        return number_parse(words->fish, 1, most, &config->fish_count)
                   ? EXIT_OK
                   : tank_options_error("--fish", words->fish, tank);
    }
    const double as_dense = round((double)config->fish_count * waters(config));
    if (as_dense > (double)most) {
        return ctl_usage(name,
                         "%s: %.0f fish at the preset's density are too many; with --fish, "
                         "%s",
                         words->given[FIGURE_AREA_SCALE] ? "--area-scale" : "--size-cm", as_dense,
                         tank);
    }
    config->fish_count = as_dense > 1.0 ? (uint32_t)as_dense : 1u;
    return EXIT_OK;
}

static void settle_water(struct tank_config *config, const struct words *words)
{
    const struct {
        enum figure figure;
        float *value;
    } figures[] = {
        { FIGURE_TEMPERATURE_C, &config->temperature_c },
        { FIGURE_PRESSURE_HPA, &config->pressure_hpa },
        { FIGURE_OXYGEN_MG_L, &config->oxygen_mg_l },
        { FIGURE_TIME_COMPRESSION, &config->time_compression },
    };
    for (uint32_t i = 0; i < sizeof figures / sizeof figures[0]; i++) {
        if (words->given[figures[i].figure]) {
            *figures[i].value = (float)words->figure[figures[i].figure];
        }
    }
    if (words->pump != PUMP_AS_PRESET) {
        config->pump = words->pump == PUMP_ON;
    }
}

static enum exit_code tank_options_finish(struct tank_options *plan, const struct words *words)
{
    struct tank_config *config = &plan->config;
    const double *figure = words->figure;
    *config = tank_config_of(words->preset);
    if (words->given[FIGURE_AREA_SCALE]) {
        config->area_scale =
            f_clamp((float)figure[FIGURE_AREA_SCALE], TANK_AREA_SCALE_MIN, TANK_AREA_SCALE_MAX);
    }
    if (words->size_cm[0] > 0.0) {
        config->size_m = v3((float)(0.01 * words->size_cm[0]), (float)(0.01 * words->size_cm[1]),
                            (float)(0.01 * words->size_cm[2]));
    }
    if (words->given[FIGURE_WALL_FOLLOW]) {
        config->wall_follow = (float)figure[FIGURE_WALL_FOLLOW];
    }
    if (words->given[FIGURE_SEED]) {
        config->seed = (uint32_t)figure[FIGURE_SEED];
    }
    if (words->given[FIGURE_STAMINA]) {
        config->stamina_min = config->stamina_max = (float)(0.01 * figure[FIGURE_STAMINA]);
    }
    plan->has_fish = words->fish != NULL;
    config->search = words->search;
    config->ball_spaces = words->balls;
    settle_water(config, words);
    plan->seconds = words->given[FIGURE_SECONDS] ? figure[FIGURE_SECONDS] : 10.0;
    plan->tick_count = (uint32_t)round(plan->seconds * CORE_TICK_HZ);
    plan->trace_every =
        words->given[FIGURE_TRACE_EVERY] ? (uint32_t)figure[FIGURE_TRACE_EVERY] : 12u;
    if (words->given[FIGURE_OBSERVE_EVERY]) {
        plan->observe_every = (uint32_t)figure[FIGURE_OBSERVE_EVERY];
    }
    return settle_fish(plan, words);
}

enum exit_code tank_options_read(struct tank_options *plan, int argc, const char *const *argv)
{
    struct words words = { .preset = TANK_PRESET_THESIS };
    int used = 0;
    *plan = (struct tank_options){ 0 };
    for (int i = 0; i < argc; i += used) {
        const char *value = i + 1 < argc ? argv[i + 1] : NULL;
        const enum exit_code code = tank_options_take_option(plan, &words, argv[i], value, &used);
        if (code != EXIT_OK) {
            return code;
        }
    }
    return tank_options_finish(plan, &words);
}
