/* patch.h -- looks for one whole round patch of paper, in the middle of the ring or on two circles
 * about it: what a fish can lie on. */
#ifndef KINGYO_CORE_GAME_PATCH_H
#define KINGYO_CORE_GAME_PATCH_H

#include <stdint.h>

#define PATCH_RADIUS_M 0.010f /* What the smallest fish of a stall needs under its body. */

struct patch {
    uint8_t middle; /* It is the middle of the ring. */
    float x_m, z_m; /* Its own, in the poi's plane. */
};

/* Whether there is paper at a point of the poi's plane, as far as the asker can tell. */
typedef int patch_holds(const void *paper, float x_m, float z_m);

/* The first there is in a ring of `radius_m`: the middle before the sides, the far side before the
 * near one. `paper` is handed to `holds`. Returns whether there is one; if not, `patch` stays as it
 * was. */
int patch_find(patch_holds *holds, const void *paper, float radius_m, struct patch *patch);

#endif
