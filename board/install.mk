# install.mk -- the stall as a service of its machine, by hand or as Debian packages.

PREFIX ?= /usr/local
DESTDIR ?=

MAN := $(BUILD)/man/kingyo.6 $(BUILD)/man/kingyoctl.1 $(BUILD)/man/kingyo.conf.5 $(BUILD)/man/kingyo.conf

## man: the manual pages and the example of kingyo.conf, filled with what the programs say, in build/man/
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

## install: programs, manual, service, rules below PREFIX=/usr/local (DESTDIR= for a root elsewhere)
install: build $(MAN)
	@DESTDIR='$(DESTDIR)' PREFIX='$(PREFIX)' BUILD='$(BUILD)' board/install.sh install

## uninstall: takes away what install put there; settings and takings stay
uninstall:
	@DESTDIR='$(DESTDIR)' PREFIX='$(PREFIX)' BUILD='$(BUILD)' board/install.sh uninstall

## deb: Debian packages, kingyo and kingyo-kiosk, into build/deb/
deb: build $(MAN)
	@BUILD='$(BUILD)' board/deb/deb.sh

## test-deb: installs, upgrades, removes and purges the packages in a minimal root; needs root and a mirror
test-deb: build $(MAN)
	@board/setup.sh dev
	@BUILD='$(BUILD)' tests/fresh/deb.sh $(RELEASE)

.PHONY: test-deb man install uninstall deb
