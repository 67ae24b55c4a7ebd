/* meshes.h -- shared functions of the mesh fuzz targets: write the input to a file, and make a
 * species from a mesh. */
#ifndef KINGYO_TESTS_FUZZ_MESHES_H
#define KINGYO_TESTS_FUZZ_MESHES_H

#include <stddef.h>

#include "platform/ctl/import/import.h"

/* Writes the bytes into a file in memory. Returns the path of the file, which stays valid until the
 * next call. */
const char *file_of(const uint8_t *bytes, size_t size, const char *suffix);

/* Makes a species from `mesh` as the importer does: orients the mesh, builds and names the species,
 * validates it and runs its growth. */
void make_species(struct import_mesh *mesh);

#endif
