#include "dda/analysis/held_friction.hpp"

#include <Eigen/Cholesky>
#include <cmath>
#include <limits>

namespace dda {

namespace {

/// Changes told in one iteration, at one back-substitution each.
constexpr int most_changes = 12;
/// Of the first difference between held forces and bounds: nearer than that the springs will change anyway.
constexpr double share_left = 0.02;
/// Of the differences, left by a back-substitution that gained little. The second of these is the last.
constexpr double poor_gain = 0.8;
constexpr int most_poor_gains = 2;
/// What is added to the products of changes of length one, lest one that hardly differs from others is taken
/// many times over.
constexpr double independence = 1e-14;

using Products = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, most_changes, most_changes>;
using Shares = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, most_changes, 1>;

/// Of columns with each other, and minus the vector that they are to bring to zero.
struct NormalEquations {
    Products products;  ///< the lower half counts
    Shares sought;

    NormalEquations() : NormalEquations(0) {}
    explicit NormalEquations(int count)
        : products(Products::Zero(count, count)), sought(Shares::Zero(count)) {}
};

/// Of portions [begin, end) of two columns.
double product(const std::vector<double>& a, const std::vector<double>& b, std::size_t begin,
               std::size_t end) {
    const auto size = static_cast<Eigen::Index>(end - begin);
    return Eigen::Map<const Eigen::VectorXd>(a.data() + begin, size)
        .dot(Eigen::Map<const Eigen::VectorXd>(b.data() + begin, size));
}

/// The shares of the columns that bring a vector nearest to zero.
Shares least_squares(const NormalEquations& equations) {
    auto [products, sought] = equations;
    products.triangularView<Eigen::StrictlyUpper>() = products.transpose();
    Shares scale(sought.size());
    for (Eigen::Index j = 0; j < scale.size(); ++j)
        scale[j] = products(j, j) > 0 ? 1 / std::sqrt(products(j, j)) : 0;
    products = (scale.asDiagonal() * products * scale.asDiagonal()).eval();
    products.diagonal().array() += independence;
    sought = scale.cwiseProduct(sought).eval();
    return scale.cwiseProduct(products.ldlt().solve(sought));
}

}  // namespace

HeldFriction::HeldFriction(const StepProblem& problem, TrialContacts& trials, LinearSolver& solver,
                           const Crew& crew)
    : p_(problem), trials_(trials), solver_(solver), crew_(crew) {
    changes_.reserve(most_changes);
    for (const JointMaterial& material : p_.model.joint_materials) {
        const auto* law = std::get_if<MohrCoulomb>(&material.law);
        friction_.push_back(
            law == nullptr ? Friction{}
                           : Friction{std::tan(law->friction_angle), std::tan(law->residual_friction_angle)});
    }
}

void HeldFriction::draw_line(Sliding& sliding, std::span<const Vec6> d) const {
    const Contact& contact = p_.contacts[sliding.contact];
    if (const auto* law = std::get_if<MohrCoulomb>(&trials_.law_of(sliding.contact))) {
        const JointHistory& history = contact.history;
        const bool broken = std::get<MohrCoulomb::History>(history).broken;
        const double reduced = 1 / p_.model.strength_reduction;
        const Friction& friction = friction_[static_cast<std::size_t>(contact.joint_material)];
        sliding.slope = reduced * (broken ? friction.residual : friction.intact);
        sliding.cohesion = reduced * (broken ? law->residual_cohesion : law->cohesion) * contact.length;
        sliding.least = broken ? 0 : -std::numeric_limits<double>::infinity();
        return;
    }
    if (trials_.is_of_faces(sliding.contact)) {
        sliding.lacks_line = !trials_.has_line(sliding.contact);
        const BoundLine line = trials_.judged_line(sliding.contact);
        sliding.slope = line.slope;
        sliding.cohesion = line.cohesion;
        return;
    }
    if (!(sliding.normal > 0) && !sliding.bonded) {
        sliding.slope = trials_.judged_slope(sliding.contact);
        return;
    }
    const auto bound_at = [&](double normal) { return trials_.bound_at(sliding.contact, normal, d); };
    sliding.cohesion = bound_at(sliding.normal);
    if (!(sliding.normal > 0)) return;
    const double half = sliding.normal / 2;
    sliding.slope = (sliding.cohesion - bound_at(half)) / half;
    sliding.cohesion -= sliding.slope * sliding.normal;
}

void HeldFriction::find_sliding(std::span<const Vec6> d) {
    sliding_.clear();
    sliding_.reserve(trials_.count());
    for (std::size_t k = 0; k < trials_.count(); ++k) {
        if (!trials_.is_pressed(k) || trials_.is_locked(k)) continue;
        sliding_.emplace_back().contact = k;
    }
    crew_.for_ranges(sliding_.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            Sliding& sliding = sliding_[i];
            const std::size_t k = sliding.contact;
            const ContactSprings& springs = p_.springs[k];
            sliding.sign = trials_.slides_forward(k) ? 1 : -1;
            sliding.bonded = trials_.is_bonded(k);
            sliding.held = trials_.held_force(k);
            sliding.normal = trials_.linear_normal(k, springs.rows.measure(springs.normal, d));
            draw_line(sliding, d);
        }
    });
    find_missing_lines(d);
}

/// Most are there: a pair of faces keeps them for the step.
void HeldFriction::find_missing_lines(std::span<const Vec6> d) {
    for (const Sliding& sliding : sliding_)
        if (sliding.lacks_line) trials_.want_line(sliding.contact);
    trials_.find_lines();
    for (Sliding& sliding : sliding_)
        if (sliding.lacks_line) draw_line(sliding, d);
}

double HeldFriction::find_differences() {
    double largest = 0;
    for (Sliding& sliding : sliding_) {
        sliding.difference = sliding.bound() - sliding.held;
        largest = std::max(largest, std::abs(sliding.difference));
    }
    return largest;
}

double HeldFriction::norm_of_differences() const {
    double squares = 0;
    for (const Sliding& sliding : sliding_) squares += sliding.difference * sliding.difference;
    return std::sqrt(squares);
}

void HeldFriction::put_load(std::span<Vec6> load) {
    change_of_.assign(trials_.count(), 0);
    for (const Sliding& sliding : sliding_) change_of_[sliding.contact] = sliding.difference;
    crew_.for_ranges(load.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t row = begin; row < end; ++row) {
            load[row].setZero();
            for (const int contact : p_.row_contacts.of(row)) {
                const auto k = static_cast<std::size_t>(contact);
                if (change_of_[k] == 0) continue;
                const ContactSprings& springs = p_.springs[k];
                load[row] +=
                    springs.rows.of_row(static_cast<int>(row), -change_of_[k] * springs.shear.direction);
            }
        }
    });
}

void HeldFriction::tell(Change& change, std::size_t rows) {
    change.share = 0;
    for (std::vector<double>* of_sliding : {&change.held, &change.normal, &change.difference}) {
        of_sliding->reserve(trials_.count());  // once for the step, however many slide
        of_sliding->resize(sliding_.size());
    }
    change.displacement.resize(rows);
    put_load(change.displacement);
    solver_.solve_roughly(change.displacement);
    crew_.for_ranges(sliding_.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const Sliding& sliding = sliding_[i];
            const ContactSprings& springs = p_.springs[sliding.contact];
            const double opening = springs.normal.direction.dot(springs.rows.apart(change.displacement));
            change.held[i] = sliding.difference;
            change.normal[i] = -trials_.normal_stiffness(sliding.contact) * opening;
        }
    });
}

void HeldFriction::make_least(int count) {
    const std::span<Change> changes = std::span(changes_).first(static_cast<std::size_t>(count));
    const auto of_portion = [&](std::size_t begin, std::size_t end) {
        NormalEquations equations(count);
        for (int j = 0; j < count; ++j) {
            Change& change = changes[static_cast<std::size_t>(j)];
            for (std::size_t i = begin; i < end; ++i) {
                change.difference[i] = sliding_[i].bound_slope() * change.normal[i] - change.held[i];
                equations.sought[j] -= change.difference[i] * sliding_[i].difference;
            }
            for (int k = 0; k <= j; ++k)
                equations.products(j, k) =
                    product(change.difference, changes[static_cast<std::size_t>(k)].difference, begin, end);
        }
        return equations;
    };
    const auto add = [](NormalEquations sum, const NormalEquations& more) {
        sum.products += more.products;
        sum.sought += more.sought;
        return sum;
    };
    const Shares shares =
        least_squares(crew_.taken_together(sliding_.size(), NormalEquations(count), of_portion, add));
    for (int j = 0; j < count; ++j) changes[static_cast<std::size_t>(j)].share += shares[j];
    crew_.for_ranges(sliding_.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            for (int j = 0; j < count; ++j) {
                const Change& change = changes[static_cast<std::size_t>(j)];
                sliding_[i].held += shares[j] * change.held[i];
                sliding_[i].normal += shares[j] * change.normal[i];
            }
        }
    });
}

int HeldFriction::agree(std::span<Vec6> d) {
    find_sliding(d);
    double off = find_differences();
    const double enough = std::max(trials_.tolerance() / 2, share_left * off);
    int count = 0;
    for (int poor = 0; off > enough && poor < most_poor_gains && count < most_changes;) {
        const double before = norm_of_differences();
        if (static_cast<int>(changes_.size()) == count) changes_.emplace_back();
        tell(changes_[static_cast<std::size_t>(count++)], d.size());
        make_least(count);
        off = find_differences();
        if (norm_of_differences() > poor_gain * before) ++poor;
    }
    crew_.for_ranges(count == 0 ? 0 : d.size(), [&](std::size_t begin, std::size_t end) {
        for (const Change& change : std::span(changes_).first(static_cast<std::size_t>(count))) {
            for (std::size_t r = begin; r < end; ++r) d[r] += change.share * change.displacement[r];
        }
    });
    for (const Sliding& sliding : sliding_) {
        trials_.hold(sliding.contact, sliding.held);
        trials_.bound_by_held_force(sliding.contact);
    }
    return count;
}

}  // namespace dda
