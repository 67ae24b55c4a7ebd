/* check_trace.c -- checks a trace file of `kingyoctl tank` without any of Kingyo's code.
 *
 * Usage: check_trace TRACE WIDTH_CM DEPTH_CM BREADTH_CM
 *
 * Prints the numbers of rows, ticks and fish, and whether every value is a finite number. Each fish
 * has a bounding box, whose eight corners are computed by rotation. The program also prints how
 * deep these boxes overlap each other, and how far they are beyond a wall or the floor. Two boxes
 * are disjoint if a plane separates their corners, which is tested along several axes. */
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define FISH_MAX 4096
#define HEAD                                                                                       \
    "tick,fish,x_cm,y_cm,z_cm,yaw_deg,pitch_deg,roll_deg,length_cm,height_cm,width_cm,"            \
    "speed_cm_s,tail_hz,gait,stamina,avoiding\n"

struct corners {
    double at[8][3], axis[3][3], centre[3], reach;
    /* 1 if no poi carries the fish, otherwise 0. */
    int free;
};

struct verdict {
    unsigned long rows, ticks, overlaps;
    /* Greatest overlap of the boxes of two fish, and greatest depth of a fish's box beyond a wall,
     * the floor or the surface, in mm. */
    double deepest_mm, beyond_mm;
};

static struct corners fish[FISH_MAX];

static bool is_one_of(const char *word, const char *list)
{
    const char *found = strstr(list, word);
    return found && strchr(" ", found[strlen(word)]);
}

/* Rotates p by `degrees` in the plane of the axes i and j, from i toward j. */
static void turn(double p[3], int i, int j, double degrees)
{
    const double a = degrees * acos(-1.0) / 180.0, from = p[i], to = p[j];
    p[i] = from * cos(a) - to * sin(a);
    p[j] = from * sin(a) + to * cos(a);
}

/* Rotates a direction from the body's axes to the world's axes. The rotations about the world's
 * axes are roll (right side down), then pitch (nose, -z, up), then yaw (nose to the left, -x). The
 * result is the same as yaw, pitch and roll about the body's own axes. */
static void to_world(double p[3], double yaw, double pitch, double roll)
{
    turn(p, 1, 0, roll);
    turn(p, 1, 2, pitch);
    turn(p, 2, 0, yaw);
}

static struct corners corners_of(const double v[9])
{
    struct corners c = { .centre = { v[0], v[1], v[2] } };
    const double half[3] = { v[8] / 2, v[7] / 2, v[6] / 2 };
    for (int k = 0; k < 8; k++) {
        double p[3];
        for (int i = 0; i < 3; i++) {
            p[i] = k >> i & 1 ? half[i] : -half[i];
        }
        to_world(p, v[3], v[4], v[5]);
        for (int i = 0; i < 3; i++) {
            c.at[k][i] = p[i] + c.centre[i];
        }
    }
    for (int i = 0; i < 3; i++) {
        c.axis[i][i] = 1.0;
        to_world(c.axis[i], v[3], v[4], v[5]);
    }
    c.reach = sqrt(half[0] * half[0] + half[1] * half[1] + half[2] * half[2]);
    return c;
}

static void span(const struct corners *c, const double axis[3], double *low, double *high)
{
    *low = INFINITY;
    *high = -INFINITY;
    for (int k = 0; k < 8; k++) {
        const double at = c->at[k][0] * axis[0] + c->at[k][1] * axis[1] + c->at[k][2] * axis[2];
        *low = fmin(*low, at);
        *high = fmax(*high, at);
    }
}

/* Returns the distance by which one box must move along the axis so that the boxes no longer
 * overlap along it. A negative result means that they do not overlap along this axis. */
static double clear_by(const struct corners *a, const struct corners *b, const double axis[3])
{
    const double length = sqrt(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2]);
    if (length < 1e-7) {
        return INFINITY;
    }
    double low_a, high_a, low_b, high_b;
    span(a, axis, &low_a, &high_a);
    span(b, axis, &low_b, &high_b);
    return fmin(high_a - low_b, high_b - low_a) / length;
}

static double depth(const struct corners *a, const struct corners *b)
{
    double least = INFINITY;
    for (int i = 0; i < 3; i++) {
        least = fmin(least, fmin(clear_by(a, b, a->axis[i]), clear_by(a, b, b->axis[i])));
        for (int j = 0; j < 3; j++) {
            const double *u = a->axis[i], *w = b->axis[j];
            const double edge[3] = { u[1] * w[2] - u[2] * w[1], u[2] * w[0] - u[0] * w[2],
                                     u[0] * w[1] - u[1] * w[0] };
            least = fmin(least, clear_by(a, b, edge));
        }
    }
    return fmax(0.0, least);
}

static void replay_verifier_tick(struct verdict *verdict, int count)
{
    verdict->ticks++;
    for (int i = 0; i < count; i++) {
        for (int j = 0; j < i && fish[i].free; j++) {
            double apart = 0.0;
            for (int k = 0; k < 3; k++) {
                apart += pow(fish[i].centre[k] - fish[j].centre[k], 2.0);
            }
            if (fish[j].free && sqrt(apart) < fish[i].reach + fish[j].reach) {
                const double mm = 10.0 * depth(&fish[i], &fish[j]);
                verdict->deepest_mm = fmax(verdict->deepest_mm, mm);
                verdict->overlaps += mm > 0.5;
            }
        }
    }
}

static void check_bounds(struct verdict *verdict, const struct corners *c, const double size[3],
                         int surfacing)
{
    for (int k = 0; k < 8 && c->free; k++) {
        const double *at = c->at[k];
        const double aside = fmax(fabs(at[0]) - size[0] / 2, fabs(at[2]) - size[2] / 2);
        const double upward = fmax(-at[1] - size[1], surfacing ? 0.0 : at[1]);
        verdict->beyond_mm = fmax(verdict->beyond_mm, 10.0 * fmax(aside, upward));
    }
}

int main(int argc, char **argv)
{
    char line[512], gait[16], avoiding[16];
    struct verdict verdict = { 0 };
    long last = -1, tick, index;
    int count = 0, most = 0;
    double v[12], stamina;
    FILE *file = argc == 5 ? fopen(argv[1], "r") : NULL;
    const double size[3] = { atof(argc == 5 ? argv[2] : "0"), atof(argc == 5 ? argv[3] : "0"),
                             atof(argc == 5 ? argv[4] : "0") };
    if (!file || !fgets(line, sizeof line, file) || strcmp(line, HEAD) != 0) {
        fputs("check_trace: no trace\n", stderr);
        return 2;
    }
    while (fgets(line, sizeof line, file)) {
        const int fields =
            sscanf(line, "%ld,%ld,%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf,%15[^,],%lf,%15[^\n]",
                   &tick, &index, v, v + 1, v + 2, v + 3, v + 4, v + 5, v + 6, v + 7, v + 8, v + 9,
                   v + 10, gait, &stamina, avoiding);
        if (tick != last) {
            replay_verifier_tick(&verdict, count);
            count = 0;
        }
        if (fields != 16 || index != count || count == FISH_MAX || stamina < 0.0 ||
            stamina > 100.0 || !is_one_of(gait, "burst swim rest escape surface held ") ||
            !is_one_of(avoiding, "none yaw pitch ")) {
            fprintf(stderr, "check_trace: row %lu: %s", verdict.rows, line);
            return 1;
        }
        last = tick;
        fish[count] = corners_of(v);
        fish[count].free = strcmp(gait, "held") != 0;
        check_bounds(&verdict, &fish[count], size, strcmp(gait, "surface") == 0);
        most = ++count > most ? count : most;
        verdict.rows++;
    }
    replay_verifier_tick(&verdict, count);
    printf("rows %lu ticks %lu fish %d last %ld overlaps %lu deepest_mm %.4f beyond_mm %.4f\n",
           verdict.rows, verdict.ticks - 1, most, last, verdict.overlaps, verdict.deepest_mm,
           verdict.beyond_mm);
    fclose(file);
    return 0;
}
