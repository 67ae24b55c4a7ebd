/* exit_code.h -- exit codes of `kingyo`, `kingyoctl`, `kingyo-poi` and the tools of assets/bake. */
#pragma once

enum exit_code {
    EXIT_OK = 0,
    EXIT_NOT_SO = 1, /* A check failed, or the display was lost. */
    EXIT_USAGE = 2,
    EXIT_BAD_DATA = 65, /* Invalid input data; the value of EX_DATAERR in sysexits.h. */
    EXIT_IO = 74,       /* Failed input or output; the value of EX_IOERR in sysexits.h. */
};
