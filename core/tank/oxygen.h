/* oxygen.h -- the dissolved oxygen of the water and its consumption by the fish.
 *
 * dC/dt = kLa (C* - C) - breath / V. The air replaces what the water lacks to saturation. The fish
 * consume oxygen by mass, temperature and speed. In a round of three minutes little changes, so the
 * oxygen may run faster than the fish: `time_compression` hours pass in one hour. Nothing else runs
 * faster. */
#ifndef KINGYO_CORE_TANK_OXYGEN_H
#define KINGYO_CORE_TANK_OXYGEN_H

#include <stdint.h>

#include "core/tank/fish.h"

#define OXYGEN_TEMPERATURE_MIN_C 0.0f
#define OXYGEN_TEMPERATURE_MAX_C 40.0f
/* Pressure at sea level in the eye of the strongest typhoon. */
#define OXYGEN_PRESSURE_MIN_HPA 870.0f
#define OXYGEN_PRESSURE_MAX_HPA 1085.0f /* Highest pressure at sea level ever measured. */
#define OXYGEN_PRESSURE_HPA 1013.25f    /* The standard atmosphere. */
#define OXYGEN_MAX_MG_L 20.0f
#define OXYGEN_TIME_COMPRESSION_MAX 1000.0f

struct oxygen {
    float dissolved_mg_l;   /* [0, OXYGEN_MAX_MG_L] */
    float temperature_c;    /* Temperature of the water. */
    float pressure_hpa;     /* Pressure of the air above the water. */
    float time_compression; /* [0, OXYGEN_TIME_COMPRESSION_MAX]; 0 keeps the oxygen constant. */
    float breath_mg_h;      /* Sum of the respiration of the fish sampled so far; all fish are
                               sampled once per second. */
    float critical_mg;      /* Sum of the critical concentrations of the same fish, weighted by
                               their respiration. */
    uint8_t pump;           /* 1 while the air stone bubbles. */
};

/* Returns the concentration of fresh water in equilibrium with air, mg/L (Benson & Krause 1984):
 * 8.263 mg/L at 25 C and 1013.25 hPa. Within 0.01 % of the formula in the ranges above. */
float oxygen_saturation_mg_l(float temperature_c, float pressure_hpa);

/* Returns the oxygen that one fish consumes in an hour, mg: the routine rate by mass and
 * temperature, and 0.6 mg/kg per metre of swimming. `mass_kg` > 0. */
float oxygen_breath_mg_h(float mass_kg, float temperature_c, float speed_m_s);

/* Returns the concentration below which a fish consumes less than it needs, in proportion: 1.2 mg/L
 * at 5 cm. */
float oxygen_critical_mg_l(float mass_kg);

/* Returns kLa, 1/h. A still surface exchanges 3 cm of water per hour; a pump exchanges five tanks
 * per hour. */
float oxygen_exchange_per_h(float water_depth_m, int pump);

/* Rates of one step. Oxygen enters at `exchange_per_h` of the deficit to `saturation_mg_l`. Fish
 * consume `breath_mg_l_h` while the concentration is at least `critical_mg_l` > 0. */
struct oxygen_balance {
    float saturation_mg_l, exchange_per_h, breath_mg_l_h, critical_mg_l;
};

/* Returns the concentration after `hours`, starting at `dissolved_mg_l`. Stable for any step; never
 * negative. */
float oxygen_after(float dissolved_mg_l, const struct oxygen_balance *balance, float hours);

/* Advances one tick: samples a share of the fish, so that all are sampled within a second, and
 * applies one step of the balance each second. Fish on a poi or in a bowl do not count. Fish that
 * gulp at the surface do not count either, because the surface film is always near saturation. */
void oxygen_tick(struct oxygen *oxygen, const struct fish *fish, uint32_t fish_count, vec3 size_m,
                 uint32_t tick);

uint64_t oxygen_hash(uint64_t hash, const struct oxygen *oxygen);

#endif
