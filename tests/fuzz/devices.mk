# devices.mk -- what controllers, coin slots and files about them may do to us, tried by libFuzzer under the
# address and undefined-behaviour sanitizers. Targets are pure: bytes in, checks out.

DEVICE_TARGETS := descriptor report rows poi_report
DEVICE_BIN := $(DEVICE_TARGETS:%=$(FUZZ)/device_%)
DEVICE_HID := $(patsubst %,$(FUZZ)/drivers/%.o,hid_descriptor hid_globals hid_item hid_report)
DEVICE_CTL := $(patsubst %,$(FUZZ)/platform/ctl/%.o,hid_file hid_rows)
DEVICE_POI := $(patsubst %,$(FUZZ)/%.o,drivers/poi_report core/base/fmath)

## fuzz-devices: hostile descriptors, reports, maps, wires and coins, FUZZ_SECONDS (30) each; counts in build/fuzz/devices.tsv
fuzz-devices:
	@board/setup.sh dev
	+@$(MAKE) --no-print-directory -j$(JOBS) $(DEVICE_BIN)
	@tests/fuzz/fuzz_devices.sh $(FUZZ) $(FUZZ_SECONDS) $(DEVICE_TARGETS)

$(FUZZ)/device_descriptor: $(DEVICE_HID)
$(FUZZ)/device_report: $(DEVICE_HID)
$(FUZZ)/device_rows: $(DEVICE_HID) $(DEVICE_CTL)
$(FUZZ)/device_poi_report: $(DEVICE_POI)
$(DEVICE_BIN): $(FUZZ)/device_%: $(FUZZ)/tests/fuzz/device_%.o
	$(call step,LINK,$@)
	$(Q)$(FUZZ_CC) -fsanitize=fuzzer,address,undefined -o $@ $^

.PHONY: fuzz-devices
.SECONDARY: $(DEVICE_TARGETS:%=$(FUZZ)/tests/fuzz/device_%.o)
