/* meshes.c -- implementation of meshes.h: creates files in memory, and makes species from
 * meshes. */
#include "tests/fuzz/meshes.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "platform/ctl/import/import.h"
#include "tests/fuzz/exercise.h"

/* Creates a file in /dev/shm (memory). The importer needs a file with the right suffix, because it
 * selects the format by the suffix. */
const char *file_of(const uint8_t *bytes, size_t size, const char *suffix)
{
    static char path[64];
    snprintf(path, sizeof path, "/dev/shm/kingyo-fuzz-%d%s", (int)getpid(), suffix);
    FILE *file = fopen(path, "wb");
    if (!file || fwrite(bytes, 1, size, file) != size || fclose(file) != 0) {
        abort();
    }
    return path;
}

void make_species(struct import_mesh *mesh)
{
    static struct species_slot slot;
    static struct import_report report;
    const struct import_options plan = {
        .id = "fuzz", .front = AXIS_NONE, .up = AXIS_Y, .unit_m = 1.0, .motion = 255, .form = 255
    };
    char why[IMPORT_WHY_SIZE], fault[VALIDATE_WHY_SIZE];
    memset(&slot.species, 0, sizeof slot.species);
    if (mesh->key_count >= 3 && import_orient(mesh, &plan, &report, why) &&
        import_build(mesh, &slot, &report, why) && import_life(mesh, &plan, &slot, &report, why)) {
        slot.tables[1] = slot.tables[0];
        slot.species.lod[1] = slot.species.lod[0];
        if (species_validate(&slot.species, fault)) {
            exercise(&slot.species);
        }
    }
}
