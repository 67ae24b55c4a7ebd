# image.mk -- makes a disk image that starts the kiosk at power on.

IMAGE := $(BUILD)/image/$(BOARD)

# A board that names a processor other than amd64 is a Raspberry Pi, whose memory card card/card.sh makes.
card_arch = $(filter-out amd64,$(shell sed -n 's/^arch=//p' board/$(BOARD)/image.conf $(if $(filter poi,$(BOARD)),board/rpi4/image.conf)))
image_script = $(if $(card_arch),card/card.sh,image.sh)
# The programs on the disk: the packages, or the program of a poi.
image_programs = $(if $(filter poi,$(BOARD)),poi-gadget,deb)

## package/image: Build a bootable image; BOARD=vm, rpi4 or poi; UPDATE_KEY=FILE.pub
image:
	@board/setup.sh vm $(if $(card_arch),cross)
	@test -f board/$(BOARD)/image.conf || { \
	    echo 'image: no board/$(BOARD)/image.conf; BOARD is one of:' \
	    $(patsubst board/%/image.conf,%,$(wildcard board/*/image.conf)) >&2; exit 2; }
	+@$(MAKE) --no-print-directory BOARD=desktop -j$(JOBS) $(card_arch:%=ARCH=%) $(image_programs)
	@BUILD=$(BUILD) IMAGE=$(IMAGE) UPDATE_KEY='$(UPDATE_KEY)' board/image/$(image_script) $(BOARD)

# The package has the system of the last `make image`. A system without UPDATE_KEY would be the last one that a machine takes.
## package/update: Sign the last image as an update for a USB stick; SIGN_KEY=FILE
update:
	@board/setup.sh test
	@test -f '$(SIGN_KEY)' || { echo 'update: SIGN_KEY names no secret key of minisign' >&2; exit 2; }
	@test -f $(IMAGE)/root.sqfs || { echo 'update: no image; make image first' >&2; exit 2; }
	@unsquashfs -cat $(IMAGE)/root.sqfs usr/lib/kingyo/update.pub >/dev/null 2>&1 || { \
	    echo 'update: the image takes no updates; make image with UPDATE_KEY=FILE.pub first' >&2; exit 2; }
	@board/image/update/make_package.sh $(IMAGE)/root.sqfs \
	    "$$(sed -n 's/^board //p' $(IMAGE)/update-version)" "$$(sed -n 's/^version //p' $(IMAGE)/update-version)" \
	    "$$(sed -n 's/^name //p' $(IMAGE)/update-version)" '$(SIGN_KEY)' $(IMAGE)/kingyo-update
	@echo '  folder $(IMAGE)/kingyo-update; copy it to a USB stick (FAT32 or exFAT)'

.PHONY: image update
