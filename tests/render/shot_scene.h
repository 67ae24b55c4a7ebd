/* shot_scene.h -- plays the stall as the options want it, and gives what is to be seen then. */
#ifndef KINGYO_TESTS_RENDER_SHOT_SCENE_H
#define KINGYO_TESTS_RENDER_SHOT_SCENE_H

#include "core/scene.h"
#include "tests/render/shot_options.h"

/* `scene` begins zeroed. Ends the program with 2 where the stall cannot be as it is wanted. */
void shot_scene(const struct shot_options *options, struct scene *scene);

#endif
