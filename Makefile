# Kingyo: a goldfish-scooping kiosk.
#
# On a fresh machine, `make run` and `make test` do everything. `make help` lists all targets. V=1 prints whole commands.
# BUILD=dir builds in another folder; each compiler and each set of options needs a folder of its own.

BOARD ?= desktop
BUILD ?= build
ifeq ($(origin CC),default)
CC := gcc
endif
OPT ?= -O2

.DEFAULT_GOAL := build
SHELL := /bin/bash
.DELETE_ON_ERROR:
MAKEFLAGS += --no-builtin-rules

ifeq ($(V),1)
say :=
Q :=
else
say = @printf '  %-5s %s\n'
Q := @
endif
# $(call step,CC,what) prints one line for each step. With V=1, make prints the command instead.
step = $(if $(say),$(say) '$(1)' '$(2)',@:)

WARN := -Wall -Wextra -Wconversion -Wshadow -Werror -Wmissing-prototypes -Wstrict-prototypes -Wvla
BASE_CFLAGS := -std=c17 $(OPT) -g $(WARN) -ffp-contract=off -I. -I$(BUILD)/generated \
    -ffile-prefix-map=$(CURDIR)=.
DEP_FLAGS = -MMD -MP
CORE_CFLAGS := $(BASE_CFLAGS) -ffreestanding -fno-math-errno -fno-stack-protector -fstack-usage \
    -Wno-psabi
# Hardening flags of the programs around the core. The core calls no function that these flags could check.
HARDEN_CFLAGS = $(if $(filter -O0,$(OPT)),,-D_FORTIFY_SOURCE=2) -fstack-protector-strong
# Programs for a 32-bit machine count time and file sizes in 64 bits, so that they show dates after 2038. Machines of 64
# bits do so without these flags, and there the flags would only rename the functions of the C library.
WORD = $(eval WORD := $$(shell echo __SIZEOF_LONG__ | $$(CC) -E -P -x c - 2>/dev/null))$(WORD)
TIME_CFLAGS = $(if $(filter 4,$(WORD)),-D_TIME_BITS=64 -D_FILE_OFFSET_BITS=64)
HOST_CFLAGS = $(BASE_CFLAGS) $(HARDEN_CFLAGS) -D_GNU_SOURCE $(TIME_CFLAGS) $(LIB_CFLAGS) $(ASSIMP) -DKINGYO_BOARD=\"$(BOARD)\"
HOST_LIBS = $(LIB_LIBS) -lm -lpthread -Wl,-z,now
TEST_CFLAGS = $(HOST_CFLAGS)

# Evaluated once, and only when something is compiled, so that `make help` and the set-up also work on a machine without
# pkg-config. The headers of libraries count as system headers, because our warnings apply to our own code only.
PACKAGES = sdl2 glesv2 egl sqlite3 libusb-1.0 $(if $(filter-out 0,$(GPIOD)),libgpiod)
# Major version of libgpiod (1 or 2) for the lines of buttons and coins; 0 means that libgpiod is not installed.
GPIOD = $(eval GPIOD := $$(or $$(firstword $$(subst ., ,$$(shell pkg-config --modversion libgpiod 2>/dev/null))),0))$(GPIOD)
LIB_CFLAGS = $(eval LIB_CFLAGS := $$(patsubst -I%,-isystem %,$$(shell pkg-config --cflags $(PACKAGES))))$(LIB_CFLAGS)
# 1 if the headers of assimp, which reads scene files, are installed. The value is a macro, because a compiler cache does
# not detect that a header becomes available to __has_include.
ASSIMP = $(eval ASSIMP := $$(shell printf '\043include <assimp/cimport.h>\n' | $$(CC) -E -x c - >/dev/null 2>&1 && echo -DHAS_ASSIMP))$(ASSIMP)
LIB_LIBS = $(eval LIB_LIBS := $$(shell pkg-config --libs $(PACKAGES)))$(LIB_LIBS)

# What the build finds on this machine. Objects depend on these files, which are rewritten only when their text changes.
# Commands may therefore run in any order, and packages may be installed or removed between them. FOUND lists everything.
# Programs that link no library (core, kingyo-poi) depend only on the compilers and flags. Objects that clang always
# compiles (fuzz targets, monkey test, variants) also depend on FOUND_CLANG, so that installing clang recompiles no others.
FOUND := $(BUILD)/found.txt
FOUND_TOOLS := $(BUILD)/found-tools.txt
FOUND_CLANG := $(BUILD)/found-clang.txt
# Evaluated here, because a target with flags of its own passes these flags to its prerequisites.
FOUND_FLAGS := $(CORE_CFLAGS) $(HARDEN_CFLAGS) $(TIME_CFLAGS)
replace_if_other = { cmp -s $@.new $@ && rm $@.new || mv $@.new $@; }

# $(call sources,FOLDER) lists every C file in FOLDER and its subfolders.
sources = $(sort $(shell find $(1) -name '*.c'))

CORE_SRC := $(call sources,core)
KIOSK_SRC := $(call sources,platform/kiosk)
CTL_SRC := $(call sources,platform/ctl)
PLATFORM_SRC := $(filter-out $(KIOSK_SRC) $(CTL_SRC),$(call sources,platform))
GPIOD_SRC := $(wildcard drivers/gpio/gpio_lines[0-9].c)
DRIVER_SRC = $(filter-out $(GPIOD_SRC),$(call sources,drivers)) $(filter %$(GPIOD).c,$(GPIOD_SRC))
BOARD_SRC := $(wildcard board/*.c board/$(BOARD)/*.c)

# SIMD kernels (core/base/simd.h) are compiled for four lanes. If the compiler targets x86-64, they are also compiled for
# eight lanes. The platform selects one of the two at program start.
KERNEL_SRC := $(filter %_simd.c,$(CORE_SRC))
WIDE_CFLAGS := -mavx2 -DSIMD_WIDE
MACHINE = $(eval MACHINE := $$(shell $(CC) -dumpmachine))$(MACHINE)
WIDE_SRC = $(if $(filter x86_64%,$(MACHINE)),$(KERNEL_SRC))

# The time stamps of libgpiod 1 have the size that the library was built with. Debian 12 built it with 32-bit times.
$(BUILD)/drivers/gpio/gpio_lines1.o: TIME_CFLAGS :=

CORE_OBJ = $(CORE_SRC:%.c=$(BUILD)/%.o) $(WIDE_SRC:%.c=$(BUILD)/%_8.o) $(GENERATED_CORE_OBJ)
PLATFORM_OBJ = $(PLATFORM_SRC:%.c=$(BUILD)/%.o) $(GENERATED_OBJ)
KIOSK_OBJ = $(KIOSK_SRC:%.c=$(BUILD)/%.o)
CTL_OBJ = $(CTL_SRC:%.c=$(BUILD)/%.o)
DRIVER_OBJ = $(DRIVER_SRC:%.c=$(BUILD)/%.o)
BOARD_OBJ = $(BOARD_SRC:%.c=$(BUILD)/%.o)
# All objects around the core except the two main() files. Programs and tests link what they call.
SHELL_OBJ = $(filter-out %/main.o,$(PLATFORM_OBJ) $(KIOSK_OBJ) $(DRIVER_OBJ) $(BOARD_OBJ))

# ARCH=arm64 on the command line runs a task for another processor (board/deb/cross.sh). A variable of the environment
# does not count, because other build systems export this name.
FOREIGN := $(if $(filter command,$(firstword $(origin ARCH))),$(ARCH))
cross = board/setup.sh cross && BUILD='$(BUILD)' ONLY='$(ONLY)' board/deb/cross.sh $(FOREIGN)

# Each part of the tree adds its own rules: board files and set-up, baked assets, tests, figures.
-include board/board.mk
-include $(wildcard assets/bake/*.mk)
-include platform/ctl/tank/tank.mk
-include tests/tests.mk
-include tests/bench/bench.mk
-include tests/soak/soak.mk
-include tests/render/render.mk
-include tests/v3d/v3d.mk
-include tests/thesis/thesis.mk
-include tests/paper/paper.mk
-include tests/fuzz/fuzz.mk
-include tests/monkey/monkey.mk
-include tests/metrics/metrics.mk
-include tests/vm/vm.mk tests/fuzz/devices.mk tests/fuzz/files.mk tests/power/power.mk tests/mutants/mutants.mk

## build/help: Print this list
help:
	@echo 'Kingyo. Start with `make run` (play) or `make test`. `make` alone builds.'
	@awk -f board/help.awk $(MAKEFILE_LIST)
	@echo; echo 'Settings: V=1 (print whole commands), BUILD=dir, CC=clang, OPT=-O0, BOARD=name'

## build/build: Build build/kingyo (game) and build/kingyoctl (command line)
build: $(BUILD)/kingyo $(BUILD)/kingyoctl

## build/clang: Build both programs with clang into build-clang/
clang:
	+@$(MAKE) --no-print-directory BUILD=build-clang CC=clang build

$(BUILD)/kingyo: $(BUILD)/platform/kiosk/main.o $(BUILD)/shell.a $(BUILD)/core.a
	$(call step,LINK,$@)
	$(Q)$(CC) $(OPT) -g -o $@ $^ $(HOST_LIBS)

$(BUILD)/kingyoctl: $(BUILD)/platform/ctl/main.o $(BUILD)/many/tank.o $(BUILD)/ctl.a $(BUILD)/shell.a $(BUILD)/core.a
	$(call step,LINK,$@)
	$(Q)$(CC) $(OPT) -g -o $@ $^ $(HOST_LIBS)

$(BUILD)/core.a: $(CORE_OBJ)
$(BUILD)/shell.a: $(SHELL_OBJ)
$(BUILD)/ctl.a: $(filter-out %/main.o,$(CTL_OBJ))
# The flag P keeps two objects that have the same name in different folders as two members.
$(BUILD)/%.a:
	$(call step,AR,$@)
	@rm -f $@
	$(Q)$(AR) rcsP $@ $^

$(FOUND_TOOLS): always
	@mkdir -p $(@D)
	@{ echo 'compiler $(CC)'; $(CC) --version | head -1; echo 'flags $(FOUND_FLAGS)'; } >$@.new
	@$(replace_if_other)

$(FOUND_CLANG): always
	@mkdir -p $(@D)
	@{ for cc in $(sort clang $(FUZZ_CC) $(MONKEY_CC)); do echo "$$cc $$($$cc --version 2>/dev/null | head -1)"; done; \
	    echo 'fuzz $(FUZZ_CFLAGS)'; echo 'monkey $(MONKEY_SAN)'; } >$@.new
	@$(replace_if_other)

$(FOUND): $(FOUND_TOOLS) always
	@{ cat $(FOUND_TOOLS); \
	    echo 'libraries $(LIB_CFLAGS) $(LIB_LIBS)'; \
	    for name in $(PACKAGES); do echo "$$name $$(pkg-config --modversion $$name 2>/dev/null)"; done; \
	    echo 'libgpiod major version $(GPIOD)'; \
	    echo 'assimp $(or $(ASSIMP),no)'; echo 'board $(BOARD)'; } >$@.new
	@$(replace_if_other)

always:

$(BUILD)/core/%.o: core/%.c $(FOUND_TOOLS) | generated
	@mkdir -p $(@D)
	$(call step,CC,$<)
	$(Q)$(CC) $(CORE_CFLAGS) $(DEP_FLAGS) -c -o $@ $<

$(BUILD)/core/%_8.o: core/%.c $(FOUND_TOOLS) | generated
	@mkdir -p $(@D)
	$(call step,CC,$< (8 lanes))
	$(Q)$(CC) $(CORE_CFLAGS) $(WIDE_CFLAGS) $(DEP_FLAGS) -c -o $@ $<

$(BUILD)/%.o: %.c $(FOUND) | generated
	@mkdir -p $(@D)
	$(call step,CC,$<)
	$(Q)$(CC) $(HOST_CFLAGS) $(DEP_FLAGS) -c -o $@ $<

# Filled by assets/bake/bake.mk: files that must exist before any file that includes them is compiled.
generated:

# A board links only if it has its own board.c. The boards of `make image` (board/NAME/image.conf) have none.
generated: | linkable-board
linkable-board:
	@test -f board/$(BOARD)/board.c || { \
	    echo 'make: board/$(BOARD)/board.c does not exist; BOARD is one of:' \
	        $(patsubst board/%/board.c,%,$(wildcard board/*/board.c)) >&2; exit 2; }

## build/compile_commands.json: Write the compilation database for editors and clang-tidy
compile_commands.json: always
	@$(MAKE) --no-print-directory --always-make --dry-run V=1 build tests 2>/dev/null | \
	    board/compile_commands.sh >$@.new
	@$(replace_if_other)

## build/clean: Remove everything that was built
clean:
	rm -rf build build-clang $(BUILD)

-include $(shell [ -d $(BUILD) ] && find $(BUILD) \( -path $(BUILD)/vm -o -path $(BUILD)/image -o -path $(BUILD)/v3d -o -path $(BUILD)/cross \) -prune -o -type f -name '*.d' -print)

.PHONY: help build clang generated linkable-board clean always
