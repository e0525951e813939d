# A direct shear test of blocks, compared with the joint law alone: additional rules of these examples.
#
#   run.toml, shear-test.toml -> law.toml        the joint material of run.toml, copied
#   law.toml, out/joints.csv -> pictures/shear.png  joint-shear: the law as a line, the blocks as circles, the misfit
JOINT_SHEAR ?= $(BIN)/joint-shear

all: $(PICTURES)/shear.png

law.toml: run.toml shear-test.toml
	sed -n '/^\[joint_material/,/^\[analysis/p' run.toml | sed '$$d' | cat - shear-test.toml >$@

$(PICTURES)/shear.png: law.toml $(OUT)/summary.json $(wildcard $(JOINT_SHEAR))
	@mkdir -p $(PICTURES)
	$(JOINT_SHEAR) law.toml -o $(PICTURES)/law.csv --compare $(OUT)/joints.csv --joint joint --picture $@

clean: clean-law
clean-law:
	rm -f law.toml
.PHONY: clean-law
