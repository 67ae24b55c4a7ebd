# devices.mk -- libFuzzer tests for data of controllers, coin slots and their files, under the
# address and undefined-behaviour sanitizers. The targets are pure functions of their input bytes.

DEVICE_TARGETS := descriptor report rows live poi_report pose_decoder map_text learn mapping_file coin edges wires pad \
    poi_tape poi_board
DEVICE_BIN := $(DEVICE_TARGETS:%=$(FUZZ)/device_%)
# A target links only the functions that it calls from this archive, and only these count as its
# coverage.
DEVICE_SRC := $(filter-out %/poi_hid.c,$(wildcard drivers/hid/*.c)) \
    $(patsubst %,drivers/pointer/%.c,pointer_poi touch_fingers) \
    $(patsubst %,drivers/gamepad/%.c,stick_motion gamepad_decoder) \
    $(patsubst %,drivers/gpio/%.c,gpio_config gpio_signal) \
    $(patsubst %,drivers/sim/%.c,hid_sim) \
    drivers/usb/usb_choice.c $(patsubst %,platform/ctl/devices/hid_%.c,file rows live) \
    $(patsubst %,board/poi-gadget/%.c,pose_script poi_config draw_wires attitude sensor_twin \
    motor) $(patsubst %,platform/%.c,os/clock os/file os/print os/number config/option_table ctl/lib/ctl) \
    core/view.c \
    $(patsubst %,core/base/%.c,fmath vec rng printable) tests/fuzz/panic.c

## test/fuzz-devices: Fuzz descriptors, reports, mappings and coins; FUZZ_SECONDS=30
fuzz-devices:
	@board/setup.sh dev
	+@$(MAKE) --no-print-directory -j$(JOBS) $(DEVICE_BIN)
	@tests/fuzz/fuzz_targets.sh device $(FUZZ) $(FUZZ_SECONDS) $(DEVICE_TARGETS)

$(FUZZ)/devices.a: $(DEVICE_SRC:%.c=$(FUZZ)/%.o)
	$(call step,AR,$@)
	@rm -f $@
	$(Q)$(AR) rcsP $@ $^

$(DEVICE_BIN): $(FUZZ)/device_%: $(FUZZ)/tests/fuzz/devices/%.o $(FUZZ)/devices.a
	$(call step,LINK,$@)
	$(Q)$(FUZZ_CC) -fsanitize=fuzzer,address,undefined -o $@ $^

.PHONY: fuzz-devices
.SECONDARY: $(DEVICE_TARGETS:%=$(FUZZ)/tests/fuzz/devices/%.o)
