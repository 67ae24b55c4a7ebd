/* import_flat.h -- a scene of nodes, meshes and morph targets as one mesh of several shapes. */
#ifndef KINGYO_PLATFORM_CTL_IMPORT_FLAT_H
#define KINGYO_PLATFORM_CTL_IMPORT_FLAT_H

#include "platform/ctl/import_mesh.h"

/* Can scenes be read here? Else `why` says what is missing. */
bool import_can_flatten(char why[IMPORT_WHY_SIZE]);

/* Reads `path` into `mesh`; `why` is without the file's name. It trusts the file and the importer
 * as far as a child process may: call it in one, and vet what comes back. */
bool import_flatten(const char *path, struct import_mesh *mesh, char why[IMPORT_WHY_SIZE]);

/* Holds what came back to every bound of import_mesh.h. Null, or what is wrong with it, which may
 * be in `room`. */
const char *import_vet(const struct import_mesh *mesh, char room[IMPORT_WHY_SIZE / 2]);

#endif
