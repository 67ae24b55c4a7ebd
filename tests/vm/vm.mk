# vm.mk -- the kiosk before Debian's real kernels, in a machine made of software.

VM_BIN := $(BUILD)/tests/vm/hand $(BUILD)/tests/vm/look

## test-vm: the kiosk on Debian's own kernel under qemu: USB poi, GPIO, screen, watchdog; GUEST=bookworm, trixie or arm64
test-vm:
	@tests/vm/ready.sh $(GUEST) || exit 0; \
	$(MAKE) --no-print-directory -j$(JOBS) build $(BUILD)/kingyo-poi $(VM_BIN) && \
	BUILD=$(BUILD) GUEST=$(GUEST) tests/vm/test-vm.sh

$(VM_BIN): %: %.o $(BUILD)/tests/vm/twin.o $(BUILD)/platform/panic.o $(BUILD)/shell.a $(BUILD)/core.a
	$(call step,LINK,$@)
	$(Q)$(CC) $(OPT) -g -o $@ $^ $(HOST_LIBS)

$(BUILD)/tests/vm/keeper: $(BUILD)/tests/vm/keeper.o
	$(call step,LINK,$@)
	$(Q)$(CC) $(OPT) -g -static -o $@ $^

GUEST ?= bookworm
.PHONY: test-vm
