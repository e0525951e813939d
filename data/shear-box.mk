# A direct shear test of blocks beside the joint by itself: what the folders of such tests add to rules.mk.
#
#   run.toml, shear-test.toml -> law.toml        the joint's material, once
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
