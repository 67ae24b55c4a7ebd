# board.mk -- sets up the machine and starts the kiosk.

# On a fresh machine, the first `make run` installs packages, builds and starts the kiosk. Later runs only start it. The
# build is a second make process, because pkg-config finds the new packages only after the set-up.

## play/run: Set up, build and start the game; ARGS='--lang en' are its options
run:
	@board/setup.sh run
	+@$(MAKE) --no-print-directory -j$(JOBS) build
	@exec $(BUILD)/kingyo $(ARGS)

## build/setup: Install every package for playing, testing and developing
setup:
	@board/setup.sh run test dev

## build/docs: Make HTML pages of the public headers in build/docs/ (Doxygen)
docs:
	@board/setup.sh dev
	@mkdir -p $(BUILD)/docs
	@{ cat board/docs/Doxyfile; echo 'OUTPUT_DIRECTORY = $(BUILD)/docs'; } | doxygen -
	@echo '  pages $(BUILD)/docs/html/index.html'

ARCHITECTURE := assets/pictures/architecture.svg

## build/architecture: Draw the folders and their includes (Graphviz)
architecture:
	@board/setup.sh dev
	+@$(MAKE) --no-print-directory -j$(JOBS) build
	@board/docs/architecture.py $(BUILD) $(ARCHITECTURE)
	@echo '  picture $(ARCHITECTURE)'

JOBS ?= $(shell nproc)

.PHONY: run setup docs architecture

-include board/poi-gadget/poi-gadget.mk
-include board/install.mk
-include board/image/image.mk
