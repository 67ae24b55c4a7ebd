/* video.c -- draws a replay frame by frame, mixes its sound and passes both to ffmpeg; see
 * video.h. */
#include "platform/kiosk/video.h"

#include <errno.h>
#include <fcntl.h>
#include <spawn.h>
#include <stdio.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/base/panic.h"
#include "core/sound/mixer.h"
#include "core/tank/preset.h"
#include "platform/board.h"
#include "platform/os/clock.h"
#include "platform/os/file.h"
#include "platform/os/log.h"
#include "platform/os/png.h"
#include "platform/os/print.h"

#define RATE_HZ                                                                                    \
    60u /* Pictures per second. frame_pacer_ticks_due() then runs two ticks a picture. */
#define SOUND_PER_PICTURE (SOUND_RATE_HZ / RATE_HZ)
#define PROGRESS_PICTURES 30u      /* Pictures between two updates of the progress. */
#define NEVER_NS (UINT64_MAX / 2u) /* START is pressed only by the recording. */
#define PATH_SIZE (OPTIONS_PATH_MAX + 32u)
#define REASON_SIZE 256u

struct video {
    struct run_common *session;
    struct mixer mixer;
    uint32_t width, height; /* Size of the pictures in pixels. */
    uint32_t count;         /* Number of complete pictures. */
    pid_t encoder;          /* Process id of ffmpeg's first run. 0 if ffmpeg cannot be started. */
    int pictures_fd;        /* Pipe for raw pictures to the encoder. */
    int encoded_fd;         /* Temporary file without a name: the encoded pictures, in NUT. */
    FILE *sound;            /* WAV file. The file has no name if ffmpeg is used. */
    FILE *errors;           /* File in memory: messages of ffmpeg. */
    char part[PATH_SIZE];   /* Path of the unfinished video. */
    char folder[PATH_SIZE]; /* Folder for pictures and sound if ffmpeg cannot be started. */
};

/* Reports that `path` cannot be written. Returns EXIT_IO. */
static enum exit_code report_unwritten(const char *path, int error)
{
    return log_fail(EXIT_IO, LOG_LEVEL_ERROR, "%s: cannot write: %s", path, file_error(error));
}

/* ---- Sound --------------------------------------------------------------------------------- */

static int recorder_audio_open(void *self)
{
    (void)self;
    return HAL_OK;
}

static int recorder_audio_play(void *self, const struct sound_event *event)
{
    mixer_play(self, event);
    return HAL_OK;
}

static void recorder_audio_set_levels(void *self, const struct sound_levels *levels)
{
    mixer_set_levels(self, levels);
}

static const char *recorder_audio_describe(void *self)
{
    (void)self;
    return "sound of a video";
}

static void recorder_audio_close(void *self)
{
    (void)self;
}

static const struct hal_audio_ops recorder_audio_ops = {
    .open = recorder_audio_open,
    .play = recorder_audio_play,
    .set_levels = recorder_audio_set_levels,
    .describe = recorder_audio_describe,
    .close = recorder_audio_close,
};

/* Writes the header of a WAV file for the sound of `pictures` pictures at the present position. The
 * file then reports a failed write when the file is flushed. */
static void write_wav_header(FILE *file, uint32_t pictures)
{
    const uint32_t size = 4u * SOUND_PER_PICTURE * pictures;
    const uint32_t header[11] = { 0x46464952u, size + 36u,  0x45564157u,   0x20746d66u,
                                  16u,         0x00020001u, SOUND_RATE_HZ, 4u * SOUND_RATE_HZ,
                                  0x00100004u, 0x61746164u, size };
    fwrite(header, sizeof header, 1, file);
}

static void write_sound(struct video *video)
{
    int16_t stereo[2u * SOUND_PER_PICTURE];
    mixer_render(&video->mixer, stereo, SOUND_PER_PICTURE);
    fwrite(stereo, sizeof stereo, 1, video->sound);
}

/* Completes the header of the WAV file. Returns 0, an errno, or EIO if an earlier write failed. */
static int finish_sound(struct video *video)
{
    if (ferror(video->sound) != 0) {
        return EIO;
    }
    if (fseek(video->sound, 0, SEEK_SET) != 0) {
        return errno;
    }
    write_wav_header(video->sound, video->count);
    return fflush(video->sound) == 0 ? 0 : errno;
}

/* ---- ffmpeg -------------------------------------------------------------------------------- */

/* Starts ffmpeg with the arguments `words` and four descriptors: `input` and `output` become its
 * standard streams, its messages go to video->errors, and descriptor 3 is the sound. ffmpeg gets a
 * process group of its own, so that Ctrl-C ends the replay, and ffmpeg completes the file. Returns
 * 0 or an errno. */
static int start_ffmpeg(const struct video *video, const char *const *words, int input, int output,
                        pid_t *process)
{
    posix_spawn_file_actions_t files;
    posix_spawnattr_t attributes;
    posix_spawn_file_actions_init(&files);
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
    posix_spawn_file_actions_adddup2(&files, input, STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&files, output, STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&files, fileno(video->errors), STDERR_FILENO);
    posix_spawn_file_actions_adddup2(&files, fileno(video->sound), 3);
    /* posix_spawnp() does not change the arguments, but the type of its parameter is older than
     * const. */
    const int error =
        posix_spawnp(process, words[0], &files, &attributes, (char *const *)words, environ);
    posix_spawn_file_actions_destroy(&files);
    posix_spawnattr_destroy(&attributes);
    return error;
}

/* Reports the first line that ffmpeg wrote. Returns EXIT_IO. */
static enum exit_code report_ffmpeg(struct video *video)
{
    char reason[REASON_SIZE] = "";
    if (fseek(video->errors, 0, SEEK_SET) == 0) {
        file_read_line(video->errors, reason, sizeof reason);
    }
    return log_fail(EXIT_IO, LOG_LEVEL_ERROR, "%s: ffmpeg failed: %s",
                    video->session->options.video, reason[0] ? reason : "no reason given");
}

/* Blocks until ffmpeg ends. Returns true if ffmpeg succeeded. */
static bool wait_for_ffmpeg(pid_t process)
{
    int status = -1;
    while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
    }
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

/* Starts the run of ffmpeg that encodes the pictures. Returns 0 or an errno. */
static int start_encoder(struct video *video)
{
    int ends[2];
    char size[32];
    snprintf(size, sizeof size, "%ux%u", video->width, video->height);
    /* The encoder needs even sides. NUT keeps the exact time of each picture, and needs no seeking
     * in the output. */
    const char *const words[] = {
        "ffmpeg",
        "-nostdin",
        "-loglevel",
        "error",
        "-xerror",
        "-f",
        "rawvideo",
        "-pixel_format",
        "rgb24",
        "-video_size",
        size,
        "-framerate",
        "60",
        "-i",
        "pipe:0",
        "-vf",
        "pad=ceil(iw/2)*2:ceil(ih/2)*2",
        "-c:v",
        "libx264",
        "-crf",
        "20",
        "-pix_fmt",
        "yuv420p",
        "-f",
        "nut",
        "pipe:1",
        NULL,
    };
    if (pipe2(ends, O_CLOEXEC) != 0) {
        return errno;
    }
    const int error = start_ffmpeg(video, words, ends[0], video->encoded_fd, &video->encoder);
    close(ends[0]);
    if (error) {
        close(ends[1]);
        video->encoder = 0;
        return error;
    }
    video->pictures_fd = ends[1];
    return 0;
}

/* Joins the encoded pictures and the sound to video->part, which then replaces the video. Returns
 * an exit code. */
static enum exit_code join_tracks(struct video *video)
{
    const char *path = video->session->options.video;
    const char *const words[] = {
        "ffmpeg",     "-nostdin", "-loglevel", "error",     "-xerror", "-y",   "-f",
        "nut",        "-i",       "pipe:0",    "-f",        "wav",     "-i",   "pipe:3",
        "-c:v",       "copy",     "-c:a",      "aac",       "-b:a",    "160k", "-movflags",
        "+faststart", "-f",       "mp4",       video->part, NULL,
    };
    pid_t process;
    /* The descriptors share their file offsets with ffmpeg, which reads from the first byte on. */
    if (lseek(video->encoded_fd, 0, SEEK_SET) != 0 ||
        lseek(fileno(video->sound), 0, SEEK_SET) != 0) {
        return report_unwritten(path, errno);
    }
    const int error =
        start_ffmpeg(video, words, video->encoded_fd, fileno(video->errors), &process);
    if (error) {
        return report_unwritten(path, error);
    }
    if (!wait_for_ffmpeg(process)) {
        return report_ffmpeg(video);
    }
    return rename(video->part, path) == 0 ? EXIT_OK : report_unwritten(path, errno);
}

/* ---- Files --------------------------------------------------------------------------------- */

/* Creates a file in the folder of the video and removes its name. The file disappears when the last
 * process closes the file. Returns the descriptor, or -1 and sets errno. */
static int open_nameless(const struct video *video)
{
    const int fd = file_handle(video->part, O_RDWR | O_CREAT | O_TRUNC, 0600);
    if (fd >= 0) {
        unlink(video->part);
    }
    return fd;
}

/* Opens the files that ffmpeg needs. Returns 0 or an errno. */
static int open_files(struct video *video)
{
    const int wrong = file_type_error(video->session->options.video);
    if (wrong) {
        return wrong;
    }
    video->encoded_fd = open_nameless(video);
    const int sound_fd = video->encoded_fd >= 0 ? open_nameless(video) : -1;
    /* The messages are in memory, because the reason may be a full disk. */
    const int errors_fd = sound_fd >= 0 ? memfd_create("ffmpeg", MFD_CLOEXEC) : -1;
    const int error = errors_fd >= 0 ? 0 : errno;
    video->sound = sound_fd >= 0 ? fdopen(sound_fd, "w+") : NULL;
    video->errors = errors_fd >= 0 ? fdopen(errors_fd, "w+") : NULL;
    return error ? error : video->sound && video->errors ? 0 : ENOMEM;
}

/* Opens the folder that is used in place of ffmpeg, and its WAV file. `reason` is the errno of the
 * start of ffmpeg. Returns an exit code. */
static enum exit_code open_folder(struct video *video, int reason)
{
    char path[PATH_SIZE + 16u];
    snprintf(video->folder, sizeof video->folder, "%s.frames", video->session->options.video);
    snprintf(path, sizeof path, "%s/sound.wav", video->folder);
    const enum exit_code code = run_common_make_folder(video->folder);
    if (code != EXIT_OK) {
        return code;
    }
    fclose(video->sound);
    const int fd = file_handle(path, O_WRONLY | O_CREAT | O_TRUNC, 0666);
    video->sound = fd >= 0 ? fdopen(fd, "w") : NULL;
    if (!video->sound) {
        return report_unwritten(path, errno);
    }
    log_print(LOG_LEVEL_WARNING, "ffmpeg: %s; pictures and sound are written to %s",
              strerror(reason), video->folder);
    return EXIT_OK;
}

/* Opens the output: ffmpeg, or the folder. Returns an exit code. */
static enum exit_code open_output(struct video *video)
{
    const char *path = video->session->options.video;
    snprintf(video->part, sizeof video->part, "%s.part", path);
    const int error = open_files(video);
    if (error) {
        return report_unwritten(path, error);
    }
    const int reason = start_encoder(video);
    const enum exit_code code = reason ? open_folder(video, reason) : EXIT_OK;
    if (code == EXIT_OK) {
        write_wav_header(video->sound, 0);
    }
    return code;
}

/* Completes the output if `code` is EXIT_OK. Otherwise removes the output. Closes all files.
 * Returns the first exit code that is not EXIT_OK. */
static enum exit_code close_output(struct video *video, enum exit_code code)
{
    char path[PATH_SIZE + 16u];
    snprintf(path, sizeof path, "%s/sound.wav", video->folder);
    const int error = code == EXIT_OK ? finish_sound(video) : 0;
    if (error) {
        code = report_unwritten(video->encoder ? video->session->options.video : path, error);
    }
    if (video->encoder) {
        close(video->pictures_fd);
        if (!wait_for_ffmpeg(video->encoder) && code == EXIT_OK) {
            code = report_ffmpeg(video);
        }
        code = code == EXIT_OK ? join_tracks(video) : code;
    }
    /* If no output was opened, neither a temporary file nor a folder exists. */
    if (code != EXIT_OK && (video->encoder || video->folder[0])) {
        unlink(video->encoder ? video->part : path);
    }
    if (video->encoded_fd >= 0) {
        close(video->encoded_fd);
    }
    if (video->sound) {
        fclose(video->sound);
    }
    if (video->errors) {
        fclose(video->errors);
    }
    return code;
}

/* ---- Frames -------------------------------------------------------------------------------- */

/* Passes the picture to ffmpeg, or writes the picture to the folder. Returns an exit code. */
static enum exit_code write_picture(struct video *video, const struct hal_image *image)
{
    char path[PATH_SIZE + 32u];
    if (video->encoder) {
        const size_t size = (size_t)image->width * image->height * 3;
        if (file_write(video->pictures_fd, image->rgb, size) == 0) {
            return EXIT_OK;
        }
        /* ffmpeg has ended, because the pipe has no reader. */
        wait_for_ffmpeg(video->encoder);
        return report_ffmpeg(video);
    }
    snprintf(path, sizeof path, "%s/frame-%06u.png", video->folder, video->count + 1u);
    const int error = png_write(path, image->rgb, image->width, image->height);
    return error ? report_unwritten(path, -error) : EXIT_OK;
}

/* Draws and writes the picture and the sound of the present frame. Returns an exit code. */
static enum exit_code write_frame(struct video *video)
{
    struct hal_image image;
    if (run_common_shot(video->session, NULL, &image)) {
        return EXIT_NOT_SO;
    }
    if (image.width != video->width || image.height != video->height) {
        return log_fail(EXIT_NOT_SO, LOG_LEVEL_ERROR, "the display has %ux%u pixels, not %ux%u",
                        image.width, image.height, video->width, video->height);
    }
    write_sound(video);
    return write_picture(video, &image);
}

static enum exit_code write_frames(struct video *video)
{
    struct run_common *session = video->session;
    const bool is_on_terminal = isatty(STDERR_FILENO);
    enum exit_code code = EXIT_OK;
    while (code == EXIT_OK && !*session->stop &&
           kiosk_frame(&session->kiosk, &session->hal) == KIOSK_RUNS) {
        code = write_frame(video);
        video->count += code == EXIT_OK;
        const uint64_t due_ns = video->count * NS_PER_S / RATE_HZ;
        board_rehearsal_advance(due_ns - hal_now_ns(session->hal.clock));
        if (is_on_terminal && video->count % PROGRESS_PICTURES == 0) {
            fprintf(stderr, "\rvideo: %.1f of %.1f s", (double)video->count / RATE_HZ,
                    (double)session->replayed.ticks / CORE_TICK_HZ);
        }
    }
    if (is_on_terminal && video->count >= PROGRESS_PICTURES) {
        fputc('\n', stderr);
    }
    if (session->kiosk.end == KIOSK_FLOAT) {
        return run_common_print_float();
    }
    return code;
}

enum exit_code video_run(struct run_common *session)
{
    /* The variable is static because the mixer is too large for the stack. */
    static struct video video;
    const struct options *options = &session->options;
    video = (struct video){
        .session = session,
        .width = options->width ? options->width : 1280u,
        .height = options->height ? options->height : 720u,
        .encoded_fd = -1,
    };
    const struct board_options board = {
        .width = video.width,
        .height = video.height,
        .on_demand = true,
        .view = tank_preset(options->tank)->view,
        .library = &session->library,
    };
    struct kiosk_config config = { .stopwatch = clock_device() };
    mixer_init(&video.mixer, 1);
    board_open_rehearsal(&session->hal, &board, NEVER_NS);
    session->hal.audio = (struct hal_audio){ .ops = &recorder_audio_ops, .self = &video.mixer };
    enum exit_code code = run_common_make_room(session, video.width, video.height);
    if (code == EXIT_OK) {
        code = run_common_begin(session, &config);
    }
    if (code == EXIT_OK) {
        code = open_output(&video);
        code = close_output(&video, code == EXIT_OK ? write_frames(&video) : code);
        const enum exit_code ended = run_common_end(session);
        code = code == EXIT_OK ? ended : code;
    }
    session->hal.display.ops->close(session->hal.display.self);
    if (code == EXIT_OK) {
        print_line(stdout, "wrote %u pictures of %ux%u (%.1f s) to %s", video.count, video.width,
                   video.height, (double)video.count / RATE_HZ,
                   video.encoder ? options->video : video.folder);
    }
    return code;
}
