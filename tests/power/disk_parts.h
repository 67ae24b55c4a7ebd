/* disk_parts.h -- what going through a tape and cutting it share. Within tests/power. */
#ifndef KINGYO_TESTS_POWER_DISK_PARTS_H
#define KINGYO_TESTS_POWER_DISK_PARTS_H

#include "tests/power/disk.h"

/* Ends the program where memory is at its end. */
void disk_need(const void *got);

/* At least so long; what is new is zeros. */
void disk_grow(struct disk_file *file, size_t size);

int disk_is_of_names(const struct tape_op *op);
void disk_apply_names(struct disk *disk, const struct tape_op *op);

int disk_is_of_bytes(const struct tape_op *op);
void disk_apply_bytes(const struct tape *tape, const struct tape_op *op,
                      struct disk_file *file);

#endif
