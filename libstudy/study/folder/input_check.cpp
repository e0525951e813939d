#include "study/folder/input_check.hpp"

#include "common/base/input_error.hpp"
#include "common/base/read_file.hpp"
#include "common/base/sha256.hpp"
#include "dda/input/read_run.hpp"

namespace rockslope::study {

namespace fs = std::filesystem;

namespace {

/// Makes a folder the current one, and goes back at the end: the overrides of a row name files relative to
/// it.
class InFolder {
  public:
    explicit InFolder(const fs::path& folder) : before_(fs::current_path()) { fs::current_path(folder); }
    ~InFolder() {
        std::error_code ignored;
        fs::current_path(before_, ignored);
    }
    InFolder(const InFolder&) = delete;
    InFolder& operator=(const InFolder&) = delete;

  private:
    fs::path before_;
};

}  // namespace

const std::string& InputCheck::digest_of(const fs::path& file) {
    const auto [entry, is_new] = digests_.try_emplace(file);
    if (is_new) {
        try {
            entry->second = sha256(read_text_file(file));
        } catch (const InputError&) {  // a file that is not there any more is another one
        }
    }
    return entry->second;
}

bool InputCheck::gives_the_same(const RowInputs& row, const fs::path& blocks) const {
    if (row.fingerprint.empty()) return false;
    const fs::path run_file = fs::absolute(run_file_), block_file = fs::absolute(blocks);
    try {
        const InFolder in_study(folder_);
        return sha256(dda::read_run(run_file, {row.overrides, block_file, {}}).fingerprint) ==
               row.fingerprint;
    } catch (const InputError&) {
        return false;
    }
}

std::optional<std::string> InputCheck::different_files(const RowInputs& row, const fs::path& blocks) {
    std::string different;
    for (const InputFile& file : row.files)
        if (digest_of(folder_ / file.path) != file.sha256)
            different += (different.empty() ? "" : ", ") + file.path.string();
    if (different.empty() || gives_the_same(row, blocks)) return std::nullopt;
    return different;
}

}  // namespace rockslope::study
