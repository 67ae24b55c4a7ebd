/* paper.c -- `kingyoctl paper`, which tests the paper of a poi (a paper scoop). The command moves
 * one poi through water or air, or computes the strength of paper from the weights under which the
 * paper tore. */
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "core/base/physics.h"
#include "platform/ctl/lib/ctl.h"
#include "platform/ctl/play/paper_lab.h"

static const char name[] = "paper";

/* ---- Simulation of a moving poi -------------------------------------------------------------- */

static void report_json(const struct paper_lab *lab)
{
    const double tore_s = paper_lab_tore_s(lab);
    printf("{\"force_n\": %.6f, \"tension_n_m_max\": %.4f, \"time_to_tear_s\": ",
           (double)lab->force_n, (double)lab->tension_n_m);
    if (tore_s < 0.0) {
        fputs("null", stdout);
    } else {
        printf("%.4f", tore_s);
    }
    printf(", \"hole_area_mm2\": %.2f, \"water_g\": %.3f}\n", paper_lab_hole_mm2(lab),
           1e3 * (double)lab->water_kg);
}

static void say_how_wet(const struct paper_options *plan)
{
    const double wet = 100.0 * (double)plan->wetness * (plan->wet_fraction > 0.0f ? 1.0 : 0.0);
    if (wet <= 0.0) {
        fputs(", dry", stdout);
    } else if (plan->wet_fraction < 1.0f) {
        printf(", %.3g %% of it %.3g %% wet", 100.0 * (double)plan->wet_fraction, wet);
    } else {
        printf(", %.3g %% wet", wet);
    }
}

static void say_what_it_meets(const struct paper_options *plan)
{
    const double tilt_deg = (double)(plan->tilt_rad / F_DEG);
    printf(": %.4g m/s at %.3g degrees through %s%s", (double)plan->speed_m_s, tilt_deg,
           plan->in_air ? "air" : "water", plan->upside_down ? ", upside down" : "");
    if (plan->fish_count > 0) {
        printf(", %u fish of %.3g cm%s", plan->fish_count, 100.0 * (double)plan->fish_m,
               plan->still ? " that lie still" : "");
    }
}

static void report_text(const struct paper_lab *lab)
{
    const struct paper_options *plan = lab->plan;
    const double tore_s = paper_lab_tore_s(lab);
    printf("No. %u paper%s", plan->grade, plan->ideal ? " of the formula" : "");
    say_how_wet(plan);
    say_what_it_meets(plan);
    printf("\n  force on the paper  %8.4f N\n", (double)lab->force_n);
    printf("  tension, greatest   %8.2f N/m; it is made for %.0f wet, %.0f dry\n",
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

static void paper_measure_all(const struct paper_options *plan)
{
    static struct paper_lab lab;
    paper_lab_open(&lab, plan);
    while (lab.tick < plan->tick_count) {
        paper_lab_tick(&lab);
    }
    (plan->as_json ? report_json : report_text)(&lab);
}

/* ---- Strength from weights ------------------------------------------------------------------- */

/* Returns the tension in N/m that the core's sheet model computes for a paper under a weight of
 * `weight_kg`. As for a fish, the load is a pressure of the whole weight on its footprint. */
static double tension_n_m(const struct paper_options *plan, double weight_kg)
{
    static struct sheet sheet;
    const float force_n = (float)weight_kg * GRAVITY_M_S2;
    const float area_m2 = F_PI * POI_RADIUS_M * POI_RADIUS_M;
    const struct sheet_load foot = { 0.0f, 0.0f, (float)plan->footprint_m, -force_n };
    const struct sheet_wetting in_air = { 0.0f, 0.0f, -1.0f };
    sheet_init(&sheet, plan->grade, POI_RADIUS_M, plan->seed);
    sheet_idealise(&sheet);
    return (double)sheet_tick(&sheet, -force_n / area_m2, in_air, &foot, 1).tension_max_n_m;
}

/* Returns the strength of the paper for a short load, in N/m. A paper resists a greater load for a
 * short time than for a long time. The strength is therefore the measured tension multiplied by
 * (time / tau)^(1/m). */
static double strength_n_m(const struct paper_options *plan, double weight_kg)
{
    const double longer = plan->hang_s / (double)SHEET_DAMAGE_TAU_S;
    return tension_n_m(plan, weight_kg) * pow(longer, 1.0 / SHEET_DAMAGE_EXPONENT);
}

static void calibrate(const struct paper_options *plan)
{
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
        printf("{\"grade\": %u, \"specimens\": %u, \"wet_n_m\": %.3f, \"spread\": %.4f}\n",
               plan->grade, plan->weight_count, mean, spread / mean);
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
    static struct paper_options plan;
    const enum exit_code code = paper_options_read(&plan, argc, argv);
    if (code != EXIT_OK) {
        return code;
    }
    (plan.weight_count > 0 ? calibrate : paper_measure_all)(&plan);
    return EXIT_OK;
}

const struct ctl_command ctl_paper = {
    .name = name,
    .summary = "one poi against water: force, tension, time to tear; weights to strength",
    .options = &paper_options_table,
    .notes = paper_options_notes,
    .run = paper_run,
};
