/* oxygen.h -- the dissolved oxygen of the water and its consumption by the fish.
 *
 * The concentration C of the oxygen follows dC/dt = kLa * (C* - C) - R / V. kLa is the rate of gas
 * exchange with the air, C* the saturation concentration, R the respiration of all fish and V the
 * volume of the water. The respiration of a fish depends on its mass, its speed and the water
 * temperature.
 *
 * During a round of three minutes the concentration hardly changes. Therefore the oxygen balance
 * can run faster than real time: `time_compression` hours of the balance pass in one hour. All
 * other parts of the simulation run in real time. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "core/tank/fish.h"

#define OXYGEN_TEMPERATURE_MIN_C 0.0f
#define OXYGEN_TEMPERATURE_MAX_C 40.0f
/* Lowest air pressure that was ever measured at sea level, in the eye of a typhoon. */
#define OXYGEN_PRESSURE_MIN_HPA 870.0f
/* Highest air pressure that was ever measured at sea level. */
#define OXYGEN_PRESSURE_MAX_HPA 1085.0f
#define OXYGEN_PRESSURE_HPA 1013.25f /* Pressure of the standard atmosphere. */
#define OXYGEN_MAX_MG_L 20.0f
#define OXYGEN_TIME_COMPRESSION_MAX 1000.0f

struct oxygen {
    float dissolved_mg_l; /* Dissolved oxygen, 0 .. OXYGEN_MAX_MG_L. */
    float temperature_c;  /* Temperature of the water. */
    float pressure_hpa;   /* Pressure of the air above the water. */
    /* Speed of the oxygen balance relative to real time, 0 .. OXYGEN_TIME_COMPRESSION_MAX. 0 keeps
     * the oxygen constant. */
    float time_compression;
    /* Sum of the respiration of the fish that were sampled in the current second. Every fish is
     * sampled once per second. */
    float breath_mg_h;
    /* Sum, over the sampled fish, of the critical oxygen concentration times the respiration of the
     * fish. At the end of each second, this sum divided by `breath_mg_h` is the mean critical
     * concentration. */
    float critical_mg;
    /* True while the air pump runs, so that the air stone in the tank bubbles. */
    bool pump;
};

/* Returns the oxygen concentration of fresh water in equilibrium with air, mg/L (Benson & Krause
 * 1984). Example: 8.263 mg/L at 25 C and 1013.25 hPa. Within the limits of temperature and pressure
 * above, the result is within 0.01 % of the published formula. */
float oxygen_saturation_mg_l(float temperature_c, float pressure_hpa);

/* Returns the oxygen that one fish consumes in an hour, mg. The result is the sum of two parts: the
 * routine respiration for the fish's mass and the water temperature, and 0.6 mg per kg of fish and
 * metre of path. `mass_kg` must be > 0. */
float oxygen_breath_mg_h(float mass_kg, float temperature_c, float speed_m_s);

/* Returns the critical oxygen concentration of a fish, mg/L. Below that concentration, respiration
 * falls in proportion to the concentration. Example: 1.2 mg/L for a fish of 5 cm. */
float oxygen_critical_mg_l(float mass_kg);

/* Returns the rate of gas exchange kLa, 1/h. The surface contributes 0.03 m/h divided by the water
 * depth. A running pump (`pump` is true) adds 5 per hour. */
float oxygen_exchange_per_h(float water_depth_m, bool pump);

/* Input of one step of the oxygen balance. Oxygen enters the water at the rate `exchange_per_h`
 * times the difference between `saturation_mg_l` and the concentration. The fish consume
 * `breath_mg_l_h` if the concentration is at least `critical_mg_l`. Below `critical_mg_l`, the
 * consumption falls in proportion to the concentration. `critical_mg_l` must be > 0. */
struct oxygen_balance {
    float saturation_mg_l, exchange_per_h, breath_mg_l_h, critical_mg_l;
};

/* Returns the concentration after `hours`, starting at `dissolved_mg_l`. The result is stable for
 * any duration and never negative. */
float oxygen_after(float dissolved_mg_l, const struct oxygen_balance *balance, float hours);

/* Advances the oxygen by one tick (1/120 s). Each tick samples the respiration of a part of the
 * fish, so that every fish is sampled once per second. At the end of each second, the function
 * advances the concentration by one step. Fish on a poi (the paper scoop) or in a bowl are not
 * counted. Fish that gulp at the surface are not counted either, because the surface film is always
 * near saturation. */
void oxygen_tick(struct oxygen *oxygen, const struct fish *fish, uint32_t fish_count, vec3 size_m,
                 uint32_t tick);
