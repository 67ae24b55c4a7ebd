/* meshes.h -- what the fuzzers of meshes share: bytes as a file, and a species made of a mesh. */
#ifndef KINGYO_TESTS_FUZZ_MESHES_H
#define KINGYO_TESTS_FUZZ_MESHES_H

#include <stddef.h>

#include "platform/ctl/import_mesh.h"

/* Puts the bytes into a file of memory alone, whose path it answers; the next call ends it. */
const char *file_of(const uint8_t *bytes, size_t size, const char *suffix);

/* Turns, builds, names, vets and grows it. */
void make_species(struct import_mesh *mesh);

#endif
