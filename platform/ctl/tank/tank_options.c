/* tank_options.c -- the options of `kingyoctl tank`: their table, and the check of the options
 * against each other and against the tank preset. */
#include "platform/ctl/tank/tank_options.h"

#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include "core/base/panic.h"
#include "platform/ctl/lib/ctl.h"
#include "platform/os/number.h"

#define LIST_MAX 256
/* Converts metres to whole centimetres. Rounding is needed because the float 0.30f is not exactly
 * 0.3. */
#define CM(metres) ((double)(int)(100.0f * (metres) + 0.5f))

static const char name[] = "tank";

enum pump {
    PUMP_OFF,
    PUMP_ON,
    PUMP_AS_PRESET,
};

/* Options as the user wrote them, before the tank preset is applied. A number that is NaN selects
 * the value of the tank preset. */
struct words {
    struct tank_options plan; /* Options that do not depend on the tank preset. */
    uint8_t preset;
    uint8_t pump;   /* Setting of the water pump (enum pump). */
    uint8_t search; /* Method of the pair search (enum pair_search). */
    uint8_t balls;  /* 1 for the option --spaces ball, otherwise 0. */
    uint32_t seed;
    double area_scale, wall_follow, stamina;
    double temperature_c, pressure_hpa, oxygen_mg_l, time_compression;
    /* Size of the tank in cm along x, y and z. The size along y is the depth of the water. 0
     * selects the size of the tank preset. */
    double size_cm[3];
    /* Value of --fish, or null if the option is absent. The allowed range depends on the tank
     * preset and on the floor area, so the value is parsed later. */
    const char *fish;
};

/* ---- Parsing lists of numbers ---------------------------------------------------------------- */

struct range {
    double min, max;
};

/* Parses `count` comma-separated numbers, each in its own range. Returns true, or false if the list
 * is invalid. */
static bool read_list(const char *text, const struct range *parts, int count, double *out)
{
    char list[LIST_MAX], *rest = list;
    CORE_ASSERT(text && count > 0);
    snprintf(list, sizeof list, "%s", text);
    for (int i = 0; i < count; i++) {
        if (!number_parse_decimal(strsep(&rest, ","), parts[i].min, parts[i].max, &out[i])) {
            return false;
        }
    }
    return !rest && strlen(text) < sizeof list;
}

static bool take_size(void *target, const struct option *option, const char *value, char *why)
{
    static const struct range parts[3] = {
        { CM(TANK_SIDE_MIN_M), CM(TANK_SIDE_MAX_M) },
        { CM(TANK_DEPTH_MIN_M), CM(TANK_DEPTH_MAX_M) },
        { CM(TANK_SIDE_MIN_M), CM(TANK_SIDE_MAX_M) },
    };
    (void)option;
    (void)why;
    return read_list(value, parts, 3, ((struct words *)target)->size_cm);
}

static bool take_shade(void *target, const struct option *option, const char *value, char *why)
{
    static const struct range parts[5] = {
        { -1000, 1000 },
        { -1000, 1000 },
        { CM(SHADE_RADIUS_MIN_M), CM(SHADE_RADIUS_MAX_M) },
        { 0, PLAN_SECONDS_MAX },
        { 0, PLAN_SECONDS_MAX },
    };
    struct tank_options *plan = &((struct words *)target)->plan;
    double part[5];
    (void)option;
    if (plan->shade_count == SHADE_MAX) {
        snprintf(why, OPTION_TEXT_MAX, "at most %u shades", SHADE_MAX);
        return false;
    }
    if (!read_list(value, parts, 5, part) || part[3] >= part[4]) {
        return false;
    }
    plan->shade[plan->shade_count++] = (struct plan_shade){
        0.01 * part[0], 0.01 * part[1], 0.01 * part[2], part[3], part[4],
    };
    return true;
}

/* ---- Table of options ------------------------------------------------------------------------ */

static const char *const pumps[] = { [PUMP_OFF] = "off", [PUMP_ON] = "on", NULL };
static const char *const searches[] = {
    [PAIR_SEARCH_GRID] = "grid",
    [PAIR_SEARCH_ALL] = "all",
    NULL,
};
static const char *const spaces[] = { "box", "ball", NULL };

#define AT(member) .offset = offsetof(struct words, member)

/* clang-format off */
static const struct option table[] = {
    { .help = "The tank" },
    { "preset", "NAME", "tank preset", OPTION_CHOICE, AT(preset), .choices = options_tank_names,
      .initial = "thesis" },
    { "fish", "N",
      "number of fish, at most 131,072 and as many as the water holds; the default is the preset's "
      "number, or the same number per volume in more or less water",
      OPTION_TEXT, AT(fish), .expects = "a whole number" },
    { "area-scale", "K", "floor area relative to the preset's floor area; 1 without the option",
      OPTION_DECIMAL, AT(area_scale), 0.05, 250 },
    { "size-cm", "W,D,B",
      "width, depth and breadth of the water; the default is the preset's size",
      OPTION_CUSTOM, .set = take_size,
      .expects = "WIDTH,DEPTH,BREADTH of the water: 30 to 200 cm, 5 to 50 cm, 30 to 200 cm" },
    { "wall-follow", "K", "strength with which walls attract fish; 0 without the option",
      OPTION_DECIMAL, AT(wall_follow), 0, 1 },
    { "spaces", "SHAPE", "shape of the personal spaces; ball is meant for comparisons",
      OPTION_CHOICE, AT(balls), .choices = spaces, .initial = "box" },
    { "stamina", "H", "stamina of every fish at the start; the default is the preset's spread",
      OPTION_DECIMAL, AT(stamina), 0, 100 },
    { "temperature-c", "T", "temperature of the water; the default is the preset's",
      OPTION_DECIMAL, AT(temperature_c), (double)OXYGEN_TEMPERATURE_MIN_C,
      (double)OXYGEN_TEMPERATURE_MAX_C },
    { "pressure-hpa", "P", "pressure of the air; 1013.25 without the option", OPTION_DECIMAL,
      AT(pressure_hpa), (double)OXYGEN_PRESSURE_MIN_HPA, (double)OXYGEN_PRESSURE_MAX_HPA },
    { "oxygen-mg-l", "C",
      "dissolved oxygen at the start; the default is as much as the water holds", OPTION_DECIMAL,
      AT(oxygen_mg_l), 0, (double)OXYGEN_MAX_MG_L },
    { "pump", "on|off", "whether the air stone bubbles; the default is the preset's",
      OPTION_CHOICE, AT(pump), .choices = pumps },
    { "time-compression", "K",
      "hours of the water for one hour of the fish; the default is the preset's", OPTION_DECIMAL,
      AT(time_compression), 0, (double)OXYGEN_TIME_COMPRESSION_MAX },
    { "seed", "N", "seed of all random numbers; equal seeds give equal fish", OPTION_WHOLE,
      AT(seed), 0, UINT32_MAX, .initial = "1" },
    { "place", "FILE",
      "start positions of the fish: CSV with x_cm,y_cm,z_cm,yaw_deg, and optionally "
      "pitch_deg,roll_deg,length_cm,speed_cm_s,gait,stamina; or a trace, of which the first tick "
      "is used. Gaits: rest, swim, burst; escape continues as burst; surface continues as gulp, or "
      "rises to gulp if the fish is deep; held is refused because no poi holds the fish. The "
      "length determines the box",
      OPTION_TEXT, AT(plan.place) },
    { .help = "The simulation" },
    { "seconds", "S", "length of the simulation in seconds", OPTION_DECIMAL, AT(plan.seconds), 0.1,
      PLAN_SECONDS_MAX, .initial = "10" },
    { "shade", "X_CM,Z_CM,R_CM,FROM_S,TO_S",
      "round shade over the water from second FROM_S to second TO_S; at most 4 shades. shade_count "
      "counts the fish within a shade, also while the shade is not cast",
      OPTION_CUSTOM, .set = take_shade,
      .expects = "X_CM,Z_CM,R_CM,FROM_S,TO_S: centre -1000 to 1000 cm, radius 1 to 30 cm, "
                 "0 <= FROM_S < TO_S <= 36000" },
    { "poi-path", "FILE",
      "path of a poi: CSV t_s,x_cm,y_cm,z_cm,yaw_deg,pitch_deg,roll_deg; linear between the rows, "
      "and constant after the last row. The poi is the game's poi with No. 5 paper and yields in "
      "the same way",
      OPTION_TEXT, AT(plan.poi_path) },
    { .help = "The output" },
    { "pairs", "HOW",
      "search for near fish: with the grid, or each fish against each fish, which is slower and "
      "gives equal results",
      OPTION_CHOICE, AT(search), .choices = searches, .initial = "grid" },
    { "json", NULL, "print the figures as JSON", OPTION_FLAG, AT(plan.as_json) },
    { "trace", "FILE", "write the positions of all fish to FILE as CSV", OPTION_TEXT,
      AT(plan.trace) },
    { "trace-every", "TICKS", "ticks between two samples of the trace, from tick 0 on",
      OPTION_WHOLE, AT(plan.trace_every), 1, PLAN_SECONDS_MAX * CORE_TICK_HZ, .initial = "12" },
    { "observe-every", "TICKS",
      "overlaps, encounters, shares and speeds are measured at this interval and after the last "
      "tick. The default is 1, or 24 with more than 2,048 fish, because measuring takes longer "
      "than a tick",
      OPTION_WHOLE, AT(plan.observe_every), 1, PLAN_SECONDS_MAX * CORE_TICK_HZ },
};
/* clang-format on */

const struct option_table tank_options_table = OPTION_TABLE(table, NULL);

const char tank_options_notes[] =
    "Lengths are in cm: x to the right, y up from the surface, z toward the player. Angles\n"
    "are in degrees: yaw about +y (0 faces -z), then pitch (lifts the nose), then roll\n"
    "(lowers the right side). A tick is 1/120 s. Counts per second begin with the start,\n"
    "second 0. Shares and means are over all fish and observed ticks. Speeds, mean and max,\n"
    "are over fish that swim: not held by a poi, and not falling through the air.\n"
    "body_overlaps counts pairs deeper than 0.5 mm, once for each observed tick. An\n"
    "encounter counts if it lasts until an observed tick.\n"
    "ns_per_fish_tick and tick_ms are the CPU time of the tank's own tick, without the\n"
    "measuring. The 4 ticks after each observation are not counted, because the measuring\n"
    "has replaced the tank's data in the caches. With --observe-every 1 to 4, all ticks are\n"
    "timed.\n"
    "In CSV files every column must be known, and every row must be as long as the header.\n";

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
    char range[96];
    const uint32_t most = tank_config_fish_max(config);
    snprintf(range, sizeof range, "1 to %u fish in %.3g times the water of the %s tank", most,
             waters(config), tank_preset(config->preset)->name);
    if (words->fish) {
        return number_parse(words->fish, 1, most, &config->fish_count)
                   ? EXIT_OK
                   : ctl_usage(name, "--fish: '%.100s' is wrong; expected %s", words->fish, range);
    }
    const double as_dense = round((double)config->fish_count * waters(config));
    if (as_dense > (double)most) {
        return ctl_usage(name,
                         "%s: %.0f fish at the preset's density are too many; with --fish, %s",
                         isnan(words->area_scale) ? "--size-cm" : "--area-scale", as_dense, range);
    }
    config->fish_count = as_dense > 1.0 ? (uint32_t)as_dense : 1u;
    return EXIT_OK;
}

enum exit_code tank_options_read(struct tank_options *plan, int argc, const char *const *argv)
{
    struct words words = {
        .pump = PUMP_AS_PRESET,
        .area_scale = NAN,
        .wall_follow = NAN,
        .stamina = NAN,
        .temperature_c = NAN,
        .pressure_hpa = NAN,
        .oxygen_mg_l = NAN,
        .time_compression = NAN,
    };
    const enum exit_code code = ctl_options(name, &tank_options_table, 0, &words, argc, argv);
    if (code != EXIT_OK) {
        return code;
    }
    *plan = words.plan;
    plan->has_fish = words.fish != NULL;
    plan->tick_count = (uint32_t)round(plan->seconds * CORE_TICK_HZ);
    struct tank_config *config = &plan->config;
    *config = tank_config_of(words.preset);
    const struct {
        double given;
        float *value;
    } numbers[] = {
        { words.area_scale, &config->area_scale },
        { words.wall_follow, &config->wall_follow },
        { 0.01 * words.stamina, &config->stamina_min },
        { 0.01 * words.stamina, &config->stamina_max },
        { words.temperature_c, &config->temperature_c },
        { words.pressure_hpa, &config->pressure_hpa },
        { words.oxygen_mg_l, &config->oxygen_mg_l },
        { words.time_compression, &config->time_compression },
    };
    for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; i++) {
        *numbers[i].value = isnan(numbers[i].given) ? *numbers[i].value : (float)numbers[i].given;
    }
    config->area_scale = f_clamp(config->area_scale, TANK_AREA_SCALE_MIN, TANK_AREA_SCALE_MAX);
    if (words.size_cm[0] > 0.0) {
        config->size_m = v3((float)(0.01 * words.size_cm[0]), (float)(0.01 * words.size_cm[1]),
                            (float)(0.01 * words.size_cm[2]));
    }
    config->seed = words.seed;
    config->pump = words.pump == PUMP_AS_PRESET ? config->pump : words.pump == PUMP_ON;
    config->search = words.search;
    config->ball_spaces = words.balls;
    return settle_fish(plan, &words);
}
