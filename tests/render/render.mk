# render.mk -- a look at the picture without playing.

$(BUILD)/tests/render/shot: $(BUILD)/tests/render/shot.o $(BUILD)/shell.a $(BUILD)/core.a
	$(call step,LINK,$@)
	$(Q)$(CC) $(OPT) -g -o $@ $^ $(HOST_LIBS)

## shot: a picture of the stall in out/shot.png; ARGS="--preset official --seconds 9 --size 1920x1080 --passes -o FILE"
shot: $(BUILD)/tests/render/shot
	@mkdir -p out
	@$< $(ARGS)

$(BUILD)/tests/render/film: $(BUILD)/tests/render/film.o $(BUILD)/shell.a $(BUILD)/core.a
	$(call step,LINK,$@)
	$(Q)$(CC) $(OPT) -g -o $@ $^ $(HOST_LIBS)

## film: twelve ticks of a C-start side by side in out/film.png; ARGS="-o FILE"
film: $(BUILD)/tests/render/film
	@mkdir -p out
	@$< $(ARGS)

# Three of the tank's moments side by side: gulping, a fan, a start.
PICTURE := out/pictures
## pictures: the tank page's picture, made anew (assets/pictures/fish.jpg); needs ImageMagick
pictures: $(BUILD)/tests/render/shot $(BUILD)/tests/render/film
	@mkdir -p $(PICTURE)
	@$(BUILD)/tests/render/shot --oxygen 1 --seconds 25 --plain --close 0.1,0,0.22 -o $(PICTURE)/gulp.png
	@$(BUILD)/tests/render/shot --seconds 14 --plain --fan 8,4 -o $(PICTURE)/fan.png
	@$(BUILD)/tests/render/film -o $(PICTURE)/film.png
	@convert \( $(PICTURE)/gulp.png -resize 800x450 \) \
	    \( $(PICTURE)/fan.png -crop 820x461+420+110 +repage -resize 800x450 \) +append $(PICTURE)/top.png
	@convert $(PICTURE)/film.png -crop 100%x33.4% +repage -resize 800x $(PICTURE)/row-%d.png
	@convert $(PICTURE)/row-0.png $(PICTURE)/row-1.png +append $(PICTURE)/strip.png
	@convert $(PICTURE)/top.png $(PICTURE)/strip.png -append -quality 86 assets/pictures/fish.jpg
	@echo 'assets/pictures/fish.jpg'

.PHONY: shot film pictures
