#include "record/synthesise.hpp"

#include <Random123/philox.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "record/baseline.hpp"
#include "record/response_spectrum.hpp"

namespace rockslope::record {

namespace {

void require(bool condition, const char* message) {
    if (!condition) {
        throw std::invalid_argument(message);
    }
}

void check(const SyntheticMotion& recipe) {
    require(recipe.step > 0 && std::isfinite(recipe.step), "step must be positive");
    require(recipe.duration >= 10 * recipe.step && recipe.duration <= 1e6 * recipe.step,
            "duration must be between 10 and 1000000 steps");
    const double steps = recipe.duration / recipe.step;
    require(std::abs(steps - std::round(steps)) < 1e-6, "duration must be a whole number of steps");
    require(recipe.peak > 0 && std::isfinite(recipe.peak), "peak must be positive");
    require(recipe.envelope.rise > 0 && recipe.envelope.strong >= 0 && recipe.envelope.decay >= 0,
            "envelope: rise must be positive, strong part and decay not negative");
    const PowerSpectrum& spectrum = recipe.spectrum;
    require(spectrum.ground_frequency > 0 && spectrum.low_cut_frequency > 0,
            "filter frequencies must be positive");
    require(spectrum.ground_damping > 0, "the ground filter's damping must be positive");
    require(spectrum.low_cut_damping > 0 && spectrum.low_cut_damping < 1,
            "the low cut's damping must be in (0, 1)");
    require(spectrum.kappa >= 0, "kappa must not be negative");
}

/// The `draw`-th random number of a seed, uniform in (0, 1), the same on every machine.
double uniform(std::uint64_t seed, std::uint32_t draw) {
    const r123::Philox4x32 generator;
    const r123::Philox4x32::ctr_type counter = {{draw, 0, 0, 0}};
    const r123::Philox4x32::key_type key = {
        {static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)}};
    const auto words = generator(counter, key);
    const std::uint64_t bits = (static_cast<std::uint64_t>(words[1]) << 32 | words[0]) >> 12;
    return (static_cast<double>(bits) + 0.5) / 4503599627370496.0;
}

std::vector<double> stationary_noise(const SyntheticMotion& recipe, std::size_t count) {
    std::vector<double> noise(count, 0.0);
    const double spacing = 1 / (2 * recipe.duration);
    const auto frequencies = static_cast<std::uint32_t>(std::floor(0.5 / recipe.step / spacing));
    for (std::uint32_t k = 1; k <= frequencies; ++k) {
        const double frequency = k * spacing;
        const double amplitude = std::sqrt(2 * ground_density(recipe.spectrum, frequency) * spacing);
        const double phase = 2 * std::numbers::pi * uniform(recipe.seed, k);
        const double turn = 2 * std::numbers::pi * frequency * recipe.step;
        for (std::size_t i = 0; i < count; ++i) {
            noise[i] += amplitude * std::cos(turn * static_cast<double>(i) + phase);
        }
    }
    return noise;
}

/// The low-cut filter: the ground acceleration minus the absolute acceleration of an oscillator on it.
Accelerogram without_low_frequencies(const Accelerogram& record, const PowerSpectrum& spectrum) {
    const OscillatorMotion motion =
        oscillate(record, 1 / spectrum.low_cut_frequency, spectrum.low_cut_damping);
    Accelerogram filtered = record;
    for (std::size_t k = 0; k < filtered.values.size(); ++k) {
        filtered.values[k] -= motion.absolute_acceleration[k];
    }
    return filtered;
}

/// Taper: 1, then half a cosine from 1 to 0 over the last `length` seconds.
double closing_taper(double time, double duration, double length) {
    const double to_end = (duration - time) / length;
    return to_end >= 1 ? 1.0 : 0.5 * (1 - std::cos(std::numbers::pi * std::max(to_end, 0.0)));
}

}  // namespace

Accelerogram synthesise(const SyntheticMotion& recipe) {
    check(recipe);
    const auto count = static_cast<std::size_t>(std::lround(recipe.duration / recipe.step)) + 1;
    Accelerogram record{recipe.step, stationary_noise(recipe, count)};
    const auto time = [&](std::size_t k) { return static_cast<double>(k) * recipe.step; };
    for (std::size_t k = 0; k < count; ++k) {
        record.values[k] *= recipe.envelope.at(time(k));
    }
    record = without_low_frequencies(record, recipe.spectrum);
    const double taper = std::min(1.0, recipe.duration / 10);
    for (std::size_t k = 0; k < count; ++k) {
        record.values[k] *= closing_taper(time(k), recipe.duration, taper);
    }
    record.values.front() = 0;
    record.values.back() = 0;
    record = correct_baseline(record);
    const double scale = recipe.peak / largest_magnitude(record.values);
    require(std::isfinite(scale), "these filters and this kappa leave no motion");
    for (double& value : record.values) {
        value *= scale;
    }
    return record;
}

}  // namespace rockslope::record
