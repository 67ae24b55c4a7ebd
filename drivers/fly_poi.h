/* fly_poi.h -- turns what sticks or a puck say into where a hand is.
 *
 * Pure: no device, no clock, no library. A stick says a speed, not a place, so the hand flies over
 * the water: pushed to the right it goes right, pushed away it goes away, and let go it stays. A
 * puck also flies up and down; a pad lets the ring down with a button, as a mouse does (dip.h).
 * What turns, turns the ring: an angle of the stick is an angle of the ring, and level again when
 * it is let go. LEVEL held brings a puck's ring back over the water. In the water the hand goes so
 * slowly that paper bears it, if it is not also shaken. */
#ifndef KINGYO_DRIVERS_FLY_POI_H
#define KINGYO_DRIVERS_FLY_POI_H

#include <stdint.h>

#include "drivers/dip.h"
#include "drivers/pointer_poi.h"

#define FLY_AIR_M_S 0.55f    /* At full push: across the stall's tank in a second and a half. */
#define FLY_WATER_M_S 0.26f  /* Under water: wet paper bears 0.4 m/s broadside. */
#define FLY_HEIGHT_M_S 0.30f /* Up and down: as fast as a dip is at its fastest. */
#define FLY_HIGH_M 0.12f     /* No higher: a hand over the rim. */
#define FLY_LOW_M (-0.11f)   /* No deeper: the floor of the stall's tank. */
#define FLY_TILT_MAX_RAD (60.0f * F_DEG)

/* Everything that sticks say at one moment; levels. */
struct fly_report {
    uint64_t time_ns;
    vec3 push;         /* Each part within -1 .. 1; any bits, what is no number is none. */
    vec3 twist;        /* Pitch, yaw, roll as shares of FLY_TILT_MAX_RAD; likewise. */
    uint32_t buttons;  /* enum pointer_button levels. */
};

struct fly_poi {
    struct view view;
    vec3 low_m[2], high_m[2]; /* Where it may fly, which is what the view shows: at FLY_LOW_M, and
                                 at FLY_HIGH_M. */
    struct fly_report report;
    struct dip dip;
    vec3 place_m;        /* Over the still water, before the dip. */
    vec3 speed_m_s;      /* It starts and stops as a hand does, within FLY_TAU_S. */
    vec3 twist_rad;      /* Pitch, yaw, roll as they follow the stick. */
    vec3 shade_m;        /* Where the fan was led last; x and z. */
    float swing;         /* [0, 1] of the fan's way in, as pointer_fan's. */
    uint64_t time_ns;    /* Of the newest report or sample. */
};

/* A hand that hovers over the middle of the water. `view` is copied. */
void fly_poi_init(struct fly_poi *fly, const struct view *view);

/* The tank is looked at so from now on; it stays within what is seen. */
void fly_poi_look(struct fly_poi *fly, const struct view *view);

/* Takes one report; one that is older than the last counts as now. */
void fly_poi_report(struct fly_poi *fly, const struct fly_report *report);

/* Where the hand is at `time_ns`, which never goes back. Always finite. */
struct poi_target fly_poi_target(struct fly_poi *fly, uint64_t time_ns);

/* The fan, while POINTER_FAN is held: sticks lead it, and the poi waits. */
struct shade_input fly_poi_fan(struct fly_poi *fly, uint64_t time_ns);

#endif
