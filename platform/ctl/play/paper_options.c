/* paper_options.c -- the table of the options of `kingyoctl paper`. */
#include "platform/ctl/play/paper_options.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "core/poi/poi.h"
#include "platform/ctl/lib/ctl.h"
#include "platform/os/number.h"

/* Options in the units of the command line. */
struct words {
    struct paper_options plan; /* Options that need no conversion. */
    uint32_t grade;
    double wetness, wet_fraction, tilt_deg, speed_m_s, fish_cm, footprint_mm;
};

/* Parses a comma-separated list of weights in grams. */
static int take_weights(void *target, const struct option *option, const char *value, char *why)
{
    struct paper_options *plan = &((struct words *)target)->plan;
    (void)option;
    (void)why;
    plan->weight_count = 0;
    for (const char *from = value;;) {
        char word[48];
        const size_t length = strcspn(from, ",");
        double grams;
        snprintf(word, sizeof word, "%.*s", (int)(length < sizeof word ? length : 0u), from);
        if (plan->weight_count == PAPER_WEIGHTS_MAX ||
            !number_parse_decimal(word, 0.1, 5000, &grams)) {
            return 0;
        }
        plan->weights_kg[plan->weight_count++] = 1e-3 * grams;
        if (from[length] == '\0') {
            return 1;
        }
        from += length + 1u;
    }
}

static const char *const media[] = { "water", "air", NULL };

#define AT(member) .offset = offsetof(struct words, member)

/* clang-format off */
static const struct option table[] = {
    { .help = "The paper" },
    { "grade", "G", "grade of the paper; 4 is strong and 7 weak", OPTION_WHOLE, AT(grade),
      SHEET_GRADE_MIN, SHEET_GRADE_MAX, .initial = "5" },
    { "wetness", "W", "wetness of the wet part", OPTION_DECIMAL, AT(wetness), 0, 1,
      .initial = "1" },
    { "wet-fraction", "F", "share of the paper that is wet, up to a straight line",
      OPTION_DECIMAL, AT(wet_fraction), 0, 1, .initial = "1" },
    { "seed", "N", "seed of the specimen", OPTION_WHOLE, AT(plan.seed), 0, UINT32_MAX,
      .initial = "1" },
    { "ideal", NULL,
      "strength without spread, and stress without concentration, as in the membrane's formula",
      OPTION_FLAG, AT(plan.ideal) },
    { .help = "The motion and the load" },
    { "tilt-deg", "A",
      "angle between the plane of the paper and the motion; 90 is perpendicular to the motion",
      OPTION_DECIMAL, AT(tilt_deg), 0, 90, .initial = "90" },
    { "speed-m-s", "V", "constant upward speed in m/s", OPTION_DECIMAL, AT(speed_m_s), 0, 5,
      .initial = "0" },
    { "medium", "water|air", "medium around the poi: deep under water, or just taken out",
      OPTION_CHOICE, AT(plan.in_air), .choices = media, .initial = "water" },
    { "upside-down", NULL, "the ring's lip is up and holds water like a bowl", OPTION_FLAG,
      AT(plan.upside_down) },
    { "fish", "N", "number of fish on the paper in air; in water they have no weight",
      OPTION_WHOLE, AT(plan.fish_count), 0, POI_CARRIED_MAX, .initial = "0" },
    { "fish-cm", "L", "length of the fish in cm", OPTION_DECIMAL, AT(fish_cm), 1, 12,
      .initial = "5" },
    { "still", NULL, "the fish do not slap the paper", OPTION_FLAG, AT(plan.still) },
    { "seconds", "S", "length of the simulation in seconds", OPTION_DECIMAL, AT(plan.seconds),
      0.01, 3600, .initial = "10" },
    { .help = "The output" },
    { "json", NULL,
      "print as JSON: force_n (greatest force on the paper without the ring), tension_n_m_max "
      "(greatest tension in the plane of the paper, without concentration), time_to_tear_s (null "
      "if the paper does not tear), hole_area_mm2 (at the end), water_g (greatest mass of water "
      "on the paper)",
      OPTION_FLAG, AT(plan.as_json) },
    { .help = "Strength from weights" },
    { "calibrate", "G1,G2,...",
      "weights in g that tore wet specimens, one for each specimen; prints their strength, its "
      "spread and the line for the table",
      OPTION_CUSTOM, .set = take_weights,
      .expects = "weights in g from 0.1 to 5000, with commas between, 64 at most" },
    { "footprint-mm", "D", "diameter of the foot under each weight in mm", OPTION_DECIMAL,
      AT(footprint_mm), 1, 60, .initial = "20" },
    { "hang-s", "S", "time for which each weight hung, in seconds", OPTION_DECIMAL,
      AT(plan.hang_s), 0.05, 3600, .initial = "5" },
};
/* clang-format on */

const struct option_table paper_options_table = { table, sizeof table / sizeof table[0], NULL };

const char paper_options_notes[] =
    "The wetness is constant. Wet paper continues to soften, by a quarter in a minute. A tear\n"
    "within 0.05 s is instant. Examples:\n"
    "  kingyoctl paper --grade 6 --speed-m-s 0.3 --json\n"
    "  kingyoctl paper --grade 6 --wet-fraction 0.5 --speed-m-s 0.45\n"
    "  kingyoctl paper --grade 7 --medium air --fish 3 --fish-cm 4 --seconds 60\n"
    "  kingyoctl paper --grade 5 --calibrate 88,96,81,104,91 --footprint-mm 20 --hang-s 5\n";

enum exit_code paper_options_read(struct paper_options *plan, int argc, const char *const *argv)
{
    struct words words = { .grade = 0 };
    const enum exit_code code = ctl_options("paper", &paper_options_table, 0, &words, argc, argv);
    *plan = words.plan;
    plan->grade = (uint8_t)words.grade;
    plan->wetness = (float)words.wetness;
    plan->wet_fraction = (float)words.wet_fraction;
    plan->tilt_rad = (float)words.tilt_deg * F_DEG;
    plan->speed_m_s = (float)words.speed_m_s;
    plan->fish_m = 0.01f * (float)words.fish_cm;
    plan->tick_count = (uint32_t)ceil(plan->seconds * CORE_TICK_HZ - 1e-6);
    plan->footprint_m = 1e-3 * words.footprint_mm;
    return code;
}
