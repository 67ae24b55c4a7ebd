/* capture.h -- how fish come onto a poi (paper scoop) and leave the poi: contact with the paper,
 * capture, and fall.
 *
 * A swimming fish over the paper becomes a carried fish if the water is too shallow for the fish to
 * stand upright. A fish that slips off the ring or falls through the paper falls into a bowl or
 * into the water. */
#pragma once

#include "core/poi/bowl/bowl.h"
#include "core/poi/catch/carried_fish.h"
#include "core/poi/poi.h"
#include "core/tank/tank.h"

/* Depth of water over the paper above which a carried fish floats off the paper, in body
 * heights. */
#define CAPTURE_FLOAT_SHARE 1.50f

/* Tries to capture fish `index` of the tank. The caller guarantees that the fish is over intact
 * paper and near the paper, and that `poi_index` < POI_MAX. Does nothing if the water over the
 * paper is deep enough for the fish to stand upright, or if the poi is too steep. If the poi
 * already carries POI_CARRIED_MAX fish, the fish slips off over the ring instead. `axes` are the
 * poi's axes. */
void capture_fish(struct poi *poi, uint32_t poi_index, const struct basis *axes, struct tank *tank,
                  uint32_t index, uint32_t tick);

/* Puts a fish that the poi cannot carry back into the water, and moves the fish away from the
 * ring's centre. A caller uses the function if the paper has no room, or if the ring presses the
 * fish against the water surface without lifting the fish. */
void capture_slip_off(const struct poi *poi, struct tank *tank, struct fish *fish);

/* Returns true if the ring presses a fish against a wall of the tank. The ring and the fish must
 * be within 15 mm of the wall, and the fish must be nearer to the wall than the ring's centre.
 * The ring must move toward the wall, or the hand must push the ring toward the wall. */
bool capture_is_walled(const struct poi *poi, const struct basis *axes, const struct tank *tank,
                       const struct fish *fish);

enum fall_end {
    FALL_GOES_ON = 0,
    FALL_INTO_BOWL, /* The fish is now in a bowl, and `fish_count` of the bowl includes it. */
    /* The fish is back in the water of the tank. The fish swims as soon as no other fish is in its
     * way. */
    FALL_INTO_WATER,
};

/* Changes a carried fish to a falling fish with the world velocity `velocity_m_s`. */
void catch_fall_begin(struct carried_fish *carried, vec3 velocity_m_s);

/* Advances the fall of a fish by one tick (1/120 s). A fish can enter the bowl of any player, but
 * only from above through the bowl's mouth. If the result is FALL_INTO_BOWL, writes the index of
 * the bowl to `bowl_index`. */
enum fall_end catch_fall_tick(struct carried_fish *carried, const struct stall *stall,
                              uint32_t *bowl_index);

/* Puts a fish back into the water of the tank, below the surface and inside the walls. The fish
 * gets the full alarm, so that it flees. */
void catch_set_free(struct tank *tank, struct fish *fish, vec3 velocity_m_s);

/* Returns true if a swimming fish is above intact paper and near enough to be captured. Only the
 * position of the fish's centre decides whether the fish is above the paper. This is sufficient,
 * because the contact solver lets no fish pass through the paper. `axes` are the poi's axes. */
bool capture_touches(const struct poi *poi, const struct basis *axes, const struct fish *fish);

/* Returns true if fish block the ring and the ring presses the fish `fish` against the water
 * surface. In this case the fish must slip off, because the poi could not be lifted
 * otherwise. */
bool capture_is_squeezed(const struct poi *poi, const struct fish *fish);

/* Returns true if the ring is jammed. The ring is jammed if fish block the ring while the target of
 * the hand is at least 3 cm above the ring (a pull of 6.5 N). */
bool capture_is_jammed(const struct poi *poi);

/* Returns true if the fish `fish` jams the ring and must leave the poi in this tick. A jammed ring
 * cannot rise, because fish between the ring and the water surface block it. These fish leave from
 * the edge inward, more fish the longer the jam lasts. After 0.1 s, all fish that touch the ring
 * leave. `axes` are the poi's axes. */
bool capture_releases(const struct poi *poi, const struct basis *axes, const struct fish *fish);
