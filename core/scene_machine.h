/* scene_machine.h -- what the machine below the stall is like, on the operator's pages. The shell
 * looks (platform/machine.h); nothing of it is in the core's state. */
#ifndef KINGYO_CORE_SCENE_MACHINE_H
#define KINGYO_CORE_SCENE_MACHINE_H

#include <stdint.h>

/* Whether what is written to the data folder outlives the power. */
enum scene_keeps {
    KEEPS_UNKNOWN = 0, /* Nobody has looked yet. */
    KEEPS_PROVEN,      /* board/kiosk/check-data has seen it come back from the disk. */
    KEEPS_FOLDER,      /* A folder of this machine, which nobody has tried. */
    KEEPS_MEMORY,      /* It lies in memory: no. */
    KEEPS_NOT,         /* check-data says no. */
    KEEPS_NOWHERE,     /* There is no folder. */
};

/* Whether anybody restarts a stall whose frames stop. */
enum scene_watch {
    WATCH_NONE = 0,
    WATCH_NO_LIMIT, /* A service manager listens, and would wait for ever. */
    WATCH_FED,
    WATCH_DEAF,     /* It took no sign of life the last time. */
};

/* Zero: nobody has looked yet. */
struct scene_machine {
    uint8_t has_looked;
    uint8_t keeps;          /* enum scene_keeps */
    uint8_t watch;          /* enum scene_watch; known without a look. */
    uint8_t has_backup, has_heat;
    uint8_t is_clock_back;  /* Its clock is behind what it wrote before this start. */
    uint32_t backup_min;    /* Since the last good backup was made; where it has one. */
    uint32_t room_mib;      /* Free in the data folder, for us. */
    int32_t heat_margin_c;  /* To the heat at which it slows down; where it has a sensor. */
    uint32_t aside;         /* Databases that were set aside, and not acknowledged. */
    uint32_t panics;        /* Programs that ended by a panic, since they are counted. */
    uint8_t left_out;       /* What was left out because of them since the machine was switched on:
                               0 nothing, 1 settings, 2 replays too, 3 names too. */
    uint32_t missed;        /* Ranked rounds since the start whose replay could not be kept. */
};

#endif
