# board.mk -- setting a machine up, and playing on it.

# A fresh machine's first command installs, then builds, then plays; the second only plays. The build
# is a second make because what it asks of pkg-config is only there after the set-up.

## run: plays; sets the machine up and builds first if it must; ARGS='--lang en' are for the kiosk
run:
	@board/setup.sh run
	+@$(MAKE) --no-print-directory -j$(JOBS) build
	@exec $(BUILD)/kingyo $(ARGS)

## setup: installs every package that playing, testing and developing need, saying why
setup:
	@board/setup.sh run test dev

JOBS ?= $(shell nproc)

.PHONY: run setup

-include board/poi-gadget/poi-gadget.mk
-include board/install.mk
-include board/image/image.mk
