# install.mk -- the stall as a service of its machine, by hand or as Debian packages.

PREFIX ?= /usr/local
DESTDIR ?=

## install: programs, manual, service, rules below PREFIX=/usr/local (DESTDIR= for a root elsewhere)
install: build
	@DESTDIR='$(DESTDIR)' PREFIX='$(PREFIX)' BUILD='$(BUILD)' board/install.sh install

## uninstall: takes away what install put there; settings and takings stay
uninstall:
	@DESTDIR='$(DESTDIR)' PREFIX='$(PREFIX)' BUILD='$(BUILD)' board/install.sh uninstall

## deb: Debian packages, kingyo and kingyo-kiosk, into build/deb/
deb: build
	@BUILD='$(BUILD)' board/deb/deb.sh

.PHONY: install uninstall deb
