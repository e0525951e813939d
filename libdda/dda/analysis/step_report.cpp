#include "dda/analysis/step_report.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "dda/contact/inherited_penetration.hpp"
#include "dda/terms/loads.hpp"
#include "dda/trial/joint_motion.hpp"

namespace rockslope::dda {

namespace {

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

double reference_acceleration(const Model& model, const BlockSystem& blocks) {
    const double largest = std::max(model.gravity.norm(), max_load_acceleration(model, blocks));
    return largest > 0 ? largest : 1.0;
}

double unbalanced_force(const BlockSystem& blocks, BlockIndex block, double reference) {
    const Vec6& acceleration = blocks.acceleration[block];
    const AreaMoments& moments = blocks.moments[block];
    const double gyration = std::sqrt((moments.xx + moments.yy) / moments.area);
    const double deforming = acceleration.tail<4>().cwiseAbs().maxCoeff() * gyration;
    return std::max(acceleration.head<2>().norm(), deforming) / reference;
}

StepReport report_step(const Model& model, const RowMap& rows, const State& after, double step,
                       double max_stiffness) {
    StepReport report;
    report.time = after.time;
    report.step = step;
    count_contacts(model.topology, after, report);
    const double g = reference_acceleration(model, after.blocks);
    double lightest = std::numeric_limits<double>::infinity();
    for (const BlockIndex b : rows.block_of) {
        report.unbalanced_force = std::max(report.unbalanced_force, unbalanced_force(after.blocks, b, g));
        lightest = std::min(lightest, after.blocks.mass[b]);
    }
    if (rows.count() > 0) report.contact_frequency_step = std::sqrt(max_stiffness / lightest) * step;
    return report;
}

double remaining_dilation(const Model& model, ContactSpan<const EvaluatedContact> evaluated,
                          ContactSpan<const Contact> before, ContactSpan<const Contact> after) {
    double largest = 0;
    for (const ContactIndex k : after.indices()) {
        const bool is_open = after[k].state == ContactState::open;
        if (is_open && !(after[k].gap < 0)) continue;
        const double left = is_open ? after[k].dilation - before[k].dilation - evaluated[k].dilation_increment
                                    : left_dilation(model, after[k]);
        largest = std::max(largest, std::abs(left));
    }
    return largest;
}

}  // namespace rockslope::dda
