# vm.mk -- the kiosk before Debian's real kernels, in a machine made of software.

VM_BIN := $(BUILD)/tests/vm/hand $(BUILD)/tests/vm/look
# What the guest runs beside the kiosk. The static ones need nothing of it.
VM_STATIC := $(BUILD)/tests/vm/keeper $(BUILD)/tests/vm/as $(BUILD)/tests/vm/panel
VM_GUEST := $(VM_STATIC) $(BUILD)/tests/vm/lag

## test-vm: the kiosk on Debian's own kernel under qemu: USB poi, GPIO, screen, watchdog; GUEST=bookworm, trixie or arm64
test-vm:
	@tests/vm/ready.sh $(GUEST); case $$? in 0) ;; 1) exit 0 ;; *) exit 2 ;; esac; \
	$(MAKE) --no-print-directory -j$(JOBS) build $(BUILD)/kingyo-poi $(VM_BIN) && \
	BUILD=$(BUILD) GUEST=$(GUEST) tests/vm/test-vm.sh

vm-guest: $(BUILD)/kingyo $(BUILD)/kingyoctl $(BUILD)/kingyo-poi $(VM_GUEST)

$(VM_BIN): $(BUILD)/tests/vm/twin.o
$(VM_BIN) $(BUILD)/tests/vm/lag: %: %.o $(BUILD)/platform/panic.o $(BUILD)/shell.a $(BUILD)/core.a
	$(call step,LINK,$@)
	$(Q)$(CC) $(OPT) -g -o $@ $(filter %.o,$^) $(filter %.a,$^) $(HOST_LIBS)

$(VM_STATIC): %: %.o
	$(call step,LINK,$@)
	$(Q)$(CC) $(OPT) -g -static -o $@ $^ -lpthread

GUEST ?= bookworm
.PHONY: test-vm vm-guest
