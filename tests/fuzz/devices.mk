# devices.mk -- what controllers, coin slots and files about them may do to us, tried by libFuzzer under the
# address and undefined-behaviour sanitizers. Targets are pure: bytes in, checks out.

DEVICE_TARGETS := descriptor report rows poi_report hand map_text learn book coin edges wires
DEVICE_BIN := $(DEVICE_TARGETS:%=$(FUZZ)/device_%)
DEVICE_HID := $(patsubst %,$(FUZZ)/drivers/%.o,hid_descriptor hid_globals hid_item hid_report)
DEVICE_CTL := $(patsubst %,$(FUZZ)/platform/ctl/%.o,hid_file hid_rows)
DEVICE_POI := $(patsubst %,$(FUZZ)/%.o,drivers/poi_report core/base/fmath)
DEVICE_MAP := $(patsubst %,$(FUZZ)/drivers/%.o,hid_map hid_map_known hid_map_text hid_offer) $(DEVICE_HID)
DEVICE_HAND := $(patsubst %,$(FUZZ)/%.o,drivers/hid_hand drivers/dip drivers/fly_poi drivers/pointer_poi \
    drivers/pointer_fan core/view core/base/vec) $(DEVICE_MAP) $(DEVICE_POI)

## fuzz-devices: hostile descriptors, reports, maps, wires and coins, FUZZ_SECONDS (30) each; counts in build/fuzz/devices.tsv
fuzz-devices:
	@board/setup.sh dev
	+@$(MAKE) --no-print-directory -j$(JOBS) $(DEVICE_BIN)
	@tests/fuzz/fuzz_devices.sh $(FUZZ) $(FUZZ_SECONDS) $(DEVICE_TARGETS)

$(FUZZ)/device_descriptor: $(DEVICE_HID)
$(FUZZ)/device_report: $(DEVICE_HID)
$(FUZZ)/device_rows: $(DEVICE_HID) $(DEVICE_CTL)
$(FUZZ)/device_poi_report: $(DEVICE_POI)
$(FUZZ)/device_hand: $(DEVICE_HAND)
$(FUZZ)/device_map_text: $(DEVICE_MAP) $(DEVICE_POI)
$(FUZZ)/device_learn: $(FUZZ)/drivers/hid_learn.o $(DEVICE_HAND)
$(FUZZ)/device_book: $(FUZZ)/drivers/hid_book_text.o $(DEVICE_MAP) $(DEVICE_POI)
$(FUZZ)/device_coin: $(FUZZ)/drivers/coin_mech.o $(FUZZ)/drivers/debounce.o
$(FUZZ)/device_edges: $(FUZZ)/drivers/gpio_input.o $(FUZZ)/drivers/debounce.o
$(FUZZ)/device_wires: $(patsubst %,$(FUZZ)/drivers/%.o,gpio_wires usb_choice poi_descriptor) $(DEVICE_HID)
$(DEVICE_BIN): $(FUZZ)/device_%: $(FUZZ)/tests/fuzz/device_%.o
	$(call step,LINK,$@)
	$(Q)$(FUZZ_CC) -fsanitize=fuzzer,address,undefined -o $@ $^

.PHONY: fuzz-devices
.SECONDARY: $(DEVICE_TARGETS:%=$(FUZZ)/tests/fuzz/device_%.o)
