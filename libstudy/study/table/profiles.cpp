#include "study/table/profiles.hpp"

#include <map>

#include "common/base/atomic_file.hpp"
#include "study/folder/study_folder.hpp"
#include "study/table/deposit.hpp"

namespace rockslope::study {

TextTable write_profiles(const std::filesystem::path& folder, const StudyRows& rows) {
    TextTable all;
    if (!rows.plan.profile) return all;
    const auto [interval, limit] = *rows.plan.profile;
    const std::size_t number = *rows.runs.find(row_column), address = *rows.runs.find(address_column);
    std::map<std::string, TextTable> known;  // rows may share a result
    for (std::size_t k = 0; k < rows.results.size(); ++k) {
        const RowState state = rows.results[k].state;
        if (!is_done(state) || state == RowState::not_needed) continue;
        const std::vector<std::string>& run = rows.runs.rows[k];
        // A row whose start has collapsed has no frames.
        if (!std::filesystem::exists(folder / "results" / run[address] / "blocks.csv")) continue;
        const auto [entry, is_new] = known.try_emplace(run[address]);
        if (is_new) {
            const std::filesystem::path results = folder / "results" / run[address];
            entry->second = Deposit(read_outlines(results)).profile(interval, limit);
            write_file_atomically(results / "profile.csv", csv_text(entry->second));
        }
        const TextTable& profile = entry->second;
        if (all.heading.empty()) {
            all.heading = {row_column};
            all.heading.insert(all.heading.end(), profile.heading.begin(), profile.heading.end());
        }
        for (std::vector<std::string> fields : profile.rows) {
            fields.insert(fields.begin(), run[number]);
            all.rows.push_back(std::move(fields));
        }
    }
    return all;
}

}  // namespace rockslope::study
