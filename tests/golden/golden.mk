# golden.mk -- pictures for eyes.

# BACKDROP=still.png puts a still of the tank behind the words.
## ui-shots: pictures of every screen's words and signs, both languages, in out/ui/
ui-shots: $(BUILD)/tests/golden/ui_shots
	@mkdir -p out/ui
	@$< out/ui $(BACKDROP)

UI_OBJ := $(patsubst %.c,$(BUILD)/%.o,$(wildcard platform/render/text.c platform/render/ui*.c \
            platform/render/gl_util.c))

$(BUILD)/tests/golden/ui_shots: $(BUILD)/tests/golden/ui_shots.o $(UI_OBJ) $(GENERATED_OBJ)
	$(call step,LINK,$@)
	$(Q)$(CC) $(OPT) -g -o $@ $^ $(HOST_LIBS)

.PHONY: ui-shots
