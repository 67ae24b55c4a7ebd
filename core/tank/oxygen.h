/* oxygen.h -- the dissolved oxygen of the water and its consumption by the fish.
 *
 * The concentration C follows dC/dt = kLa (C* - C) - breath / V. The air supplies oxygen in
 * proportion to the deficit from the saturation C*. The fish consume oxygen according to mass,
 * temperature and speed. Because little changes in a round of three minutes, the oxygen can run
 * faster than the fish: `time_compression` hours of the oxygen balance pass in one hour. Nothing
 * else runs faster. */
#ifndef KINGYO_CORE_TANK_OXYGEN_H
#define KINGYO_CORE_TANK_OXYGEN_H

#include <stdint.h>

#include "core/tank/fish.h"

#define OXYGEN_TEMPERATURE_MIN_C 0.0f
#define OXYGEN_TEMPERATURE_MAX_C 40.0f
/* Lowest pressure at sea level that was measured, in the eye of a typhoon. */
#define OXYGEN_PRESSURE_MIN_HPA 870.0f
#define OXYGEN_PRESSURE_MAX_HPA 1085.0f /* Highest pressure at sea level that was measured. */
#define OXYGEN_PRESSURE_HPA 1013.25f    /* Pressure of the standard atmosphere. */
#define OXYGEN_MAX_MG_L 20.0f
#define OXYGEN_TIME_COMPRESSION_MAX 1000.0f

struct oxygen {
    float dissolved_mg_l;   /* Dissolved oxygen, 0 .. OXYGEN_MAX_MG_L. */
    float temperature_c;    /* Temperature of the water. */
    float pressure_hpa;     /* Pressure of the air above the water. */
    float time_compression; /* Speed of the oxygen balance, 0 .. OXYGEN_TIME_COMPRESSION_MAX. 0
                               keeps the oxygen constant. */
    float breath_mg_h;      /* Sum of the respiration of the fish that were sampled in the current
                               second. Every fish is sampled once per second. */
    float critical_mg;      /* Sum of the critical concentrations of the sampled fish, each weighted
                               by the fish's respiration. */
    uint8_t pump;           /* 1 while the air stone bubbles, otherwise 0. */
};

/* Returns the oxygen concentration of fresh water in equilibrium with air, mg/L (Benson & Krause
 * 1984). Example: 8.263 mg/L at 25 C and 1013.25 hPa. The result is within 0.01 % of the published
 * formula for OXYGEN_TEMPERATURE_MIN_C .. _MAX_C and OXYGEN_PRESSURE_MIN_HPA .. _MAX_HPA. */
float oxygen_saturation_mg_l(float temperature_c, float pressure_hpa);

/* Returns the oxygen that one fish consumes in an hour, mg. The sum has two parts: the routine rate
 * for mass and temperature, and 0.6 mg per kg and metre of swimming. `mass_kg` must be > 0. */
float oxygen_breath_mg_h(float mass_kg, float temperature_c, float speed_m_s);

/* Returns the critical oxygen concentration of a fish, mg/L. Below that concentration, respiration
 * falls in proportion to the concentration. Example: 1.2 mg/L for a fish of 5 cm. */
float oxygen_critical_mg_l(float mass_kg);

/* Returns the rate of gas exchange kLa, 1/h. A still surface exchanges 3 cm of water depth per
 * hour. A pump (`pump` = 1) adds five tank volumes per hour. */
float oxygen_exchange_per_h(float water_depth_m, int pump);

/* Rates of one step of the balance. Oxygen enters at the rate `exchange_per_h` times the deficit
 * from `saturation_mg_l`. The fish consume `breath_mg_l_h` if the concentration is at least
 * `critical_mg_l`, which must be > 0. */
struct oxygen_balance {
    float saturation_mg_l, exchange_per_h, breath_mg_l_h, critical_mg_l;
};

/* Returns the concentration after `hours`, starting at `dissolved_mg_l`. The result is stable for
 * any duration and never negative. */
float oxygen_after(float dissolved_mg_l, const struct oxygen_balance *balance, float hours);

/* Advances the oxygen by one tick (1/120 s). Each tick samples a share of the fish, so that all
 * fish are sampled within a second. Each second applies one step of the balance. Fish on a poi or
 * in a bowl are not counted. Fish that gulp at the surface are not counted either, because the
 * surface film is always near saturation. */
void oxygen_tick(struct oxygen *oxygen, const struct fish *fish, uint32_t fish_count, vec3 size_m,
                 uint32_t tick);

uint64_t oxygen_hash(uint64_t hash, const struct oxygen *oxygen);

#endif
