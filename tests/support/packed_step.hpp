#pragma once

#include <cstdio>
#include <filesystem>
#include <limits>
#include <memory>
#include <stdexcept>
#include <vector>

#include "support/recorded_step.hpp"

namespace rockslope::recorded_step {

/// A recording of a larger run, which is kept outside the sources: doubles, little endian, packed by xz. 16
/// numbers of the head, per row 36 of the matrix, 6 of the load and 6 of the displacement found, then 42 per
/// contact. The tolerance is for the largest contact force at the displacement of the solution, so that it is
/// found along with that.
struct PackedStep {
    RecordedStep step;           ///< without lengths and tolerance
    double force_tolerance = 0;  ///< over the largest force of a contact
    double smallest_force = 0;   ///< N per metre; a smaller one is rounding
};

inline std::vector<double> unpacked(const std::filesystem::path& file) {
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> pipe(
        ::popen(("xz -dc '" + file.string() + "'").c_str(), "r"), ::pclose);
    if (!pipe) throw std::runtime_error("xz cannot be started");
    std::vector<double> numbers, chunk(1 << 16);
    while (const std::size_t count = std::fread(chunk.data(), sizeof(double), chunk.size(), pipe.get()))
        numbers.insert(numbers.end(), chunk.begin(), chunk.begin() + static_cast<std::ptrdiff_t>(count));
    return numbers;
}

/// The state of the initial guess where there is one, otherwise that of the step's start.
inline dda::Piece packed_start(const double* n, bool may_close, bool is_bonded) {
    const bool has_guess = n[32] >= 0;
    const double state = has_guess ? n[32] : n[20];
    const bool is_held_back = n[21] > 0, is_in_group = n[23] >= 0;
    bool is_pressed = state != 0 || (!has_guess && n[15] < 0 && !is_in_group);
    is_pressed = (is_pressed && may_close && !is_held_back) || is_bonded;
    dda::Piece piece;
    if (is_pressed) piece.normal = dda::Piece::Normal::pressed;
    const bool is_locked = is_pressed && (has_guess ? state == 2 : state != 1);
    piece.slides = is_locked ? 0 : ((has_guess ? n[33] : n[17]) >= 0 ? 1 : -1);
    return piece;
}

inline RecordedStep::Contact packed_contact(const double* n) {
    const auto row = [](double number) {
        return number < 0 ? dda::RowIndex::none() : dda::RowIndex(static_cast<int>(number));
    };
    RecordedStep::Contact contact;
    contact.rows = {row(n[0]), row(n[1]), {n[2], n[3]}, {n[4], n[5]}};
    dda::LimitedContact& law = contact.law;
    law.opening = {n[6], n[7]};
    law.shearing = {n[9], n[10]};
    law.normal_stiffness = n[12];
    law.shear_stiffness = n[13];
    law.origin = {-n[12] * (n[35] + n[8] - n[16]), n[17] + n[13] * n[11]};
    law.may_close = n[36] > 0;
    const bool is_broken = n[26] > 0, is_bonded = n[22] > 0, was_closed = n[20] != 0;
    const double cohesion = (is_broken ? n[29] : n[27]) * n[19];
    law.forward = {was_closed || is_bonded ? cohesion : 0, is_broken ? n[30] : n[28]};
    law.backward = law.forward;
    if (is_bonded) {
        law.least_normal = -std::numeric_limits<double>::infinity();
        law.floor = law.forward.slope > 0 ? -cohesion / law.forward.slope : 0;
    }
    contact.start = packed_start(n, law.may_close, is_bonded);
    return contact;
}

/// @throws std::runtime_error with the file's name, if it is no recording.
inline PackedStep read_packed_step(const std::filesystem::path& file) {
    constexpr std::size_t head = 16;
    const std::vector<double> numbers = unpacked(file);
    if (numbers.size() < head || numbers[0] != 20261122)
        throw std::runtime_error("no recording: " + file.string());
    PackedStep packed;
    packed.force_tolerance = numbers[6];
    packed.smallest_force = numbers[7];
    packed.step.iterations = static_cast<int>(numbers[3]);
    packed.step.factorizations = static_cast<int>(numbers[4]);
    packed.step.rows.resize(static_cast<std::size_t>(numbers[1]));
    const double* at = numbers.data() + head;
    for (RecordedStep::Row& row : packed.step.rows) {
        row.length = 1;
        row.stiffness = Eigen::Map<const dda::Mat6>(at);
        at += 36;
    }
    for (const auto vector : {&RecordedStep::Row::load, &RecordedStep::Row::displacement}) {
        for (RecordedStep::Row& row : packed.step.rows) {
            row.*vector = Eigen::Map<const dda::Vec6>(at);
            at += 6;
        }
    }
    const auto contacts = static_cast<std::size_t>(numbers[2]);
    for (std::size_t k = 0; k < contacts; ++k, at += 42) packed.step.contacts.push_back(packed_contact(at));
    return packed;
}

}  // namespace rockslope::recorded_step
