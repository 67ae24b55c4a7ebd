/* paper.c -- `kingyoctl paper`, which tests the paper of a poi (a paper scoop). The command moves
 * one poi through water or air, or computes the strength of paper from the weights under which the
 * paper tore. */
#include "platform/ctl/play/paper_lab.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "core/base/panic.h"
#include "core/base/physics.h"
#include "core/poi/poi.h"
#include "platform/ctl/lib/ctl.h"
#include "platform/os/json.h"
#include "platform/os/number.h"

/* Options in the units of the command line. */
struct words {
    struct paper_options plan; /* Options that are used without conversion. */
    uint32_t grade;
    double wetness, wet_fraction, tilt_deg, speed_m_s, fish_cm, footprint_mm;
};

/* Parses a comma-separated list of weights in grams. */
static bool take_weights(void *target, const struct option *option, const char *value, char *why)
{
    struct paper_options *plan = &((struct words *)target)->plan;
    char list[2048], *rest = list;
    (void)option;
    (void)why;
    if ((size_t)snprintf(list, sizeof list, "%s", value) >= sizeof list) {
        return false;
    }
    for (plan->weight_count = 0; rest; plan->weight_count++) {
        double grams;
        if (plan->weight_count == PAPER_WEIGHTS_MAX ||
            !number_parse_decimal(strsep(&rest, ","), 0.1, 5000, &grams)) {
            return false;
        }
        plan->weights_kg[plan->weight_count] = 1e-3 * grams;
    }
    return true;
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

static const struct option_table paper_options_table = OPTION_TABLE(table, NULL);

static const char paper_options_notes[] =
    "The wetness is constant. Wet paper continues to soften, by a quarter in a minute. A tear\n"
    "within 0.05 s is instant. Examples:\n"
    "  kingyoctl paper --grade 6 --speed-m-s 0.3 --json\n"
    "  kingyoctl paper --grade 6 --wet-fraction 0.5 --speed-m-s 0.45\n"
    "  kingyoctl paper --grade 7 --medium air --fish 3 --fish-cm 4 --seconds 60\n"
    "  kingyoctl paper --grade 5 --calibrate 88,96,81,104,91 --footprint-mm 20 --hang-s 5\n";

static const char name[] = "paper";

/* ---- Simulation of a moving poi -------------------------------------------------------------- */

static void report_json(const struct paper_lab *lab)
{
    const double tore_s = paper_lab_tore_s(lab);
    struct json json = { .file = stdout };
    json_print(&json,
               "{force_n: %.6f, tension_n_m_max: %.4f, time_to_tear_s: %.4f, hole_area_mm2: %.2f,"
               " water_g: %.3f}",
               (double)lab->force_n, (double)lab->tension_n_m, tore_s < 0.0 ? (double)NAN : tore_s,
               paper_lab_hole_mm2(lab), 1e3 * (double)lab->water_kg);
    json_end(&json);
}

static void report_text(const struct paper_lab *lab)
{
    const struct paper_options *plan = lab->plan;
    const double tore_s = paper_lab_tore_s(lab);
    printf("No. %u paper%s", plan->grade, plan->ideal ? " of the formula" : "");
    const double wet = 100.0 * (double)plan->wetness * (plan->wet_fraction > 0.0f ? 1.0 : 0.0);
    if (wet <= 0.0) {
        fputs(", dry", stdout);
    } else if (plan->wet_fraction < 1.0f) {
        printf(", %.3g %% of it %.3g %% wet", 100.0 * (double)plan->wet_fraction, wet);
    } else {
        printf(", %.3g %% wet", wet);
    }
    printf(": %.4g m/s at %.3g degrees through %s%s", (double)plan->speed_m_s,
           (double)(plan->tilt_rad / F_DEG), plan->in_air ? "air" : "water",
           plan->upside_down ? ", upside down" : "");
    if (plan->fish_count > 0) {
        printf(", %u fish of %.3g cm%s", plan->fish_count, 100.0 * (double)plan->fish_m,
               plan->still ? " that lie still" : "");
    }
    printf("\n  force on the paper  %8.4f N\n", (double)lab->force_n);
    printf("  tension, greatest   %8.2f N/m; its strength is %.0f wet, %.0f dry\n",
           (double)lab->tension_n_m, (double)sheet_grade(plan->grade)->wet_n_m,
           (double)sheet_grade(plan->grade)->dry_n_m);
    if (tore_s < 0.0) {
        printf("  tears                  not in %.4g s\n", plan->seconds);
    } else {
        printf("  tears after         %8.3f s%s\n", tore_s,
               paper_lab_is_instant(lab) ? ": instant" : "");
    }
    printf("  hole, in the end    %8.0f mm2 of %.0f\n", paper_lab_hole_mm2(lab),
           1e6 * (double)(F_PI * POI_RADIUS_M * POI_RADIUS_M));
    printf("  water carried       %8.2f g at most\n", 1e3 * (double)lab->water_kg);
}

/* ---- Strength from weights ------------------------------------------------------------------- */

/* Returns the strength in N/m of a paper that tore under a weight of `weight_kg`. The core's sheet
 * model computes the tension. As for a fish, the load is a pressure of the whole weight on its
 * footprint. A paper resists a greater load for a short time than for a long time. The strength for
 * a short load is therefore the tension multiplied by (time / tau)^(1/m). */
static double strength_n_m(const struct paper_options *plan, double weight_kg)
{
    static struct sheet sheet;
    const float force_n = (float)weight_kg * GRAVITY_M_S2;
    const float area_m2 = F_PI * POI_RADIUS_M * POI_RADIUS_M;
    const struct sheet_load foot = { 0.0f, 0.0f, (float)plan->footprint_m, -force_n };
    const struct sheet_wetting in_air = { 0.0f, 0.0f, -1.0f };
    CORE_ASSERT(weight_kg > 0.0 && plan->footprint_m > 0.0 && plan->hang_s > 0.0);
    sheet_init(&sheet, plan->grade, POI_RADIUS_M, plan->seed);
    sheet_idealise(&sheet);
    const float tension_n_m =
        sheet_tick(&sheet, -force_n / area_m2, in_air, &foot, 1).tension_max_n_m;
    const double longer = plan->hang_s / (double)SHEET_DAMAGE_TAU_S;
    return (double)tension_n_m * pow(longer, 1.0 / SHEET_DAMAGE_EXPONENT);
}

static void print_paper_calibration(const struct paper_options *plan)
{
    CORE_ASSERT(plan->weight_count >= 1 && plan->weight_count <= PAPER_WEIGHTS_MAX);
    const struct paper_grade *grade = sheet_grade(plan->grade);
    const double count = (double)plan->weight_count;
    double sum = 0.0, squares = 0.0;
    for (uint32_t i = 0; i < plan->weight_count; i++) {
        const double strength = strength_n_m(plan, plan->weights_kg[i]);
        sum += strength;
        squares += strength * strength;
    }
    const double mean = sum / count;
    const double spread =
        count > 1.0 ? sqrt(fmax(0.0, (squares - count * mean * mean) / (count - 1.0))) : 0.0;
    if (plan->as_json) {
        struct json json = { .file = stdout };
        json_print(&json, "{grade: %u, specimens: %u, wet_n_m: %.3f, spread: %.4f}", plan->grade,
                   plan->weight_count, mean, spread / mean);
        json_end(&json);
        return;
    }
    printf("No. %u: %u weights on a foot of %.3g mm, %.3g s each\n", plan->grade,
           plan->weight_count, 1e3 * plan->footprint_m, plan->hang_s);
    printf("  wet strength  %.1f N/m (now %.0f in the table)\n", mean, (double)grade->wet_n_m);
    if (plan->weight_count > 1) {
        printf("  spread        %.0f %% (now 12)\n", 100.0 * spread / mean);
    }
    printf("  the line      { .areal_kg_m2 = %.3ff, .dry_n_m = %.1ff, .wet_n_m = %.1ff, "
           ".stiffness_n_m = %.1ff },\n",
           (double)grade->areal_kg_m2, (double)grade->dry_n_m, mean, (double)grade->stiffness_n_m);
}

/* ---- Command line and main program ----------------------------------------------------------- */

static enum exit_code paper_run(int argc, const char *const *argv)
{
    static struct paper_lab lab;
    struct words words = { .grade = 0 };
    const enum exit_code code = ctl_options(name, &paper_options_table, 0, &words, argc, argv);
    if (code != EXIT_OK) {
        return code;
    }
    struct paper_options plan = words.plan;
    plan.grade = (uint8_t)words.grade;
    plan.wetness = (float)words.wetness;
    plan.wet_fraction = (float)words.wet_fraction;
    plan.tilt_rad = (float)words.tilt_deg * F_DEG;
    plan.speed_m_s = (float)words.speed_m_s;
    plan.fish_m = 0.01f * (float)words.fish_cm;
    plan.tick_count = (uint32_t)ceil(plan.seconds * CORE_TICK_HZ - 1e-6);
    plan.footprint_m = 1e-3 * words.footprint_mm;
    if (plan.weight_count > 0) {
        print_paper_calibration(&plan);
        return EXIT_OK;
    }
    paper_lab_open(&lab, &plan);
    while (lab.tick < plan.tick_count) {
        paper_lab_tick(&lab);
    }
    (plan.as_json ? report_json : report_text)(&lab);
    return EXIT_OK;
}

const struct ctl_command ctl_paper = {
    .name = name,
    .summary = "one poi against water: force, tension, time to tear; weights to strength",
    .options = &paper_options_table,
    .notes = paper_options_notes,
    .run = paper_run,
};
