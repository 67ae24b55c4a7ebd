/* textures.h -- uploads the OpenGL textures of the pictures that the build generates. Each texture
 * is uploaded once. */
#pragma once

#include "core/morph/species.h"
#include "platform/render/gl_util.h"

/* Varieties of the goldfish. The simulation has only the wakin. A variety has the keys, lengths and
 * growth of the wakin and a mesh of the same topology, so that only its shape differs. */
extern const struct species species_demekin, species_ryukin;

struct textures {
    /* Array texture of the light pattern (caustics) on the floor. The layers are the frames of one
     * animation loop. */
    GLuint caustics;
    /* Array texture of the goldfish patterns: the red patches and the scales. */
    GLuint patterns;
    GLuint environment; /* Environment map that the water reflects. */
    GLuint backdrop; /* Array texture of the street behind the stall: layer 0 by night, 1 by day. */
    GLuint wood;
    GLuint paper;
};

void textures_open(struct gl_status *status, struct textures *textures);
/* Returns the number of the layer of the texture `patterns` for a fish with the appearance number
 * `look` (see struct scene_fish). */
float textures_pattern(uint32_t look);
/* Returns the hue of a fish with the appearance number `look` (see struct scene_fish): [0, 1] from
 * deep red to pale gold, and above 1, up to 2, for a black fish. */
float textures_hue(uint32_t look);

/* Returns the variety of a fish with the appearance number `look` (see struct scene_fish). The
 * black fish are demekin, one fish of 32 is a ryukin with patches, and all others are wakin. */
const struct species *textures_variety(uint32_t look);

void textures_close(struct textures *textures);
