#include "record/match_spectrum.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <complex>
#include <optional>
#include <stdexcept>
#include <unsupported/Eigen/FFT>

#include "common/base/read_file.hpp"
#include "record/baseline.hpp"
#include "record/record_lines.hpp"
#include "record/records.hpp"
#include "record/response_spectrum.hpp"
#include "record/spectral_wavelets.hpp"
#include "record/two_columns.hpp"

namespace rockslope::record {

namespace {

constexpr int compared_periods = 100;
constexpr double misfit_tolerance = 0.02;  // largest misfit
/// Step lengths tried in a round with wavelets; 1 is the full correction.
constexpr double step_lengths[] = {1, 0.7, 0.5, 0.35, 0.25, 0.12, 0.06};

std::vector<double> periods_of(const TargetSpectrum& target) {
    std::vector<double> periods;
    const double ratio = target.periods.back() / target.periods.front();
    for (int k = 0; k < compared_periods; ++k)
        periods.push_back(target.periods.front() * std::pow(ratio, k / (compared_periods - 1.0)));
    return periods;
}

/// The factors target / response at the compared periods.
TargetSpectrum target_over_response(const Accelerogram& record, const TargetSpectrum& target,
                                    double damping) {
    TargetSpectrum factors{periods_of(target), {}};
    for (const SpectralOrdinate& ordinate : response_spectrum(record, factors.periods, damping)) {
        if (!(ordinate.absolute_acceleration > 0))
            throw std::invalid_argument("a record without motion cannot be matched to a spectrum");
        factors.accelerations.push_back(target.at(ordinate.period) / ordinate.absolute_acceleration);
    }
    return factors;
}

SpectralMatch evaluate_match(const Accelerogram& record, const TargetSpectrum& factors) {
    SpectralMatch match{record, 0, 0};
    for (const double factor : factors.accelerations) {
        const double misfit = std::abs(1 / factor - 1);
        match.mean_misfit += misfit / compared_periods;
        match.largest_misfit = std::max(match.largest_misfit, misfit);
    }
    return match;
}

/// Merit of the line search in a round with wavelets: the 6-norm of the misfits, which weights large ones.
double norm_of_misfits(const TargetSpectrum& factors) {
    double sum = 0;
    for (const double factor : factors.accelerations) sum += std::pow(1 / factor - 1, 6);
    return std::pow(sum, 1 / 6.0);
}

/// Multiplies each Fourier amplitude by the factor of its period, and corrects the baseline. The record is
/// padded with zeros, so that its end does not wrap around to its beginning.
Accelerogram scale_amplitudes(const Accelerogram& record, const TargetSpectrum& factors) {
    std::vector<double> padded = record.values;
    padded.resize(2 * std::bit_ceil(record.values.size()), 0.0);
    std::vector<std::complex<double>> amplitudes;
    Eigen::FFT<double> fft;
    fft.fwd(amplitudes, padded);
    const double length = static_cast<double>(padded.size()) * record.step;
    const std::size_t count = padded.size();
    for (std::size_t k = 0; k < count; ++k) {
        const std::size_t harmonic = std::min(k, count - k);
        amplitudes[k] *= harmonic == 0 ? 0 : factors.at(length / static_cast<double>(harmonic));
    }
    fft.inv(padded, amplitudes);
    padded.resize(record.values.size());
    padded.front() = padded.back() = 0;
    return correct_baseline({record.step, std::move(padded)});
}

/// The round in the frequency domain with the smallest mean misfit.
SpectralMatch match_in_frequency_domain(const Accelerogram& record, const TargetSpectrum& target,
                                        double damping, int rounds) {
    Accelerogram current = record;
    TargetSpectrum factors = target_over_response(current, target, damping);
    SpectralMatch best = evaluate_match(current, factors);
    for (int round = 0; round < rounds; ++round) {
        current = scale_amplitudes(current, factors);
        factors = target_over_response(current, target, damping);
        const SpectralMatch match = evaluate_match(current, factors);
        if (match.mean_misfit < best.mean_misfit) best = match;
    }
    return best;
}

std::vector<TargetOrdinate> target_ordinates(const TargetSpectrum& target) {
    std::vector<TargetOrdinate> ordinates;
    for (const double period : periods_of(target)) ordinates.push_back({period, target.at(period)});
    return ordinates;
}

/// An iterate of the record, with its factors target / response.
struct Candidate {
    Accelerogram record;
    TargetSpectrum factors;
};

Candidate with_change(const Accelerogram& record, const std::vector<double>& change, double step_length,
                      const TargetSpectrum& target, double damping) {
    Accelerogram candidate = record;
    for (std::size_t k = 0; k < change.size(); ++k) candidate.values[k] += step_length * change[k];
    candidate = correct_baseline(candidate);
    TargetSpectrum factors = target_over_response(candidate, target, damping);
    return {std::move(candidate), std::move(factors)};
}

/// Line search along the wavelet correction. Tries the step lengths from long to short until one reduces the
/// misfit norm and the next does not reduce it further. If none reduces it, the smallest increase is taken,
/// which may lead out of a local minimum.
Candidate wavelet_step(const Candidate& current, const TargetSpectrum& target, double damping) {
    const std::vector<double> change = matching_wavelets(current.record, target_ordinates(target), damping);
    const double current_norm = norm_of_misfits(current.factors);
    std::optional<Candidate> best;
    double smallest = 0;
    for (const double step_length : step_lengths) {
        Candidate candidate = with_change(current.record, change, step_length, target, damping);
        const double norm = norm_of_misfits(candidate.factors);
        if (!best || norm < smallest) {
            smallest = norm;
            best = std::move(candidate);
        } else if (smallest < current_norm) {
            break;
        }
    }
    return *best;
}

void check(const Accelerogram& record, const TargetSpectrum& target, double damping, int rounds) {
    if (!(damping >= 0 && damping < 1)) throw std::invalid_argument("damping must be at least 0 and below 1");
    if (rounds < 0 || rounds > 100) throw std::invalid_argument("rounds must be between 0 and 100");
    if (record.values.size() < 4) throw std::invalid_argument("a match needs at least 4 samples");
    if (target.periods.size() < 2 || target.periods.size() != target.accelerations.size() ||
        !(target.periods.front() > 0))
        throw std::invalid_argument("a target spectrum needs two points or more, and positive periods");
}

}  // namespace

double TargetSpectrum::at(double period) const {
    const auto next = std::upper_bound(periods.begin(), periods.end(), period);
    if (next == periods.begin()) return accelerations.front();
    if (next == periods.end()) return accelerations.back();
    const std::size_t k = next - periods.begin();
    const double fraction = std::log(period / periods[k - 1]) / std::log(periods[k] / periods[k - 1]);
    return accelerations[k - 1] * std::pow(accelerations[k] / accelerations[k - 1], fraction);
}

TargetSpectrum read_target_spectrum(const std::filesystem::path& path) {
    const std::string text = read_text_file(path);
    const RecordLines lines(text, path.string());
    TwoColumns columns = parse_two_columns(lines);
    const auto factor = record_unit_factor(Quantity::acceleration, columns.heading.unit);
    if (columns.heading.quantity != Quantity::acceleration || !factor)
        lines.fail(0, "the heading names no acceleration and unit", "period (s),acceleration (g)");
    for (std::size_t k = 0; k < columns.times.size(); ++k) {
        if (!(columns.times[k] >= 1e-3 && columns.times[k] <= 1e3 && columns.values[k] > 0))
            lines.fail(columns.lines[k], "the line is not an ordinate of a spectrum",
                       "a period of 0.001 to 1000 s and a positive acceleration");
        columns.values[k] *= *factor;
    }
    return {std::move(columns.times), std::move(columns.values)};
}

SpectralMatch match_spectrum(const Accelerogram& record, const TargetSpectrum& target, double damping,
                             int rounds) {
    check(record, target, damping, rounds);
    SpectralMatch best = match_in_frequency_domain(record, target, damping, rounds);
    if (!(damping > 0)) return best;
    Candidate current{best.record, target_over_response(best.record, target, damping)};
    for (int round = 0; round < rounds && best.largest_misfit > misfit_tolerance; ++round) {
        current = wavelet_step(current, target, damping);
        const SpectralMatch match = evaluate_match(current.record, current.factors);
        if (match.largest_misfit < best.largest_misfit) best = match;
    }
    return best;
}

}  // namespace rockslope::record
