/* oxygen.c -- the oxygen balance of a well mixed tank: solubility, respiration and gas exchange. */
#include "core/tank/oxygen.h"

#include "core/base/hash.h"
#include "core/input.h"
#include "core/tank/behavior/surface_breathing.h"

#define REFERENCE_C 25.0f
#define KELVIN 273.15f
#define HPA_PER_ATM 1013.25f
/* Exchange coefficient k_L of a still surface, for which 2 to 5 cm/h are published. */
#define STILL_M_H 0.03f
/* Exchange rate kLa of an air stone, for which 2 to 10 per hour are published. */
#define PUMP_PER_H 5.0f
/* Oxygen for swimming, mg per kg of fish and metre (goldfish of 5 cm; Li). */
#define COST_MG_KG_M 0.6f
#define STEP_H 0.005f /* Longest step of the balance. Rates are constant within a step. */
#define LITRES_PER_M3 1000.0f

/* Returns 1000 K / T minus the value of 1000 K / T at 25 C. The published polynomials in 1 / T have
 * terms in the hundreds and a sum of 2, so single precision would lose a thousandth. Therefore the
 * polynomials in this file are expanded around 25 C, the usual water temperature at a festival
 * stall. */
static float inverse_kelvin(float temperature_c)
{
    const float reference_k = REFERENCE_C + KELVIN;
    return 1000.0f * (REFERENCE_C - temperature_c) / ((temperature_c + KELVIN) * reference_k);
}

/* Returns the saturation concentration at one atmosphere, mg/L (Benson & Krause 1984). `z` is the
 * result of inverse_kelvin(). */
static float saturation_at_1_atm(float z)
{
    return f_exp(2.11184299f +
                 z * (1.63790983f + z * (0.53350163f + z * (0.870736542f - z * 0.8621949f))));
}

/* Returns the pressure of water vapour, atm: exp(11.8571 - 3840.70 / T - 216961 / T^2). `z` is the
 * result of inverse_kelvin(). */
static float vapour_atm(float z)
{
    return f_exp(-3.46535769f - z * (5.29608152f + z * 0.216961f));
}

float oxygen_saturation_mg_l(float temperature_c, float pressure_hpa)
{
    const float z = inverse_kelvin(temperature_c);
    const float p = pressure_hpa / HPA_PER_ATM;
    const float u = vapour_atm(z);
    const float theta = 0.000975f - temperature_c * (1.426e-5f - temperature_c * 6.436e-8f);
    return saturation_at_1_atm(z) * ((p - u) * (1.0f - theta * p)) / ((1.0f - u) * (1.0f - theta));
}

/* Routine oxygen rate of young Carassius auratus grandoculis from 15 to 30 C (Yamanaka): 0.0674
 * W^-0.193 e^(0.0562 T) mg per g and hour, with W in g. The rate grows by a factor of 1.75 per 10 K
 * (Q10). */
float oxygen_breath_mg_h(float mass_kg, float temperature_c, float speed_m_s)
{
    const float mass_g = 1000.0f * mass_kg;
    const float routine = 0.0674f * f_exp(0.807f * f_log(mass_g) + 0.0562f * temperature_c);
    return routine + COST_MG_KG_M * mass_kg * 3600.0f * speed_m_s;
}

/* Critical concentration after Yamanaka: 1.35 W^-0.107 mg/L with W in g, at any temperature. */
float oxygen_critical_mg_l(float mass_kg)
{
    return 1.35f * f_exp(-0.107f * f_log(1000.0f * mass_kg));
}

float oxygen_exchange_per_h(float water_depth_m, int pump)
{
    return STILL_M_H / water_depth_m + (pump ? PUMP_PER_H : 0.0f);
}

/* Advances the balance by one step. During the step, respiration removes a constant share of the
 * dissolved oxygen. The balance is then a linear equation, which the step solves exactly and
 * stably. The form of 1 - exp(-x) avoids cancellation, with an error of 1e-6 for x below 0.2. */
static float relax_oxygen(float dissolved_mg_l, const struct oxygen_balance *balance, float hours)
{
    const float share_per_h =
        balance->breath_mg_l_h / f_max(dissolved_mg_l, balance->critical_mg_l);
    const float rate_per_h = balance->exchange_per_h + share_per_h;
    const float x = rate_per_h * hours;
    const float approached = x / (1.0f + x * (0.5f + x * (1.0f / 12.0f)));
    if (approached <= 0.0f) {
        return dissolved_mg_l;
    }
    const float end_mg_l = balance->exchange_per_h * balance->saturation_mg_l / rate_per_h;
    return dissolved_mg_l + (end_mg_l - dissolved_mg_l) * f_min(approached, 1.0f);
}

float oxygen_after(float dissolved_mg_l, const struct oxygen_balance *balance, float hours)
{
    const uint32_t steps = (uint32_t)(hours / STEP_H) + 1u;
    for (uint32_t i = 0; i < steps; i++) {
        dissolved_mg_l = relax_oxygen(dissolved_mg_l, balance, hours / (float)steps);
    }
    return dissolved_mg_l;
}

static void request_breath(struct oxygen *oxygen, const struct fish *fish)
{
    if (fish_swims(fish) && !surface_breathes(fish)) {
        const float mass_kg = fish_mass_kg(fish->length_m);
        const float breath_mg_h =
            oxygen_breath_mg_h(mass_kg, oxygen->temperature_c, fish->speed_m_s);
        oxygen->breath_mg_h += breath_mg_h;
        oxygen->critical_mg += breath_mg_h * oxygen_critical_mg_l(mass_kg);
    }
}

static void second(struct oxygen *oxygen, vec3 size_m)
{
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

void oxygen_tick(struct oxygen *oxygen, const struct fish *fish, uint32_t fish_count, vec3 size_m,
                 uint32_t tick)
{
    const uint32_t share = tick % CORE_TICK_HZ;
    const uint32_t first = (uint32_t)((uint64_t)fish_count * share / CORE_TICK_HZ);
    const uint32_t end = (uint32_t)((uint64_t)fish_count * (share + 1u) / CORE_TICK_HZ);
    for (uint32_t i = first; i < end; i++) {
        request_breath(oxygen, &fish[i]);
    }
    if (share == CORE_TICK_HZ - 1u) {
        second(oxygen, size_m);
    }
}

uint64_t oxygen_hash(uint64_t hash, const struct oxygen *oxygen)
{
    const float values[] = {
        oxygen->dissolved_mg_l,   oxygen->temperature_c, oxygen->pressure_hpa,
        oxygen->time_compression, oxygen->breath_mg_h,   oxygen->critical_mg,
    };
    hash = hash_floats(hash, values, sizeof values / sizeof values[0]);
    return hash_u32(hash, oxygen->pump);
}
