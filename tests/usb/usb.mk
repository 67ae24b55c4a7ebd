# usb.mk -- tests the USB transport with a simulated bus (tests/unit/support/usb/usb_sim.h), also
# under the sanitizers.

USB_TESTS := usb_transport usb_reports usb_unplug usb_many usb_ring usb_choice usb_kind usb_sysfs usb_wait
USB_SIM := usb_sim usb_sim_lib usb_sim_open

# The simulated bus defines libusb's functions, because the linker prefers definitions of the
# program to those of libraries.
$(patsubst %,$(BUILD)/tests/unit/drivers/usb/test_%,$(USB_TESTS) usb_play) \
    $(BUILD)/tests/unit/board/desktop/test_board_usb: $(USB_SIM:%=$(BUILD)/tests/unit/support/usb/%.o)
.SECONDARY: $(USB_SIM:%=$(BUILD)/tests/unit/support/usb/%.o)

# The same tests with all code under the address and undefined-behaviour sanitizers, and again
# under the thread sanitizer.
USB_SAN := $(BUILD)/usb
USB_SAN_SRC := $(wildcard drivers/usb/*.c) $(patsubst %,drivers/hid/%.c,hid_descriptor hid_item \
    hid_mapping hid_mapping_auto hid_port poi_report) core/base/fmath.c core/base/printable.c platform/os/clock.c \
    platform/os/file.c platform/os/thread.c $(USB_SIM:%=tests/unit/support/usb/%.c) \
    tests/unit/support/panic.c
USB_SAN_BIN := $(foreach t,$(USB_TESTS),$(USB_SAN)/address/test_$(t) $(USB_SAN)/thread/test_$(t))
USB_SAN_CFLAGS := -std=c17 -O1 -g $(WARN) -D_GNU_SOURCE -I. -fno-sanitize-recover=all
USB_FLAGS = $(eval USB_FLAGS := $$(patsubst -I%,-isystem %,$$(shell pkg-config --cflags libusb-1.0)))$(USB_FLAGS)

## test/test-usb-sanitizers: Test unplugging and hot-plug storms under the sanitizers
test-usb-sanitizers: $(USB_SAN_BIN)
	@tests/run.sh $(USB_SAN)/address $(filter $(USB_SAN)/address/%,$(USB_SAN_BIN))
	@tests/run.sh $(USB_SAN)/thread $(filter $(USB_SAN)/thread/%,$(USB_SAN_BIN))

$(USB_SAN)/address/%: SANITIZE := -fsanitize=address,undefined
$(USB_SAN)/thread/%: SANITIZE := -fsanitize=thread
$(USB_SAN)/address/test_%: $(USB_SAN)/address/tests/unit/drivers/usb/test_%.o $(USB_SAN_SRC:%.c=$(USB_SAN)/address/%.o)
	$(call step,LINK,$@)
	$(Q)$(CC) $(SANITIZE) -o $@ $^ -lcmocka -lpthread -lm
$(USB_SAN)/thread/test_%: $(USB_SAN)/thread/tests/unit/drivers/usb/test_%.o $(USB_SAN_SRC:%.c=$(USB_SAN)/thread/%.o)
	$(call step,LINK,$@)
	$(Q)$(CC) $(SANITIZE) -o $@ $^ -lcmocka -lpthread -lm
$(USB_SAN)/address/%.o: %.c $(FOUND)
	@mkdir -p $(@D)
	$(call step,CC,$< (address))
	$(Q)$(CC) $(USB_SAN_CFLAGS) $(USB_FLAGS) $(SANITIZE) $(DEP_FLAGS) -c -o $@ $<
$(USB_SAN)/thread/%.o: %.c $(FOUND)
	@mkdir -p $(@D)
	$(call step,CC,$< (thread))
	$(Q)$(CC) $(USB_SAN_CFLAGS) $(USB_FLAGS) $(SANITIZE) $(DEP_FLAGS) -c -o $@ $<

.PHONY: test-usb-sanitizers
.SECONDARY: $(USB_SAN_SRC:%.c=$(USB_SAN)/address/%.o) $(USB_SAN_SRC:%.c=$(USB_SAN)/thread/%.o) \
    $(foreach t,$(USB_TESTS),$(USB_SAN)/address/tests/unit/drivers/usb/test_$(t).o $(USB_SAN)/thread/tests/unit/drivers/usb/test_$(t).o)

## measure/bench-usb: Measure the delay of a USB report until its frame; SECONDS=10
bench-usb: $(BUILD)/tests/bench/bench_usb
	@$< $(or $(SECONDS),10)

$(BUILD)/tests/bench/bench_usb: %: %.o $(USB_SIM:%=$(BUILD)/tests/unit/support/usb/%.o) $(BUILD)/shell.a $(BUILD)/core.a
	$(call step,LINK,$@)
	$(Q)$(CC) $(OPT) -g -o $@ $^ $(HOST_LIBS)

.PHONY: bench-usb
