# vm.mk -- tests of the kiosk with Debian's real kernels, in an emulated machine.

VM_BIN := $(BUILD)/tests/vm/scoop_planner $(BUILD)/tests/vm/state_writer $(BUILD)/tests/vm/image/witness
# Programs that run in the guest beside the kiosk. The static programs need no library of the
# guest.
VM_STATIC := $(BUILD)/tests/vm/watchdog_host $(BUILD)/tests/vm/as $(BUILD)/tests/vm/panel \
    $(BUILD)/tests/vm/image/hold
VM_GUEST := $(VM_STATIC) $(BUILD)/tests/vm/lag
# Release of the kernel of the disk image (board/image/root.sh).
IMAGE_KERNEL := $(BUILD)/image/bookworm-amd64/kernel/release

# Make runs a line that contains the name MAKE even in a dry run (make -n). The lines below also start
# virtual machines, so they use this name.
run_make = $(MAKE) --no-print-directory

# The disk image has Debian 12, so only that guest also runs test-image.
## test/test-vm: Run the kiosk in QEMU; GUEST=bookworm|trixie|arm64, IMAGE=no: no disk
test-vm:
	@tests/vm/ready.sh $(GUEST); case $$? in 0) ;; 1) exit 0 ;; *) exit 2 ;; esac; \
	$(run_make) -j$(JOBS) build $(BUILD)/kingyo-poi $(VM_BIN) && \
	BUILD=$(BUILD) GUEST=$(GUEST) tests/vm/test-vm.sh && \
	{ [ $(GUEST) != bookworm ] || [ "$(IMAGE)" = no ] || $(run_make) PARTS=round test-image; }

## test/test-image: Boot the disk image: a round, faults, intruders; PARTS=...
test-image:
	@tests/vm/ready.sh bookworm; case $$? in 0) ;; 1) exit 0 ;; *) exit 2 ;; esac; \
	$(run_make) BOARD=vm image && \
	$(run_make) -j$(JOBS) vm-guest $(VM_BIN) && \
	BUILD=$(BUILD) GUEST=bookworm IMAGE_KERNEL=$(IMAGE_KERNEL) tests/vm/prepare.sh && \
	BUILD=$(BUILD) tests/vm/image/test-image.sh

# The programs of the guest are those of the root of `make deb ARCH=arm64`. MACHINES='parts raspi3b' runs two of the machines.
## test/test-board: Boot the cards in emulated boards; MACHINES=..., COUNT=3 power cuts
test-board: MACHINES ?= parts raspi3b virt power selftest poi
test-board: COUNT ?= 3
test-board:
	@tests/vm/ready.sh arm64; case $$? in 0) ;; 1) exit 0 ;; *) exit 2 ;; esac; \
	$(run_make) BOARD=rpi4 image && \
	$(run_make) -j$(JOBS) BOARD=desktop $(VM_BIN) $(BUILD)/tests/vm/image/cut && \
	BUILD=$(BUILD) board/deb/cross.sh arm64 vm-guest && \
	{ [ -z "$(findstring poi,$(MACHINES))" ] || $(run_make) BOARD=poi image; } && \
	BUILD=$(BUILD) MACHINES='$(MACHINES)' COUNT=$(COUNT) tests/vm/board/test-board.sh

## test/test-firmware: Boot the disk image by UEFI firmware alone
test-firmware:
	@tests/vm/ready.sh bookworm; case $$? in 0) ;; 1) exit 0 ;; *) exit 2 ;; esac; \
	$(run_make) BOARD=vm image && BUILD=$(BUILD) tests/vm/image/test-firmware.sh

update_card = $(filter rpi4,$(BOARD))
## test/test-update: Update a disk from USB sticks; BOARD=rpi4, PARTS=..., COUNT=200 cuts
test-update: COUNT ?= 200
test-update:
	@board/setup.sh test
	@tests/vm/ready.sh $(if $(update_card),arm64,bookworm); case $$? in 0) ;; 1) exit 0 ;; *) exit 2 ;; esac; \
	mkdir -p $(BUILD)/vm && { test -f $(BUILD)/vm/update.key || \
	    minisign -G -W -p $(BUILD)/vm/update.pub -s $(BUILD)/vm/update.key >/dev/null; } && \
	$(run_make) BOARD=$(or $(update_card),vm) UPDATE_KEY=$(BUILD)/vm/update.pub image && \
	$(run_make) -j$(JOBS) BOARD=desktop vm-guest $(VM_BIN) $(BUILD)/tests/vm/image/cut && \
	$(if $(update_card),BUILD=$(BUILD) board/deb/cross.sh arm64 vm-guest && BUILD=$(BUILD) tests/vm/board/modules.sh, \
	    BUILD=$(BUILD) GUEST=bookworm IMAGE_KERNEL=$(IMAGE_KERNEL) tests/vm/prepare.sh) && \
	BUILD=$(BUILD) CARD=$(update_card) COUNT=$(COUNT) SEED=$(SEED) tests/vm/image/test-update.sh

## test/test-kills: Cut the power of a virtual machine KILLS=50 times while coins fall
test-kills: KILLS ?= 50
test-kills:
	@tests/vm/ready.sh bookworm; case $$? in 0) ;; 1) exit 0 ;; *) exit 2 ;; esac; \
	$(run_make) BOARD=vm image && \
	$(run_make) -j$(JOBS) vm-guest $(VM_BIN) $(BUILD)/tests/vm/image/cut && \
	BUILD=$(BUILD) GUEST=bookworm IMAGE_KERNEL=$(IMAGE_KERNEL) tests/vm/prepare.sh && \
	BUILD=$(BUILD) KILLS=$(KILLS) tests/vm/image/kills.sh

vm-guest: $(BUILD)/kingyo $(BUILD)/kingyoctl $(BUILD)/kingyo-poi $(VM_GUEST)

$(VM_BIN): $(BUILD)/tests/vm/twin.o
$(VM_BIN) $(BUILD)/tests/vm/lag: %: %.o $(BUILD)/platform/panic_core.o $(BUILD)/shell.a $(BUILD)/core.a
	$(call step,LINK,$@)
	$(Q)$(CC) $(OPT) -g -o $@ $(filter %.o,$^) $(filter %.a,$^) $(HOST_LIBS)

$(VM_STATIC) $(BUILD)/tests/vm/image/cut: %: %.o
	$(call step,LINK,$@)
	$(Q)$(CC) $(OPT) -g -static -o $@ $^ -lpthread

GUEST ?= bookworm
.PHONY: test-vm test-image test-board test-firmware test-update test-kills vm-guest
