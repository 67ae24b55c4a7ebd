# Kingyo -- a goldfish-scooping stall in a box.
#
# Two commands do everything on a fresh machine: `make run` and `make test`. `make help` lists the rest.
# V=1 shows whole commands; BUILD=dir builds elsewhere (one folder per compiler and option set).

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
# $(call step,CC,what): one quiet line per step; V=1 shows the command instead.
step = $(if $(say),$(say) '$(1)' '$(2)',@:)

WARN := -Wall -Wextra -Wconversion -Wshadow -Werror -Wmissing-prototypes -Wstrict-prototypes -Wvla
BASE_CFLAGS := -std=c17 $(OPT) -g $(WARN) -ffp-contract=off -I. -I$(BUILD)/generated \
    -ffile-prefix-map=$(CURDIR)=.
DEP_FLAGS = -MMD -MP
CORE_CFLAGS := $(BASE_CFLAGS) -ffreestanding -fno-math-errno -fno-stack-protector -fstack-usage \
    -Wno-psabi
# What the programs around the core are hardened with; the core calls nothing that this could check.
HARDEN_CFLAGS = $(if $(filter -O0,$(OPT)),,-D_FORTIFY_SOURCE=2) -fstack-protector-strong
HOST_CFLAGS = $(BASE_CFLAGS) $(HARDEN_CFLAGS) -D_GNU_SOURCE $(LIB_CFLAGS) $(ASSIMP) -DKINGYO_BOARD=\"$(BOARD)\"
HOST_LIBS = $(LIB_LIBS) -lm -lpthread -Wl,-z,now
TEST_CFLAGS = $(HOST_CFLAGS)

# Asked for once, and only when something is compiled, so that `make help` and the set-up work on a
# machine that has no pkg-config yet. Libraries' headers are the system's: our warnings are for us.
PACKAGES = sdl2 glesv2 egl sqlite3 libusb-1.0 $(if $(filter-out 0,$(GPIOD)),libgpiod)
# Lines of buttons and coins: libgpiod 1.x or 2.x as the machine has it, or none (0).
GPIOD = $(eval GPIOD := $$(or $$(firstword $$(subst ., ,$$(shell pkg-config --modversion libgpiod 2>/dev/null))),0))$(GPIOD)
LIB_CFLAGS = $(eval LIB_CFLAGS := $$(patsubst -I%,-isystem %,$$(shell pkg-config --cflags $(PACKAGES))))$(LIB_CFLAGS)
# Scenes are read by assimp where its headers are. A macro, because a compiler cache does not notice a
# header that __has_include finds later.
ASSIMP = $(eval ASSIMP := $$(shell printf '\043include <assimp/cimport.h>\n' | $$(CC) -E -x c - >/dev/null 2>&1 && echo -DHAS_ASSIMP))$(ASSIMP)
LIB_LIBS = $(eval LIB_LIBS := $$(shell pkg-config --libs $(PACKAGES)))$(LIB_LIBS)

# What the build finds on this machine. Objects depend on these files, which are rewritten only when
# their text changes: commands may come in any order, and packages may come and go between them.
# FOUND has all of it; what links no library (core, kingyo-poi) depends on the compilers and flags.
FOUND := $(BUILD)/found.txt
FOUND_TOOLS := $(BUILD)/found-tools.txt
# Taken here, because a target of its own flags passes them to what it depends on.
FOUND_FLAGS := $(CORE_CFLAGS)
replace_if_other = { cmp -s $@.new $@ && rm $@.new || mv $@.new $@; }

# $(call sources,FOLDER): every C file in FOLDER and below.
sources = $(sort $(shell find $(1) -name '*.c'))

CORE_SRC := $(call sources,core)
KIOSK_SRC := $(call sources,platform/kiosk)
CTL_SRC := $(call sources,platform/ctl)
PLATFORM_SRC := $(filter-out $(KIOSK_SRC) $(CTL_SRC),$(call sources,platform))
GPIOD_SRC := $(wildcard drivers/gpio/gpio_lines[0-9].c)
DRIVER_SRC = $(filter-out $(GPIOD_SRC),$(call sources,drivers)) $(filter %$(GPIOD).c,$(GPIOD_SRC))
BOARD_SRC := $(wildcard board/*.c board/$(BOARD)/*.c)

# Kernels (core/base/simd.h) are compiled once for four lanes and, where the compiler makes code for
# x86-64, once more for eight; the platform says at the start which of the two run.
KERNEL_SRC := $(filter %_simd.c,$(CORE_SRC))
WIDE_CFLAGS := -mavx2 -DSIMD_WIDE
MACHINE = $(eval MACHINE := $$(shell $(CC) -dumpmachine))$(MACHINE)
WIDE_SRC = $(if $(filter x86_64%,$(MACHINE)),$(KERNEL_SRC))

CORE_OBJ = $(CORE_SRC:%.c=$(BUILD)/%.o) $(WIDE_SRC:%.c=$(BUILD)/%_8.o) $(GENERATED_CORE_OBJ)
PLATFORM_OBJ = $(PLATFORM_SRC:%.c=$(BUILD)/%.o) $(GENERATED_OBJ)
KIOSK_OBJ = $(KIOSK_SRC:%.c=$(BUILD)/%.o)
CTL_OBJ = $(CTL_SRC:%.c=$(BUILD)/%.o)
DRIVER_OBJ = $(DRIVER_SRC:%.c=$(BUILD)/%.o)
BOARD_OBJ = $(BOARD_SRC:%.c=$(BUILD)/%.o)
# Everything around the core but the two main()s: programs and tests take from it what they call.
SHELL_OBJ = $(filter-out %/main.o,$(PLATFORM_OBJ) $(KIOSK_OBJ) $(DRIVER_OBJ) $(BOARD_OBJ))

# What each part adds of its own: board files and set-up, baked assets, tests, figures.
-include board/board.mk
-include $(wildcard assets/bake/*.mk)
-include platform/ctl/tank/tank.mk
-include tests/tests.mk
-include tests/bench/bench.mk
-include tests/soak/soak.mk
-include tests/render/render.mk
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
# P: objects of one name in two folders are two members.
$(BUILD)/%.a:
	$(call step,AR,$@)
	@rm -f $@
	$(Q)ar rcsP $@ $^

$(FOUND_TOOLS): always
	@mkdir -p $(@D)
	@{ echo 'compiler $(CC)'; $(CC) --version | head -1; echo 'flags $(FOUND_FLAGS)'; } >$@.new
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

# Filled by assets/bake/bake.mk: what must exist before anything that includes it compiles.
generated:

# A board links only with a board.c of its own. The boards of `make image` (board/NAME/image.conf) do not.
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

-include $(shell [ -d $(BUILD) ] && find $(BUILD) \( -path $(BUILD)/vm -o -path $(BUILD)/image \) -prune -o -type f -name '*.d' -print)

.PHONY: help build clang generated linkable-board clean always
