#pragma once

#include "common/base/thread_pool.hpp"
#include "dda/path/limited_contact.hpp"
#include "dda/terms/row_contacts.hpp"

namespace rockslope::dda {

/// The contacts of a step with their laws frozen but for their limits.
struct LimitedStep {
    const BaseSystem& base;
    const RowContacts& row_contacts;
    ContactSpan<const LimitedContact> contacts;
};

/// The forces of such a step at a displacement. Memory is kept from one to the next.
class LimitedForces {
  public:
    /// @param displacement per row, m.
    /// @param length per row, m: moments over it are compared with forces.
    void evaluate(const LimitedStep& step, RowSpan<const Vec6> displacement, RowSpan<const double> length,
                  const ThreadPool& pool);

    /// Per contact that may close.
    ContactSpan<ElasticForces> elastic() { return elastic_; }
    ContactSpan<const ElasticForces> elastic() const { return elastic_; }
    /// The unbalanced force of a block: that of its inertia and elasticity less loads and contact forces,
    /// with moments over the length. N per metre
    const Vec6& unbalanced(RowIndex row) const { return unbalanced_[row]; }
    /// The root of the sum of the squares of all unbalanced forces, N per metre.
    double norm() const;

  private:
    Vec6 unbalanced_force(const LimitedStep& step, RowIndex row, const Vec6& displacement) const;

    PerContact<ElasticForces> elastic_;
    PerContact<Vec2> force_;  ///< per contact: normal and shear force, N per metre
    PerRow<Vec6> unbalanced_;
};

}  // namespace rockslope::dda
