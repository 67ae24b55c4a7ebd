/* refit_marks.c -- reads landmark files, finds landmarks on the template, and computes the warp
 * that moves one set of landmarks to another. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/panic.h"
#include "platform/ctl/import/refit.h"
#include "platform/os/file.h"

#define LINE_SIZE 256
#define MARKS_SIZE_MAX (64u * 1024u)

/* How the position of a landmark is found on the template. */
enum rule {
    RULE_NEAR,    /* The vertex of the part that is nearest to the body coordinates u and v. */
    RULE_HIGHEST, /* The highest vertex of the part. */
    RULE_LOWEST,  /* The lowest vertex of the part. */
    RULE_MEAN,    /* The mean of all vertices of the part. */
};

#define FIN(name, part, side)                                                                      \
    { name "_start", RULE_NEAR, part, side, 0.0f, 0.0f },                                          \
        { name "_end", RULE_NEAR, part, side, 1.0f, 0.0f },                                        \
        { name "_tip", RULE_NEAR, part, side, 0.0f, 1.0f }

/* All landmarks and how they are found. SIDE_MIDDLE selects the vertices of both sides. */
static const struct landmark {
    const char *name;
    enum rule rule;
    uint8_t part, side;
    float u, v;
} landmarks[] = {
    { "snout", RULE_NEAR, PART_BODY, SIDE_MIDDLE, 0.0f, 0.25f },
    { "tail_root", RULE_NEAR, PART_BODY, SIDE_MIDDLE, 1.0f, 0.25f },
    { "back", RULE_HIGHEST, PART_BODY, SIDE_MIDDLE, 0.0f, 0.0f },
    { "belly", RULE_LOWEST, PART_BODY, SIDE_MIDDLE, 0.0f, 0.0f },
    { "eye_right", RULE_MEAN, PART_EYE, SIDE_RIGHT, 0.0f, 0.0f },
    { "eye_left", RULE_MEAN, PART_EYE, SIDE_LEFT, 0.0f, 0.0f },
    { "tail_top", RULE_NEAR, PART_TAIL, SIDE_MIDDLE, 0.0f, 1.0f },
    { "tail_bottom", RULE_NEAR, PART_TAIL, SIDE_MIDDLE, 1.0f, 1.0f },
    FIN("dorsal2", PART_DORSAL_2, SIDE_MIDDLE),
    FIN("dorsal", PART_DORSAL, SIDE_MIDDLE),
    FIN("anal", PART_ANAL, SIDE_MIDDLE),
    FIN("pectoral_right", PART_PECTORAL, SIDE_RIGHT),
    FIN("pectoral_left", PART_PECTORAL, SIDE_LEFT),
    FIN("pelvic_right", PART_PELVIC, SIDE_RIGHT),
    FIN("pelvic_left", PART_PELVIC, SIDE_LEFT),
};

static const struct landmark *find_landmark(const char *name)
{
    for (size_t i = 0; i < sizeof landmarks / sizeof landmarks[0]; i++) {
        if (strcmp(landmarks[i].name, name) == 0) {
            return &landmarks[i];
        }
    }
    return NULL;
}

static bool refit_marks_error(char why[IMPORT_WHY_SIZE], const char *path, uint32_t line,
                              const char *what)
{
    return import_error(why, "%.80s:%u: %s", path, line, what);
}

static bool refit_marks_read_line(char *text, struct refit_marks *list, const char *path,
                                  uint32_t line, char why[IMPORT_WHY_SIZE])
{
    struct refit_landmark mark = { 0 };
    char *rest = NULL;
    text[strcspn(text, "#")] = '\0';
    const char *name = strtok_r(text, " \t\r\n", &rest);
    if (!name) {
        return true;
    }
    if (list->count == REFIT_MARKS_MAX) {
        return refit_marks_error(why, path, line, "more than 24 landmarks");
    }
    if (!find_landmark(name)) {
        return refit_marks_error(why, path, line, "unknown landmark; --help lists the names");
    }
    snprintf(mark.name, sizeof mark.name, "%s", name);
    float *const place[3] = { &mark.place.x, &mark.place.y, &mark.place.z };
    for (int i = 0; i < 3; i++) {
        const char *word = strtok_r(NULL, " \t\r\n", &rest);
        char *end = NULL;
        *place[i] = word ? strtof(word, &end) : NAN;
        if (!word || *end != '\0' || !(fabsf(*place[i]) <= IMPORT_REACH_MAX)) {
            return refit_marks_error(why, path, line, "expected NAME X Y Z");
        }
    }
    if (strtok_r(NULL, " \t\r\n", &rest)) {
        return refit_marks_error(why, path, line, "expected NAME X Y Z");
    }
    list->marks[list->count++] = mark;
    return true;
}

enum exit_code refit_marks_read(const char *path, struct refit_marks *list,
                                char why[IMPORT_WHY_SIZE])
{
    char text[LINE_SIZE];
    uint32_t line = 0;
    bool good = true;
    FILE *file;
    const enum exit_code opened = import_open(path, MARKS_SIZE_MAX, &file, why);
    list->count = 0;
    if (opened != EXIT_OK) {
        return opened;
    }
    enum file_line got;
    while (good && (got = file_read_line(file, text, sizeof text)) != FILE_LINE_END) {
        line++;
        good = got == FILE_LINE_READ
                   ? refit_marks_read_line(text, list, path, line, why)
                   : refit_marks_error(
                         why, path, line,
                         "the line is longer than 255 characters or contains a zero byte");
    }
    if (good && list->count < 4) {
        good = refit_marks_error(why, path, line, "at least four landmarks are needed");
    }
    const bool broken = ferror(file) != 0;
    fclose(file);
    return broken ? EXIT_IO : good ? EXIT_OK : EXIT_BAD_DATA;
}

/* ---- Landmarks of the template --------------------------------------------------------------- */

bool refit_marks_of_template(const struct species_mesh *mesh, const vec3 *positions,
                             const char *name, vec3 *out)
{
    const struct landmark *mark = find_landmark(name);
    vec3 sum = { 0.0f, 0.0f, 0.0f };
    float best = INFINITY, count = 0.0f;
    for (uint32_t i = 0; mark && i < mesh->vertex_count; i++) {
        const struct species_vertex *at = &mesh->vertices[i];
        if (at->part != mark->part || (mark->side != SIDE_MIDDLE && at->side != mark->side)) {
            continue;
        }
        const float off = mark->rule == RULE_NEAR ? fabsf(at->u - mark->u) + fabsf(at->v - mark->v)
                          : mark->rule == RULE_HIGHEST ? -positions[i].y
                                                       : positions[i].y;
        if (off < best) {
            best = off;
            *out = positions[i];
        }
        sum = v3_add(sum, positions[i]);
        count += 1.0f;
    }
    if (mark && mark->rule == RULE_MEAN) {
        *out = v3_scale(sum, 1.0f / fmaxf(count, 1.0f));
    }
    return count > 0.0f;
}

/* ---- Warp between two sets of landmarks ------------------------------------------------------ */

#define SYSTEM_MAX REFIT_MARKS_MAX
/* Regularization of the linear transform, in squared body lengths for each landmark. */
#define RIDGE 0.0005
#define REACH 0.8 /* Radius of the displacement around a landmark, in body lengths. */
/* Regularization of the displacements around landmarks. If two landmarks nearly coincide and their
 * displacements differ, an error of this fraction of the difference may remain. */
#define SLACK 1e-4

static double point_distance(vec3 a, vec3 b)
{
    return (double)v3_length(v3_sub(a, b));
}

/* Solves `n` linear equations with three right-hand sides by elimination. Each row of `m` contains
 * the coefficients and then the right-hand sides. Unknown i is m[i][n + k] / m[i][i] for the
 * right-hand side k. The unknowns of singular columns are 0. */
static void solve(double m[SYSTEM_MAX][SYSTEM_MAX + 3], uint32_t n)
{
    for (uint32_t column = 0; column < n; column++) {
        uint32_t pivot = column;
        for (uint32_t i = column + 1; i < n; i++) {
            pivot = fabs(m[i][column]) > fabs(m[pivot][column]) ? i : pivot;
        }
        for (uint32_t j = 0; j < n + 3; j++) {
            const double held = m[pivot][j];
            m[pivot][j] = m[column][j];
            m[column][j] = held;
        }
        if (fabs(m[column][column]) < 1e-12) {
            memset(m[column], 0, sizeof m[column]);
            m[column][column] = 1.0;
        }
        for (uint32_t i = 0; i < n; i++) {
            const double share = i == column ? 0.0 : m[i][column] / m[column][column];
            for (uint32_t j = column; j < n + 3; j++) {
                m[i][j] -= share * m[column][j];
            }
        }
    }
}

/* Returns Wendland's function at the distance `r` from a landmark. The value is 1 at the landmark
 * and decreases smoothly to 0 at the distance REACH. With this function, the linear system for the
 * weights of the displacements is never singular. */
static double bump(double r)
{
    const double t = fmax(1.0 - r / REACH, 0.0);
    return t * t * t * t * (4.0 * r / REACH + 1.0);
}

static vec3 mean_of(const vec3 *points, uint32_t n)
{
    vec3 sum = { 0.0f, 0.0f, 0.0f };
    for (uint32_t i = 0; i < n; i++) {
        sum = v3_add(sum, points[i]);
    }
    return v3_scale(sum, 1.0f / (float)n);
}

static vec3 stretched(double m[SYSTEM_MAX][SYSTEM_MAX + 3], vec3 p, vec3 middle, vec3 goal)
{
    const vec3 at = v3_sub(p, middle);
    const double a[3] = { (double)at.x, (double)at.y, (double)at.z };
    double way[3] = { 0.0, 0.0, 0.0 };
    for (uint32_t r = 0; r < 3; r++) {
        for (uint32_t k = 0; k < 3; k++) {
            way[k] += a[r] * m[r][3 + k] / m[r][r];
        }
    }
    return v3_add(v3_add(at, goal), v3((float)way[0], (float)way[1], (float)way[2]));
}

void refit_marks_warp(const vec3 *from, const vec3 *to, uint32_t n, vec3 *points, uint32_t count)
{
    CORE_ASSERT(n <= REFIT_MARKS_MAX);
    static double m[SYSTEM_MAX][SYSTEM_MAX + 3];
    vec3 at[REFIT_MARKS_MAX];
    if (n == 0) {
        return;
    }
    const vec3 middle = mean_of(from, n), goal = mean_of(to, n);
    /* Fits the linear transform that best maps the landmarks of `from` to the landmarks of `to`.
     * The result is the 3 x 3 matrix in `m`. It maps the offset of a landmark from the centre of
     * `from` to the landmark's displacement. The fit is regularized toward no displacement, because
     * landmarks in one plane do not determine the deformation perpendicular to the plane. */
    memset(m, 0, 3 * sizeof *m);
    for (uint32_t i = 0; i < n; i++) {
        const vec3 p = v3_sub(from[i], middle), way = v3_sub(v3_sub(to[i], goal), p);
        const float a[3] = { p.x, p.y, p.z }, d[3] = { way.x, way.y, way.z };
        for (uint32_t r = 0; r < 3; r++) {
            for (uint32_t k = 0; k < 3; k++) {
                m[r][k] += (double)(a[r] * a[k]);
                m[r][3 + k] += (double)(a[r] * d[k]);
            }
        }
    }
    for (uint32_t r = 0; r < 3; r++) {
        m[r][r] += RIDGE;
    }
    solve(m, 3);
    for (uint32_t i = 0; i < n; i++) {
        at[i] = stretched(m, from[i], middle, goal);
    }
    for (uint32_t i = 0; i < count; i++) {
        points[i] = stretched(m, points[i], middle, goal);
    }
    /* Computes the weights of the displacements around the landmarks. The linear transform does not
     * move each landmark exactly to its target, so the displacements add the missing distance. */
    memset(m, 0, sizeof m);
    for (uint32_t i = 0; i < n; i++) {
        const vec3 way = v3_sub(to[i], at[i]);
        for (uint32_t j = 0; j < n; j++) {
            m[i][j] = bump(point_distance(at[i], at[j])) + (i == j ? SLACK : 0.0);
        }
        m[i][n] = (double)way.x;
        m[i][n + 1] = (double)way.y;
        m[i][n + 2] = (double)way.z;
    }
    solve(m, n);
    for (uint32_t i = 0; i < count; i++) {
        double way[3] = { 0.0, 0.0, 0.0 };
        for (uint32_t j = 0; j < n; j++) {
            const double share = bump(point_distance(points[i], at[j])) / m[j][j];
            for (uint32_t k = 0; k < 3; k++) {
                way[k] += share * m[j][n + k];
            }
        }
        points[i] = v3_add(points[i], v3((float)way[0], (float)way[1], (float)way[2]));
    }
}
