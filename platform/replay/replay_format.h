/* replay_format.h -- byte offsets within the parts of a recording, used by the writer and the
 * reader. */
#ifndef KINGYO_PLATFORM_REPLAY_REPLAY_FORMAT_H
#define KINGYO_PLATFORM_REPLAY_REPLAY_FORMAT_H

/* First bytes of a recording, which include control and non-ASCII characters. A text conversion
 * changes these bytes, so that the reader rejects the file. */
#define REPLAY_MAGIC "KGR\x1a\r\n\x89\n"
#define REPLAY_CHUNK_TAG "SECS"
#define REPLAY_END_TAG "ENDS"

enum {
    HEADER_VERSION = 8,
    HEADER_SIZE_FIELD = 10,
    HEADER_TICK_HZ = 12,
    HEADER_PROGRAM = 16,
    HEADER_DIGEST_TICKS = 32,
    HEADER_START = 36,
    HEADER_BOOK = 40,
    HEADER_SUM = 44,

    CHUNK_PAYLOAD_SIZE = 4,
    CHUNK_FIRST_TICK = 8,
    CHUNK_TICK_COUNT = 12,
    CHUNK_ROUNDS = 16,
    CHUNK_CAUGHT = 20,
    CHUNK_FOULS = 24,
    CHUNK_WHO = 28,
    CHUNK_HASH = 32,

    END_TICKS = 4,
    END_ROUNDS = 8,
    END_CAUGHT = 12,
    END_FOULS = 16,
    END_WHO = 20,
    END_HASH = 24,
    END_SUM = 32,
};

#endif
