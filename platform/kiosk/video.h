/* video.h -- converts the recording of --replay to a video with sound (option --video).
 *
 * The replay runs without a screen on a simulated clock, at 60 pictures a second. The program
 * ffmpeg encodes the pictures and the sound. If ffmpeg cannot be started, one line reports the
 * reason, and the pictures (PNG) and the sound (WAV) are written to the folder FILE.frames. */
#pragma once

#include "platform/kiosk/run_common.h"

/* Writes the video to session->options.video. Returns an exit code: EXIT_IO if a file cannot be
 * written or ffmpeg fails, EXIT_NOT_SO if no picture could be drawn. Reports all errors before it
 * returns. After an error the unfinished video is removed, and an older file of the same name is
 * unchanged. SIGINT and SIGTERM end the video early. */
enum exit_code video_run(struct run_common *session);
