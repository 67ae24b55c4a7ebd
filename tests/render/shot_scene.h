/* shot_scene.h -- plays the game as the options require, and returns the scene of the last
 * frame. */
#ifndef KINGYO_TESTS_RENDER_SHOT_SCENE_H
#define KINGYO_TESTS_RENDER_SHOT_SCENE_H

#include "core/scene.h"
#include "tests/render/shot_options.h"

/* Plays the game and fills `scene`, which the caller must set to zero before. Ends the program with
 * exit status 2 if the options cannot be met. */
void shot_scene(const struct shot_options *options, struct scene *scene);

/* Moves the camera of `scene` from its place of rest to its place after the first frame. */
void shot_move_camera(const struct shot_options *options, struct scene *scene);

#endif
