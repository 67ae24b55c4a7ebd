/* import_flat.h -- converts a scene of nodes, meshes and morph targets to one mesh with several key
 * shapes. */
#ifndef KINGYO_PLATFORM_CTL_IMPORT_IMPORT_FLAT_H
#define KINGYO_PLATFORM_CTL_IMPORT_IMPORT_FLAT_H

#include "platform/ctl/import/import_mesh.h"

/* Returns whether scenes can be read in this build. If not, `why` names what is missing. */
bool import_can_flatten(char why[IMPORT_WHY_SIZE]);

/* Reads the scene at `path` into `mesh`. Returns false with `why`, without the file name, if the
 * scene cannot be used.
 *
 * Call this function only in a child process, because a hostile file may crash the importer. The
 * caller must validate `mesh` with import_validate(). */
bool import_flatten(const char *path, struct import_mesh *mesh, char why[IMPORT_WHY_SIZE]);

/* Checks a received mesh against every bound of import_mesh.h. Returns null, or the error text. The
 * text may be stored in `room`. */
const char *import_validate(const struct import_mesh *mesh, char room[IMPORT_WHY_SIZE / 2]);

#endif
