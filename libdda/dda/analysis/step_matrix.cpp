#include "dda/analysis/step_matrix.hpp"

#include <algorithm>

namespace rockslope::dda {

StepMatrix::StepMatrix(const StepProblem& problem, const BlockPattern& pattern, BlockMatrix& work,
                       const ThreadPool& pool)
    : p_(problem),
      pattern_(pattern),
      matrix_(work),
      pool_(pool),
      contacts_(problem.springs.size()),
      contact_changed_(problem.springs.size()),
      bolts_(problem.bolts.size()) {}

void StepMatrix::assemble(const TrialContacts& trials) {
    update_springs(trials);
    update_bolts(trials);
    matrix_.diagonal.resize(p_.base.stiffness.size());
    matrix_.upper.resize(pattern_.columns.size());
    pool_.parallel_for(p_.base.stiffness.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t row = begin; row < end; ++row) {
            if (is_changed(static_cast<int>(row))) assemble_row(row);
        }
    });
    for (std::size_t k = 0; k < bolts_.size(); ++k) {
        if (bolts_[k] != 0) add_bolt(p_.bolts[k], bolts_[k]);
    }
    assembled_ = true;
}

StepMatrix::Springs StepMatrix::springs_of(const TrialContacts& trials, std::size_t contact) const {
    return {trials.has_normal_spring(contact) ? trials.normal_stiffness(contact) : 0,
            trials.has_shear_spring(contact) ? p_.springs[contact].shear_stiffness : 0};
}

double StepMatrix::stiffness_of_bolt(const TrialContacts& trials, std::size_t bolt) const {
    return trials.is_elastic(bolt) ? p_.bolts[bolt].stiffness : 0;
}

void StepMatrix::update_springs(const TrialContacts& trials) {
    pool_.parallel_for(contacts_.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            const Springs now = springs_of(trials, k);
            contact_changed_[k] = now != contacts_[k] ? 1 : 0;
            contacts_[k] = now;
        }
    });
    if (!assembled_) return;
    changed_.resize(p_.base.stiffness.size());
    pool_.parallel_for(changed_.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t row = begin; row < end; ++row) {
            const std::span<const int> contacts = p_.row_contacts.of(row);
            changed_[row] =
                std::any_of(contacts.begin(), contacts.end(),
                            [&](int k) { return contact_changed_[static_cast<std::size_t>(k)] != 0; })
                    ? 1
                    : 0;
        }
    });
}

void StepMatrix::update_bolts(const TrialContacts& trials) {
    for (std::size_t k = 0; k < bolts_.size(); ++k) {
        const double now = stiffness_of_bolt(trials, k);
        const BlockPair& rows = p_.bolts[k].rows;
        for (const int row : {rows.first, rows.second}) {
            if (assembled_ && now != bolts_[k] && row >= 0) changed_[static_cast<std::size_t>(row)] = 1;
        }
        bolts_[k] = now;
    }
}

void StepMatrix::assemble_row(std::size_t row) {
    const int r = static_cast<int>(row);
    matrix_.diagonal[row] = p_.base.stiffness[row];
    for (int k = pattern_.start[row]; k < pattern_.start[row + 1]; ++k) {
        const auto place = static_cast<std::size_t>(k);
        if (is_changed(pattern_.columns[place])) matrix_.upper[place].setZero();
    }
    int last_partner = -1;  // row of the last contact's other block, which is that of the next few, too
    Mat6* off_diagonal = nullptr;
    for (const int contact : p_.row_contacts.of(row)) {
        const auto k = static_cast<std::size_t>(contact);
        const ContactSprings& s = p_.springs[k];
        const int partner = s.rows.first == r ? s.rows.second : s.rows.first;
        if (partner != last_partner) {
            last_partner = partner;
            off_diagonal = last_partner > r && is_changed(last_partner)
                               ? &matrix_.upper[static_cast<std::size_t>(pattern_.position(r, last_partner))]
                               : nullptr;
        }
        const auto add = [&](const Vec2& direction, double stiffness) {
            if (stiffness == 0) return;
            const Vec6 gradient = s.rows.project_on_row(r, direction);
            const Vec6 force = stiffness * gradient;
            matrix_.diagonal[row].noalias() += force * gradient.transpose();
            if (off_diagonal != nullptr)
                off_diagonal->noalias() += force * s.rows.project_on_row(last_partner, direction).transpose();
        };
        add(s.normal.direction, contacts_[k].normal);
        add(s.shear.direction, contacts_[k].shear);
    }
}

void StepMatrix::add_bolt(const BoltSpring& bolt, double stiffness) {
    const BlockPair& rows = bolt.rows;
    const bool first = is_changed(rows.first);
    const bool second = is_changed(rows.second);
    const Vec6 gradient_first = rows.gradient_first(bolt.elongation);
    const Vec6 gradient_second = rows.gradient_second(bolt.elongation);
    if (first) matrix_.add_rank_one(rows.first, gradient_first, stiffness);
    if (second) matrix_.add_rank_one(rows.second, gradient_second, stiffness);
    if (first && second && rows.first != rows.second)
        matrix_.add_outer(pattern_, rows.first, rows.second, stiffness * gradient_first, gradient_second);
}

}  // namespace rockslope::dda
