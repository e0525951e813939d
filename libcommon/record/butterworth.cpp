#include "record/butterworth.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>

namespace rockslope::record {

namespace {

/// The section with a pole and its conjugate, or with one real pole, in the z plane. Its zeros are at z = 1
/// for a high pass and at z = -1 for a low pass. Its gain is one at the other end of the spectrum.
FilterSection section_of(std::complex<double> pole, bool is_pair, Pass pass) {
    const double zero = pass == Pass::high ? 1 : -1;
    FilterSection section;
    section.a1 = is_pair ? -2 * pole.real() : -pole.real();
    section.a2 = is_pair ? std::norm(pole) : 0;
    const double passed = -zero;  // z where the gain is one
    const double gain = (1 + section.a1 * passed + section.a2) /
                        (is_pair ? (passed - zero) * (passed - zero) : 1 - zero * passed);
    section.b0 = gain;
    section.b1 = (is_pair ? -2 * zero : -zero) * gain;
    section.b2 = is_pair ? gain : 0;
    return section;
}

/// The state of a section in the transposed direct form II.
using SectionState = std::array<double, 2>;

/// The state in which a constant input of 1 gives a constant output.
SectionState steady_state(const FilterSection& s) {
    const double gain = (s.b0 + s.b1 + s.b2) / (1 + s.a1 + s.a2);
    const double second = s.b2 - s.a2 * gain;
    return {s.b1 - s.a1 * gain + second, second};
}

void run(const std::vector<FilterSection>& filter, std::vector<double>& signal) {
    if (signal.empty()) return;
    double steady = signal.front();  // steady input of the section
    for (const FilterSection& s : filter) {
        const SectionState unit = steady_state(s);
        SectionState state = {unit[0] * steady, unit[1] * steady};
        steady *= (s.b0 + s.b1 + s.b2) / (1 + s.a1 + s.a2);
        for (double& value : signal) {
            const double x = value;
            value = s.b0 * x + state[0];
            state[0] = s.b1 * x - s.a1 * value + state[1];
            state[1] = s.b2 * x - s.a2 * value;
        }
    }
}

std::vector<double> extended(const std::vector<double>& signal, std::size_t extension) {
    std::vector<double> longer;
    longer.reserve(signal.size() + 2 * extension);
    for (std::size_t k = extension; k > 0; --k) longer.push_back(2 * signal.front() - signal[k]);
    longer.insert(longer.end(), signal.begin(), signal.end());
    for (std::size_t k = 2; k <= extension + 1; ++k)
        longer.push_back(2 * signal.back() - signal[signal.size() - k]);
    return longer;
}

}  // namespace

std::vector<FilterSection> butterworth(Pass pass, int order, double corner, double step) {
    if (order < 1 || order > 12)
        throw std::invalid_argument("the order of a filter must be between 1 and 12");
    if (!(step > 0) || !(corner > 0) || !(corner < 0.5 / step))
        throw std::invalid_argument("a corner frequency must be positive and below half the sampling rate");
    const double warped = std::tan(std::numbers::pi * corner * step);  // w h / 2
    std::vector<FilterSection> filter;
    const auto add = [&](std::complex<double> unit_pole, bool is_pair) {
        const std::complex<double> s = pass == Pass::high ? warped / unit_pole : warped * unit_pole;
        filter.push_back(section_of((1.0 + s) / (1.0 - s), is_pair, pass));
    };
    for (int k = 0; k < order / 2; ++k)
        add(std::polar(1.0, std::numbers::pi * (0.5 + (2 * k + 1) / (2.0 * order))), true);
    if (order % 2 == 1) add({-1, 0}, false);
    return filter;
}

std::vector<double> filter_both_ways(const std::vector<FilterSection>& filter,
                                     const std::vector<double>& signal, std::size_t extension) {
    if (signal.empty()) return {};
    if (extension >= signal.size())
        throw std::invalid_argument("a filter's extension must be shorter than its signal");
    std::vector<double> filtered = extended(signal, extension);
    run(filter, filtered);
    std::reverse(filtered.begin(), filtered.end());
    run(filter, filtered);
    std::reverse(filtered.begin(), filtered.end());
    const auto from = filtered.begin() + static_cast<std::ptrdiff_t>(extension);
    return {from, from + static_cast<std::ptrdiff_t>(signal.size())};
}

}  // namespace rockslope::record
