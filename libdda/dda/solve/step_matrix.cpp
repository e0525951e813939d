#include "dda/solve/step_matrix.hpp"

#include <algorithm>

namespace rockslope::dda {

namespace {

/// The blocks of one row of the matrix that the springs to one other row change.
struct RowBlocks {
    RowIndex row;
    RowIndex partner;
    Mat6& diagonal;
    Mat6* off_diagonal;  ///< null where the symmetric block is stored, or where it does not change
};

/// Adds the submatrices of a spring along `direction`, Eq. (24), to a row. Its forces are part of the
/// right-hand side.
void add_spring(const BlockPair& pair, const Vec2& direction, double stiffness, const RowBlocks& blocks) {
    if (stiffness == 0) return;
    const Vec6 gradient = pair.project_on_row(blocks.row, direction);
    const Vec6 force = stiffness * gradient;
    blocks.diagonal.noalias() += force * gradient.transpose();
    if (blocks.off_diagonal != nullptr)
        blocks.off_diagonal->noalias() += force * pair.project_on_row(blocks.partner, direction).transpose();
}

}  // namespace

StepMatrix::StepMatrix(const StepProblem& problem, const BlockPattern& pattern, BlockMatrix& work,
                       const ThreadPool& pool)
    : p_(problem),
      pattern_(pattern),
      matrix_(work),
      pool_(pool),
      contacts_(problem.springs.size()),
      contact_changed_(problem.springs.size()),
      bolts_(problem.bolts.size()) {}

/// Assembles the matrix of Eq. (3).
void StepMatrix::assemble(const TrialContacts& trials) {
    update_springs(trials);
    update_bolts(trials);
    assemble_changed_rows();
}

void StepMatrix::assemble(const TrialContacts& trials, const PerContact<Springs>& springs) {
    assembled_ = false;
    changed_.clear();
    contacts_ = springs;
    update_bolts(trials);
    assemble_changed_rows();
}

void StepMatrix::assemble_changed_rows() {
    matrix_.diagonal.resize(p_.base.stiffness.size());
    matrix_.upper.resize(pattern_.columns.size());
    pool_.parallel_for(p_.base.stiffness.size(), [&](std::size_t begin, std::size_t end) {
        for (const RowIndex row : indices<RowIndex>(begin, end)) {
            if (is_changed(row)) assemble_row(row);
        }
    });
    for (std::size_t k = 0; k < bolts_.size(); ++k) {
        if (bolts_[k] != 0) add_bolt(p_.bolts[k], bolts_[k]);
    }
    assembled_ = true;
}

StepMatrix::Springs StepMatrix::springs_of(const TrialContacts& trials, ContactIndex contact) const {
    const ContactTrial& trial = trials[contact];
    return {trial.has_normal_spring ? trial.tangent.stiffness : 0,
            trial.has_shear_spring ? p_.springs[contact].shear_stiffness : trial.sliding_stiffness,
            trial.has_normal_spring ? trial.tilt : 0};
}

double StepMatrix::stiffness_of_bolt(const TrialContacts& trials, std::size_t bolt) const {
    return trials.bolts().is_elastic(bolt) ? p_.bolts[bolt].stiffness : 0;
}

void StepMatrix::update_springs(const TrialContacts& trials) {
    pool_.parallel_for(contacts_.size(), [&](std::size_t begin, std::size_t end) {
        for (const ContactIndex k : indices<ContactIndex>(begin, end)) {
            const Springs now = springs_of(trials, k);
            contact_changed_[k] = now != contacts_[k] ? 1 : 0;
            contacts_[k] = now;
        }
    });
    if (!assembled_) return;
    changed_.resize(p_.base.stiffness.size());
    pool_.parallel_for(changed_.size(), [&](std::size_t begin, std::size_t end) {
        for (const RowIndex row : indices<RowIndex>(begin, end)) {
            const std::span<const ContactIndex> contacts = p_.row_contacts.of(row);
            changed_[row] = std::any_of(contacts.begin(), contacts.end(),
                                        [&](ContactIndex k) { return contact_changed_[k] != 0; })
                                ? 1
                                : 0;
        }
    });
}

void StepMatrix::update_bolts(const TrialContacts& trials) {
    for (std::size_t k = 0; k < bolts_.size(); ++k) {
        const double now = stiffness_of_bolt(trials, k);
        const BlockPair& rows = p_.bolts[k].rows;
        for (const RowIndex row : {rows.first, rows.second}) {
            if (assembled_ && now != bolts_[k] && row.exists()) changed_[row] = 1;
        }
        bolts_[k] = now;
    }
}

void StepMatrix::assemble_row(RowIndex row) {
    matrix_.diagonal[row] = p_.base.stiffness[row];
    for (std::size_t k = pattern_.start[row]; k < pattern_.start[row + 1]; ++k) {
        if (is_changed(pattern_.columns[k])) matrix_.upper[k].setZero();
    }
    RowIndex last_partner = RowIndex::none();  // consecutive contacts often have the same other block
    Mat6* off_diagonal = nullptr;
    for (const ContactIndex k : p_.row_contacts.of(row)) {
        const ContactSprings& s = p_.springs[k];
        const RowIndex partner = s.rows.first == row ? s.rows.second : s.rows.first;
        if (partner != last_partner) {
            last_partner = partner;
            off_diagonal = last_partner > row && is_changed(last_partner)
                               ? &matrix_.upper[pattern_.position(row, last_partner)]
                               : nullptr;
        }
        const RowBlocks blocks{row, last_partner, matrix_.diagonal[row], off_diagonal};
        add_spring(s.rows, s.normal.direction - contacts_[k].tilt * s.shear.direction, contacts_[k].normal,
                   blocks);
        add_spring(s.rows, s.shear.direction, contacts_[k].shear, blocks);
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
