# sql.mk -- converts the sections of each .sql file below platform to C strings. For example, the section settings of
# platform/store/sqlite/ledger.sql becomes sql_settings.

SQL_FILES := $(sort $(shell find platform -name '*.sql'))
SQL_BAKE := assets/bake/sql.awk assets/bake/sql.mk
SQL_HEADER := $(BUILD)/generated/sql_texts.h
SQL_C := $(SQL_FILES:%.sql=$(BUILD)/generated/sql/%_sql.c)
GENERATED_OBJ += $(SQL_C:%.c=%.o)

generated: $(SQL_HEADER)

$(SQL_HEADER): $(SQL_FILES) $(SQL_BAKE)
	@mkdir -p $(@D)
	$(Q){ echo '/* Made from the .sql files by assets/bake/sql.mk. */'; \
	  awk -f assets/bake/sql.awk -v header=1 $(SQL_FILES); } > $@

$(SQL_C): $(BUILD)/generated/sql/%_sql.c: %.sql $(SQL_BAKE)
	@mkdir -p $(@D)
	$(Q){ echo '#include "sql_texts.h"'; awk -f assets/bake/sql.awk $<; } > $@
