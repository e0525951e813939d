#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <vector>

#include "dda/solve/limited_forces.hpp"

namespace rockslope::recorded_step {

/// The equations of a step as a run met them, read from a recording (doubles, little endian, packed by xz):
/// 16 numbers of the head, per row 36 of the matrix, 6 of the load and 6 of the displacement found, then 42
/// per contact.
class RecordedStep {
  public:
    explicit RecordedStep(const std::filesystem::path& file) {
        const std::vector<double> numbers = unpacked(file);
        if (numbers.size() < head || numbers[0] != 20261122)
            throw std::runtime_error("no recording: " + file.string());
        const auto rows = static_cast<std::size_t>(numbers[1]);
        const auto contacts = static_cast<std::size_t>(numbers[2]);
        iterations_ = static_cast<int>(numbers[3]);
        factorizations_ = static_cast<int>(numbers[4]);
        force_tolerance_ = numbers[6];
        smallest_force_ = numbers[7];
        const double* at = numbers.data() + head;
        for (std::size_t k = 0; k < rows; ++k, at += 36)
            base_.stiffness.push_back(Eigen::Map<const dda::Mat6>(at));
        for (std::size_t k = 0; k < rows; ++k, at += 6) base_.load.push_back(Eigen::Map<const dda::Vec6>(at));
        at += 6 * rows;
        springs_.resize(contacts);
        for (std::size_t k = 0; k < contacts; ++k, at += 42) add_contact(k, at);
        row_contacts_.find(rows, springs_);
    }

    std::size_t rows() const { return base_.load.size(); }
    /// Iterations and factorisations of the run that recorded it.
    int iterations() const { return iterations_; }
    int factorizations() const { return factorizations_; }
    dda::LimitedStep step() const { return {base_, row_contacts_, contacts_}; }
    /// The piece that each contact was on at the step's start.
    const std::vector<dda::Piece>& start() const { return start_; }
    /// The tolerance of forces, N per metre. @param largest_force of a contact, N per metre
    double tolerance(double largest_force) const {
        return std::max(force_tolerance_ * largest_force, smallest_force_);
    }

  private:
    static constexpr std::size_t head = 16;

    static std::vector<double> unpacked(const std::filesystem::path& file) {
        const std::unique_ptr<std::FILE, int (*)(std::FILE*)> pipe(
            ::popen(("xz -dc '" + file.string() + "'").c_str(), "r"), ::pclose);
        if (!pipe) throw std::runtime_error("xz cannot be started");
        std::vector<double> numbers, chunk(1 << 16);
        while (const std::size_t count = std::fread(chunk.data(), sizeof(double), chunk.size(), pipe.get()))
            numbers.insert(numbers.end(), chunk.begin(), chunk.begin() + static_cast<std::ptrdiff_t>(count));
        return numbers;
    }

    void add_contact(std::size_t k, const double* n) {
        const auto row = [](double number) {
            return number < 0 ? dda::RowIndex::none() : dda::RowIndex(static_cast<int>(number));
        };
        springs_[k].rows = {row(n[0]), row(n[1]), {n[2], n[3]}, {n[4], n[5]}};
        dda::LimitedContact c;
        c.rows = &springs_[k].rows;
        c.opening = {n[6], n[7]};
        c.shearing = {n[9], n[10]};
        c.normal_stiffness = n[12];
        c.shear_stiffness = n[13];
        c.origin = {-n[12] * (n[35] + n[8] - n[16]), n[17] + n[13] * n[11]};
        c.may_close = n[36] > 0;
        const bool is_broken = n[26] > 0, is_bonded = n[22] > 0, was_closed = n[20] != 0;
        const double cohesion = (is_broken ? n[29] : n[27]) * n[19];
        c.forward = {was_closed || is_bonded ? cohesion : 0, is_broken ? n[30] : n[28]};
        c.backward = c.forward;
        if (is_bonded) {
            c.least_normal = -std::numeric_limits<double>::infinity();
            c.floor = c.forward.slope > 0 ? -cohesion / c.forward.slope : 0;
        }
        contacts_.push_back(c);
        start_.push_back(start_piece(n, c.may_close, is_bonded));
    }
    /// The state of the initial guess where there is one, otherwise that of the step's start.
    static dda::Piece start_piece(const double* n, bool may_close, bool is_bonded) {
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

    int iterations_ = 0;
    int factorizations_ = 0;
    double force_tolerance_ = 0;
    double smallest_force_ = 0;
    dda::BaseSystem base_;
    std::vector<dda::ContactSprings> springs_;
    std::vector<dda::LimitedContact> contacts_;
    std::vector<dda::Piece> start_;
    dda::RowContacts row_contacts_;
};

}  // namespace rockslope::recorded_step
