#include "measures_text.hpp"

#include <cmath>
#include <vector>

#include "formatted.hpp"
#include "record/measures.hpp"
#include "record/response_spectrum.hpp"

namespace rockslope {

std::string measures_text(const record::Accelerogram& record) {
    const record::RecordMeasures m = record::measure(record);
    return formatted("samples %zu, step %g s, duration %g s\n", record.values.size(), record.step,
                     record.duration()) +
           formatted("peak acceleration %.4f g, velocity %.4f m/s, displacement %.4f m\n",
                     m.peak_acceleration / record::standard_gravity, m.peak_velocity, m.peak_displacement) +
           formatted("Arias intensity %.3f m/s, significant duration (5-75 %%) %.2f s, (5-95 %%) %.2f s\n",
                     m.arias_intensity, m.significant_duration_75, m.significant_duration) +
           formatted("at the end: velocity %.1e m/s, displacement %.1e m\n", m.final_velocity,
                     m.final_displacement) +
           formatted("cumulative absolute velocity %.3f m/s, mean period %.3f s\n",
                     m.cumulative_absolute_velocity, m.mean_period);
}

std::string spectrum_text(const record::Accelerogram& record, double damping) {
    std::vector<double> periods;
    for (int k = 0; k <= 60; ++k) periods.push_back(0.02 * std::pow(10.0, k / 24.0));
    std::string text = "period (s),displacement (m),velocity (m/s),absolute acceleration (g)\n";
    for (const record::SpectralOrdinate& ordinate : record::response_spectrum(record, periods, damping))
        text += formatted("%.4f,%.5f,%.5f,%.5f\n", ordinate.period, ordinate.displacement, ordinate.velocity,
                          ordinate.absolute_acceleration / record::standard_gravity);
    return text;
}

}  // namespace rockslope
