#include "study/folder/row_settings.hpp"

#include <cmath>

#include "common/base/input_error.hpp"
#include "common/base/text.hpp"
#include "common/config/toml_text.hpp"
#include "record/differentiate.hpp"
#include "record/measures.hpp"
#include "record/records.hpp"
#include "record/response_spectrum.hpp"

namespace rockslope::study {

namespace {

constexpr double spectral_damping = 0.05;

double intensity_of(const record::Accelerogram& record, const RecordScale& scale) {
    if (scale.measure == ScaleMeasure::spectral_acceleration) {
        const std::vector<double> periods = {scale.period};
        return record::response_spectrum(record, periods, spectral_damping).front().absolute_acceleration;
    }
    const record::RecordMeasures measures = record::measure(record);
    if (scale.measure == ScaleMeasure::peak_velocity) return measures.peak_velocity;
    if (scale.measure == ScaleMeasure::arias_intensity) return measures.arias_intensity;
    return measures.peak_acceleration;
}

double measured_intensity(const std::filesystem::path& file, const RecordScale& scale) {
    record::RecordDeclaration declaration;
    declaration.assumed_quantity = record::Quantity::acceleration;
    const record::Record read = record::read_record(file, declaration);
    const double intensity = intensity_of({read.dt, record::acceleration_samples(read)}, scale);
    if (!(intensity > 0)) throw InputError({file.string()}, "has no motion to scale", "a record with motion");
    return intensity;
}

}  // namespace

double RecordFactors::scale_of(const Row& row, std::size_t scaled) {
    const Factor& factor = plan_.factors[scaled];
    const std::size_t of_record = plan_.index_of(factor.scale->record);
    const std::filesystem::path& file =
        plan_.factors[of_record].files[static_cast<std::size_t>(row.levels[of_record])];
    const auto key = std::pair(scaled, file);
    if (!known_.contains(key)) known_[key] = measured_intensity(file, *factor.scale);
    const double target = factor.intensities[static_cast<std::size_t>(row.levels[scaled])];
    // The Arias intensity grows with the square of the motion.
    const double ratio = target / known_[key];
    return factor.scale->measure == ScaleMeasure::arias_intensity ? std::sqrt(ratio) : ratio;
}

std::vector<Setting> row_settings(const Plan& plan, const Row& row, RecordFactors& records) {
    std::vector<Setting> settings;
    for (std::size_t k = 0; k < plan.factors.size(); ++k) {
        const Factor& factor = plan.factors[k];
        for (const Target& target : factor.targets) {
            Setting setting{target, row.values[k], {}};
            if (factor.scale) setting.value = shortest_text(records.scale_of(row, k));
            if (!factor.files.empty()) {
                setting.file = factor.files[static_cast<std::size_t>(row.levels[k])];
                setting.value.clear();
            }
            settings.push_back(std::move(setting));
        }
    }
    return settings;
}

std::string override_text(const Setting& setting, const std::filesystem::path& folder) {
    if (setting.file.empty()) return setting.target.key + "=" + setting.value;
    const std::filesystem::path shown =
        folder.empty() ? setting.file : setting.file.lexically_relative(folder);
    return setting.target.key + "=" + toml_string(shown.string());
}

}  // namespace rockslope::study
