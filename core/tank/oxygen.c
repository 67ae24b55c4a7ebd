/* oxygen.c -- computes the oxygen balance of a well mixed tank: solubility, respiration and gas
 * exchange. */
#include "core/tank/oxygen.h"

#include "core/base/panic.h"
#include "core/input.h"
#include "core/tank/behavior/surface_breathing.h"

#define REFERENCE_C 25.0f
#define KELVIN 273.15f
#define HPA_PER_ATM 1013.25f
/* Gas exchange coefficient k_L of a still water surface, m/h. Published values are 2 to 5 cm/h. */
#define STILL_M_H 0.03f
/* Gas exchange rate kLa that a bubbling air stone adds, 1/h. Published values are 2 to 10 per
 * hour. */
#define PUMP_PER_H 5.0f
/* Oxygen that a fish consumes for swimming, in mg per kg of fish and per metre of path. The value
 * is from a measurement by Li of the cost of transport of goldfish 5 cm long. The exact publication
 * is not recorded. */
#define COST_MG_KG_M 0.6f
/* Longest step of the oxygen balance. All rates are constant within a step. */
#define STEP_H 0.005f
#define LITRES_PER_M3 1000.0f

float oxygen_saturation_mg_l(float temperature_c, float pressure_hpa)
{
    CORE_ASSERT(pressure_hpa > 0.0f);
    /* z is 1000 K / T minus the value of 1000 K / T at 25 C, where T is the absolute temperature.
     * The published polynomials in 1 / T have terms in the hundreds, but the sum of the terms is
     * only about 2. Single precision would cause an error of a thousandth in the sum. Therefore the
     * polynomials in this file are expanded around 25 C, a usual water temperature at a festival
     * stall. */
    const float reference_k = REFERENCE_C + KELVIN;
    const float z =
        1000.0f * (REFERENCE_C - temperature_c) / ((temperature_c + KELVIN) * reference_k);
    const float p = pressure_hpa / HPA_PER_ATM;
    /* u is the pressure of water vapour, atm. The published formula is exp(11.8571 - 3840.70 / T -
     * 216961 / T^2). */
    const float u = f_exp(-3.46535769f - z * (5.29608152f + z * 0.216961f));
    const float theta = 0.000975f - temperature_c * (1.426e-5f - temperature_c * 6.436e-8f);
    /* The first factor, f_exp(...), is the saturation concentration at one atmosphere, mg/L (Benson
     * & Krause 1984). */
    return f_exp(2.11184299f +
                 z * (1.63790983f + z * (0.53350163f + z * (0.870736542f - z * 0.8621949f)))) *
           ((p - u) * (1.0f - theta * p)) / ((1.0f - u) * (1.0f - theta));
}

/* Adds two parts: the routine respiration and the additional respiration for swimming. Young
 * Carassius auratus grandoculis have a routine respiration of 0.0674 * W^-0.193 * exp(0.0562 * T)
 * mg per g and hour from 15 to 30 C (Yamanaka). W is the mass in g and T the temperature in C. The
 * routine respiration grows by a factor of 1.75 per 10 K (Q10). */
float oxygen_breath_mg_h(float mass_kg, float temperature_c, float speed_m_s)
{
    CORE_ASSERT(mass_kg > 0.0f);
    CORE_ASSERT(speed_m_s >= 0.0f);
    const float mass_g = 1000.0f * mass_kg;
    const float routine = 0.0674f * f_exp(0.807f * f_log(mass_g) + 0.0562f * temperature_c);
    return routine + COST_MG_KG_M * mass_kg * 3600.0f * speed_m_s;
}

/* Computes the critical concentration by the formula of Yamanaka: 1.35 * W^-0.107 mg/L at any
 * temperature, where W is the mass of the fish in g. */
float oxygen_critical_mg_l(float mass_kg)
{
    CORE_ASSERT(mass_kg > 0.0f);
    return 1.35f * f_exp(-0.107f * f_log(1000.0f * mass_kg));
}

float oxygen_exchange_per_h(float water_depth_m, bool pump)
{
    CORE_ASSERT(water_depth_m > 0.0f);
    return STILL_M_H / water_depth_m + (pump ? PUMP_PER_H : 0.0f);
}

float oxygen_after(float dissolved_mg_l, const struct oxygen_balance *balance, float hours)
{
    CORE_ASSERT(hours >= 0.0f);
    CORE_ASSERT(balance->critical_mg_l > 0.0f);
    const uint32_t steps = (uint32_t)(hours / STEP_H) + 1u;
    for (uint32_t i = 0; i < steps; i++) {
        /* During a step of the oxygen balance, the fish remove a constant fraction of the dissolved
         * oxygen per hour, so the balance is a linear differential equation. The exact solution of
         * the equation is stable for a step of any length. The code approximates 1 - exp(-x) by a
         * quotient, which avoids cancellation and has an error of 1e-6 for x below 0.2. */
        const float share_per_h =
            balance->breath_mg_l_h / f_max(dissolved_mg_l, balance->critical_mg_l);
        const float rate_per_h = balance->exchange_per_h + share_per_h;
        const float x = rate_per_h * (hours / (float)steps);
        const float approached = x / (1.0f + x * (0.5f + x * (1.0f / 12.0f)));
        if (approached > 0.0f) {
            const float end_mg_l = balance->exchange_per_h * balance->saturation_mg_l / rate_per_h;
            dissolved_mg_l += (end_mg_l - dissolved_mg_l) * f_min(approached, 1.0f);
        }
    }
    return dissolved_mg_l;
}

void oxygen_tick(struct oxygen *oxygen, const struct fish *fish, uint32_t fish_count, vec3 size_m,
                 uint32_t tick)
{
    CORE_ASSERT(fish_count <= TANK_FISH_MAX);
    CORE_ASSERT(oxygen->time_compression >= 0.0f);
    const uint32_t share = tick % CORE_TICK_HZ;
    const uint32_t first = (uint32_t)((uint64_t)fish_count * share / CORE_TICK_HZ);
    const uint32_t end = (uint32_t)((uint64_t)fish_count * (share + 1u) / CORE_TICK_HZ);
    for (uint32_t i = first; i < end; i++) {
        if (fish_swims(&fish[i]) && !surface_breathes(&fish[i])) {
            const float mass_kg = fish_mass_kg(fish[i].length_m);
            const float breath_mg_h =
                oxygen_breath_mg_h(mass_kg, oxygen->temperature_c, fish[i].speed_m_s);
            oxygen->breath_mg_h += breath_mg_h;
            oxygen->critical_mg += breath_mg_h * oxygen_critical_mg_l(mass_kg);
        }
    }
    if (share == CORE_TICK_HZ - 1u) {
        const float litres = LITRES_PER_M3 * size_m.x * size_m.y * size_m.z;
        const float breath_mg_h = oxygen->breath_mg_h;
        const struct oxygen_balance balance = {
            .saturation_mg_l = oxygen_saturation_mg_l(oxygen->temperature_c, oxygen->pressure_hpa),
            .exchange_per_h = oxygen_exchange_per_h(size_m.y, oxygen->pump),
            .breath_mg_l_h = breath_mg_h / litres,
            .critical_mg_l = breath_mg_h > 0.0f ? oxygen->critical_mg / breath_mg_h : 1.0f,
        };
        oxygen->dissolved_mg_l =
            oxygen_after(oxygen->dissolved_mg_l, &balance, oxygen->time_compression / 3600.0f);
        oxygen->breath_mg_h = 0.0f;
        oxygen->critical_mg = 0.0f;
    }
}
