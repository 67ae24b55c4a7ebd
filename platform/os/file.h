/* file.h -- opens, reads, replaces and locks files and folders. Regular files are opened without
 * blocking, because opening a FIFO or a device could block the caller forever. A file is replaced
 * atomically: a reader gets either the old content or the complete new content. Functions with an
 * int result return 0 or a positive value on success and a negative errno on an error, unless the
 * comment of a function says otherwise. */
#pragma once

#include <limits.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <sys/types.h>

/* ---- Regular files --------------------------------------------------------------------------- */

/* Maximum number of bytes to read from a file of the kernel in /proc or /sys. These files have at
 * most a few memory pages. */
#define FILE_KERNEL_SIZE_MAX (1u << 20)

/* Opens a file for reading. The path comes from the user, therefore symbolic links are followed.
 * The caller closes the returned stream, which does not support seeking. On an error returns null
 * and sets errno: EISDIR for a folder, ENOTSUP for a FIFO, a device or a socket, EFBIG for more
 * than `size_max` bytes. Some files in /proc return more bytes than their reported size. If one of
 * these files exceeds `size_max`, a read fails with EFBIG. */
FILE *file_open(const char *path, uint32_t size_max);

/* Opens a file in the data folder with the `flags` and `mode` of open(2). The function adds
 * O_NOFOLLOW, O_NONBLOCK, O_CLOEXEC and O_NOCTTY. O_TRUNC truncates regular files only. Returns the
 * descriptor. On an error returns -1 and sets errno: ELOOP for a symbolic link, EISDIR for a
 * folder, ENOTSUP for a FIFO, a device or a socket, otherwise as open(2) does. */
int file_handle(const char *path, int flags, mode_t mode);

/* Opens a file as file_handle() does, but `path` is relative to the folder with the descriptor
 * `folder` (openat(2)). */
int file_handle_at(int folder, const char *path, int flags, mode_t mode);

/* Opens a file as file_handle() does, but follows symbolic links, because the path comes from the
 * user. */
int file_user_handle(const char *path, int flags, mode_t mode);

/* Gives the regular file `path`, which is relative to the folder with the descriptor `folder`, to
 * the user `owner` and the group `group`, and sets its mode. The folder of the file may belong to
 * another user, who can replace the file at any time. Therefore only a file that belongs to the
 * calling user and has a single hard link is changed, and symbolic links are not followed. Returns
 * 0. On an error returns -1 and sets errno: EPERM for a file of another user or with several hard
 * links, otherwise as file_handle() does. */
int file_give_at(int folder, const char *path, uid_t owner, gid_t group, mode_t mode);

/* Returns the error with which file_handle() rejects `path`: ELOOP for a symbolic link, EISDIR for
 * a folder, and ENOTSUP for another file that is not regular. Returns 0 for a regular file, and for
 * a path that does not exist or cannot be examined. */
int file_type_error(const char *path);

/* Returns true if file_type_error() returns an error. */
bool file_is_other(const char *path);

/* Returns true if the file name `name` ends with `suffix`, for example ".obj". */
bool file_has_suffix(const char *name, const char *suffix);

/* Returns strerror(`error`), or a more specific text for ELOOP, ENOTSUP and EFBIG. */
const char *file_error(int error);

/* ---- Lines ----------------------------------------------------------------------------------- */

/* Result of file_read_line(). */
enum file_line {
    /* No line was read because of the end of the file or a read error (see ferror(3)). */
    FILE_LINE_END = 0,
    FILE_LINE_READ, /* `line` is a complete line. */
    /* The line is too long or contains a zero byte. `line` contains the start of the line, and the
     * rest of the line is skipped. */
    FILE_LINE_BAD,
};

/* Reads the next line of `file` into `line` without its line end. `size` is the size of the buffer,
 * at least 2. `line` is unchanged if the result is FILE_LINE_END. */
enum file_line file_read_line(FILE *file, char *line, size_t size);

/* Skips the byte-order mark (U+FEFF in UTF-8), which some editors write at the start of a file.
 * Returns the first character of `text` after the mark, or `text` if there is no mark. */
char *file_skip_mark(char *text);

/* Removes white space at both ends of `text`, in place. Returns the first remaining character. */
char *file_trim(char *text);

/* Removes the comment and the white space around a line of a configuration file, in place. A '#'
 * starts a comment only at the start of the line or after white space, because a path may contain
 * '#'. Returns the first remaining character. */
char *file_trim_comment(char *line);

/* Splits the text "KEY = VALUE" at `key` in place, at the first '='. Removes the white space behind
 * KEY. Returns VALUE without the white space around it, or null if the text has no '='. */
char *file_cut_value(char *key);

/* Reads the first line of the file `path`, which is usually a file of the kernel. Writes "" if the
 * file cannot be opened or is empty. A longer line is cut to `size` - 1 bytes. */
void file_first_line(const char *path, char *line, size_t size);

/* ---- Atomic replacement ---------------------------------------------------------------------- */

#define FILE_ATOMIC_PART ".part"

/* File that is written as a stream. The output goes to the temporary file PATH.part in the same
 * folder. When the file is closed, PATH.part replaces PATH. The content of PATH is therefore
 * complete even if the disk is full or the power fails. If PATH is a symbolic link, the link stays
 * and its target is replaced. A dangling link, a folder or a disk is rejected. A terminal,
 * /dev/null or a pipe with a reader is written directly. */
struct atomic_file {
    FILE *file;
    /* True for a terminal, a pipe or /dev/null, which are written without a temporary file. */
    bool is_stream;
    bool lasts;           /* True if file_atomic_close() blocks until the content is on disk. */
    char place[PATH_MAX]; /* Resolved path of the target. */
    char part[PATH_MAX];
};

/* Opens `path` for writing, with empty content. Returns 0 or a negative errno. */
int file_atomic_open(struct atomic_file *out, const char *path);

/* Opens `path` as file_atomic_open() does. file_atomic_close() then blocks until the content is on
 * disk. Returns -ENOTSUP if `path` exists and is not a regular file. */
int file_atomic_open_durable(struct atomic_file *out, const char *path);

/* Closes the file. Returns 0, or the negative errno of the first failed write. After an error the
 * temporary file is removed and the old file is unchanged. */
int file_atomic_close(struct atomic_file *out);

/* Flags of file_replace(). */
enum file_replace_flag {
    /* file_replace() blocks until the content and the name are on disk. */
    FILE_REPLACE_DURABLE = 1,
    FILE_REPLACE_PUBLIC = 2, /* All users can read the new file, independent of the umask. */
};

/* Replaces the file or symbolic link `path` by a regular file with `size` bytes of content. Writes
 * the temporary file PATH.part first. `flags` is a combination of enum file_replace_flag. Returns 0
 * or a negative errno. After an error the old file is unchanged. */
int file_replace(const char *path, const void *bytes, size_t size, int flags);

/* Renames a file, and blocks until the new name is on disk. Returns 0 or a negative errno. */
int file_rename_durable(const char *from, const char *to);

/* Renames a file, but never replaces an existing file. Returns 0 or a negative errno: -EEXIST if
 * `to` exists. The new name is not synced. */
int file_rename_new(const char *from, const char *to);

/* Syncs the folder that contains `path`. A new file name survives a power cut only after this sync.
 * Returns 0 or a negative errno. */
int file_sync_parent(const char *path);

/* Writes all `size` bytes to the descriptor `fd`. Retries after an interruption by a signal.
 * Returns 0 or a negative errno. Async-signal-safe. */
int file_write(int fd, const void *bytes, size_t size);

/* ---- Folders --------------------------------------------------------------------------------- */

#define FILE_FOLDER_MAX 1024u

/* Creates the folder `path` and its parents with mode 0755, and checks that files can be created in
 * `path`. Returns 0 or a negative errno: -ENAMETOOLONG if `path` has FILE_FOLDER_MAX bytes or
 * more, -ENOTDIR if `path` is not a folder. */
int file_make_folder(const char *path);

/* Locks the folder `path` for the calling process. Returns a descriptor. The lock lasts until the
 * caller closes the descriptor or the process ends. Returns -EWOULDBLOCK if another process holds
 * the lock, or another negative errno. */
int file_lock_folder(const char *path);

/* Writes the default path of the store, which is in the user's data folder. Writes "" if the user
 * has no data folder. */
void file_default_data(char out[FILE_FOLDER_MAX]);
