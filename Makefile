# Kingyo -- a goldfish-scooping stall in a box.
#
# Two commands do everything on a fresh machine: `make run` and `make test`. `make help` lists the rest.

BOARD ?= desktop
BUILD ?= build
CC ?= gcc
OPT ?= -O2

.DEFAULT_GOAL := help
SHELL := /bin/bash

WARN := -Wall -Wextra -Wconversion -Wshadow -Werror -Wmissing-prototypes -Wstrict-prototypes -Wvla
BASE_CFLAGS := -std=c17 $(OPT) -g $(WARN) -ffp-contract=off -I. -I$(BUILD)/generated -MMD -MP
CORE_CFLAGS := $(BASE_CFLAGS) -ffreestanding -fno-math-errno -fno-stack-protector
# Lazy, so that `make help` and `make setup` work before pkg-config is there.
LIBS_SHELL = pkg-config --cflags sdl2 glesv2 sqlite3
HOST_CFLAGS = $(BASE_CFLAGS) -D_GNU_SOURCE $(shell $(LIBS_SHELL)) -DKINGYO_BOARD=\"$(BOARD)\"
HOST_LIBS = $(shell pkg-config --libs sdl2 glesv2 sqlite3) -lm -lpthread

CORE_SRC := $(wildcard core/*.c core/*/*.c)
PLATFORM_SRC := $(wildcard platform/*.c platform/render/*.c)
KIOSK_SRC := $(wildcard platform/kiosk/*.c)
CTL_SRC := $(wildcard platform/ctl/*.c)
DRIVER_SRC := $(wildcard drivers/*.c)
BOARD_SRC := $(wildcard board/$(BOARD)/*.c)

CORE_OBJ = $(CORE_SRC:%.c=$(BUILD)/%.o) $(GENERATED_CORE_OBJ)
PLATFORM_OBJ = $(PLATFORM_SRC:%.c=$(BUILD)/%.o) $(GENERATED_OBJ)
KIOSK_OBJ = $(KIOSK_SRC:%.c=$(BUILD)/%.o)
CTL_OBJ = $(CTL_SRC:%.c=$(BUILD)/%.o)
DRIVER_OBJ = $(DRIVER_SRC:%.c=$(BUILD)/%.o)
BOARD_OBJ = $(BOARD_SRC:%.c=$(BUILD)/%.o)

# What each part adds of its own: baked assets, tests, board files.
-include assets/bake/bake.mk
-include tests/tests.mk
-include board/board.mk

## help: this list
help:
	@echo 'Kingyo: make run plays, make test tests. Every task:'
	@grep -hE '^## [a-z-]+:' $(MAKEFILE_LIST) | sed 's/^## /  make /' | awk -F': ' '{printf "%-24s %s\n", $$1, $$2}'

## build: the kiosk (build/kingyo) and the operator's command line (build/kingyoctl)
build: $(BUILD)/kingyo $(BUILD)/kingyoctl

$(BUILD)/kingyo: $(KIOSK_OBJ) $(PLATFORM_OBJ) $(DRIVER_OBJ) $(BOARD_OBJ) $(BUILD)/core.a
	$(CC) $(OPT) -g -o $@ $^ $(HOST_LIBS)

$(BUILD)/kingyoctl: $(CTL_OBJ) $(PLATFORM_OBJ) $(DRIVER_OBJ) $(filter-out %/main.o,$(KIOSK_OBJ)) $(BOARD_OBJ) $(BUILD)/core.a
	$(CC) $(OPT) -g -o $@ $^ $(HOST_LIBS)

$(BUILD)/core.a: $(CORE_OBJ)
	@rm -f $@
	ar rcs $@ $^

$(BUILD)/core/%.o: core/%.c | generated
	@mkdir -p $(@D)
	$(CC) $(CORE_CFLAGS) -c -o $@ $<

$(BUILD)/%.o: %.c | generated
	@mkdir -p $(@D)
	$(CC) $(HOST_CFLAGS) -c -o $@ $<

# Filled by assets/bake/bake.mk: what must exist before anything that includes it compiles.
generated:

## clean: removes everything that was built
clean:
	rm -rf $(BUILD)

-include $(shell find $(BUILD) -name '*.d' 2>/dev/null)

.PHONY: help build generated clean
