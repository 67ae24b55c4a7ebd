/* import_scene.c -- glTF and its kin, through assimp where this machine has it. */
#include <stdio.h>

#include "platform/ctl/import_mesh.h"

bool import_knows_scenes(void)
{
    return false;
}

enum exit_code import_scene(struct import_mesh *mesh, const char *path, char why[IMPORT_WHY_SIZE])
{
    (void)mesh;
    snprintf(why, IMPORT_WHY_SIZE, "%.80s: this kingyoctl was built without assimp", path);
    return EXIT_NOT_SO;
}
