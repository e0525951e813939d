#include "dda/path/limited_forces.hpp"

#include <cmath>

namespace rockslope::dda {

void LimitedForces::evaluate(const LimitedStep& step, RowSpan<const Vec6> displacement,
                             RowSpan<const double> length, const ThreadPool& pool) {
    elastic_.resize(step.contacts.size());
    force_.resize(step.contacts.size());
    pool.parallel_for(elastic_.size(), [&](std::size_t begin, std::size_t end) {
        for (const ContactIndex k : indices<ContactIndex>(begin, end)) {
            const LimitedContact& contact = step.contacts[k];
            if (!contact.may_close) continue;
            elastic_[k] = contact.elastic_at(displacement);
            force_[k] = contact.on(contact.piece_at(elastic_[k])).at(elastic_[k]);
        }
    });
    unbalanced_.resize(displacement.size());
    pool.parallel_for(unbalanced_.size(), [&](std::size_t begin, std::size_t end) {
        for (const RowIndex row : indices<RowIndex>(begin, end)) {
            unbalanced_[row] = unbalanced_force(step, row, displacement[row]);
            unbalanced_[row].tail<4>() /= length[row];
        }
    });
}

Vec6 LimitedForces::unbalanced_force(const LimitedStep& step, RowIndex row, const Vec6& displacement) const {
    Vec6 force = step.base.stiffness[row] * displacement - step.base.load[row];
    for (const ContactIndex k : step.row_contacts.of(row)) {
        const LimitedContact& contact = step.contacts[k];
        if (!contact.may_close) continue;
        force -= contact.rows->project_on_row(
            row, Vec2(force_[k].x() * contact.opening - force_[k].y() * contact.shearing));
    }
    return force;
}

double LimitedForces::norm() const {
    double sum = 0;
    for (const Vec6& force : unbalanced_) sum += force.squaredNorm();
    return std::sqrt(sum);
}

}  // namespace rockslope::dda
