/* curves.c -- computes the data of figure 2.9 of the 2013 thesis with Kingyo's water model, as CSV
 * on standard output. The columns are the oxygen consumption of 100 g of goldfish and the oxygen
 * content of a litre of water, over the temperature. */
#include <stdio.h>

#include "core/tank/oxygen.h"

#define SHOAL_KG 0.100f
#define LENGTH_M 0.05f /* Assumed length of each fish. */

int main(void)
{
    const float fish_kg = fish_mass_kg(LENGTH_M);
    const float count = SHOAL_KG / fish_kg;
    puts("temperature_c,saturation_mg_l,saturation_900_hpa_mg_l,breath_mg_h,breath_one_fish_mg_h");
    for (int t = 0; t <= 40; t++) {
        const float temperature_c = (float)t;
        printf("%d,%.4f,%.4f,%.3f,%.3f\n", t,
               (double)oxygen_saturation_mg_l(temperature_c, OXYGEN_PRESSURE_HPA),
               (double)oxygen_saturation_mg_l(temperature_c, 900.0f),
               (double)(count * oxygen_breath_mg_h(fish_kg, temperature_c, 0.0f)),
               (double)oxygen_breath_mg_h(SHOAL_KG, temperature_c, 0.0f));
    }
    return 0;
}
