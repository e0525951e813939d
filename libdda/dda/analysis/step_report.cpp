#include "dda/analysis/step_report.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "dda/contact/inherited_penetration.hpp"
#include "dda/terms/loads.hpp"

namespace rockslope::dda {

namespace {

/// The acceleration that scales unbalanced forces, m/s2: gravity, or the largest acceleration by a load where
/// that is larger, or 1 where both are zero.
double reference_acceleration(const Model& model, const BlockSystem& blocks) {
    const double largest = std::max(model.gravity.norm(), max_load_acceleration(model, blocks));
    return largest > 0 ? largest : 1.0;
}

void count_contacts(const Topology& topology, const State& after, StepReport& report) {
    for (const Contact& contact : after.contacts.contacts) {
        ++(contact.state == ContactState::open      ? report.open
           : contact.state == ContactState::sliding ? report.sliding
                                                    : report.locked);
        const double depth = penetration_accounted_for(topology, after.blocks.vertices, contact).value_or(0);
        report.largest_penetration = std::max(report.largest_penetration, depth);
    }
}

}  // namespace

StepReport report_step(const Model& model, const RowMap& rows, const State& after, double step,
                       double max_stiffness) {
    StepReport report;
    report.time = after.time;
    report.step = step;
    count_contacts(model.topology, after, report);
    const double g = reference_acceleration(model, after.blocks);
    double lightest = std::numeric_limits<double>::infinity();
    for (const BlockIndex b : rows.block_of) {
        const Vec6& a = after.blocks.acceleration[b];
        const AreaMoments& m = after.blocks.moments[b];
        const double gyration = std::sqrt((m.xx + m.yy) / m.area);
        // Rotation and strains count as the accelerations that they cause at the radius of gyration.
        const double deforming = a.tail<4>().cwiseAbs().maxCoeff() * gyration;
        report.unbalanced_force = std::max({report.unbalanced_force, a.head<2>().norm() / g, deforming / g});
        lightest = std::min(lightest, after.blocks.mass[b]);
    }
    if (rows.count() > 0) report.contact_frequency_step = std::sqrt(max_stiffness / lightest) * step;
    return report;
}

double remaining_dilation(ContactSpan<const Contact> before, ContactSpan<const EvaluatedContact> evaluated,
                          ContactSpan<const Contact> after) {
    double largest = 0;
    for (const ContactIndex k : after.indices()) {
        if (after[k].state == ContactState::open && !(after[k].gap < 0)) continue;
        const double dilated = after[k].dilation - before[k].dilation;
        largest = std::max(largest, std::abs(dilated - evaluated[k].dilation_increment));
    }
    return largest;
}

}  // namespace rockslope::dda
