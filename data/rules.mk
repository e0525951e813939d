# The rules of an example: model files -> blocks -> run -> pictures. The Makefile of each example includes this file.
#
#   slope.toml -> slope.blocks           blockgen    geometry: redone when the joints change
#   run.toml, slope.blocks -> out/       dda-run     mechanics: redone when strengths, stages or the record change
#   out/ -> pictures/                    dda-plot
#
# make [all]          everything            make blocks    only the cutting
# make pictures       drawings              make run       only the analysis
# make clean          removes all results   make RECORD=x  another accelerogram (PEER AT2 or two-column CSV)
#
# BIN is the folder of the programs, OUT the folder of the results. BLOCKGEN_FLAGS and RUN_FLAGS are passed to the
# programs; THREADS is the number of threads of a run, one under make -j unless it is set. E.g.
#   make OUT=out-weak RUN_FLAGS="--set joint_material.bedding.friction_angle='28 deg'"

BIN ?= ../../build/release/bin
OUT ?= out
PICTURES ?= pictures
BLOCKGEN ?= $(BIN)/blockgen
DDA_RUN ?= $(BIN)/dda-run
DDA_PLOT ?= $(BIN)/dda-plot

.PHONY: all blocks run pictures clean
.SUFFIXES:

all: pictures
blocks: slope.blocks
run: $(OUT)/summary.json

slope.blocks: slope.toml $(wildcard $(BLOCKGEN))
	@mkdir -p $(PICTURES)
	$(BLOCKGEN) slope.toml -o $@ --depfile slope.blocks.d --picture $(PICTURES)/blocks.png --report slope.report.json \
	    $(BLOCKGEN_FLAGS)

# A file with the options of the run. It is rewritten only when the options change, so that make repeats the run.
RUN_OPTIONS = $(if $(RECORD),--set 'stage[$(SHAKEN_STAGE)].base_motion.x.file="$(abspath $(RECORD))"') $(RUN_FLAGS)
$(OUT)/options: force
	@mkdir -p $(OUT)
	@printf '%s\n' $(call quoted,$(RUN_OPTIONS)) | cmp -s - $@ || printf '%s\n' $(call quoted,$(RUN_OPTIONS)) >$@
quoted = '$(subst ','\'',$(1))'
.PHONY: force

# With --make an interrupted run goes on from its checkpoint, and the summary is there only when all is done: a run that
# fails keeps its results, with the reason in failed.json, and the next make tries again.
THREADS ?= $(if $(filter -j% --jobserver%,$(MAKEFLAGS)),1)
$(OUT)/summary.json: run.toml slope.blocks $(OUT)/options $(if $(RECORD),$(abspath $(RECORD))) $(wildcard $(DDA_RUN))
	$(DDA_RUN) run.toml --make --blocks slope.blocks -o $(OUT) --depfile $(OUT)/summary.json.d \
	    $(addprefix --threads ,$(THREADS)) $(RUN_OPTIONS)

pictures: $(PICTURES)/drawn
$(PICTURES)/drawn: $(OUT)/summary.json $(wildcard $(DDA_PLOT))
	@mkdir -p $(PICTURES)
	$(DDA_PLOT) $(OUT) -o $(PICTURES) $(PLOT_FLAGS)
	@touch $@

clean:
	rm -rf $(OUT) $(PICTURES) slope.blocks slope.blocks.d slope.report.json

-include slope.blocks.d $(OUT)/summary.json.d
