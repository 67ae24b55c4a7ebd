/* scene_machine.h -- the state of the computer for the operator's pages. The shell fills in struct
 * scene_machine (platform/system_health.h). The core's state does not contain it. */
#ifndef KINGYO_CORE_SCENE_MACHINE_H
#define KINGYO_CORE_SCENE_MACHINE_H

#include <stdint.h>

/* Result of the check whether data written to the data folder survives a power cut. */
enum scene_keeps {
    KEEPS_UNKNOWN = 0, /* The data folder was not checked yet. */
    KEEPS_PROVEN,      /* The script board/kiosk/check-data has read test data back after a power
                          cut. */
    KEEPS_FOLDER,      /* The data folder is on a disk of this machine, but no power cut was
                          tested. */
    KEEPS_MEMORY,      /* The data folder is in RAM, so data does not survive. */
    KEEPS_NOT,         /* The script board/kiosk/check-data found that data does not survive a power
                          cut. */
    KEEPS_NOWHERE,     /* No data folder exists. */
};

/* State of the watchdog, which restarts the kiosk when frames stop. */
enum scene_watch {
    WATCH_NONE = 0,
    WATCH_NO_LIMIT, /* A service manager is connected, but has no watchdog timeout. */
    WATCH_FED,
    WATCH_DEAF, /* The service manager did not accept the last keep-alive message. */
};

/* State of the computer. All fields are 0 if the machine was not checked yet. */
struct scene_machine {
    uint8_t has_looked;
    uint8_t keeps; /* Result of the data check (enum scene_keeps). */
    uint8_t watch; /* State of the watchdog (enum scene_watch); valid even if `has_looked` is 0. */
    uint8_t has_backup, has_heat;
    uint8_t is_clock_back; /* 1 if the clock is behind a time stamp written before this start,
                              otherwise 0. */
    uint32_t backup_min;   /* Minutes since the last good backup; valid if `has_backup` is 1. */
    uint32_t room_mib;     /* Space available to Kingyo in the data folder, in MiB. */
    int32_t heat_margin_c; /* Degrees Celsius below the throttling temperature; valid if `has_heat`
                              is 1. */
    uint32_t aside;        /* Number of quarantined databases that the operator has not
                              acknowledged. */
    uint32_t panics;       /* Number of programs that ended by a panic since the panic count was
                              reset. */
    uint8_t left_out;      /* Data that the kiosk does not load because of panics since power-on: 0
                              none, 1 settings, 2 settings and replays, 3 settings, replays and
                              names. */
    uint32_t missed;       /* Number of ranked rounds since the start whose replay could not be
                              saved. */
};

#endif
