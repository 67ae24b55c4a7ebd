# render.mk -- makes pictures of the game without playing.

SHOT_PARTS := shot shot_options shot_scene shot_menu
$(BUILD)/tests/render/shot: $(SHOT_PARTS:%=$(BUILD)/tests/render/%.o) $(BUILD)/shell.a \
    $(BUILD)/core.a
	$(call step,LINK,$@)
	$(Q)$(CC) $(OPT) -g -o $@ $^ $(HOST_LIBS)

# --start presses START after half a second. --mode NAME enables only that mode, and --choose
# enables all three. --players N sets the number of bots. --follow M views the first poi from a
# distance of M metres. --closer shows the moving camera of a round with one player. --paper shows a
# poi with --stress, --water MM, --tilt DEGREES and --owner N. --heel DEGREES tilts the bowls.
# --careless plays with a bot that wets half the paper and pushes it. --lab SPECIES --progress P
# shows the growth lab with --compare, --path or --size-layer. --album N --progress P shows the
# album with N fish. --menu PAGE --step N shows a page of the operator's menu. --coins N sets the
# price of a round. --rotation QUARTERS, --inset and --shift THOUSANDTHS and --light PERCENT
# transform the picture on the screen. --frames N --every S draws N pictures, S seconds apart.
# --steps writes the name of each render step on standard error. --quality-step N lowers the quality
# by N steps.
## picture/shot: Play and keep a frame in out/shot.png; ARGS="--players 4"
shot: $(BUILD)/tests/render/shot
	@mkdir -p out
	@$< $(ARGS)

## picture/strips: Draw ten frames of entry, tear, catch, pour and escape in out/strips
strips: $(BUILD)/tests/render/shot
	@tests/render/strips.sh $(BUILD) out/strips

$(BUILD)/tests/render/film: $(BUILD)/tests/render/film.o $(BUILD)/shell.a $(BUILD)/core.a
	$(call step,LINK,$@)
	$(Q)$(CC) $(OPT) -g -o $@ $^ $(HOST_LIBS)

## picture/film: Draw twelve ticks of a startled fish side by side in out/film.png
film: $(BUILD)/tests/render/film
	@mkdir -p out
	@$< $(ARGS)

$(BUILD)/tests/render/specimen: $(BUILD)/tests/render/specimen.o $(BUILD)/platform/panic_core.o \
    $(BUILD)/shell.a $(BUILD)/core.a
	$(call step,LINK,$@)
	$(Q)$(CC) $(OPT) -g -o $@ $^ $(HOST_LIBS)

## picture/specimen: Draw a species at any age; ARGS="--species hirame"
specimen: $(BUILD)/tests/render/specimen
	@mkdir -p out
	@$< $(ARGS)

PICTURE := out/pictures
## picture/pictures: Draw the pictures of the README pages (needs ImageMagick)
pictures: fish-pictures game-pictures growth-picture lab-pictures menu-picture manual-pictures moving-picture stall-picture

GL_MEMORY := $(BUILD)/tests/render/gl_memory.so
$(GL_MEMORY): tests/render/gl_memory.c
	$(call step,LINK,$@)
	@mkdir -p $(@D)
	$(Q)$(CC) -std=c17 -O1 -Wall -Wextra -shared -fPIC -o $@ $<

## measure/bench-gpu-memory: Count the memory of textures and buffers with a V3D's quality
bench-gpu-memory: $(BUILD)/tests/render/shot $(GL_MEMORY) $(BUILD)/tests/v3d/gl_trace.so
	@for scene in '1280x720 festival 1' '1280x720 championship 4' '1920x1080 festival 1'; do \
	    set -- $$scene; echo "$$1, $$2, players: $$3"; \
	    LD_PRELOAD="$(GL_MEMORY) $(BUILD)/tests/v3d/gl_trace.so" GL_TRACE_RENDERER=V3D $< --size $$1 --mode $$2 \
	        --players $$3 --start --seconds 3 -o $(BUILD)/gpu_memory.png 2>$(BUILD)/gpu_memory.log || \
	        { tail -1 $(BUILD)/gpu_memory.log; exit 1; }; done
.PHONY: bench-gpu-memory

# The choice of a mode, a championship of four players, and paper under a big fish in practice
# mode. Bots play, so a change of the physics moves the moments. Check the pictures before you keep
# them.
game-pictures: $(BUILD)/tests/render/shot
	@mkdir -p $(PICTURE)
	@$< --choose --seconds 3 -o $(PICTURE)/choose.png
	@$< --mode championship --players 4 --start --seconds 66.2 -o $(PICTURE)/championship.png
	@$< --mode practice --start --seed 3 --seconds 33 --follow 0.27 -o $(PICTURE)/practice.png
	@for name in choose championship practice; do \
	    convert $(PICTURE)/$$name.png -resize 1120x -quality 88 assets/pictures/$$name.jpg; \
	    echo "assets/pictures/$$name.jpg"; done

# Three moments of the tank side by side: fish that breathe at the surface, a fan, and a startle.
fish-pictures: $(BUILD)/tests/render/shot $(BUILD)/tests/render/film
	@mkdir -p $(PICTURE)
	@$(BUILD)/tests/render/shot --oxygen 1 --seconds 25 --plain --close 0.1,0,0.22 -o $(PICTURE)/gulp.png
	@$(BUILD)/tests/render/shot --seconds 24 --plain --fan 8,4 -o $(PICTURE)/fan.png
	@$(BUILD)/tests/render/film -o $(PICTURE)/film.png
	@convert \( $(PICTURE)/gulp.png -resize 800x450 \) \
	    \( $(PICTURE)/fan.png -crop 820x461+420+110 +repage -resize 800x450 \) +append $(PICTURE)/top.png
	@convert $(PICTURE)/film.png -crop 100%x33.4% +repage -resize 800x $(PICTURE)/row-%d.png
	@convert $(PICTURE)/row-0.png $(PICTURE)/row-1.png +append $(PICTURE)/strip.png
	@convert $(PICTURE)/top.png $(PICTURE)/strip.png -append -quality 86 assets/pictures/fish.jpg
	@echo 'assets/pictures/fish.jpg'

# All species from hatchling to adult, one in each row, as the growth lab shows them.
growth-picture: $(BUILD)/tests/render/specimen
	@mkdir -p $(PICTURE)
	@$< --cell 420x250 -o $(PICTURE)/growth.png
	@convert $(PICTURE)/growth.png -resize 1120x -quality 88 assets/pictures/growth.jpg
	@echo 'assets/pictures/growth.jpg'

# The lab in the middle of the metamorphosis of hirame, and six fish of a catch at half their life.
# A third picture shows three forms of hirame from the figures of the 2005 thesis.
lab-pictures: $(BUILD)/tests/render/shot thesis-figures-2005
	@mkdir -p $(PICTURE)
	@$< --lab hirame --progress 0.22 --en --path -o $(PICTURE)/lab.png
	@$< --album 6 --progress 0.45 --en -o $(PICTURE)/album.png
	@for name in lab album; do \
	    convert $(PICTURE)/$$name.png -resize 1120x -quality 88 assets/pictures/$$name.jpg; \
	    echo "assets/pictures/$$name.jpg"; done
	@convert build/thesis-2005/figure-4.14-three-ways.png -resize 1120x -quality 86 assets/pictures/hirame.jpg
	@echo 'assets/pictures/hirame.jpg'

# The operator's device page: a controller that is being learned, and a test of buttons and coins.
menu-picture: $(BUILD)/tests/render/shot
	@mkdir -p $(PICTURE)
	@$< --menu learn --step 3 --en -o $(PICTURE)/learn.png
	@$< --menu lines --en -o $(PICTURE)/lines.png
	@convert $(PICTURE)/learn.png $(PICTURE)/lines.png -resize 800x +append -quality 86 assets/pictures/menu.jpg
	@echo 'assets/pictures/menu.jpg'

# Eight seconds of a round of the bot, from a recording that the kiosk writes as a video.
MOVING_FROM_S := 16
moving-picture: $(BUILD)/kingyo
	@mkdir -p $(PICTURE)
	@rm -f $(PICTURE)/round.kgr
	@$< --demo 30 --seed 7 --window 320x240 --shots $(PICTURE)/round --record $(PICTURE)/round.kgr >/dev/null
	@$< --replay $(PICTURE)/round.kgr --window 960x540 --video $(PICTURE)/round.mp4
	@ffmpeg -nostdin -v error -y -ss $(MOVING_FROM_S) -t 8 -i $(PICTURE)/round.mp4 -vf fps=12,scale=560:-2 \
	    -c:v libwebp_anim -loop 0 -quality 40 -compression_level 6 assets/pictures/round.webp
	@echo 'assets/pictures/round.webp'

# The kiosk as its operator configures it: the money page, a name that is entered, and the ranking.
stall-picture: $(BUILD)/tests/render/shot ui-shots
	@$< --menu money --en -o $(PICTURE)/money.png
	@convert $(PICTURE)/money.png out/ui/name_ja_1280x720.png out/ui/wall_ja_1280x720.png -resize 640x +append \
	    -quality 86 assets/pictures/stall.jpg
	@echo 'assets/pictures/stall.jpg'

# Pictures of the operator's manual: two pages of the menu side by side, each as PAGE or PAGE@STEP.
MANUAL_PICTURES := menu:top:money picture:picture:card ranking:ranking:score books:earnings:hours \
    lines:lines:axes upkeep:files:about calibration:calibration@3:calibration@6 \
    selftest:selftest:machine update:upkeep:update

## picture/manual-pictures: Draw the pictures of the manual (needs ImageMagick)
manual-pictures: $(BUILD)/tests/render/shot
	@mkdir -p $(PICTURE)
	@set -e; for row in $(MANUAL_PICTURES); do IFS=: read -r name left right <<<"$$row"; \
	    for page in $$left $$right; do step=$${page#*@}; [ "$$step" != "$$page" ] || step=0; \
	        $< --menu $${page%@*} --step $$step --en -o $(PICTURE)/$$page.png >/dev/null; done; \
	    convert $(PICTURE)/$$left.png $(PICTURE)/$$right.png -resize 800x +append -quality 86 \
	        assets/pictures/manual-$$name.jpg; \
	    echo "assets/pictures/manual-$$name.jpg"; done

.PHONY: strips stall-picture manual-pictures menu-picture lab-pictures growth-picture shot film specimen pictures fish-pictures game-pictures
