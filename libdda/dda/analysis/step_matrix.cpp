#include "dda/analysis/step_matrix.hpp"

namespace dda {

StepMatrix::StepMatrix(const StepProblem& problem, const BlockPattern& pattern, BlockMatrix& work)
    : p_(problem),
      pattern_(pattern),
      matrix_(work),
      contacts_(problem.springs.size()),
      bolts_(problem.bolts.size()) {}

void StepMatrix::assemble(const TrialContacts& trials) {
    if (assembled_) changed_.assign(p_.base.stiffness.size(), 0);
    for (std::size_t k = 0; k < contacts_.size(); ++k) {
        const Springs now = springs_of(trials, k);
        if (assembled_ && now != contacts_[k]) mark(p_.springs[k].rows);
        contacts_[k] = now;
    }
    for (std::size_t k = 0; k < bolts_.size(); ++k) {
        const double now = stiffness_of_bolt(trials, k);
        if (assembled_ && now != bolts_[k]) mark(p_.bolts[k].rows);
        bolts_[k] = now;
    }
    clear_changed();
    for (std::size_t k = 0; k < contacts_.size(); ++k) {
        const ContactSprings& s = p_.springs[k];
        if (contacts_[k].normal != 0) add_spring(s.rows, s.normal, contacts_[k].normal);
        if (contacts_[k].shear != 0) add_spring(s.rows, s.shear, contacts_[k].shear);
    }
    for (std::size_t k = 0; k < bolts_.size(); ++k) {
        if (bolts_[k] != 0) add_spring(p_.bolts[k].rows, p_.bolts[k].elongation, bolts_[k]);
    }
    assembled_ = true;
}

StepMatrix::Springs StepMatrix::springs_of(const TrialContacts& trials, std::size_t contact) const {
    return {trials.is_pressed(contact) ? trials.normal_stiffness(contact) : 0,
            trials.is_locked(contact) ? p_.springs[contact].shear_stiffness : 0};
}

double StepMatrix::stiffness_of_bolt(const TrialContacts& trials, std::size_t bolt) const {
    return trials.is_elastic(bolt) ? p_.bolts[bolt].stiffness : 0;
}

void StepMatrix::mark(const PairRows& rows) {
    for (const int row : {rows.first, rows.second}) {
        if (row >= 0) changed_[static_cast<std::size_t>(row)] = 1;
    }
}

void StepMatrix::clear_changed() {
    if (changed_.empty()) matrix_.reset(pattern_);
    for (std::size_t r = 0; r < p_.base.stiffness.size(); ++r) {
        if (!is_changed(static_cast<int>(r))) continue;
        matrix_.diagonal[r] = p_.base.stiffness[r];
        for (int k = pattern_.start[r]; k < pattern_.start[r + 1] && !changed_.empty(); ++k) {
            const auto place = static_cast<std::size_t>(k);
            if (is_changed(pattern_.columns[place])) matrix_.upper[place].setZero();
        }
    }
}

void StepMatrix::add_spring(const PairRows& rows, const Relative& relative, double stiffness) {
    const bool first = is_changed(rows.first);
    const bool second = is_changed(rows.second);
    if (first) matrix_.add_square(rows.first, rows.of_first(relative), stiffness);
    if (second) matrix_.add_square(rows.second, rows.of_second(relative), stiffness);
    if (first && second && rows.first != rows.second)
        matrix_.add_outer(pattern_, rows.first, rows.second, stiffness * rows.of_first(relative),
                          rows.of_second(relative));
}

}  // namespace dda
