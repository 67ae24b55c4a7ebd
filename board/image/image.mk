# image.mk -- makes a disk image that starts the kiosk at power on.

IMAGE := $(BUILD)/image/$(BOARD)

## package/image: Build a bootable Debian disk image; BOARD=vm is for a virtual machine
image:
	@board/setup.sh vm
	@test -f board/$(BOARD)/image.conf || { \
	    echo 'image: no board/$(BOARD)/image.conf; BOARD is one of:' \
	    $(patsubst board/%/image.conf,%,$(wildcard board/*/image.conf)) >&2; exit 2; }
	+@$(MAKE) --no-print-directory BOARD=desktop -j$(JOBS) deb
	@BUILD=$(BUILD) IMAGE=$(IMAGE) board/image/image.sh $(BOARD)

.PHONY: image
