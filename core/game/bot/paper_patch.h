/* paper_patch.h -- searches for a whole round patch of paper that can hold a fish, in the middle of
 * the ring or on two circles around it. */
#ifndef KINGYO_CORE_GAME_BOT_PAPER_PATCH_H
#define KINGYO_CORE_GAME_BOT_PAPER_PATCH_H

#include <stdint.h>

/* Support that the smallest fish of a stall needs under its body. */
#define PAPER_PATCH_RADIUS_M 0.010f

struct patch {
    uint8_t middle; /* 1: the patch is in the middle of the ring. */
    float x_m, z_m; /* Centre of the patch in the poi's plane. */
};

/* Callback: returns 1 if paper exists at a point of the poi's plane, as far as the caller can
 * detect. */
typedef int paper_patch_holds(const void *paper, float x_m, float z_m);

/* Finds the first whole patch in a ring of `radius_m`: the middle before the circles, the far side
 * before the near side. `paper` is passed to `holds`. Returns 1, or 0 with `patch` unchanged. */
int paper_patch_find(paper_patch_holds *holds, const void *paper, float radius_m,
                     struct patch *patch);

#endif
