# install.mk -- installs the kiosk as a service, directly or by Debian packages.

PREFIX ?= /usr/local
DESTDIR ?=

MAN := $(BUILD)/man/kingyo.6 $(BUILD)/man/kingyoctl.1 $(BUILD)/man/kingyo.conf.5 $(BUILD)/man/kingyo.conf

## build/man: Build the manual pages and the example kingyo.conf in build/man/
man: $(MAN)

$(BUILD)/man/kingyo.conf: $(BUILD)/kingyoctl
	@mkdir -p $(@D)
	$(call step,MAN,$@)
	$(Q)$< config defaults >$@

$(BUILD)/man/%: board/man/%.in board/man/fill.sh $(BUILD)/kingyo $(BUILD)/kingyoctl
	@mkdir -p $(@D)
	$(call step,MAN,$@)
	$(Q)BUILD='$(BUILD)' board/man/fill.sh $< >$@

tests: $(MAN)

## package/install: Install below PREFIX=/usr/local; DESTDIR= names another root
install: build $(MAN)
	@DESTDIR='$(DESTDIR)' PREFIX='$(PREFIX)' BUILD='$(BUILD)' board/install.sh install

## package/uninstall: Remove the installed files; settings and takings stay
uninstall:
	@DESTDIR='$(DESTDIR)' PREFIX='$(PREFIX)' BUILD='$(BUILD)' board/install.sh uninstall

## package/deb: Build the Debian packages in build/deb/; ARCH=arm64 or armhf
ifneq ($(FOREIGN),)
deb:
	@$(cross) deb
else
deb: build $(MAN)
	@BUILD='$(BUILD)' board/deb/deb.sh
endif

## test/test-deb: Install, upgrade and purge the packages in a minimal root; ARCH=arm64
test-deb: build $(MAN)
	@board/setup.sh dev $(if $(FOREIGN),cross)
	@ARCH='$(FOREIGN)' BUILD='$(BUILD)' tests/fresh/deb.sh $(RELEASE)

## test/test-pi-os: Run the commands of the cabinet's page in an emulated arm64 root
test-pi-os:
	@board/setup.sh dev cross
	@$(MAKE) --no-print-directory ARCH=arm64 deb
	@BUILD='$(BUILD)' tests/fresh/pi_os.sh rpi5

.PHONY: test-deb test-pi-os man install uninstall deb
