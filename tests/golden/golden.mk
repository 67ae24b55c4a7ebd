# golden.mk -- pictures for visual inspection.

# BACKDROP=still.png draws a still of the tank behind the text.
TEXT ?= 0
## picture/ui-shots: Draw every screen in both languages in out/ui/; TEXT=2: large texts
ui-shots: $(BUILD)/tests/golden/ui_shots
	@mkdir -p out/ui
	@$< out/ui $(TEXT) $(BACKDROP)

# The screens in four sizes and both languages, compared with the golden sheets in tests/golden. The
# scenes of tests/render/gallery.txt are compared, too. out/sheets/sheet.png shows all pictures. Mesa's
# llvmpipe draws on every machine, because another GPU rounds colours differently.
GALLERY = LIBGL_ALWAYS_SOFTWARE=1 GALLIUM_DRIVER=llvmpipe $(BUILD)/tests/golden/ui_shots out/sheets $(if $(KEEP),--keep,--compare) tests/golden
GALLERY_SCENES := $(shell awk '!/^\#/ && NF { print "out/gallery/" $$1 ".png" }' tests/render/gallery.txt)

## picture/gallery: Draw and compare all screens and twelve scenes; KEEP=1 keeps; BEFORE=DIR
gallery: $(BUILD)/tests/render/shot $(BUILD)/tests/v3d/gl_trace.so $(BUILD)/tests/golden/ui_shots
	@tests/render/gallery.sh $(BUILD) out/gallery
	@[ -z "$(BEFORE)" ] || tests/render/gallery.py $(BEFORE) out/gallery out/gallery-crops
	@mkdir -p out/sheets
	@$(GALLERY) $(GALLERY_SCENES)

## picture/ui-gallery: Draw and compare all screens without the scenes; KEEP=1 keeps
ui-gallery: $(BUILD)/tests/golden/ui_shots
	@mkdir -p out/sheets
	@$(GALLERY)

$(BUILD)/tests/golden/ui_shots: $(BUILD)/tests/golden/ui_shots.o $(BUILD)/tests/golden/golden_sheet.o \
    $(BUILD)/tests/golden/screens.o $(BUILD)/tests/render/shot_menu.o $(BUILD)/platform/panic_core.o $(BUILD)/shell.a $(BUILD)/core.a
	$(call step,LINK,$@)
	$(Q)$(CC) $(OPT) -g -o $@ $^ $(HOST_LIBS)

LAB_SHOT = $(BUILD)/tests/render/shot --seconds 3 --lab
ALBUM_SHOT = $(BUILD)/tests/render/shot --seconds 3 --album
## picture/lab-shots: Draw the growth lab with every species, and the album, in out/lab/
lab-shots: $(BUILD)/tests/render/shot
	@mkdir -p out/lab
	@for name in $(SPECIES); do \
	    $(LAB_SHOT) $$name --progress 0.4 -o out/lab/$$name.png && \
	    $(LAB_SHOT) $$name --progress 0.6 --path --compare --en -o out/lab/$$name-compare.png && \
	    $(LAB_SHOT) $$name --progress 0.8 --size 1080x1920 -o out/lab/$$name-upright.png || exit 1; \
	done
	@for fish in 1 3 6; do \
	    $(ALBUM_SHOT) $$fish --progress 0.6 -o out/lab/album-$$fish.png && \
	    $(ALBUM_SHOT) $$fish --progress 0.9 --size 1080x1920 --en -o out/lab/album-$$fish-upright.png || exit 1; \
	done

.PHONY: ui-shots gallery ui-gallery lab-shots
