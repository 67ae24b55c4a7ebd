/* fuzz_scene.c -- a glTF file through assimp, in its child process, whose end is seen to here. */
#include <time.h>
#include <unistd.h>

#include "tests/fuzz/meshes.h"

#define PATIENCE_S 40 /* More than import_scene() ever waits. */

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    static struct import_mesh mesh;
    char why[IMPORT_WHY_SIZE];
    const char *path = file_of(bytes, size, ".glb");
    const time_t begin = time(NULL);
    if (import_scene(&mesh, path, why) == EXIT_OK) {
        make_species(&mesh);
    }
    if (time(NULL) - begin > PATIENCE_S) {
        __builtin_trap();
    }
    unlink(path);
    return 0;
}
