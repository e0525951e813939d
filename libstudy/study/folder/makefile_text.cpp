#include "study/folder/makefile_text.hpp"

#include <cstdio>
#include <set>

#include "common/base/command_text.hpp"
#include "study/folder/row_settings.hpp"

namespace rockslope::study {

namespace fs = std::filesystem;

namespace {

const char* const head =
    R"make(# Written by dda-study from the plan, and again when an input changes: edit the plan, not this file.
#
#   make -j4                            all rows; goes on where it was, and ends with a list of the rows that failed
#   make runs/000001/summary.json       one row
#   make -n                             what would be done
#   make THREADS=2                      threads of a run; one by default, for make runs several at a time
#
#   cuts/ADDRESS.blocks                 a cut, for all rows with the same joints
#   starts/ADDRESS/                     the first stages of a run, for all rows that differ in later ones only
#   results/ADDRESS/                    a row; runs/NUMBER leads there
#
# An address is the hash of all that a result depends on: what is there under its address is never computed again.
)make";

/// The recipes. That of a row has no character of the shell outside single quotes, so that make starts the
/// run itself: a shell would cost a millisecond and more for each row. A start is computed by one process at
/// a time, also on several machines. An incremental row waits for that of the next smaller intensity, and is
/// computed unless that one, or one before it, has failed; its age does not matter.
const char* const recipes = R"make(
.SUFFIXES:
.PHONY: all rows
MAKEFLAGS += --no-builtin-rules --no-print-directory

all:
	-@+$(MAKE) -k rows
	@$(DDA_STUDY) status . --failures

run = $(DDA_RUN) $(RUN) --make --log '$(2)' --threads $(THREADS) -o $(@D) $(COMMON) $(1)

cut = @[ -d $(@D) ] || mkdir -p $(@D); $(BLOCKGEN) $(SLOPE) -o $@ $(1) >$(basename $@).log 2>&1 || \
    { tail -n 1 $(basename $@).log >&2; exit 1; }
start = @[ -d $(@D) ] || mkdir -p $(@D); exec 9>$(@D)/lock; flock 9; [ ! -e $@ ] || exit 0; exec $(call run,$(1),start $(notdir $(@D)))
row = @$(call run,$(1),row $(2))
row_if_needed = @$(DDA_STUDY) skip . $(2); code=$$?; [ $$code -eq 1 ] || exit $$code; exec $(call run,$(1),row $(2))
)make";

/// The options --set of some settings.
std::string set_options(const std::vector<Setting>& settings, ModelFile file, const fs::path& folder) {
    std::string text;
    for (const Setting& setting : settings)
        if (setting.target.file == file) text += " --set " + shell_quoted(override_text(setting, folder));
    // $(call ...) would take a comma for the end of an argument.
    std::string escaped;
    for (const char c : recipe_text(text)) escaped += c == ',' ? std::string("$(comma)") : std::string(1, c);
    return escaped;
}

std::string common_options(const std::vector<std::string>& set) {
    std::string text;
    for (const std::string& assignment : set) text += " --set " + shell_quoted(assignment);
    return recipe_text(text);
}

class Writer {
  public:
    Writer(const PlannedStudy& study, fs::path folder) : study_(study), folder_(std::move(folder)) {}

    std::string text(const Programs& programs) {
        text_ = head;
        variables(programs);
        text_ += recipes;
        own_rule();
        rows_target();
        cuts();
        starts();
        rows();
        return text_;
    }

  private:
    std::string relative(const fs::path& file) const { return file.lexically_relative(folder_).string(); }

    void variables(const Programs& programs) {
        text_ += "\nBIN ?= " + recipe_text(programs.folder.string()) +
                 "\nBLOCKGEN ?= $(BIN)/blockgen\nDDA_RUN ?= $(BIN)/dda-run\nDDA_STUDY ?= "
                 "$(BIN)/dda-study\nTHREADS ?= 1\n";
        if (!study_.plan.slope.empty()) text_ += "SLOPE = " + quoted(study_.plan.slope) + "\n";
        text_ += "RUN = " + quoted(study_.plan.run) + "\nCOMMON =" + common_options(study_.run_set()) +
                 "\ncomma = ,\n";
    }
    /// Make writes the Makefile again, and reads it, when an input has changed.
    void own_rule() {
        text_ += "\nMakefile:";
        for (const fs::path& file : study_.inputs) text_ += " \\\n    " + make_escaped(relative(file));
        text_ += "\n\t$(DDA_STUDY) make " + quoted(study_.plan.file) + " -o .\n";
        for (const fs::path& file : study_.inputs) text_ += make_escaped(relative(file)) + ":\n";
    }
    std::string quoted(const fs::path& file) const { return recipe_text(shell_quoted(relative(file))); }

    void rows_target() {
        text_ += "\nrows:";
        for (std::size_t k = 0; k < study_.rows.size(); ++k)
            text_ += " \\\n    runs/" + row_name(k) + "/summary.json";
        text_ += "\n";
    }
    std::string blocks_of(std::size_t cut) const {
        return study_.plan.slope.empty() ? relative(study_.plan.blocks)
                                         : "cuts/" + study_.cuts[cut].address + ".blocks";
    }
    void cuts() {
        if (study_.plan.slope.empty()) return;
        for (const PlannedCut& cut : study_.cuts)
            text_ += "\ncuts/" + cut.address + ".blocks:\n\t$(call cut," +
                     common_options(study_.plan.slope_set) +
                     set_options(cut.settings, ModelFile::slope, folder_) + ")\n";
    }
    std::string saved_of(const PlannedStart& start) const {
        return "starts/" + start.address + "/stage-" + std::to_string(study_.branch_stages) + ".saved.h5";
    }
    void starts() {
        for (const PlannedStart& start : study_.starts)
            text_ += "\n" + saved_of(start) + ": " + make_escaped(blocks_of(start.cut)) +
                     "\n\t$(call start,--until " + recipe_text(shell_quoted(study_.last_start_stage)) +
                     blocks_option(start.cut) + set_options(start.settings, ModelFile::run, folder_) + ")\n";
    }
    std::string blocks_option(std::size_t cut) const {
        return " --blocks " + recipe_text(shell_quoted(blocks_of(cut)));
    }

    void rows() {
        for (std::size_t k = 0; k < study_.rows.size(); ++k) {
            const PlannedRow& row = study_.rows[k];
            const std::string target = "results/" + row.address + "/summary.json";
            text_ += "\nruns/" + row_name(k) + "/summary.json: " + target + " ;\n";
            if (!first_of_address(k)) continue;
            const std::string saved = study_.branch_stages > 0 ? saved_of(study_.starts[row.start]) : "";
            const std::string before = previous(row);
            text_ += target + ": " + (saved.empty() ? "" : saved + " ") + make_escaped(blocks_of(row.cut)) +
                     (before.empty() ? "" : " | " + before) + "\n\t$(call " +
                     (before.empty() ? "row" : "row_if_needed") + "," +
                     (saved.empty() ? "" : "--from " + saved) + blocks_option(row.cut) +
                     set_options(row.settings, ModelFile::run, folder_) + "," + row_name(k) + ")\n";
        }
    }
    /// Whether no row before has this address: the rule of a target is written once.
    bool first_of_address(std::size_t index) { return addresses_.emplace(study_.rows[index].address).second; }

    /// Incremental: the summary of the row of the next smaller intensity; of other rows nothing.
    std::string previous(const PlannedRow& row) const {
        if (row.row.previous < 0) return "";
        return "results/" + study_.rows[static_cast<std::size_t>(row.row.previous)].address + "/summary.json";
    }

    const PlannedStudy& study_;
    fs::path folder_;
    std::string text_;
    std::set<std::string> addresses_;
};

}  // namespace

std::string makefile_text(const PlannedStudy& study, const fs::path& folder, const Programs& programs) {
    return Writer(study, folder).text(programs);
}

std::string row_name(std::size_t index) {
    char name[24];
    std::snprintf(name, sizeof name, "%06zu", index + 1);
    return name;
}

}  // namespace rockslope::study
