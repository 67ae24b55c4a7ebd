/* paper_options.c -- parses the options of `kingyoctl paper` with a table of all options and their
 * ranges. */
#include "platform/ctl/play/paper_options.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "core/poi/poi.h"
#include "platform/ctl/lib/ctl.h"
#include "platform/os/number.h"

static const char name[] = "paper";

/* ---- Parsing the options --------------------------------------------------------------------- */

enum figure {
    GRADE,
    WETNESS,
    WET_FRACTION,
    TILT_DEG,
    SPEED_M_S,
    FISH,
    FISH_CM,
    SECONDS,
    SEED,
    FOOTPRINT_MM,
    HANG_S,
    FIGURE_COUNT,
};

struct range {
    const char *option;
    double min, max;
    uint8_t is_whole;
    double standard; /* Default value of the option. */
};

static const struct range ranges[FIGURE_COUNT] = {
    [GRADE] = { "--grade", SHEET_GRADE_MIN, SHEET_GRADE_MAX, 1, 5 },
    [WETNESS] = { "--wetness", 0, 1, 0, 1 },
    [WET_FRACTION] = { "--wet-fraction", 0, 1, 0, 1 },
    [TILT_DEG] = { "--tilt-deg", 0, 90, 0, 90 },
    [SPEED_M_S] = { "--speed-m-s", 0, 5, 0, 0 },
    [FISH] = { "--fish", 0, POI_CARRIED_MAX, 1, 0 },
    [FISH_CM] = { "--fish-cm", 1, 12, 0, 5 },
    [SECONDS] = { "--seconds", 0.01, 3600, 0, 10 },
    [SEED] = { "--seed", 0, UINT32_MAX, 1, 1 },
    [FOOTPRINT_MM] = { "--footprint-mm", 1, 60, 0, 20 },
    [HANG_S] = { "--hang-s", 0.05, 3600, 0, 5 },
};

static enum exit_code paper_options_error(const char *option, const char *value,
                                          const char *expected)
{
    return ctl_usage(name, "%s: '%.100s' is not right; expected %s", option, value ? value : "",
                     expected);
}

static enum exit_code take_figure(double figures[FIGURE_COUNT], enum figure figure,
                                  const char *value)
{
    const struct range *range = &ranges[figure];
    double *out = &figures[figure];
    char expected[96];
    if (number_parse_decimal(value, range->min, range->max, out) &&
        (!range->is_whole || floor(*out) == *out)) {
        return EXIT_OK;
    }
    snprintf(expected, sizeof expected, "%s from %.10g to %.10g",
             range->is_whole ? "a whole number" : "a number", range->min, range->max);
    return paper_options_error(range->option, value, expected);
}

static enum exit_code take_medium(struct paper_options *plan, const char *value)
{
    plan->in_air = value && strcmp(value, "air") == 0;
    return plan->in_air || (value && strcmp(value, "water") == 0)
               ? EXIT_OK
               : paper_options_error("--medium", value, "water or air");
}

/* Parses a comma-separated list of weights in grams. */
static enum exit_code take_weights(struct paper_options *plan, const char *value)
{
    static const char expected[] = "weights in g from 0.1 to 5000, with commas between, 64 at most";
    const char *from = value ? value : "";
    plan->weight_count = 0;
    for (;;) {
        char word[48];
        const size_t length = strcspn(from, ",");
        snprintf(word, sizeof word, "%.*s", (int)(length < sizeof word ? length : 0u), from);
        double grams;
        if (plan->weight_count == PAPER_WEIGHTS_MAX ||
            !number_parse_decimal(word, 0.1, 5000, &grams)) {
            return paper_options_error("--calibrate", value, expected);
        }
        plan->weights_kg[plan->weight_count++] = 1e-3 * grams;
        if (from[length] == '\0') {
            return EXIT_OK;
        }
        from += length + 1u;
    }
}

static int take_flag(struct paper_options *plan, const char *option)
{
    const struct {
        const char *option;
        uint8_t *flag;
    } flags[] = {
        { "--upside-down", &plan->upside_down },
        { "--still", &plan->still },
        { "--ideal", &plan->ideal },
        { "--json", &plan->as_json },
    };
    for (size_t i = 0; i < sizeof flags / sizeof flags[0]; i++) {
        if (strcmp(option, flags[i].option) == 0) {
            *flags[i].flag = 1;
            return 1;
        }
    }
    return 0;
}

static enum exit_code take_valued(struct paper_options *plan, double figures[FIGURE_COUNT],
                                  const char *option, const char *value)
{
    if (strcmp(option, "--medium") == 0) {
        return take_medium(plan, value);
    }
    if (strcmp(option, "--calibrate") == 0) {
        return take_weights(plan, value);
    }
    for (uint32_t figure = 0; figure < FIGURE_COUNT; figure++) {
        if (strcmp(option, ranges[figure].option) == 0) {
            return take_figure(figures, (enum figure)figure, value);
        }
    }
    return ctl_usage(name, "unknown option '%.100s'; --help lists them", option);
}

enum exit_code paper_options_read(struct paper_options *plan, int argc, const char *const *argv)
{
    double figures[FIGURE_COUNT];
    *plan = (struct paper_options){ 0 };
    for (uint32_t figure = 0; figure < FIGURE_COUNT; figure++) {
        figures[figure] = ranges[figure].standard;
    }
    for (int i = 0; i < argc; i++) {
        if (take_flag(plan, argv[i])) {
            continue;
        }
        const char *value = i + 1 < argc ? argv[i + 1] : NULL;
        const enum exit_code code = take_valued(plan, figures, argv[i], value);
        if (code != EXIT_OK) {
            return code;
        }
        i++;
    }
    plan->grade = (uint8_t)figures[GRADE];
    plan->wetness = (float)figures[WETNESS];
    plan->wet_fraction = (float)figures[WET_FRACTION];
    plan->tilt_rad = (float)figures[TILT_DEG] * F_DEG;
    plan->speed_m_s = (float)figures[SPEED_M_S];
    plan->fish_count = (uint32_t)figures[FISH];
    plan->fish_m = 0.01f * (float)figures[FISH_CM];
    plan->seconds = figures[SECONDS];
    plan->tick_count = (uint32_t)ceil(figures[SECONDS] * CORE_TICK_HZ - 1e-6);
    plan->seed = (uint32_t)figures[SEED];
    plan->footprint_m = 1e-3 * figures[FOOTPRINT_MM];
    plan->hang_s = figures[HANG_S];
    return EXIT_OK;
}

/* ---- Text of --help -------------------------------------------------------------------------- */

const char paper_options_usage[] =
    "The paper\n"
    "  --grade G              4 (strong) to 7 (weak) (5)\n"
    "  --wetness W            of the wetted part, 0 to 1 (1)\n"
    "  --wet-fraction F       how much of the paper is wetted, 0 to 1, up to a straight line (1)\n"
    "  --seed N               which specimen (1)\n"
    "  --ideal                strength without spread, stress without concentration: what the\n"
    "                         membrane's formula speaks of\n"
    "What it meets\n"
    "  --tilt-deg A           between the paper's plane and its way, 0 to 90: broadside (90)\n"
    "  --speed-m-s V          its way leads straight up, 0 to 5 m/s, all the time (0)\n"
    "  --medium water|air     deep under water, or over it, just taken out (water)\n"
    "  --upside-down          the ring's lip up: it holds water like a bowl\n"
    "  --fish N               so many lie on it in air, 0 to 16; in water they weigh nothing (0)\n"
    "  --fish-cm L            1 to 12 (5)\n"
    "  --still                they do not slap\n"
    "  --seconds S            for so long, 0.01 to 3600 (10)\n"
    "What is told\n"
    "  --json                 force_n (greatest, on the paper without the ring), tension_n_m_max\n"
    "                         (of the paper's own plane, before it gathers anywhere),\n"
    "                         time_to_tear_s (null: it holds), hole_area_mm2 (at the end),\n"
    "                         water_g (the most that it carried)\n"
    "From weights to strength\n"
    "  --calibrate G1,G2,...  the weights in g that tore wet specimens, one each; prints their\n"
    "                         strength, its spread and the line for the table\n"
    "  --footprint-mm D       of the foot that they stood on, 1 to 60 (20)\n"
    "  --hang-s S             how long each step of weight hung, 0.05 to 3600 (5)\n\n"
    "The wetness is held; wet paper goes on softening, by a quarter in a minute. A tear within\n"
    "0.05 s is instant. Examples:\n"
    "  kingyoctl paper --grade 6 --speed-m-s 0.3 --json\n"
    "  kingyoctl paper --grade 6 --wet-fraction 0.5 --speed-m-s 0.45\n"
    "  kingyoctl paper --grade 7 --medium air --fish 3 --fish-cm 4 --seconds 60\n"
    "  kingyoctl paper --grade 5 --calibrate 88,96,81,104,91 --footprint-mm 20 --hang-s 5\n";
