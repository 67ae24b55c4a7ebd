/* fish_colours.h -- computes the colours of a goldfish in the tank. The vertex shader
 * fish.vert.glsl interpolates between these colours. specimen.frag.glsl computes the same colours
 * for a specimen on a page, and has the reasons for the formulas. */
#pragma once

/* Colours with the components red, green and blue, from 0 to about 1. */
struct fish_colours {
    float stained; /* Fraction by which the fins are stained. */
    float seed;    /* Random fraction [0, 1), different for each fish. */
    /* Colours of the skin where its pattern is white (`pale`) and where it is red (`stain`), at the
     * back and at the belly. */
    float pale_back[3], stain_back[3], pale_belly[3], stain_belly[3];
    /* Colours of a fin, and as a fourth value the phase of the stains in rad. */
    float pale_fin[4], stain_fin[3];
};

/* Computes the colour of a goldfish where its pattern is red. A `hue` in [0, 1] gives deep red over
 * vermilion and orange to a rare pale gold. A larger hue gives black. */
void fish_colours_red(float red[3], float hue);

/* Computes the colours of a fish. `maturity` is as in struct scene_fish. `hue` and `layer` are the
 * results of textures_hue() and textures_pattern(). */
void fish_colours_compute(struct fish_colours *colours, float maturity, float hue, float layer);

/* Multiplies all colours by the red, green and blue of `light`. Strong light is attenuated, so that
 * a fish below a bulb keeps its shading. */
void fish_colours_illuminate(struct fish_colours *colours, const float light[3]);
