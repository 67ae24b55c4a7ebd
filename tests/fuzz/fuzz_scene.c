/* fuzz_scene.c -- fuzz target: arbitrary bytes as a glTF file. The library assimp reads the file.
 * The scene is then flattened to one mesh, checked against the mesh limits, and converted to a
 * species. Unlike kingyoctl, which imports in a child process, this target imports in its own
 * process, so that the fuzzer measures the coverage. */
#include <string.h>
#include <unistd.h>

#include "platform/ctl/import/import.h"
#include "tests/fuzz/meshes.h"

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    static struct import_mesh mesh;
    char why[IMPORT_WHY_SIZE], room[IMPORT_WHY_SIZE / 2];
    const char *path = file_of(bytes, size, ".glb");
    memset(&mesh, 0, offsetof(struct import_mesh, positions));
    mesh.time_count = mesh.is_ours = mesh.has_life = mesh.has_uv = mesh.has_colours = 0;
    if (import_flatten(path, &mesh, why) && !import_validate(&mesh, room)) {
        make_species(&mesh);
    }
    unlink(path);
    return 0;
}
