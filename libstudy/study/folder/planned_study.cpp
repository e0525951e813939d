#include "study/folder/planned_study.hpp"

#include <algorithm>
#include <charconv>
#include <limits>
#include <map>
#include <set>
#include <thread>

#include "blockgen/cut/cut_blocks.hpp"
#include "blockgen/faces/enclosed_area.hpp"
#include "blockgen/input/read_slope_model.hpp"
#include "blockgen/mesh/block_file.hpp"
#include "blockgen/sampling/sample_joints.hpp"
#include "common/base/input_error.hpp"
#include "common/base/read_file.hpp"
#include "common/base/read_log.hpp"
#include "common/base/sha256.hpp"
#include "common/base/text.hpp"
#include "common/base/thread_pool.hpp"
#include "dda/checkpoint/start_of_run.hpp"
#include "dda/input/read_run.hpp"
#include "study/folder/row_settings.hpp"

namespace rockslope::study {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t address_length = 16;  ///< hexadecimal digits: 64 bits
/// Combinations of values that are read when a plan is made; of more, as many at equal distances.
constexpr std::size_t most_combinations_read = 20'000;
constexpr std::size_t most_sample_blocks = 1'000'000;

std::string address_of(const std::string& text) {
    return sha256(text).substr(0, address_length);
}

/// A temporary block file, removed at the end.
class SampleBlocks {
  public:
    explicit SampleBlocks(const fs::path& folder) : path_(folder / ".sample.blocks") {}
    ~SampleBlocks() {
        std::error_code ignored;
        fs::remove(path_, ignored);
    }
    SampleBlocks(const SampleBlocks&) = delete;
    SampleBlocks& operator=(const SampleBlocks&) = delete;
    const fs::path& path() const { return path_; }

  private:
    fs::path path_;
};

/// Reads files once for their digests.
class Digests {
  public:
    const std::string& of(const fs::path& file) {
        const auto found = known_.find(file);
        if (found != known_.end()) return found->second;
        return known_.emplace(file, sha256(read_text_file(file))).first->second;
    }

  private:
    std::map<fs::path, std::string> known_;
};

std::vector<std::string> overrides_of(const std::vector<std::string>& common,
                                      const std::vector<Setting>& settings, ModelFile file) {
    std::vector<std::string> overrides = common;
    for (const Setting& setting : settings)
        if (setting.target.file == file) overrides.push_back(override_text(setting, {}));
    return overrides;
}

/// The model of a slope, and what its cut depends on.
struct ReadSlope {
    blockgen::SlopeModel model;
    std::string fingerprint;
    std::vector<fs::path> files;
};

ReadSlope read_slope(const fs::path& file, const std::vector<std::string>& overrides) {
    const ReadLog log;
    const ConfigTable config = ConfigTable::from_file(file, overrides);
    ReadSlope slope;
    slope.model = blockgen::read_slope_model(config, blockgen::enclosed_area);
    slope.fingerprint = config.effective_text([&](const fs::path& path) { return log.digest_of(path); });
    for (const InputFile& input : log.files()) slope.files.push_back(input.path);
    return slope;
}

/// The fingerprint of a run without that of its block file, which is cut later.
std::string without_blocks(const std::string& fingerprint) {
    const std::size_t begin = fingerprint.find("blocks = ");
    if (begin == std::string::npos) return fingerprint;
    return fingerprint.substr(0, begin) + fingerprint.substr(fingerprint.find('\n', begin) + 1);
}

/// Whether a key changes what a run writes, and not what it computes.
bool is_of_output(const std::string& key) {
    return (key.starts_with("output.") && key != "output.relative_to" && key != "output.slip_threshold") ||
           key.starts_with("measured_region");
}

class Planner {
  public:
    Planner(const Plan& plan, const fs::path& folder) : sample_(folder) {
        study_.plan = plan;
        add_input(plan.file);
    }

    PlannedStudy result() {
        const std::vector<Row> rows = make_rows(study_.plan);
        RecordFactors records(study_.plan);
        for (const Row& row : rows) {
            PlannedRow planned;
            planned.row = row;
            planned.settings = row_settings(study_.plan, row, records);
            for (const Setting& setting : planned.settings)
                if (!setting.file.empty()) add_input(setting.file);
            study_.rows.push_back(std::move(planned));
        }
        plan_cuts();
        read_base();
        add_perturbations();
        try_combinations();
        choose_branch();
        address_starts();
        address_rows();
        study_.inputs.assign(inputs_.begin(), inputs_.end());
        return std::move(study_);
    }

  private:
    void add_input(const fs::path& file) { inputs_.insert(fs::absolute(file).lexically_normal()); }

    void plan_cuts() {
        const Plan& plan = study_.plan;
        if (plan.slope.empty()) {
            study_.cuts.push_back({address_of("blocks\n" + digests_.of(plan.blocks)), {}});
            add_input(plan.blocks);
            sample_file_ = plan.blocks;
            return;
        }
        std::map<std::string, std::size_t> known;  // by overrides, then by address
        for (PlannedRow& planned : study_.rows) {
            std::vector<Setting> settings;
            for (const Setting& setting : planned.settings)
                if (setting.target.file == ModelFile::slope) settings.push_back(setting);
            const std::vector<std::string> overrides =
                overrides_of(plan.slope_set, settings, ModelFile::slope);
            std::string key;
            for (const std::string& text : overrides) key += text + "\n";
            const auto [entry, is_new] = known.try_emplace(key, study_.cuts.size());
            if (is_new) add_cut(read_slope(plan.slope, overrides), settings, entry->second);
            planned.cut = entry->second;
        }
    }

    void add_cut(const ReadSlope& slope, const std::vector<Setting>& settings, std::size_t& index) {
        for (const fs::path& file : slope.files) add_input(file);
        const std::string address = address_of("cut\n" + slope.fingerprint);
        for (std::size_t k = 0; k < study_.cuts.size(); ++k)
            if (study_.cuts[k].address == address) {
                index = k;
                return;
            }
        study_.cuts.push_back({address, settings});
        if (!sample_file_.empty()) return;
        const blockgen::CutResult result =
            blockgen::cut_blocks(slope.model, blockgen::all_traces(slope.model, most_sample_blocks),
                                 {.max_blocks = most_sample_blocks, .full_report = false});
        blockgen::write_block_file(sample_.path(), result.mesh);
        sample_file_ = sample_.path();
    }

    dda::RunInput read(const std::vector<Setting>& settings) const {
        return dda::read_run(study_.plan.run,
                             {overrides_of(study_.run_set(), settings, ModelFile::run), sample_file_, {}});
    }

    void read_base() {
        const dda::RunInput base = read({});
        fingerprint_ = without_blocks(base.fingerprint);
        for (const dda::Stage& stage : base.stages) {
            stage_names_.push_back(stage.name);
            is_dynamic_.push_back(!stage.is_static());
        }
        for (const fs::path& file : base.files)
            if (file != sample_file_) add_input(file);
    }

    /// Gives each replicate but the first its perturbation.
    void add_perturbations() {
        if (study_.plan.replicates == 1) return;
        const auto first = std::find(is_dynamic_.begin(), is_dynamic_.end(), true);
        if (first == is_dynamic_.end())
            throw InputError({study_.plan.file.string()},
                             "'replicates' needs a dynamic stage to perturb, and the run has none",
                             "replicates = 1, or a run with a dynamic stage");
        const std::string key = "stage[" + std::to_string(first - is_dynamic_.begin()) + "].perturbation";
        for (PlannedRow& planned : study_.rows)
            if (planned.row.replicate > 0)
                planned.settings.push_back(
                    {{ModelFile::run, key}, std::to_string(planned.row.replicate), {}});
    }

    /// Rows that set the run file alike, once each.
    std::vector<const PlannedRow*> different_runs() const {
        std::vector<const PlannedRow*> rows;
        std::set<std::vector<std::string>> known;
        for (const PlannedRow& planned : study_.rows)
            if (known.insert(overrides_of({}, planned.settings, ModelFile::run)).second)
                rows.push_back(&planned);
        return rows;
    }
    /// "row 17 and 3 combinations more, friction = 27 deg, record = b.at2".
    std::string described(const PlannedRow& planned, std::ptrdiff_t more) const {
        std::string text = "row " + std::to_string(&planned - study_.rows.data() + 1);
        if (more > 0) text += " and " + std::to_string(more) + " combinations more";
        for (std::size_t k = 0; k < study_.plan.factors.size(); ++k)
            text += ", " + study_.plan.factors[k].name + " = " + planned.row.values[k];
        return text;
    }
    /// Reads the run with each combination of values that will be computed: two values may be wrong together
    /// alone.
    void try_combinations() const {
        const std::vector<const PlannedRow*> rows = different_runs();
        const std::size_t count = std::min(rows.size(), most_combinations_read);
        std::vector<std::string> faults(count);
        const auto row_of = [&](std::size_t k) { return rows[k * rows.size() / count]; };
        const ThreadPool threads(static_cast<int>(std::max(1u, std::thread::hardware_concurrency())));
        threads.parallel_for_dynamic(count, [&](std::size_t k, std::size_t) {
            try {
                read(row_of(k)->settings);
            } catch (const InputError& error) {
                faults[k] = error.what();
            }
        });
        const auto fault =
            std::find_if(faults.begin(), faults.end(), [](const auto& f) { return !f.empty(); });
        if (fault == faults.end()) return;
        const auto first = static_cast<std::size_t>(fault - faults.begin());
        const auto bad =
            std::count_if(faults.begin(), faults.end(), [](const auto& f) { return !f.empty(); });
        throw InputError({described(*row_of(first), bad - 1)}, *fault, "");
    }

    /// Rows that differ in the stages from some one on share what comes before it.
    void choose_branch() {
        int first = std::numeric_limits<int>::max();
        for (const PlannedRow& planned : study_.rows)
            for (const Setting& setting : planned.settings)
                if (setting.target.file == ModelFile::run)
                    if (const int stage = stage_of_key(setting.target.key); stage >= 0)
                        first = std::min(first, stage);
        if (first == std::numeric_limits<int>::max() || first < 1) return;
        if (first > static_cast<int>(stage_names_.size()) - 1) return;
        const std::string& last = stage_names_[static_cast<std::size_t>(first) - 1];
        if (std::count(stage_names_.begin(), stage_names_.end(), last) == 1) {
            study_.branch_stages = first;
            study_.last_start_stage = last;
        }
    }

    std::string hashed_text(const std::vector<Setting>& settings) {
        std::string text;
        for (const Setting& setting : settings)
            text += setting.target.key + "=" +
                    (setting.file.empty() ? setting.value : digests_.of(setting.file)) + "\n";
        return text;
    }

    void address_starts() {
        if (study_.branch_stages == 0) return;
        const std::string start = dda::start_of_run(fingerprint_, study_.branch_stages);
        std::map<std::string, std::size_t> known;
        for (PlannedRow& planned : study_.rows) {
            std::vector<Setting> settings;
            for (const Setting& setting : planned.settings)
                if (setting.target.file == ModelFile::run && stage_of_key(setting.target.key) < 0 &&
                    !is_of_output(setting.target.key))
                    settings.push_back(setting);
            const std::string address = address_of("start\n" + study_.cuts[planned.cut].address + "\n" +
                                                   start + hashed_text(settings));
            const auto [entry, is_new] = known.try_emplace(address, study_.starts.size());
            if (is_new) study_.starts.push_back({address, planned.cut, settings, 0});
            planned.start = entry->second;
            ++study_.starts[planned.start].rows;
        }
        if (study_.starts.size() < study_.rows.size()) return;
        study_.branch_stages = 0;  // nothing would be shared
        study_.starts.clear();
    }

    void address_rows() {
        for (PlannedRow& planned : study_.rows)
            planned.address = address_of("row\n" + study_.cuts[planned.cut].address + "\n" + fingerprint_ +
                                         hashed_text(planned.settings));
    }

    PlannedStudy study_;
    SampleBlocks sample_;
    fs::path sample_file_;
    Digests digests_;
    std::set<fs::path> inputs_;
    std::string fingerprint_;  ///< of the run without the factors and the blocks
    std::vector<std::string> stage_names_;
    std::vector<bool> is_dynamic_;
};

}  // namespace

std::vector<std::string> PlannedStudy::run_set() const {
    std::vector<std::string> set = {
        "output.frames=" + std::to_string(plan.output.frames),
        std::string("output.joint_frames=") + (plan.output.joint_frames ? "true" : "false"),
        std::string("output.step_log=") + (plan.output.step_log ? "true" : "false"),
        "output.history_interval=" + shortest_text(plan.output.history_interval)};
    set.insert(set.end(), plan.run_set.begin(), plan.run_set.end());
    return set;
}

PlannedStudy plan_study(const Plan& plan, const fs::path& folder) {
    return Planner(plan, folder).result();
}

int stage_of_key(const std::string& key) {
    const std::string start = "stage[";
    if (!key.starts_with(start)) return -1;
    int stage = -1;
    const auto [end, error] = std::from_chars(key.data() + start.size(), key.data() + key.size(), stage);
    return error == std::errc{} && end != key.data() + key.size() && *end == ']' ? stage : -1;
}

}  // namespace rockslope::study
