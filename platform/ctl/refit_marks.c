/* refit_marks.c -- landmarks: read, found on the template, and the warp that carries one set onto
 * another. */
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "platform/ctl/refit.h"

#define LINE_SIZE 256
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

/* Which fin a name is of, and in `end` what of it; COUNT(fins) where it is of none. */
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

static bool refuse(char why[IMPORT_WHY_SIZE], const char *path, uint32_t line, const char *what)
{
    snprintf(why, IMPORT_WHY_SIZE, "%.80s:%u: %s", path, line, what);
    return false;
}

static bool read_line(char *text, struct mark_list *list, const char *path, uint32_t line,
                      char why[IMPORT_WHY_SIZE])
{
    struct landmark mark;
    char *rest = NULL;
    text[strcspn(text, "#")] = '\0';
    const char *name = strtok_r(text, " \t\r\n", &rest);
    if (!name) {
        return true;
    }
    if (list->count == MARK_LIST_MAX) {
        return refuse(why, path, line, "more than 24 landmarks");
    }
    if (strlen(name) >= MARK_NAME_SIZE || !is_landmark(name)) {
        return refuse(why, path, line, "no landmark of that name; --help lists them");
    }
    memset(&mark, 0, sizeof mark);
    memcpy(mark.name, name, strlen(name));
    float *const place[3] = { &mark.place.x, &mark.place.y, &mark.place.z };
    for (int i = 0; i < 3; i++) {
        const char *word = strtok_r(NULL, " \t\r\n", &rest);
        char *end = NULL;
        *place[i] = word ? strtof(word, &end) : NAN;
        if (!word || *end != '\0' || !(fabsf(*place[i]) <= IMPORT_REACH_MAX)) {
            return refuse(why, path, line, "write: NAME X Y Z");
        }
    }
    if (strtok_r(NULL, " \t\r\n", &rest)) {
        return refuse(why, path, line, "write: NAME X Y Z");
    }
    list->marks[list->count++] = mark;
    return true;
}

enum exit_code marks_read(const char *path, struct mark_list *list, char why[IMPORT_WHY_SIZE])
{
    char text[LINE_SIZE];
    uint32_t line = 0;
    bool good = true;
    FILE *file = fopen(path, "r");
    list->count = 0;
    if (!file) {
        snprintf(why, IMPORT_WHY_SIZE, "%.80s: %s", path, strerror(errno));
        return EXIT_IO;
    }
    while (good && fgets(text, sizeof text, file)) {
        good = read_line(text, list, path, ++line, why);
    }
    if (good && list->count < 4) {
        good = refuse(why, path, line, "four landmarks or more are needed");
    }
    fclose(file);
    return good ? EXIT_OK : EXIT_BAD_DATA;
}

/* ---- On the template ------------------------------------------------------------------------- */

/* The vertex of a part whose coordinates are nearest to (u, v). */
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

/* The body's highest (`sign` 1) or lowest point. */
static bool extreme(const struct species_mesh *mesh, const vec3 *positions, float sign, vec3 *out)
{
    float best = -INFINITY;
    for (uint32_t i = 0; i < mesh->vertex_count; i++) {
        if (mesh->vertices[i].part == PART_BODY && sign * positions[i].y > best) {
            best = sign * positions[i].y;
            *out = positions[i];
        }
    }
    return best > -INFINITY;
}

static bool middle_of(const struct species_mesh *mesh, const vec3 *positions, uint8_t part,
                      uint8_t side, vec3 *out)
{
    vec3 sum = { 0.0f, 0.0f, 0.0f };
    float count = 0.0f;
    for (uint32_t i = 0; i < mesh->vertex_count; i++) {
        if (mesh->vertices[i].part == part && mesh->vertices[i].side == side) {
            sum = v3_add(sum, positions[i]);
            count += 1.0f;
        }
    }
    *out = v3_scale(sum, 1.0f / fmaxf(count, 1.0f));
    return count > 0.0f;
}

bool marks_of_template(const struct species_mesh *mesh, const vec3 *positions, const char *name,
                       vec3 *out)
{
    if (strcmp(name, "snout") == 0 || strcmp(name, "tail_root") == 0) {
        return vertex_near(mesh, positions, PART_BODY, SIDE_MIDDLE, name[0] == 's' ? 0.0f : 1.0f,
                           0.25f, out);
    }
    if (strcmp(name, "back") == 0 || strcmp(name, "belly") == 0) {
        return extreme(mesh, positions, strcmp(name, "back") == 0 ? 1.0f : -1.0f, out);
    }
    if (strcmp(name, "eye_right") == 0 || strcmp(name, "eye_left") == 0) {
        return middle_of(mesh, positions, PART_EYE, name[4] == 'r' ? SIDE_RIGHT : SIDE_LEFT, out);
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

/* ---- The warp -------------------------------------------------------------------------------- */

#define SYSTEM_MAX (MARK_LIST_MAX + 4u) /* A weight a landmark, and an affine part. */

static double gap(vec3 a, vec3 b)
{
    return (double)v3_length(v3_sub(a, b));
}

/* Rows [A | B] with three right sides; singular columns stay at 0. */
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

void marks_warp(const vec3 *from, const vec3 *to, uint32_t n, vec3 *points, uint32_t count)
{
    static double m[SYSTEM_MAX][SYSTEM_MAX + 3];
    const uint32_t size = n + 4;
    memset(m, 0, sizeof m);
    for (uint32_t i = 0; i < n; i++) {
        const double affine[4] = { 1.0, (double)from[i].x, (double)from[i].y, (double)from[i].z };
        for (uint32_t j = 0; j < n; j++) {
            m[i][j] = gap(from[i], from[j]);
        }
        for (uint32_t k = 0; k < 4; k++) {
            m[i][n + k] = m[n + k][i] = affine[k];
        }
        const vec3 way = v3_sub(to[i], from[i]);
        m[i][size] = (double)way.x;
        m[i][size + 1] = (double)way.y;
        m[i][size + 2] = (double)way.z;
    }
    /* Landmarks in a plane say nothing about across: the affine part is held toward none at all. */
    for (uint32_t k = 0; k < 4; k++) {
        m[n + k][n + k] = -1e-6;
    }
    solve(m, size);
    for (uint32_t i = 0; i < count; i++) {
        const double terms[4] = { 1.0, (double)points[i].x, (double)points[i].y,
                                  (double)points[i].z };
        double way[3] = { 0.0, 0.0, 0.0 };
        for (uint32_t j = 0; j < size; j++) {
            const double term = j < n ? gap(points[i], from[j]) : terms[j - n];
            for (uint32_t k = 0; k < 3; k++) {
                way[k] += term * m[j][size + k] / m[j][j];
            }
        }
        points[i] = v3_add(points[i], v3((float)way[0], (float)way[1], (float)way[2]));
    }
}
