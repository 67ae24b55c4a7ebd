/* oxygen.h -- what the water holds for the fish to breathe, and how soon they use it up.
 *
 * dC/dt = kLa (C* - C) - breath / V. Air gives what the water lacks to saturation, fish take by
 * mass, temperature and speed. In a round of three minutes little changes, so the water's hours may
 * run faster than the fish: `time_compression` of them pass in one. Nothing else is hurried. */
#ifndef KINGYO_CORE_TANK_OXYGEN_H
#define KINGYO_CORE_TANK_OXYGEN_H

#include <stdint.h>

#include "core/tank/fish.h"

#define OXYGEN_TEMPERATURE_MIN_C 0.0f
#define OXYGEN_TEMPERATURE_MAX_C 40.0f
#define OXYGEN_PRESSURE_MIN_HPA 870.0f  /* The eye of the strongest typhoon, at sea level ... */
#define OXYGEN_PRESSURE_MAX_HPA 1085.0f /* ... and the highest that was ever measured. */
#define OXYGEN_PRESSURE_HPA 1013.25f    /* One standard atmosphere. */
#define OXYGEN_MAX_MG_L 20.0f
#define OXYGEN_TIME_COMPRESSION_MAX 1000.0f

struct oxygen {
    float dissolved_mg_l;   /* [0, OXYGEN_MAX_MG_L] */
    float temperature_c;    /* Of the water. */
    float pressure_hpa;     /* Of the air above it. */
    float time_compression; /* [0, OXYGEN_TIME_COMPRESSION_MAX] 0 holds the oxygen as it is. */
    float breath_mg_h;      /* What the fish asked so far breathe; all are asked once a second. */
    float critical_mg;      /* The same fish's critical concentrations, by what they breathe. */
    uint8_t pump;           /* Whether the air stone bubbles. */
};

/* What fresh water holds in equilibrium with air (Benson & Krause 1984): 8.263 mg/L at 25 C and
 * 1013.25 hPa. Within 0.01 % of the formula in the ranges above. */
float oxygen_saturation_mg_l(float temperature_c, float pressure_hpa);

/* What one fish takes in an hour, mg: routine rate by mass and temperature, and 0.6 mg/kg for each
 * metre that it swims. `mass_kg` > 0. */
float oxygen_breath_mg_h(float mass_kg, float temperature_c, float speed_m_s);

/* Below this it cannot take what it needs, but less in proportion: 1.2 mg/L at 5 cm. */
float oxygen_critical_mg_l(float mass_kg);

/* kLa, 1/h: a still surface lets in 3 cm of water's worth an hour, a pump five tanks' worth. */
float oxygen_exchange_per_h(float water_depth_m, int pump);

/* Oxygen comes in at `exchange_per_h` of what is missing to `saturation_mg_l`; fish breathe
 * `breath_mg_l_h` as long as there is `critical_mg_l` > 0. */
struct oxygen_balance {
    float saturation_mg_l, exchange_per_h, breath_mg_l_h, critical_mg_l;
};

/* What there is after `hours`, from `dissolved_mg_l`. Stable for any step; never negative. */
float oxygen_after(float dissolved_mg_l, const struct oxygen_balance *balance, float hours);

/* One tick: asks its share of the fish, so that all are asked in a second, and each second moves
 * the water on. Fish on a poi or in a bowl do not breathe here, nor do those that gulp at the
 * surface: its film is always near saturation. */
void oxygen_tick(struct oxygen *oxygen, const struct fish *fish, uint32_t fish_count, vec3 size_m,
                 uint32_t tick);

uint64_t oxygen_hash(uint64_t hash, const struct oxygen *oxygen);

#endif
