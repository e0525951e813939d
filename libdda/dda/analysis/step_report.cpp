#include "dda/analysis/step_report.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "dda/contact/inherited_penetration.hpp"
#include "dda/terms/loads.hpp"
#include "dda/trial/joint_motion.hpp"

namespace rockslope::dda {

namespace {

/// Contacts in each state, and the largest penetration that they account for, m.
struct ContactCounts {
    int open = 0;
    int sliding = 0;
    int locked = 0;
    double largest_penetration = 0;
};

ContactCounts operator+(const ContactCounts& a, const ContactCounts& b) {
    return {a.open + b.open, a.sliding + b.sliding, a.locked + b.locked,
            std::max(a.largest_penetration, b.largest_penetration)};
}

ContactCounts count_contacts(const Topology& topology, const State& after, const ThreadPool& pool) {
    const auto of_chunk = [&](std::size_t begin, std::size_t end) {
        ContactCounts counts;
        for (const ContactIndex k : indices<ContactIndex>(begin, end)) {
            const Contact& contact = after.contacts.contacts[k];
            ++(contact.state == ContactState::open      ? counts.open
               : contact.state == ContactState::sliding ? counts.sliding
                                                        : counts.locked);
            const double depth =
                penetration_accounted_for(topology, after.blocks.vertices, contact).value_or(0);
            counts.largest_penetration = std::max(counts.largest_penetration, depth);
        }
        return counts;
    };
    return pool.parallel_reduce(after.contacts.contacts.size(), ContactCounts(), of_chunk, std::plus<>());
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
                       double max_stiffness, const ThreadPool& pool) {
    StepReport report;
    report.time = after.time;
    report.step = step;
    const ContactCounts counts = count_contacts(model.topology, after, pool);
    report.open = counts.open;
    report.sliding = counts.sliding;
    report.locked = counts.locked;
    report.largest_penetration = counts.largest_penetration;
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
                          ContactSpan<const Contact> before, ContactSpan<const Contact> after,
                          const ThreadPool& pool) {
    const auto largest_of_chunk = [&](std::size_t begin, std::size_t end) {
        double largest = 0;
        for (const ContactIndex k : indices<ContactIndex>(begin, end)) {
            const bool is_open = after[k].state == ContactState::open;
            if (is_open && !(after[k].gap < 0)) continue;
            const double left = is_open
                                    ? after[k].dilation - before[k].dilation - evaluated[k].dilation_increment
                                    : left_dilation(model, after[k]);
            largest = std::max(largest, std::abs(left));
        }
        return largest;
    };
    return pool.parallel_reduce(after.size(), 0.0, largest_of_chunk,
                                [](double a, double b) { return std::max(a, b); });
}

}  // namespace rockslope::dda
