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

.PHONY: shot film
