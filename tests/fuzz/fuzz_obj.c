/* fuzz_obj.c -- fuzz target: arbitrary text as an OBJ file. An accepted mesh becomes a species:
 * every key shape gets the mesh itself, and the last key shape gets the mesh slightly stretched. */
#include <unistd.h>

#include "platform/ctl/import/refit.h"
#include "tests/fuzz/meshes.h"

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    static struct import_mesh mesh;
    char why[IMPORT_WHY_SIZE];
    const char *path = file_of(bytes, size, ".obj");
    enum exit_code code = EXIT_OK;
    for (uint32_t key = 0; key < 3 && code == EXIT_OK; key++) {
        code = import_obj(&mesh, key, path, why);
    }
    for (uint32_t i = 0; code == EXIT_OK && i < mesh.vertex_count; i++) {
        mesh.positions[2][i] = v3_scale(mesh.positions[2][i], 1.5f);
    }
    if (code == EXIT_OK) {
        make_species(&mesh);
    }
    unlink(path);
    return 0;
}
