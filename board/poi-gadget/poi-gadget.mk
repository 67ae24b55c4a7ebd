# poi-gadget.mk -- builds kingyo-poi, the program on the board of a poi. The program needs only libc and
# libm, so it is built on the board itself, or cross-compiled:
# make poi-gadget CC=aarch64-linux-gnu-gcc BUILD=build-arm64

GADGET_DIR := board/poi-gadget
GADGET_SRC := $(wildcard $(GADGET_DIR)/*.c)
GADGET_SHARED := core/base/fmath.c core/base/vec.c core/base/rng.c core/base/printable.c \
    drivers/hid/poi_report.c platform/config/option_table.c platform/os/clock.c platform/os/file.c \
    platform/os/number.c platform/os/print.c
# The program is linked statically, because the board's Debian may be older than the build machine's.
GADGET_LDFLAGS ?= -static
GADGET_OBJ := $(patsubst %.c,$(BUILD)/poi-gadget/%.o,$(GADGET_SRC) $(GADGET_SHARED))

# The tests link the parts of the program from the archive that all tests link.
BOARD_OBJ += $(patsubst %.c,$(BUILD)/%.o,$(filter-out %/main.c,$(GADGET_SRC)))

## build/poi-gadget: Build kingyo-poi, the program on the board inside a poi
ifneq ($(FOREIGN),)
poi-gadget:
	@$(cross) poi-gadget
else
poi-gadget: $(BUILD)/kingyo-poi
endif

$(BUILD)/kingyo-poi: $(GADGET_OBJ)
	$(call step,LINK,$@)
	$(Q)$(CC) $(OPT) -g $(GADGET_LDFLAGS) -o $@ $^ -lm

$(BUILD)/poi-gadget/%.o: %.c $(FOUND_TOOLS)
	@mkdir -p $(@D)
	$(call step,CC,$< (poi))
	$(Q)$(CC) $(BASE_CFLAGS) -D_GNU_SOURCE $(DEP_FLAGS) -c -o $@ $<

tests: $(BUILD)/kingyo-poi

.PHONY: poi-gadget
