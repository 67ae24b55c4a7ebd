/* fuzz_pack.c -- fuzz target: arbitrary bytes as a packed species file. Each input is used twice:
 * unchanged, and with a corrected header, so that the body passes the CRC check and is parsed. */
#include "platform/species/pack.c"

#include "tests/fuzz/exercise.h"

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size);

static void try(const uint8_t *bytes, size_t size)
{
    static struct species_slot slot;
    static uint8_t again[PACK_SIZE_MAX];
    char why[VALIDATE_WHY_SIZE];
    if (pack_decode(bytes, size, &slot, why) == PACK_OK) {
        exercise(&slot.species);
        if (pack_encode(&slot, again) != size || memcmp(bytes, again, size) != 0) {
            /* An accepted species must have the same bytes after it is packed again. */
            __builtin_trap();
        }
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    static uint8_t mended[PACK_SIZE_MAX];
    try(bytes, size);
    if (size >= HEAD_SIZE && size <= PACK_SIZE_MAX) {
        const uint32_t body = (uint32_t)(size - HEAD_SIZE);
        memcpy(mended, bytes, size);
        const uint32_t head[3] = { PACK_VERSION, body, crc32(mended + HEAD_SIZE, body) };
        memcpy(mended, magic, sizeof magic);
        memcpy(mended + sizeof magic, head, sizeof head);
        try(mended, size);
    }
    return 0;
}
