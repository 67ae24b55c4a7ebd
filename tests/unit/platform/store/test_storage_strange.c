/* test_storage_strange.c -- Tests a data folder in which FIFOs, links, devices, sockets or folders
 * are in the place of regular files. Also tests a log of 1 GiB.
 *
 * A start must not block, must not write through such an object, and must report each object in one
 * line. */
#include <errno.h>
#include <fcntl.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <cmocka.h>

#include "drivers/hid/hid_mapping_store.h"
#include "drivers/usb/usb_choice.h"
#include "platform/os/file.h"
#include "platform/store/graph_file.h"
#include "platform/store/storage.h"

static char dir[64], foreign[96];
static struct storage storage;
static struct hal_storage device;

static int set_up(void **state)
{
    (void)state;
    alarm(60); /* alarm() ends the test program if a test blocks for a minute. */
    strcpy(dir, "/tmp/kingyo-strange-XXXXXX");
    snprintf(foreign, sizeof foreign, "/tmp/kingyo-foreign-%d", (int)getpid());
    return mkdtemp(dir) ? 0 : -1;
}

static int tear_down(void **state)
{
    (void)state;
    char command[200];
    alarm(0);
    snprintf(command, sizeof command, "rm -rf %s %s", dir, foreign);
    return system(command);
}

/* ---- Functions that create non-regular files ------------------------------------------------ */

static void put_fifo(const char *path)
{
    assert_int_equal(mkfifo(path, 0600), 0);
}

static void put_link(const char *path)
{
    assert_int_equal(symlink(foreign, path), 0);
}

static void put_device_link(const char *path)
{
    assert_int_equal(symlink("/dev/zero", path), 0);
}

static void put_folder(const char *path)
{
    assert_int_equal(mkdir(path, 0700), 0);
}

static void put_socket(const char *path)
{
    struct sockaddr_un at = { .sun_family = AF_UNIX };
    const int handle = socket(AF_UNIX, SOCK_STREAM, 0);
    snprintf(at.sun_path, sizeof at.sun_path, "%s", path);
    assert_int_equal(bind(handle, (const struct sockaddr *)&at, sizeof at), 0);
    close(handle);
}

static void put_device(const char *path)
{
    /* Creates a device node like /dev/zero, or a FIFO if the test does not run as root. */
    if (mknod(path, S_IFCHR | 0600, 0x105) != 0) {
        put_fifo(path);
    }
}

static void (*const kinds[])(const char *) = { put_fifo,   put_link,   put_device_link,
                                               put_folder, put_socket, put_device };
#define KIND_COUNT (sizeof kinds / sizeof kinds[0])

static const char *in_dir(const char *name)
{
    static char path[160];
    snprintf(path, sizeof path, "%s/%s", dir, name);
    return path;
}

static void victim_is_untouched(void)
{
    assert_int_equal(access(foreign, F_OK), -1);
}

/* ---- Tests of the files of the store -------------------------------------------------------- */

static int keep(uint32_t id)
{
    const struct ledger_entry coin = { .id = id,
                                       .boot = 1,
                                       .tick = 100 * id,
                                       .kind = LEDGER_COINS,
                                       .count = 1,
                                       .value = 1,
                                       .balance = { .paid = id } };
    return device.ledger.ops->append(device.ledger.self, &coin);
}

static int begin(void)
{
    storage = (struct storage){ .dir = dir, .without_thread = true };
    device = storage_device(&storage);
    return device.ledger.ops->open(device.ledger.self);
}

static void fill_and_close(void)
{
    char command[128];
    snprintf(command, sizeof command, "rm -rf %s/*", dir);
    assert_int_equal(system(command), 0);
    assert_int_equal(begin(), HAL_OK);
    for (uint32_t id = 1; id <= 3; id++) {
        assert_int_equal(keep(id), HAL_OK);
    }
    storage_work(&storage);
    assert_int_equal(device.ledger.ops->close(device.ledger.self), 0);
}

static void continues_after(const char *name, void (*put)(const char *))
{
    static struct persistent_state memory;
    char aside[64];
    fill_and_close();
    unlink(in_dir(name));
    put(in_dir(name));
    assert_int_equal(begin(), HAL_OK);
    assert_int_equal(device.ledger.ops->load(device.ledger.self, &memory), HAL_OK);
    assert_int_equal(memory.ledger.last_id, 3);
    const char *text = device.ledger.ops->describe(device.ledger.self);
    assert_non_null(strstr(text, "was not a regular file and was set aside"));
    assert_non_null(strstr(text, name));
    assert_null(strchr(text, '\n'));
    snprintf(aside, sizeof aside, "%s.other-1", name);
    assert_int_equal(faccessat(AT_FDCWD, in_dir(aside), F_OK, AT_SYMLINK_NOFOLLOW), 0);
    keep(4);
    storage_work(&storage);
    assert_int_equal(device.ledger.ops->committed_id(device.ledger.self), 4);
    assert_true(device.ledger.ops->is_healthy(device.ledger.self));
    assert_int_equal(device.ledger.ops->close(device.ledger.self), 0);
    victim_is_untouched();
}

static void test_a_non_regular_file_beside_the_database_is_quarantined(void **state)
{
    (void)state;
    static const char *const names[] = { STORAGE_FILE STORAGE_BACKUP_SUFFIX,
                                         STORAGE_FILE STORAGE_MIRROR_SUFFIX, STORAGE_FILE "-wal",
                                         STORAGE_FILE "-shm", STORAGE_FILE "-journal" };
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
        for (size_t k = 0; k < KIND_COUNT; k++) {
            continues_after(names[i], kinds[k]);
        }
    }
}

static void test_a_non_regular_file_in_place_of_the_database_is_replaced_by_the_backup(void **state)
{
    (void)state;
    static void (*const others[])(const char *) = { put_fifo, put_folder, put_socket, put_device };
    for (size_t i = 0; i < sizeof others / sizeof others[0]; i++) {
        static struct persistent_state memory;
        fill_and_close();
        unlink(in_dir(STORAGE_FILE));
        others[i](in_dir(STORAGE_FILE));
        assert_int_equal(begin(), HAL_OK);
        assert_int_equal(device.ledger.ops->load(device.ledger.self, &memory), HAL_OK);
        assert_int_equal(memory.ledger.last_id, 3);
        assert_non_null(strstr(device.ledger.ops->describe(device.ledger.self), "damaged-1"));
        assert_int_equal(device.ledger.ops->close(device.ledger.self), 0);
    }
}

/* The link may point to a card that is inserted later, so the store must not change the link. */
static void test_a_link_in_place_of_the_database_is_reported_and_not_followed(void **state)
{
    (void)state;
    static void (*const links[])(const char *) = { put_link, put_device_link };
    for (size_t i = 0; i < 2; i++) {
        fill_and_close();
        unlink(in_dir(STORAGE_FILE));
        links[i](in_dir(STORAGE_FILE));
        assert_int_equal(begin(), HAL_ERR_IO);
        assert_non_null(
            strstr(device.ledger.ops->describe(device.ledger.self), "is a symbolic link"));
        storage_work(&storage);
        assert_int_equal(device.ledger.ops->close(device.ledger.self), 0);
        victim_is_untouched();
    }
}

/* Leaves a database whose entries are all in its write-ahead log, as after SIGKILL. */
static void fill_and_kill(void)
{
    char command[400];
    fill_and_close();
    assert_int_equal(begin(), HAL_OK);
    assert_int_equal(keep(4), HAL_OK);
    storage_work(&storage);
    snprintf(command, sizeof command,
             "mkdir %s && cp --preserve %s/" STORAGE_FILE " %s/" STORAGE_FILE "-wal %s", foreign,
             dir, dir, foreign);
    assert_int_equal(system(command), 0);
    assert_int_equal(device.ledger.ops->close(device.ledger.self), 0);
    snprintf(command, sizeof command, "cp %s/* %s && rm -r %s", foreign, dir, foreign);
    assert_int_equal(system(command), 0);
}

/* The log has a size of 1 GiB, but only its first part, the frames, uses disk space. All other
 * bytes are a hole. If the store wrote the hole again, it would fill the disk, and a start would
 * take minutes. */
static void test_a_huge_log_is_rewritten_only_as_far_as_its_frames(void **state)
{
    (void)state;
    static void (*const fills[])(void) = { fill_and_close, fill_and_kill };
    for (uint32_t i = 0; i < 2; i++) {
        static struct persistent_state memory;
        struct stat log;
        fills[i]();
        const int file = open(in_dir(STORAGE_FILE "-wal"), O_WRONLY | O_CREAT, 0600);
        assert_int_equal(ftruncate(file, (off_t)1 << 30), 0);
        close(file);
        assert_int_equal(begin(), HAL_OK);
        assert_int_equal(stat(in_dir(STORAGE_FILE "-wal"), &log), 0);
        assert_true(log.st_blocks < 4096); /* st_blocks counts blocks of 512 bytes, so the limit is
                                              2 MiB. */
        assert_int_equal(device.ledger.ops->load(device.ledger.self, &memory), HAL_OK);
        assert_int_equal(memory.ledger.last_id, 3 + i);
        assert_int_equal(device.ledger.ops->close(device.ledger.self), 0);
    }
}

static void test_a_non_regular_file_at_a_temporary_path_is_no_obstacle(void **state)
{
    (void)state;
    static const char *const names[] = { STORAGE_FILE STORAGE_NEW_SUFFIX LEDGER_PART_SUFFIX,
                                         STORAGE_FILE STORAGE_BACKUP_SUFFIX LEDGER_PART_SUFFIX };
    for (size_t i = 0; i < 4; i++) {
        static struct persistent_state memory;
        fill_and_close();
        unlink(in_dir(STORAGE_FILE));
        (i % 2u == 0 ? put_fifo : put_link)(in_dir(names[i / 2u]));
        assert_int_equal(begin(), HAL_OK);
        assert_int_equal(device.ledger.ops->load(device.ledger.self, &memory), HAL_OK);
        assert_int_equal(memory.ledger.last_id, 3);
        storage_work(&storage);
        assert_int_equal(device.ledger.ops->close(device.ledger.self), 0);
        victim_is_untouched();
    }
}

/* ---- Tests of the other files in the data folder -------------------------------------------- */

static void test_file_handle_opens_only_regular_files(void **state)
{
    (void)state;
    for (size_t i = 0; i < KIND_COUNT; i++) {
        kinds[i](in_dir("one"));
        assert_true(file_is_other(in_dir("one")));
        assert_int_equal(file_handle(in_dir("one"), O_RDONLY, 0), -1);
        assert_int_equal(file_handle(in_dir("one"), O_RDWR | O_CREAT | O_TRUNC, 0600), -1);
        assert_int_equal(file_handle(in_dir("one"), O_WRONLY | O_CREAT, 0600), -1);
        assert_int_equal(remove(in_dir("one")), 0);
    }
    assert_string_equal(file_error(ELOOP), "is a symbolic link");
    assert_string_equal(file_error(ENOTSUP), "is not a regular file");
    const int handle = file_handle(in_dir("one"), O_RDWR | O_CREAT, 0600);
    assert_true(handle >= 0);
    assert_int_equal(write(handle, "12", 2), 2);
    close(handle);
    struct stat about;
    close(file_handle(in_dir("one"), O_WRONLY | O_TRUNC, 0));
    assert_int_equal(stat(in_dir("one"), &about), 0);
    assert_int_equal(about.st_size, 0);
    victim_is_untouched();
}

static void test_mapping_and_usb_files_must_be_regular_files(void **state)
{
    (void)state;
    static char text[HID_MAPPING_STORE_TEXT_SIZE];
    static struct usb_choice choice;
    char why[HAL_TEXT_SIZE];
    for (size_t i = 0; i < KIND_COUNT; i++) {
        kinds[i](in_dir("one"));
        assert_int_not_equal(hid_mapping_store_file_read(in_dir("one"), text), 0);
        assert_true(usb_choice_load(&choice, in_dir("one"), why) < 0);
        assert_int_equal(remove(in_dir("one")), 0);
    }
    char path[160];
    snprintf(path, sizeof path, "%s", in_dir("one"));
    put_fifo(in_dir("one.part"));
    assert_int_equal(file_replace(path, "text", 4, FILE_REPLACE_DURABLE), 0);
    put_link(in_dir("one.part"));
    assert_int_equal(file_replace(path, "text", 4, FILE_REPLACE_DURABLE), 0);
    put_fifo(in_dir("one.part"));
    assert_int_equal(usb_choice_save(&choice, path), 0);
    put_link(in_dir("one.part"));
    assert_int_equal(usb_choice_save(&choice, path), 0);
    victim_is_untouched();
}

int main(void)
{
#define TEST(name) cmocka_unit_test_setup_teardown(name, set_up, tear_down)
    const struct CMUnitTest tests[] = {
        TEST(test_a_non_regular_file_beside_the_database_is_quarantined),
        TEST(test_a_non_regular_file_in_place_of_the_database_is_replaced_by_the_backup),
        TEST(test_a_link_in_place_of_the_database_is_reported_and_not_followed),
        TEST(test_a_huge_log_is_rewritten_only_as_far_as_its_frames),
        TEST(test_a_non_regular_file_at_a_temporary_path_is_no_obstacle),
        TEST(test_file_handle_opens_only_regular_files),
        TEST(test_mapping_and_usb_files_must_be_regular_files),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
