/* import_flat.h -- converts a scene of nodes, meshes and morph targets to one mesh with several key
 * shapes.
 *
 * A key shape is the shape of the fish at one modelled growth stage. Scenes are read with the
 * library assimp. */
#ifndef KINGYO_PLATFORM_CTL_IMPORT_IMPORT_FLAT_H
#define KINGYO_PLATFORM_CTL_IMPORT_IMPORT_FLAT_H

#include "platform/ctl/import/import_mesh.h"

/* Returns true if this build can read scenes. Otherwise writes what is missing to `why` and returns
 * false. */
bool import_can_flatten(char why[IMPORT_WHY_SIZE]);

/* Reads the scene at `path` into `mesh`. Returns true. If the scene cannot be used, writes the
 * reason to `why`, without the file name, and returns false.
 *
 * Must be called only in a child process, because a hostile file may crash the importer. The caller
 * must validate `mesh` with import_validate(). */
bool import_flatten(const char *path, struct import_mesh *mesh, char why[IMPORT_WHY_SIZE]);

/* Checks a mesh that the child process wrote against every limit of import_mesh.h. Returns null if
 * the mesh is valid. Otherwise returns the error text, which is static or stored in `room`. */
const char *import_validate(const struct import_mesh *mesh, char room[IMPORT_WHY_SIZE / 2]);

#endif
