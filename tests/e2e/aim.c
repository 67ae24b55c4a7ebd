/* aim.c -- where on the screen a place of the tank is, for a test that has to point at it.
 *
 * aim WIDTHxHEIGHT place|bowl [X Y Z]  prints `x y` in pixels; the camera is the festival preset's. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/panic.h"
#include "core/tank/preset.h"

_Noreturn void core_panic(const char *condition, const char *file, int line)
{
    fprintf(stderr, "%s:%d: %s\n", file, line, condition);
    exit(70);
}

int main(int argc, char **argv)
{
    float width, height;
    if (argc < 3 || sscanf(argv[1], "%fx%f", &width, &height) != 2 || (argc != 3 && argc != 6)) {
        fprintf(stderr, "usage: aim WIDTHxHEIGHT place X Y Z | aim WIDTHxHEIGHT bowl\n");
        return 2;
    }
    const struct tank_preset *preset = tank_preset(TANK_PRESET_FESTIVAL);
    vec3 place_m = preset->bowl_m;
    if (argc == 6) {
        place_m = v3(strtof(argv[3], NULL), strtof(argv[4], NULL), strtof(argv[5], NULL));
    }
    const struct basis axes = view_basis(&preset->view);
    const float tan_y = view_half_height_tan(&preset->view, width / height);
    const vec3 seen = basis_to_body(&axes, v3_sub(place_m, preset->view.eye_m));
    const float x = seen.x / (-seen.z * tan_y * width / height);
    const float y = seen.y / (-seen.z * tan_y);
    printf("%.0f %.0f\n", (double)(0.5f * (1.0f + x) * width), (double)(0.5f * (1.0f - y) * height));
    return 0;
}
