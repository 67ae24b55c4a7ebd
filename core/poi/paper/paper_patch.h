/* paper_patch.h -- searches the paper for an undamaged patch that can hold a fish, and decides
 * whether torn paper is still usable. Patches lie in the middle of the ring and on two circles
 * around the middle. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

struct sheet;

/* Radius of the patch that the smallest fish of a stall needs under its body. */
#define PAPER_PATCH_RADIUS_M 0.010f

struct patch {
    uint8_t middle; /* 1 if the patch is in the middle of the ring, otherwise 0. */
    float x_m, z_m; /* Centre of the patch in the poi's plane. */
};

/* Callback that returns true if paper exists at a point of the poi's plane, as far as the caller
 * can detect. */
typedef bool paper_patch_holds(const void *paper, float x_m, float z_m);

/* Finds the first undamaged patch in a ring of `radius_m`. The patch in the middle of the ring is
 * tested first, then the patches on the inner circle and on the outer circle. On each circle the
 * far side is tested before the near side. `paper` is passed to `holds`. Returns true, or false
 * with `patch` unchanged if no patch is undamaged. */
bool paper_patch_find(paper_patch_holds *holds, const void *paper, float radius_m,
                      struct patch *patch);

/* Smallest usable share of the paper area. A smaller remainder is only a fringe along the ring. */
#define PAPER_LEFT_MIN 0.35f

/* Returns true if a fish could still lie on the paper. At least PAPER_LEFT_MIN of the paper's area
 * must be left, with an undamaged patch in it. A hole alone, even in the middle, does not end a
 * round, because the rules allow a partly torn poi. */
bool paper_can_hold(const struct sheet *sheet);
