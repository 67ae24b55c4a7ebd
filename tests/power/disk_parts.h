/* disk_parts.h -- internal functions that disk.c and disk_cut.c share. */
#ifndef KINGYO_TESTS_POWER_DISK_PARTS_H
#define KINGYO_TESTS_POWER_DISK_PARTS_H

#include <stdbool.h>

#include "tests/power/disk.h"

/* Ends the program if `got` is null, which means that an allocation failed. */
void disk_need(const void *got);

/* Extends the file to at least `size` bytes. The new bytes are zeros. */
void disk_grow(struct disk_file *file, size_t size);

/* Returns 1 if the operation creates, renames or deletes a file. */
bool disk_is_of_names(const struct tape_op *op);
/* Changes the durable names as `op` requires. `op` must create, rename or delete a file. */
void disk_apply_names(struct disk *disk, const struct tape_op *op);

/* Returns 1 if the operation writes or truncates a file. */
bool disk_is_of_bytes(const struct tape_op *op);
/* Changes the bytes of `file` as `op` requires. `op` must be a write or a truncation. */
void disk_apply_bytes(const struct tape *tape, const struct tape_op *op, struct disk_file *file);

#endif
