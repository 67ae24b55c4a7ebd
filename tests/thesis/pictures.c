/* pictures.c -- renders figures 4.1 to 4.24 of chapter 4 of the 2013 thesis from Kingyo's tank.
 *
 * Usage: pictures FOLDER. The program writes the pictures, and one line for each picture into
 * FOLDER/pictures.tsv: number, file, time, description and options. `kingyoctl tank` runs the same
 * tank with these options, so that each picture can be examined there. */
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "platform/ctl/tank/tank_report.h"
#include "tests/thesis/easel.h"

#define WORDS_MAX 24
#define WORDS_LENGTH 256u
#define SEEDS_MAX 64u
#define STRAIGHT_RAD_S (5.0f * F_DEG)
#define GOES_ON_LENGTHS 1.3f

static struct tank_lab lab;
static struct tank_options plan;
static const char *folder;
static FILE *list;

static void fail(const char *what)
{
    fprintf(stderr, "pictures: %s\n", what);
    exit(1);
}

/* Opens the tank that the options in `words` describe. */
static void open_lab(const char *words)
{
    static char text[512];
    const char *argv[WORDS_MAX];
    int argc = 0;
    snprintf(text, sizeof text, "%s", words);
    for (char *word = strtok(text, " "); word && argc < WORDS_MAX; word = strtok(NULL, " ")) {
        argv[argc++] = word;
    }
    memset(&lab, 0, sizeof lab);
    if (tank_options_read(&plan, argc, argv) != EXIT_OK || tank_lab_open(&lab, &plan) != EXIT_OK) {
        fail(words);
    }
}

static void run_until(uint32_t tick)
{
    while (lab.tick < tick) {
        tank_lab_tick(&lab);
    }
}

static void shoot(const char *number, const struct easel_shot *shot, const char *seen,
                  const char *words)
{
    char path[1024], file[64];
    snprintf(file, sizeof file, "figure-%s.png", number);
    snprintf(path, sizeof path, "%s/%s", folder, file);
    if (easel_shoot(&lab, shot, path) != 0) {
        exit(1);
    }
    fprintf(list, "%s\t%s\t%.2f s\t%s\t%s\n", number, file, (double)lab.tick / CORE_TICK_HZ, seen,
            words);
    printf("  %s  %s at %.2f s: %s\n", file, number, (double)lab.tick / CORE_TICK_HZ, seen);
    fflush(stdout);
}

/* ---- Figures 4.1 to 4.12: two fish meet ----------------------------------------------------- */

/* An encounter of two fish in section 4.1 of the thesis. Each fish gives way to a random side. The
 * program therefore searches for the first seed with which both fish turn as in the thesis. */
struct encounter {
    /* Number of the first of the encounter's figures. The value n stands for figure 4.n of the
     * thesis. */
    int first;
    const char *name, *what;
    uint8_t kind; /* Kind of encounter (enum meeting_kind). */
    float turn;   /* Side to which the first fish must turn: -1 is right, +1 is left. */
    /* Number of fish that must give way: one of the two fish, or both. */
    uint8_t yields;
};

static const struct encounter encounters[] = {
    { 1, "head_on", "head-on", MEET_HEAD_ON, 1.0f, 2 },
    /* In this encounter, the second fish hits the side of the first fish from behind. */
    { 5, "side", "from the side", MEET_STRUCK, 1.0f, 2 },
    { 9, "rear_end", "from behind", MEET_REAR_END, -1.0f, 1 },
};

struct moments {
    uint32_t begins, nearest, done, after;
};

static int avoids(uint32_t i)
{
    return lab.tank.fish[i].avoiding != AVOID_NONE;
}

static double apart_m(void)
{
    return (double)v3_length(v3_sub(lab.tank.fish[0].position_m, lab.tank.fish[1].position_m));
}

static bool is_of_its_kind(const struct encounter *encounter)
{
    const struct fish *fish = &lab.tank.fish[0];
    return avoids(0) && fish->avoid_kind == encounter->kind &&
           fish->avoid_turn * encounter->turn > 0.0f;
}

/* Returns 1 if both fish have kept their course since `from`. A swimming fish must also have
 * advanced by more than its length. */
static int both_go_on(const struct fish from[2])
{
    for (int i = 0; i < 2; i++) {
        const struct fish *fish = &lab.tank.fish[i];
        const vec3 way_m = v3_sub(fish->position_m, from[i].position_m);
        const int rests = fish->gait == GAIT_REST;
        if (f_abs(fish->yaw_rate_rad_s) > STRAIGHT_RAD_S ||
            (!rests && v3_dot(way_m, fish_forward(fish)) < GOES_ON_LENGTHS * fish->length_m)) {
            return 0;
        }
    }
    return 1;
}

/* Finds the ticks of four moments of an encounter: the fish begin to give way, are nearest to each
 * other, end the avoidance, and swim on. Returns 1 if the encounter is like that of the thesis. */
static int find_moments(const char *words, const struct encounter *encounter, struct moments *found)
{
    struct fish from[2] = { 0 };
    uint8_t gave_way[2] = { 0 };
    double nearest_m = INFINITY;
    int right = 0;
    *found = (struct moments){ 0 };
    open_lab(words);
    while (found->after == 0 && lab.tick < plan.tick_count) {
        tank_lab_tick(&lab);
        if (apart_m() < nearest_m) {
            nearest_m = apart_m();
            found->nearest = lab.tick;
        }
        if (avoids(0) || avoids(1)) {
            right = found->begins ? right : is_of_its_kind(encounter);
            found->begins = found->begins ? found->begins : lab.tick;
            found->done = lab.tick + 1u;
            gave_way[0] |= (uint8_t)avoids(0);
            gave_way[1] |= (uint8_t)avoids(1);
        } else if (found->begins && lab.tick == found->done) {
            memcpy(from, lab.tank.fish, sizeof from);
        } else if (found->begins && both_go_on(from)) {
            found->after = lab.tick;
        }
    }
    tank_lab_close(&lab);
    return right && found->after && gave_way[0] + gave_way[1] == encounter->yields;
}

static void open_trace(struct tank_trace *trace, const char *name)
{
    static char path[1024];
    snprintf(path, sizeof path, "%s/%s.csv", folder, name);
    if (tank_trace_open(trace, path) != EXIT_OK) {
        exit(1);
    }
}

static void close_trace(struct tank_trace *trace)
{
    if (tank_trace_close(trace) != EXIT_OK) {
        exit(1);
    }
}

static void trace_meeting(const char *name, const char *words, const struct moments *moments)
{
    struct tank_trace trace;
    open_lab(words);
    open_trace(&trace, name);
    for (tank_trace_add(&trace, &lab.tank, 0); lab.tick < moments->after;) {
        tank_lab_tick(&lab);
        if (lab.tick % 6u == 0) {
            tank_trace_add(&trace, &lab.tank, lab.tick);
        }
    }
    close_trace(&trace);
    tank_lab_close(&lab);
}

/* Sets the camera so that its picture contains both fish at all four moments, with a margin of a
 * fish's length. */
static void frame_all(struct easel_shot *shot, const char *words, const uint32_t ticks[4])
{
    vec3 low = { 9.0f, 0.0f, 9.0f }, high = { -9.0f, 0.0f, -9.0f };
    open_lab(words);
    for (int i = 0; i < 4; i++) {
        run_until(ticks[i]);
        for (int k = 0; k < 2; k++) {
            const vec3 at = lab.tank.fish[k].position_m;
            low = v3(f_min(low.x, at.x), at.y, f_min(low.z, at.z));
            high = v3(f_max(high.x, at.x), at.y, f_max(high.z, at.z));
        }
    }
    tank_lab_close(&lab);
    const float wide_m = high.x - low.x + 0.10f, tall_m = high.z - low.z + 0.08f;
    shot->look_at_m = v3_lerp(low, high, 0.5f);
    shot->width_m = f_max(0.24f, f_max(wide_m, tall_m * 16.0f / 9.0f));
}

/* Finds the first seed with which the fish meet as in the thesis. Writes the options of the tank
 * with this seed to `words`, and returns the four moments. */
static struct moments stage_meeting(const struct encounter *encounter, char words[WORDS_LENGTH])
{
    struct moments found;
    for (uint32_t seed = 1; seed <= SEEDS_MAX; seed++) {
        snprintf(words, WORDS_LENGTH, "--place tests/thesis/%s.csv --seconds 12 --seed %u",
                 encounter->name, seed);
        if (find_moments(words, encounter, &found)) {
            return found;
        }
    }
    fail("no seed has them give way as in the thesis");
    return found;
}

static void shoot_meeting(const struct encounter *encounter)
{
    static const char *const moments[4] = { "they begin to give way", "they give way",
                                            "they have given way", "each goes on" };
    char words[WORDS_LENGTH], number[8], seen[160];
    const struct moments found = stage_meeting(encounter, words);
    struct easel_shot shot = { .camera = CAMERA_MEETING };
    /* The second picture shows the moment at which the fish are nearest to each other. If this
     * moment is not during the avoidance, the picture shows the middle of the avoidance instead. */
    const uint32_t during = found.nearest > found.begins && found.nearest < found.done
                                ? found.nearest
                                : (found.begins + found.done) / 2u;
    const uint32_t ticks[4] = { found.begins, during, found.done, found.after };
    trace_meeting(encounter->name, words, &found);
    frame_all(&shot, words, ticks);
    open_lab(words);
    for (int i = 0; i < 4; i++) {
        run_until(ticks[i]);
        snprintf(number, sizeof number, "4.%d", encounter->first + i);
        snprintf(seen, sizeof seen, "%s: %s (centres %.1f cm apart)", encounter->what, moments[i],
                 100.0 * apart_m());
        shoot(number, &shot, seen, words);
    }
    tank_lab_close(&lab);
}

/* ---- Figures 4.13 to 4.24 ------------------------------------------------------------------- */

static void shoot_crowd(void)
{
    static const char words[] = "--fish 600 --seconds 10";
    static const char *const seen[] = { "600 fish from above", "the middle of the tank",
                                        "through the wall", "from 60 degrees" };
    static const enum easel_camera cameras[] = { CAMERA_TOP, CAMERA_CENTRE, CAMERA_SIDE,
                                                 CAMERA_SLANT };
    char number[8];
    struct tank_trace trace;
    open_lab(words);
    run_until(10u * CORE_TICK_HZ);
    open_trace(&trace, "crowd");
    tank_trace_add(&trace, &lab.tank, lab.tick);
    close_trace(&trace);
    for (int i = 0; i < 4; i++) {
        snprintf(number, sizeof number, "4.%d", 13 + i);
        shoot(number, &(struct easel_shot){ .camera = cameras[i] }, seen[i], words);
    }
    tank_lab_close(&lab);
}

static void shoot_series(int first, const char *words, const uint32_t seconds[4],
                         enum easel_camera camera, const char *csv, const char *what,
                         uint32_t **counts)
{
    char number[8], seen[96], path[1024];
    const struct easel_shot shot = { .camera = camera };
    open_lab(words);
    snprintf(path, sizeof path, "%s/%s", folder, csv);
    FILE *table = fopen(path, "w");
    if (!table) {
        fail(path);
    }
    fprintf(table, "t_s,fish\n");
    for (int i = 0; i < 4; i++) {
        run_until(seconds[i] * CORE_TICK_HZ);
        snprintf(number, sizeof number, "4.%d", first + i);
        snprintf(seen, sizeof seen, "%u of 200 fish %s", (*counts)[seconds[i]], what);
        shoot(number, &shot, seen, words);
    }
    run_until(plan.tick_count);
    for (uint32_t second = 0; second < tank_lab_seconds(&plan); second++) {
        fprintf(table, "%u,%u\n", second, (*counts)[second]);
    }
    fclose(table);
    tank_lab_close(&lab);
}

int main(int argc, char **argv)
{
    char path[1024];
    if (argc != 2) {
        fail("usage: pictures FOLDER");
    }
    folder = argv[1];
    snprintf(path, sizeof path, "%s/pictures.tsv", folder);
    list = fopen(path, "w");
    if (!list || easel_open(EASEL_FINER_MAX) != 0) {
        fail("cannot begin");
    }
    for (size_t i = 0; i < sizeof encounters / sizeof encounters[0]; i++) {
        shoot_meeting(&encounters[i]);
    }
    shoot_crowd();
    shoot_series(17, "--fish 200 --shade 0,0,10,0,20 --seconds 20", (uint32_t[]){ 0, 1, 6, 10 },
                 CAMERA_SHADE, "shade.csv", "in the shade", &lab.shade_count);
    shoot_series(21, "--fish 200 --stamina 20 --seconds 20", (uint32_t[]){ 0, 1, 3, 10 },
                 CAMERA_NOSES, "gulping.csv", "gulp at the surface", &lab.surfacing_count);
    easel_close();
    return fclose(list) == 0 ? 0 : 1;
}
