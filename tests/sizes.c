/* sizes.c -- prints the sizes of the large structs for reviews (`make sizes`). */
#include <stdio.h>

#include "core/core.h"
#include "core/morph/species.h"
#include "core/sound/mixer.h"

#define ROW(type, count_max) printf("  %-24s %9zu  %s\n", #type, sizeof(struct type), count_max)

int main(void)
{
    puts("struct                        bytes  how many");
    ROW(core, "1: the whole state of the core");
    ROW(tank, "1");
    ROW(fish, "TANK_FISH_MAX, in the tank");
    ROW(spatial_grid, "1, in the tank");
    ROW(water, "1, in the tank");
    ROW(poi, "POI_MAX");
    ROW(sheet, "POI_MAX, in the poi");
    ROW(bowl, "POI_MAX");
    ROW(game, "1");
    ROW(scene, "1 a frame being shown");
    ROW(scene_fish, "SCENE_FISH_MAX, in the scene");
    ROW(input, "1 a tick");
    ROW(output, "1");
    ROW(mixer, "1, on the audio thread");
    return 0;
}
