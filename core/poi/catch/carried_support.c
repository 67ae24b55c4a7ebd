/* carried_support.c -- tests the support of a fish at five places along its body, with three points
 * across the body at each place. */
#include "core/poi/catch/carried_support.h"

#include "core/poi/poi.h"

/* Distance between test places along the body, in body lengths. The places reach from 0.36 body
 * lengths in front of the centre to 0.36 body lengths behind it. */
#define ALONG_STEP 0.18f
/* Distance of the outer test points from the midline of the body, as a fraction of the body's
 * girth. The fraction is less than one half, because a body tapers. */
#define ACROSS 0.30f

static int is_borne(const struct sheet *sheet, float x_m, float z_m)
{
    const float square = x_m * x_m + z_m * z_m;
    if (square >= sheet->radius_m * sheet->radius_m) {
        return square <= POI_OUTER_RADIUS_M * POI_OUTER_RADIUS_M;
    }
    return sheet_holds(sheet, x_m, z_m);
}

/* Returns 1 if paper or ring supports at least one of three points across the body, otherwise 0.
 * `along` is the distance of the points behind the fish's centre, in body lengths. */
static int slice_holds(const struct sheet *sheet, const struct carried_fish *carried,
                       const struct fish *fish, float along)
{
    const float tail_x = f_sin(carried->heading_rad), tail_z = f_cos(carried->heading_rad);
    const float x = carried->x_m + along * fish->length_m * tail_x;
    const float z = carried->z_m + along * fish->length_m * tail_z;
    const float aside = ACROSS * f_lerp(fish->width_m, fish->height_m, carried->lie);
    return is_borne(sheet, x, z) || is_borne(sheet, x + aside * tail_z, z - aside * tail_x) ||
           is_borne(sheet, x - aside * tail_z, z + aside * tail_x);
}

static int half_holds(const struct sheet *sheet, const struct carried_fish *carried,
                      const struct fish *fish, float way)
{
    return slice_holds(sheet, carried, fish, way * ALONG_STEP) ||
           slice_holds(sheet, carried, fish, 2.0f * way * ALONG_STEP);
}

int carried_support_holds(const struct sheet *sheet, const struct carried_fish *carried,
                          const struct fish *fish)
{
    const float square = carried->x_m * carried->x_m + carried->z_m * carried->z_m;
    if (square > POI_OUTER_RADIUS_M * POI_OUTER_RADIUS_M) {
        return 0;
    }
    if (sheet->paper_cells == sheet->paper_cells_new) {
        return 1; /* The paper has no hole, which is the case in most ticks of a round. */
    }
    return slice_holds(sheet, carried, fish, 0.0f) &&
           (half_holds(sheet, carried, fish, -1.0f) || half_holds(sheet, carried, fish, 1.0f));
}
