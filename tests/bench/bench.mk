# bench.mk -- measures the figures, each in one row with its command.

BENCH_BIN := $(BUILD)/tests/bench/bench_start $(BUILD)/tests/bench/bench_latency \
    $(BUILD)/tests/bench/bench_open $(BUILD)/tests/bench/bench_reports

## measure/bench: Print frame time, start, memory, latency and sizes; build/bench.tsv
bench:
	@board/setup.sh test
	+@$(MAKE) --no-print-directory -j$(JOBS) build $(BENCH_BIN) $(E2E_BIN) $(BUILD)/tests/sizes $(BUILD)/core.o
	@BUILD=$(BUILD) tests/bench/bench.sh

$(BENCH_BIN): %: %.o $(BUILD)/shell.a $(BUILD)/core.a
	$(call step,LINK,$@)
	$(Q)$(CC) $(OPT) -g -o $@ $^ $(HOST_LIBS)

# The benchmark of the tank uses the tank that is compiled for 131,072 fish
# (platform/ctl/tank/tank.mk).
BENCH_TANK := $(BUILD)/tests/bench/bench_tank
# The calls between modules that the benchmark measures. tests/bench/bench_tank.c wraps each of
# them.
BENCH_TANK_TIMED := swim_move_all broad_phase_mark broad_phase_sync broad_phase_is_stale broad_phase_select_contacts broad_phase_update \
    narrow_phase_begin narrow_phase_next contact_solver_project contact_solver_finish swim_settle_all oxygen_tick

## measure/bench-tank: Measure a tick with 50 to 100,000 fish; build/bench_tank.tsv
bench-tank:
	+@$(MAKE) --no-print-directory -j$(JOBS) $(BENCH_TANK) $(BUILD)/tests/sizes
	@tests/bench/bench_tank.sh $(BUILD)

UNCHECKED := $(BUILD)/without-assertions

## measure/bench-assertions: Count the instructions that assertions add to a tick of the tank
bench-assertions:
	+@$(MAKE) --no-print-directory -j$(JOBS) $(BENCH_TANK)
	+@$(MAKE) --no-print-directory -j$(JOBS) BUILD=$(UNCHECKED) OPT='$(OPT) -DCORE_WITHOUT_ASSERTIONS' \
	    $(UNCHECKED)/tests/bench/bench_tank
	@tests/bench/bench_assertions.sh $(BENCH_TANK) $(UNCHECKED)/tests/bench/bench_tank

$(BENCH_TANK): $(MANY)/bench_tank.o $(MANY_OBJ) $(BUILD)/platform/cpu.o $(BUILD)/platform/huge_pages.o $(GENERATED_CORE_OBJ)
	@mkdir -p $(@D)
	$(call step,LINK,$@)
	$(Q)$(CC) $(OPT) -g $(BENCH_TANK_TIMED:%=-Wl,--wrap=%) -o $@ $^ -lm

$(MANY)/bench_tank.o: tests/bench/bench_tank.c $(FOUND_TOOLS) | generated
	@mkdir -p $(@D)
	$(call step,CC,$<)
	$(Q)$(CC) $(BASE_CFLAGS) -Wno-psabi -D_GNU_SOURCE $(MANY_CFLAGS) $(DEP_FLAGS) -c -o $@ $<

BENCH_POI := $(BUILD)/tests/bench/bench_poi

## measure/bench-poi: Measure a tick of the paper with five fish on it
bench-poi:
	+@$(MAKE) --no-print-directory -j$(JOBS) $(BENCH_POI)
	@$(BENCH_POI) $(BUILD)/bench_poi.tsv

$(BENCH_POI): %: %.o $(BUILD)/core.a
	$(call step,LINK,$@)
	$(Q)$(CC) $(OPT) -g -o $@ $^ -lm

BENCH_MORPH := $(BUILD)/tests/bench/bench_morph

## measure/bench-morph: Measure the blending of 3, 5 and 8 key shapes against memory speed
bench-morph:
	+@$(MAKE) --no-print-directory -j$(JOBS) $(BENCH_MORPH)
	@$(BENCH_MORPH) $(BUILD)/bench_morph.tsv

$(BENCH_MORPH): %: %.o $(BUILD)/core.a
	$(call step,LINK,$@)
	$(Q)$(CC) $(OPT) -g -o $@ $^ -lm

BENCH_SOUND := $(BUILD)/tests/bench/bench_sound

## measure/bench-sound: Measure cost, loudness and spectrum of a round; build/bench_sound.wav
bench-sound:
	+@$(MAKE) --no-print-directory -j$(JOBS) $(BENCH_SOUND)
	@$(BENCH_SOUND) $(or $(PLAYERS),4) $(BUILD)/bench_sound.wav

$(BENCH_SOUND): %: %.o $(BUILD)/core.a
	$(call step,LINK,$@)
	$(Q)$(CC) $(OPT) -g -o $@ $^ -lm

BENCH_HID := $(BUILD)/tests/bench/bench_hid
BENCH_HID_SRC := $(patsubst %,drivers/hid/%.c,hid_descriptor hid_item)

## measure/bench-hid: Measure the time and memory of the slowest report descriptors
bench-hid:
	+@$(MAKE) --no-print-directory -j$(JOBS) $(BENCH_HID)
	@$(BENCH_HID) tests/hid $(BUILD)/bench_hid.tsv
	@for file in $(BENCH_HID_SRC); do $(CC) $(HOST_CFLAGS) -fstack-usage -c -o $(BUILD)/bench_hid.o $$file && \
	    cat $(BUILD)/bench_hid.su; done | sort -t"$$(printf '\t')" -k2 -nr | head -1 | \
	    awk -F'\t' '{ printf "  the deepest frame of the reader: %d bytes of stack (%s)\n", $$2, $$1 }'

$(BENCH_HID): %: %.o $(BUILD)/ctl.a $(BUILD)/shell.a $(BUILD)/core.a
	$(call step,LINK,$@)
	$(Q)$(CC) $(OPT) -g -o $@ $^ $(HOST_LIBS)

.PHONY: bench bench-tank bench-assertions bench-poi bench-sound bench-morph bench-hid

# Rounds of the bots on all cores, which take minutes. gnuplot draws pictures if it is installed
# (board/setup.sh dev).
BENCH_PLAY := $(BUILD)/tests/bench/technique $(BUILD)/tests/bench/scores
BENCH_PLOT = if command -v gnuplot >/dev/null; then gnuplot -e "dir='$(1)'" $(2) && echo "picture: $(3)"; \
    else echo 'no gnuplot, no picture'; fi
SEEDS ?= 200
FIRST ?= 0
ROUNDS ?= 200

## measure/bench-technique: Test whether good technique pays in SEEDS=200 paired rounds
bench-technique:
	+@$(MAKE) --no-print-directory -j$(JOBS) $(BUILD)/tests/bench/technique
	@mkdir -p $(BUILD)/technique
	@$(BUILD)/tests/bench/technique $(SEEDS) tests/bench/technique $(BUILD)/technique $(FIRST); code=$$?; \
	    [ $$code -gt 1 ] || { $(call BENCH_PLOT,$(BUILD)/technique,tests/bench/technique.gp,$(BUILD)/technique/technique.png); }; \
	    exit $$code

## measure/bench-scores: Compare the catches of bots with those of people; ROUNDS=200
bench-scores:
	+@$(MAKE) --no-print-directory -j$(JOBS) $(BUILD)/tests/bench/scores
	@mkdir -p $(BUILD)/scores
	@$(BUILD)/tests/bench/scores $(ROUNDS) $(BUILD)/scores; code=$$?; \
	    [ $$code -gt 1 ] || { $(call BENCH_PLOT,$(BUILD)/scores,tests/bench/scores.gp,$(BUILD)/scores/scores.png); }; \
	    exit $$code

$(BENCH_PLAY): %: %.o $(BUILD)/tests/bench/league.o $(BUILD)/tests/bench/progress.o $(BUILD)/tests/bench/statistics.o \
    $(BUILD)/ctl.a $(BUILD)/shell.a $(BUILD)/core.a
	$(call step,LINK,$@)
	$(Q)$(CC) $(OPT) -g -o $@ $^ $(HOST_LIBS)

# Simulated players with the habits of visitors, through the decoders of their input devices.
BENCH_PLAYERS := $(BUILD)/tests/bench/players/players
PERSON_OBJ := $(patsubst %,$(BUILD)/tests/bench/players/%.o,sim_player habits device person) \
    $(BUILD)/tests/bench/progress.o
PLAYERS_OBJ := $(PERSON_OBJ) $(patsubst %,$(BUILD)/tests/bench/players/%.o,round round_pool goals) $(BUILD)/tests/bench/statistics.o
LEVEL ?= master
bench-players: SEEDS = 60

## measure/bench-players: Measure the catches of visitors; SEEDS=60, LEVEL=master, ONLY=a,b
bench-players:
	+@$(MAKE) --no-print-directory -j$(JOBS) $(BENCH_PLAYERS)
	@mkdir -p $(BUILD)/players
	@$(BENCH_PLAYERS) $(SEEDS) $(BUILD)/players --level $(LEVEL) --first $(FIRST) --only '$(ONLY)'

$(BENCH_PLAYERS): %: %.o $(PLAYERS_OBJ) $(BUILD)/ctl.a $(BUILD)/shell.a $(BUILD)/core.a
	$(call step,LINK,$@)
	$(Q)$(CC) $(OPT) -g -o $@ $^ $(HOST_LIBS)

# Pairs of such visitors, one of whom follows an aid on the screen.
BENCH_HINTS := $(BUILD)/tests/bench/players/hints
bench-hints: SEEDS = 60
bench-hints: LEVEL = normal

## measure/bench-hints: Prove each aid for players in SEEDS=60 paired rounds; LEVEL=normal
bench-hints:
	+@$(MAKE) --no-print-directory -j$(JOBS) $(BENCH_HINTS)
	@$(BENCH_HINTS) $(SEEDS) $(LEVEL) $(SIGN)

$(BENCH_HINTS): %: %.o $(BUILD)/tests/bench/players/pupils.o $(PLAYERS_OBJ) $(BUILD)/ctl.a $(BUILD)/shell.a $(BUILD)/core.a
	$(call step,LINK,$@)
	$(Q)$(CC) $(OPT) -g -o $@ $^ $(HOST_LIBS)

# A day of such visitors at one kiosk, with a queue and coins.
BENCH_DAY := $(BUILD)/tests/bench/day/bench_day
DAY_OBJ := $(PERSON_OBJ) $(patsubst %,$(BUILD)/tests/bench/day/%.o,visitor day table report)
bench-day: LEVEL = normal

## measure/bench-day: Simulate a day of visitors at a kiosk; LEVEL, PLAYERS, PRICE, ROUND
bench-day:
	+@$(MAKE) --no-print-directory -j$(JOBS) $(BENCH_DAY)
	@mkdir -p $(BUILD)/day
	@$(BENCH_DAY) $(BUILD)/day --price $(or $(PRICE),1) --round $(or $(ROUND),60) --level $(LEVEL) \
	    --players $(or $(PLAYERS),1) --visitors $(or $(VISITORS),200) --seed $(or $(SEED),0) \
	    --hours $(or $(HOURS),8) --goal $(or $(GOAL),90)

$(BENCH_DAY): %: %.o $(DAY_OBJ) $(BUILD)/ctl.a $(BUILD)/shell.a $(BUILD)/core.a
	$(call step,LINK,$@)
	$(Q)$(CC) $(OPT) -g -o $@ $^ $(HOST_LIBS)

.PHONY: bench-technique bench-scores bench-players bench-hints bench-day
