/* species.c -- the tool `bake_species IN.txt OUT.c`, which converts a species text to the core's
 * constant tables.
 *
 * Exit status: 0 for success, 2 for wrong usage, 65 for an invalid species text, 74 for a file
 * error. */
#include "assets/bake/species_write.h"
#include "core/base/panic.h"
#include "platform/os/exit_code.h"
#include "platform/species/drawing.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

static int complain(const char *path)
{
    fprintf(stderr, "%s: %s\n", path, strerror(errno));
    return EXIT_IO;
}

_Noreturn void core_panic(const char *condition, const char *file, int line)
{
    fprintf(stderr, "%s:%d: %s\n", file, line, condition);
    abort();
}

static int bake(const struct species_text *text, const char *path)
{
    static struct species species;
    static struct loft loft;
    static struct mesh_tables tables[SPECIES_LOD_COUNT];
    species_compile(text, &species);
    for (uint32_t lod = 0; lod < SPECIES_LOD_COUNT; lod++) {
        species_loft(text, &species_detail[lod], &loft);
        species_pack(&loft, text->key_count, &tables[lod], &species.lod[lod]);
    }
    FILE *file = fopen(path, "w");
    if (!file) {
        return complain(path);
    }
    const bool whole = species_write(file, &species);
    if (fclose(file) != 0 || !whole) {
        return complain(path);
    }
    return 0;
}

int main(int argc, char **argv)
{
    static struct species_text species;
    if (argc != 3) {
        fprintf(stderr, "usage: %s SPECIES.txt OUT.c\n", argv[0]);
        return EXIT_USAGE;
    }
    FILE *file = fopen(argv[1], "r");
    if (!file) {
        return complain(argv[1]);
    }
    const bool good = species_read(file, argv[1], stderr, &species);
    fclose(file);
    return good ? bake(&species, argv[2]) : EXIT_BAD_DATA;
}
