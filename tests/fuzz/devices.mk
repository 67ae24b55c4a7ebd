# devices.mk -- what controllers, coin slots and files about them may do to us, tried by libFuzzer under the
# address and undefined-behaviour sanitizers. Targets are pure: bytes in, checks out.

DEVICE_TARGETS := descriptor report rows live poi_report hand map_text learn book coin edges wires pad \
    poi_tape poi_board
DEVICE_BIN := $(DEVICE_TARGETS:%=$(FUZZ)/device_%)
# A target takes from this archive what it calls, and is counted by that alone.
DEVICE_SRC := $(wildcard drivers/hid_*.c drivers/pointer_*.c drivers/pose_*.c drivers/poi_[dr]*.c drivers/fly_*.c \
    drivers/dip.c drivers/pad_hand.c drivers/pad_tilt.c drivers/pad_track.c drivers/touch_fingers.c \
    drivers/gpio_wires.c drivers/gpio_word.c drivers/gpio_input.c drivers/coin_mech.c drivers/debounce.c \
    drivers/usb_choice.c) $(patsubst %,platform/ctl/hid_%.c,file rows live names) \
    $(patsubst %,board/poi-gadget/%.c,pose_line pose_glide pose_tape poi_config draw_wires attitude steady \
    board_pose sensor_twin feel_mix) $(patsubst %,platform/%.c,plain_file print ctl/user_file) core/view.c \
    $(patsubst %,core/base/%.c,fmath vec rng printable)

## test/fuzz-devices: Fuzz descriptors, reports, mappings and coins; FUZZ_SECONDS=30
fuzz-devices:
	@board/setup.sh dev
	+@$(MAKE) --no-print-directory -j$(JOBS) $(DEVICE_BIN)
	@tests/fuzz/fuzz_targets.sh device $(FUZZ) $(FUZZ_SECONDS) $(DEVICE_TARGETS)

$(FUZZ)/devices.a: $(DEVICE_SRC:%.c=$(FUZZ)/%.o)
	$(call step,AR,$@)
	@rm -f $@
	$(Q)ar rcs $@ $^

$(DEVICE_BIN): $(FUZZ)/device_%: $(FUZZ)/tests/fuzz/device_%.o $(FUZZ)/devices.a
	$(call step,LINK,$@)
	$(Q)$(FUZZ_CC) -fsanitize=fuzzer,address,undefined -o $@ $^

.PHONY: fuzz-devices
.SECONDARY: $(DEVICE_TARGETS:%=$(FUZZ)/tests/fuzz/device_%.o)
