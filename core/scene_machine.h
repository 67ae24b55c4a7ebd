/* scene_machine.h -- the state of the computer for the operator's pages. The shell fills it in
 * (platform/system_health.h); the core's state does not contain it. */
#ifndef KINGYO_CORE_SCENE_MACHINE_H
#define KINGYO_CORE_SCENE_MACHINE_H

#include <stdint.h>

/* Whether data written to the data folder survives a power cut. */
enum scene_keeps {
    KEEPS_UNKNOWN = 0, /* Not yet checked. */
    KEEPS_PROVEN,      /* board/kiosk/check-data has read test data back after a power cut. */
    KEEPS_FOLDER,      /* The data folder is on a disk of this machine, but was never tested. */
    KEEPS_MEMORY,      /* The data folder is in RAM, so data does not survive. */
    KEEPS_NOT,         /* check-data found that data does not survive. */
    KEEPS_NOWHERE,     /* No data folder exists. */
};

/* Whether a watchdog restarts the kiosk when frames stop. */
enum scene_watch {
    WATCH_NONE = 0,
    WATCH_NO_LIMIT, /* A service manager is connected, but has no timeout. */
    WATCH_FED,
    WATCH_DEAF, /* The last keep-alive message was not accepted. */
};

/* All zero: the machine was not checked yet. */
struct scene_machine {
    uint8_t has_looked;
    uint8_t keeps; /* enum scene_keeps */
    uint8_t watch; /* enum scene_watch; valid even if `has_looked` is 0. */
    uint8_t has_backup, has_heat;
    uint8_t is_clock_back; /* 1: the clock is behind a time stamp written before this start. */
    uint32_t backup_min;   /* Minutes since the last good backup, if `has_backup`. */
    uint32_t room_mib;     /* Space available to Kingyo in the data folder, in MiB. */
    int32_t heat_margin_c; /* Degrees Celsius left to the throttling temperature, if `has_heat`. */
    uint32_t aside;        /* Quarantined databases that the operator has not acknowledged. */
    uint32_t panics;       /* Programs ended by a panic, since the count began. */
    uint8_t left_out;      /* Data left out because of panics since power-on: 0 nothing, 1
                              settings, 2 also replays, 3 also names. */
    uint32_t missed;       /* Ranked rounds since the start whose replay could not be saved. */
};

#endif
