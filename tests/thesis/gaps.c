/* gaps.c -- measures how closely two fish pass each other with two shapes of their personal space:
 * a box around the body, or a ball.
 *
 * Section 4.1 of the 2013 thesis states that fish with boxes pass each other more closely and more
 * smoothly. In this program two fish swim toward each other on parallel courses 0 to 10 cm apart.
 * The program writes CSV to standard output. Each row has the smallest gap between the bodies, the
 * deviation from the course, and whether the fish gave way. The values are means over SEEDS tanks,
 * because each fish gives way to a random side. */
#include <math.h>
#include <stdio.h>

#include "core/tank/tank.h"
#include "platform/cpu.h"

#define SEEDS 8u
#define TICKS (5u * CORE_TICK_HZ)
#define SPEED_M_S 0.0525f

struct passage {
    double gap_mm, stray_mm, gave_way;
};

static struct tank tank;

static void stage(float aside_m, uint8_t balls, uint32_t seed)
{
    struct tank_config config = tank_config_of(TANK_PRESET_THESIS);
    /* clang-format off */
    const struct tank_stage stages[2] = {
        { .position_m = { -0.12f, -0.10f, 0.0f }, .angles = { -0.5f * F_PI, 0.0f, 0.0f },
          .speed_m_s = SPEED_M_S, .stamina = 1.0f, .gait = GAIT_SWIM },
        { .position_m = { 0.12f, -0.10f, aside_m }, .angles = { 0.5f * F_PI, 0.0f, 0.0f },
          .speed_m_s = SPEED_M_S, .stamina = 1.0f, .gait = GAIT_SWIM },
    };
    /* clang-format on */
    config.fish_count = 2;
    config.ball_spaces = balls;
    config.seed = seed;
    config.lanes = cpu_lanes();
    if (tank_open(&tank, &config)) {
        tank_stage_all(&tank, stages, 2);
    }
}

static double gap_mm(void)
{
    const struct box a = fish_box(&tank.fish[0]), b = fish_box(&tank.fish[1]);
    /* The margins of 1 m are so large that box_gap() computes the exact gap. With small margins the
     * function may return early. */
    return 1000.0 * (double)box_gap(&a, 1.0f, &b, 1.0f).body_m;
}

static struct passage pass(float aside_m, uint8_t balls, uint32_t seed)
{
    struct passage passage = { .gap_mm = INFINITY };
    stage(aside_m, balls, seed);
    for (uint32_t tick = 0; tick < TICKS; tick++) {
        tank_tick(&tank, tick, NULL, 0);
        const struct fish *fish = tank.fish;
        const double first_mm = 1000.0 * fabs((double)fish[0].position_m.z);
        const double second_mm = 1000.0 * fabs((double)(fish[1].position_m.z - aside_m));
        passage.gap_mm = fmin(passage.gap_mm, gap_mm());
        /* Measures the deviation only until the fish have passed each other. */
        if (fish[0].position_m.x < fish[1].position_m.x) {
            passage.stray_mm = fmax(passage.stray_mm, 0.5 * (first_mm + second_mm));
        }
        if (fish[0].avoiding != AVOID_NONE || fish[1].avoiding != AVOID_NONE) {
            passage.gave_way = 1.0;
        }
    }
    return passage;
}

int main(void)
{
    puts("courses_apart_cm,box_gap_mm,ball_gap_mm,box_stray_mm,ball_stray_mm,box_gave_way,"
         "ball_gave_way");
    for (int step = 0; step <= 20; step++) {
        const float aside_m = 0.005f * (float)step;
        struct passage mean[2] = { 0 };
        for (uint32_t i = 0; i < 2u * SEEDS; i++) {
            const struct passage one = pass(aside_m, (uint8_t)(i % 2u), 1u + i / 2u);
            struct passage *sum = &mean[i % 2u];
            sum->gap_mm += one.gap_mm / SEEDS;
            sum->stray_mm += one.stray_mm / SEEDS;
            sum->gave_way += one.gave_way / SEEDS;
        }
        printf("%.1f,%.2f,%.2f,%.2f,%.2f,%.3f,%.3f\n", 100.0 * (double)aside_m, mean[0].gap_mm,
               mean[1].gap_mm, mean[0].stray_mm, mean[1].stray_mm, mean[0].gave_way,
               mean[1].gave_way);
    }
    return 0;
}
