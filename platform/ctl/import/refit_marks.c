/* refit_marks.c -- reads landmark files, finds landmarks on the template, and computes the warp
 * that moves one set of landmarks to another. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/panic.h"
#include "platform/ctl/import/refit.h"
#include "platform/species/text.h"

#define LINE_SIZE 256
#define MARKS_SIZE_MAX (64u * 1024u)
#define COUNT(array) (sizeof(array) / sizeof((array)[0]))

static const struct {
    const char *name;
    uint8_t part, side;
} fins[] = {
    { "dorsal2", PART_DORSAL_2, SIDE_MIDDLE },
    { "dorsal", PART_DORSAL, SIDE_MIDDLE },
    { "anal", PART_ANAL, SIDE_MIDDLE },
    { "pectoral_right", PART_PECTORAL, SIDE_RIGHT },
    { "pectoral_left", PART_PECTORAL, SIDE_LEFT },
    { "pelvic_right", PART_PELVIC, SIDE_RIGHT },
    { "pelvic_left", PART_PELVIC, SIDE_LEFT },
};

static const char *const singles[] = { "snout",     "tail_root", "back",     "belly",
                                       "eye_right", "eye_left",  "tail_top", "tail_bottom" };

/* Returns the index of the fin whose name starts the name of the landmark, and sets `end` to the
 * rest of the landmark's name. Returns COUNT(fins) if the landmark is not on a fin. */
static size_t fin_of(const char *name, const char **end)
{
    size_t i = 0;
    for (; i < COUNT(fins); i++) {
        const size_t length = strlen(fins[i].name);
        if (strncmp(name, fins[i].name, length) != 0 || name[length] != '_') {
            continue;
        }
        *end = name + length + 1;
        if (strcmp(*end, "start") == 0 || strcmp(*end, "end") == 0 || strcmp(*end, "tip") == 0) {
            break;
        }
    }
    return i;
}

static bool is_landmark(const char *name)
{
    const char *end;
    bool known = fin_of(name, &end) < COUNT(fins);
    for (size_t i = 0; i < COUNT(singles); i++) {
        known = known || strcmp(name, singles[i]) == 0;
    }
    return known;
}

static bool refit_marks_error(char why[IMPORT_WHY_SIZE], const char *path, uint32_t line,
                              const char *what)
{
    snprintf(why, IMPORT_WHY_SIZE, "%.80s:%u: %s", path, line, what);
    return false;
}

static bool refit_marks_read_line(char *text, struct refit_marks *list, const char *path,
                                  uint32_t line, char why[IMPORT_WHY_SIZE])
{
    struct refit_landmark mark;
    char *rest = NULL;
    text[strcspn(text, "#")] = '\0';
    const char *name = strtok_r(text, " \t\r\n", &rest);
    if (!name) {
        return true;
    }
    if (list->count == REFIT_MARKS_MAX) {
        return refit_marks_error(why, path, line, "more than 24 landmarks");
    }
    if (strlen(name) >= MARK_NAME_SIZE || !is_landmark(name)) {
        return refit_marks_error(why, path, line, "no landmark of that name; --help lists them");
    }
    memset(&mark, 0, sizeof mark);
    memcpy(mark.name, name, strlen(name));
    float *const place[3] = { &mark.place.x, &mark.place.y, &mark.place.z };
    for (int i = 0; i < 3; i++) {
        const char *word = strtok_r(NULL, " \t\r\n", &rest);
        char *end = NULL;
        *place[i] = word ? strtof(word, &end) : NAN;
        if (!word || *end != '\0' || !(fabsf(*place[i]) <= IMPORT_REACH_MAX)) {
            return refit_marks_error(why, path, line, "write: NAME X Y Z");
        }
    }
    if (strtok_r(NULL, " \t\r\n", &rest)) {
        return refit_marks_error(why, path, line, "write: NAME X Y Z");
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
    enum text_file_line got = text_file_line(file, text, sizeof text);
    for (; good && got != TEXT_FILE_END; got = text_file_line(file, text, sizeof text)) {
        line++;
        good = got == TEXT_FILE_LINE ? refit_marks_read_line(text, list, path, line, why)
               : got == TEXT_FILE_LONG
                   ? refit_marks_error(why, path, line, "the line is longer than 254")
                   : refit_marks_error(why, path, line, "a zero byte, in what is a text");
    }
    if (good && list->count < 4) {
        good = refit_marks_error(why, path, line, "four landmarks or more are needed");
    }
    const bool broken = ferror(file) != 0;
    fclose(file);
    return broken ? EXIT_IO : good ? EXIT_OK : EXIT_BAD_DATA;
}

/* ---- Landmarks of the template --------------------------------------------------------------- */

/* Finds the vertex of a part whose body coordinates are nearest to (u, v). Returns false if the
 * fish does not have the part. */
static bool vertex_near(const struct species_mesh *mesh, const vec3 *positions, uint8_t part,
                        uint8_t side, float u, float v, vec3 *out)
{
    float best = INFINITY;
    for (uint32_t i = 0; i < mesh->vertex_count; i++) {
        const struct species_vertex *at = &mesh->vertices[i];
        if (at->part != part || (side != SIDE_MIDDLE && at->side != side)) {
            continue;
        }
        const float off = fabsf(at->u - u) + fabsf(at->v - v);
        if (off < best) {
            best = off;
            *out = positions[i];
        }
    }
    return best < INFINITY;
}

bool refit_marks_of_template(const struct species_mesh *mesh, const vec3 *positions,
                             const char *name, vec3 *out)
{
    CORE_ASSERT(name[0]);
    if (strcmp(name, "snout") == 0 || strcmp(name, "tail_root") == 0) {
        return vertex_near(mesh, positions, PART_BODY, SIDE_MIDDLE, name[0] == 's' ? 0.0f : 1.0f,
                           0.25f, out);
    }
    if (strcmp(name, "back") == 0 || strcmp(name, "belly") == 0) {
        /* `sign` is 1 for the highest point of the body, and -1 for the lowest point. */
        const float sign = strcmp(name, "back") == 0 ? 1.0f : -1.0f;
        float best = -INFINITY;
        for (uint32_t i = 0; i < mesh->vertex_count; i++) {
            if (mesh->vertices[i].part == PART_BODY && sign * positions[i].y > best) {
                best = sign * positions[i].y;
                *out = positions[i];
            }
        }
        return best > -INFINITY;
    }
    if (strcmp(name, "eye_right") == 0 || strcmp(name, "eye_left") == 0) {
        const enum species_side side = name[4] == 'r' ? SIDE_RIGHT : SIDE_LEFT;
        vec3 sum = { 0.0f, 0.0f, 0.0f };
        float count = 0.0f;
        for (uint32_t i = 0; i < mesh->vertex_count; i++) {
            if (mesh->vertices[i].part == PART_EYE && mesh->vertices[i].side == side) {
                sum = v3_add(sum, positions[i]);
                count += 1.0f;
            }
        }
        *out = v3_scale(sum, 1.0f / fmaxf(count, 1.0f));
        return count > 0.0f;
    }
    if (strcmp(name, "tail_top") == 0 || strcmp(name, "tail_bottom") == 0) {
        return vertex_near(mesh, positions, PART_TAIL, SIDE_MIDDLE, name[5] == 't' ? 0.0f : 1.0f,
                           1.0f, out);
    }
    const char *end = name;
    const size_t i = fin_of(name, &end);
    if (i == COUNT(fins)) {
        return false;
    }
    return vertex_near(mesh, positions, fins[i].part, fins[i].side, end[0] == 'e' ? 1.0f : 0.0f,
                       end[0] == 't' ? 1.0f : 0.0f, out);
}

/* ---- Warp between two sets of landmarks ------------------------------------------------------ */

#define SYSTEM_MAX REFIT_MARKS_MAX
/* Regularization of the affine transform, in squared body lengths for each landmark. */
#define RIDGE 0.0005
#define REACH 0.8 /* Radius of the displacement around a landmark, in body lengths. */
/* Regularization of the displacements around landmarks. Two landmarks that nearly coincide may keep
 * an error of this fraction of the difference between their displacements. */
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

/* Returns Wendland's function at the distance `r` from a landmark. The value is 1 at the
 * landmark and decreases smoothly to 0 at the distance REACH. The resulting linear system is
 * never singular. */
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

/* Computes the weights of the displacements around the landmarks. The affine transform does not
 * move each landmark exactly to its target. The displacements together add the missing distance. */
static void fit_bumps(const vec3 *from, const vec3 *to, uint32_t n,
                      double m[SYSTEM_MAX][SYSTEM_MAX + 3])
{
    memset(m, 0, SYSTEM_MAX * sizeof *m);
    for (uint32_t i = 0; i < n; i++) {
        const vec3 way = v3_sub(to[i], from[i]);
        for (uint32_t j = 0; j < n; j++) {
            m[i][j] = bump(point_distance(from[i], from[j])) + (i == j ? SLACK : 0.0);
        }
        m[i][n] = (double)way.x;
        m[i][n + 1] = (double)way.y;
        m[i][n + 2] = (double)way.z;
    }
    solve(m, n);
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
    /* Compute the best linear transform from the offsets of `from` to the offsets of `to`. The
     * result is a 3 x 3 matrix in `m` that converts an offset from the centre of `from` to a
     * displacement. The transform is regularized toward the identity. If all landmarks lie in a
     * plane, they do not determine the deformation perpendicular to the plane. */
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
    fit_bumps(at, to, n, m);
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
