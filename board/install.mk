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

.PHONY: man install uninstall deb
