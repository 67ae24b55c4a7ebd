/* world.h -- struct world: all objects that the physics simulates, which are the tank, the pois and
 * the bowls.
 *
 * A poi is the paper scoop with its sheet of paper. Element i of `poi` and element i of `bowl`
 * belong to player i. The game changes the world, but the physics does not depend on the phases or
 * the players of the game. */
#pragma once

#include "core/poi/bowl/bowl.h"
#include "core/poi/catch/near_miss.h"
#include "core/poi/poi.h"
#include "core/poi/tear_clip.h"
#include "core/tank/tank.h"

/* The latest splashes and scraps of paper, as two ring buffers, for display only. No hash contains
 * them. The age of an entry is computed from its tick plus 1. The value 0 means no entry. */
struct splashes {
    struct scene_splash latest[SCENE_SPLASH_MAX];
    uint32_t ticks[SCENE_SPLASH_MAX];
    uint32_t next; /* Index of the oldest entry, which the next splash replaces. */
    struct scene_scrap scraps[SCENE_SCRAP_MAX];
    uint32_t scrap_ticks[SCENE_SCRAP_MAX];
    uint32_t next_scrap;
};

struct world {
    struct tank tank;
    struct poi poi[POI_MAX];
    struct bowl bowl[POI_MAX];
    struct tear_clip tear_clip[POI_MAX]; /* Recording of each poi in the present round. */
    struct near_miss near_miss[POI_MAX]; /* Near misses of each poi in the present round. */
    struct splashes splashes;
};

/* Adds a splash to `splashes`. `at_m` is its place on the surface of the water of the tank, or of a
 * bowl if `in_bowl` is true. The number of drops
 * increases with the speed of `push_m_s`, from none at SPLASH_FROM_M_S to `drops_max` at
 * SPLASH_FULL_M_S. */
void surface_splash(struct splashes *splashes, vec3 at_m, bool in_bowl, vec3 push_m_s,
                    float radius_m, uint8_t drops_max, uint32_t tick);
/* Adds the splash of a poi whose ring enters or leaves the water in this tick. */
void surface_splash_poi(struct splashes *splashes, const struct poi *poi, uint32_t tick);
/* Adds a scrap of paper at a hole of the poi's sheet if the sheet tore in this tick. Adds at most
 * one scrap in SPLASH_SCRAP_TICKS. */
void surface_splash_scrap(struct splashes *splashes, const struct poi *poi, uint32_t tick);
/* Writes the splashes of the last SCENE_SPLASH_S and the scraps of the last SCENE_SCRAP_S before
 * `tick` to `scene`. */
void surface_splash_show(const struct splashes *splashes, uint32_t tick, struct scene *scene);

#define SPLASH_SCRAP_TICKS 16u
/* Speeds of a body, in m/s, from which its splash has drops, and from which the splash has its
 * largest number of drops. */
#define SPLASH_FROM_M_S 0.08f
#define SPLASH_FULL_M_S 0.7f
