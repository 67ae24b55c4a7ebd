# golden.mk -- pictures for eyes.

# BACKDROP=still.png puts a still of the tank behind the words.
## ui-shots: pictures of every screen's words and signs, both languages, in out/ui/
ui-shots: $(BUILD)/tests/golden/ui_shots
	@mkdir -p out/ui
	@$< out/ui $(BACKDROP)

$(BUILD)/tests/golden/ui_shots: $(BUILD)/tests/golden/ui_shots.o $(BUILD)/platform/panic.o \
    $(BUILD)/shell.a $(BUILD)/core.a
	$(call step,LINK,$@)
	$(Q)$(CC) $(OPT) -g -o $@ $^ $(HOST_LIBS)

.PHONY: ui-shots
