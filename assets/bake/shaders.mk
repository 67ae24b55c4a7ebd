# shaders.mk -- converts each shader in assets/shaders to a C string. For example, fish.vert.glsl
# becomes shader_fish_vert.

SHADERS := $(sort $(wildcard assets/shaders/*.glsl))
SHADER_DIR := $(BUILD)/generated
SHADER_NAME = shader_$(subst .,_,$(basename $(notdir $(1))))
GENERATED_OBJ += $(SHADER_DIR)/shaders.o

generated: $(SHADER_DIR)/shaders.h

$(SHADER_DIR)/shaders.h: $(SHADERS) assets/bake/shaders.mk
	@mkdir -p $(@D)
	$(Q){ echo '/* Made from assets/shaders by assets/bake/shaders.mk. */'; \
	  $(foreach s,$(SHADERS),echo 'extern const char $(call SHADER_NAME,$(s))[];';) } > $@

# Comments are kept, so that line numbers in a driver's error message refer to the shader file.
$(SHADER_DIR)/shaders.c: $(SHADERS) assets/bake/shaders.mk
	@mkdir -p $(@D)
	$(Q){ echo '#include "shaders.h"'; \
	  $(foreach s,$(SHADERS),echo 'const char $(call SHADER_NAME,$(s))[] ='; \
	    sed -e 's/\\/\\\\/g' -e 's/"/\\"/g' -e 's/^/    "/' -e 's/$$/\\n"/' $(s); echo '    ;';) } > $@

$(SHADER_DIR)/shaders.o: $(SHADER_DIR)/shaders.c $(SHADER_DIR)/shaders.h $(FOUND)
	$(call step,CC,$<)
	$(Q)$(CC) $(HOST_CFLAGS) -c -o $@ $<
