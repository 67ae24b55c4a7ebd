/* membrane.c -- computes the tension in wet paper with finite elements and compares the result with
 * the simpler model of sheet.c.
 *
 * Usage: membrane > membrane.tsv
 *
 * The loads of the paper are the drag of the water, and a body or a slap on a round patch at
 * several distances from the centre. The paper is modelled as a membrane without bending stiffness
 * that is clamped at the ring. Its triangles have constant strain and large displacements (Saint
 * Venant-Kirchhoff material, Poisson's ratio 0.3).
 *
 * Columns: the pressure, the force, the diameter of the patch, the distance of the patch from the
 * centre, the highest tension of all triangles, the highest tension of the triangles beside the
 * ring, and the highest tension in sheet.c. The part of a patch beyond the paper's edge loads the
 * ring, not the paper.
 *
 * Returns exit status 1 if the tension under pressure alone differs by more than 5 % from Hencky's
 * solution. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/panic.h"
#include "core/poi/paper/sheet.h"

#define RINGS 20 /* Number of rings of triangles; each ring is 2 mm wide. */
#define NODE_MAX (3 * RINGS * (RINGS + 1) + 1)
#define TRIANGLE_MAX (6 * RINGS * RINGS)
#define RADIUS_M 0.040
#define POISSON 0.3
#define GRADE 6u
#define PI 3.14159265358979
/* Largest number of steps of the dynamic relaxation. */
#define STEPS_MAX 60000
/* Largest force in N that may remain unbalanced at a node of the solution. */
#define RESIDUAL_N 2e-7
#define BESIDE_RING_M 0.0025

struct triangle {
    int node[3];
    /* Inverse of the 2 x 2 matrix whose columns are two edges of the triangle in the flat paper. */
    double inverse[2][2];
    double area_m2;
    double tension_n_m; /* Highest principal tension. */
};

struct load {
    double pressure_pa, force_n, diameter_m, x_m;
};

static double flat_m[NODE_MAX][2], place_m[NODE_MAX][3], speed[NODE_MAX][3], force_n[NODE_MAX][3];
static double load_n[NODE_MAX];
static struct triangle triangles[TRIANGLE_MAX];
static int node_count, triangle_count;

_Noreturn void core_panic(const char *condition, const char *file, int line)
{
    fprintf(stderr, "membrane: %s:%d: %s\n", file, line, condition);
    abort();
}

/* ---- Mesh ----------------------------------------------------------------------------------- */

/* Returns the index of node `k` on the ring of nodes `ring`. Ring 0 is the centre, and ring r has 6
 * r nodes. */
static int node_of(int ring, int k)
{
    return ring == 0 ? 0 : 1 + 3 * ring * (ring - 1) + k % (6 * ring);
}

static void add_triangle(int a, int b, int c)
{
    struct triangle *triangle = &triangles[triangle_count++];
    const double x1 = flat_m[b][0] - flat_m[a][0], z1 = flat_m[b][1] - flat_m[a][1];
    const double x2 = flat_m[c][0] - flat_m[a][0], z2 = flat_m[c][1] - flat_m[a][1];
    const double twice = x1 * z2 - x2 * z1;
    *triangle =
        (struct triangle){ .node = { a, b, c },
                           .inverse = { { z2 / twice, -x2 / twice }, { -z1 / twice, x1 / twice } },
                           .area_m2 = 0.5 * fabs(twice) };
}

static void build_mesh(void)
{
    for (int ring = 0; ring <= RINGS; ring++) {
        for (int k = 0; k < (ring == 0 ? 1 : 6 * ring); k++) {
            const double angle = ring == 0 ? 0.0 : 2.0 * PI * k / (6.0 * ring);
            flat_m[node_count][0] = RADIUS_M * ring / RINGS * cos(angle);
            flat_m[node_count][1] = RADIUS_M * ring / RINGS * sin(angle);
            node_count++;
        }
    }
    for (int ring = 1; ring <= RINGS; ring++) {
        for (int k = 0; k < 6 * ring; k++) {
            const int sector = k / ring, inner = sector * (ring - 1) + k % ring;
            add_triangle(node_of(ring, k), node_of(ring, k + 1), node_of(ring - 1, inner));
            if (k % ring < ring - 1) {
                add_triangle(node_of(ring, k + 1), node_of(ring - 1, inner + 1),
                             node_of(ring - 1, inner));
            }
        }
    }
}

static double centre_m(const struct triangle *triangle, int axis)
{
    return (flat_m[triangle->node[0]][axis] + flat_m[triangle->node[1]][axis] +
            flat_m[triangle->node[2]][axis]) /
           3.0;
}

/* ---- Loads ---------------------------------------------------------------------------------- */

/* Computes the load of each node from the pressure and from the force on the patch. Only the part
 * of the patch that lies on the paper counts. */
static void put_load(const struct load *load)
{
    static double patch_m2[NODE_MAX];
    double sum_m2 = 0.0;
    memset(patch_m2, 0, sizeof patch_m2);
    memset(load_n, 0, sizeof load_n);
    for (int i = 0; i < triangle_count; i++) {
        const struct triangle *triangle = &triangles[i];
        const double x = centre_m(triangle, 0) - load->x_m, z = centre_m(triangle, 1);
        const double patch = hypot(x, z) < 0.5 * load->diameter_m ? triangle->area_m2 / 3.0 : 0.0;
        sum_m2 += 3.0 * patch;
        for (int k = 0; k < 3; k++) {
            load_n[triangle->node[k]] += load->pressure_pa * triangle->area_m2 / 3.0;
            patch_m2[triangle->node[k]] += patch;
        }
    }
    const double whole_m2 = 0.25 * PI * load->diameter_m * load->diameter_m;
    const int is_inside = load->x_m + 0.5 * load->diameter_m <= RADIUS_M;
    const double per_m2 = load->force_n / (is_inside ? sum_m2 : whole_m2);
    for (int i = 0; i < node_count && load->force_n > 0.0; i++) {
        load_n[i] += patch_m2[i] * per_m2;
    }
}

/* ---- Solving for equilibrium ---------------------------------------------------------------- */

/* Adds the elastic forces of a triangle to `force_n`, and computes the tension of the triangle. */
static void pull_triangle(struct triangle *triangle, double stiffness_n_m)
{
    const double *at[3] = { place_m[triangle->node[0]], place_m[triangle->node[1]],
                            place_m[triangle->node[2]] };
    const double(*inverse)[2] = triangle->inverse;
    /* Columns of the deformation gradient (`f`) and of the stress (`s`). */
    double f[2][3], s[2][2];
    for (int q = 0; q < 3; q++) {
        const double edge1 = at[1][q] - at[0][q], edge2 = at[2][q] - at[0][q];
        f[0][q] = edge1 * inverse[0][0] + edge2 * inverse[1][0];
        f[1][q] = edge1 * inverse[0][1] + edge2 * inverse[1][1];
    }
    const double xx = 0.5 * (f[0][0] * f[0][0] + f[0][1] * f[0][1] + f[0][2] * f[0][2] - 1.0);
    const double zz = 0.5 * (f[1][0] * f[1][0] + f[1][1] * f[1][1] + f[1][2] * f[1][2] - 1.0);
    const double xz = 0.5 * (f[0][0] * f[1][0] + f[0][1] * f[1][1] + f[0][2] * f[1][2]);
    const double plane = stiffness_n_m / (1.0 - POISSON * POISSON);
    s[0][0] = plane * (xx + POISSON * zz);
    s[1][1] = plane * (zz + POISSON * xx);
    s[0][1] = s[1][0] = plane * (1.0 - POISSON) * xz;
    const double half = 0.5 * (s[0][0] - s[1][1]);
    triangle->tension_n_m = 0.5 * (s[0][0] + s[1][1]) + sqrt(half * half + s[0][1] * s[0][1]);
    for (int q = 0; q < 3; q++) {
        const double p0 = f[0][q] * s[0][0] + f[1][q] * s[1][0];
        const double p1 = f[0][q] * s[0][1] + f[1][q] * s[1][1];
        const double n1 = triangle->area_m2 * (p0 * inverse[0][0] + p1 * inverse[0][1]);
        const double n2 = triangle->area_m2 * (p0 * inverse[1][0] + p1 * inverse[1][1]);
        force_n[triangle->node[1]][q] -= n1;
        force_n[triangle->node[2]][q] -= n2;
        force_n[triangle->node[0]][q] += n1 + n2;
    }
}

/* Advances the dynamic relaxation by one step of the pseudo time 1. All nodes have the mass `mass`.
 * When the kinetic energy falls below its previous value `energy`, all velocities are set to 0
 * (kinetic damping). Returns the largest unbalanced force. */
static double relax_step(double mass, double *energy)
{
    const int free_count = node_of(RINGS, 0);
    double now = 0.0, residual_n = 0.0;
    for (int i = 0; i < free_count; i++) {
        for (int q = 0; q < 3; q++) {
            speed[i][q] += force_n[i][q] / mass;
            now += speed[i][q] * speed[i][q];
            residual_n = fmax(residual_n, fabs(force_n[i][q]));
        }
    }
    if (now < *energy) {
        memset(speed, 0, sizeof speed);
        *energy = 0.0;
        return residual_n;
    }
    *energy = now;
    for (int i = 0; i < free_count; i++) {
        for (int q = 0; q < 3; q++) {
            place_m[i][q] += speed[i][q];
        }
    }
    return residual_n;
}

/* Computes the equilibrium under `load`. Writes the highest tension of all triangles and the
 * highest tension beside the ring. */
static void solve(const struct load *load, double *most_n_m, double *ring_n_m)
{
    const double stiffness_n_m = (double)sheet_grade(GRADE)->stiffness_n_m;
    double energy = 0.0, residual_n = 1.0;
    put_load(load);
    memset(speed, 0, sizeof speed);
    for (int i = 0; i < node_count; i++) {
        const double r = hypot(flat_m[i][0], flat_m[i][1]) / RADIUS_M;
        place_m[i][0] = flat_m[i][0];
        place_m[i][1] = flat_m[i][1];
        place_m[i][2] = 0.002 * (1.0 - r * r);
    }
    for (int step = 0; step < STEPS_MAX && (step < 500 || residual_n > RESIDUAL_N); step++) {
        memset(force_n, 0, sizeof force_n);
        for (int i = 0; i < node_count; i++) {
            force_n[i][2] = load_n[i];
        }
        for (int i = 0; i < triangle_count; i++) {
            pull_triangle(&triangles[i], stiffness_n_m);
        }
        residual_n = relax_step(18.0 * stiffness_n_m, &energy);
    }
    *most_n_m = *ring_n_m = 0.0;
    for (int i = 0; i < triangle_count; i++) {
        const double r = hypot(centre_m(&triangles[i], 0), centre_m(&triangles[i], 1));
        *most_n_m = fmax(*most_n_m, triangles[i].tension_n_m);
        *ring_n_m =
            r > RADIUS_M - BESIDE_RING_M ? fmax(*ring_n_m, triangles[i].tension_n_m) : *ring_n_m;
    }
}

/* Returns the highest tension that the game's own paper model (sheet.c) computes under `load`. */
static double sheet_most_n_m(const struct load *load)
{
    static struct sheet sheet;
    const struct sheet_wetting dry = { 0.0f, 0.0f, -1.0f };
    const struct sheet_load patch = { (float)load->x_m, 0.0f, (float)load->diameter_m,
                                      (float)load->force_n };
    sheet_init(&sheet, GRADE, (float)RADIUS_M, 1);
    sheet_idealise(&sheet);
    return (double)sheet_tick(&sheet, (float)load->pressure_pa, dry, &patch, load->force_n > 0.0)
        .tension_max_n_m;
}

int main(void)
{
    static const double at_m[] = { 0.0, 0.010, 0.018, 0.025, 0.030, 0.035, 0.040 };
    /* Loads to compare: the drag of a lift at 0.5 m/s with the ring broadside, the weight of a fish
     * of 5 cm, both together, and a weak slap. */
    static const struct load loads[] = { { 140.0, 0.0, 0.020, 0.0 },
                                         { 0.0, 0.028, 0.020, 0.0 },
                                         { 140.0, 0.028, 0.020, 0.0 },
                                         { 0.0, 0.050, 0.004, 0.0 } };
    int code = 0;
    build_mesh();
    puts("pressure_pa\tforce_n\tdiameter_mm\tat_mm\tmost_n_m\tat_ring_n_m\tsheet_n_m");
    for (size_t i = 0; i < sizeof loads / sizeof loads[0]; i++) {
        for (size_t k = 0; k < (i == 0 ? 1 : sizeof at_m / sizeof at_m[0]); k++) {
            struct load load = loads[i];
            double most_n_m, ring_n_m;
            load.x_m = at_m[k];
            solve(&load, &most_n_m, &ring_n_m);
            const double sheet_n_m = sheet_most_n_m(&load);
            printf("%g\t%g\t%g\t%g\t%.2f\t%.2f\t%.2f\n", load.pressure_pa, load.force_n,
                   1e3 * load.diameter_m, 1e3 * load.x_m, most_n_m, ring_n_m, sheet_n_m);
            code |= i == 0 && fabs(most_n_m / sheet_n_m - 1.0) > 0.05;
        }
    }
    return code;
}
