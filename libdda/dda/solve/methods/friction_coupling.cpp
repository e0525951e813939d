#include "dda/solve/methods/friction_coupling.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "common/base/parallel_filter.hpp"

namespace rockslope::dda {

namespace {

/// Largest number of directions, each with one back-substitution.
constexpr int max_directions = 12;
/// Target of the largest residual over its first value. A smaller residual is useless, because the active set
/// will change.
constexpr double relative_tolerance = 0.02;
/// Smallest residual over the force tolerance. Less accurate friction lets small blocks wander.
constexpr double force_ratio = 0.05;
/// A direction stagnates if the residual norm stays above this fraction of its previous value. The second
/// stagnating direction is the last.
constexpr double stagnation_ratio = 0.8;
constexpr int max_stagnations = 2;
/// Added to the diagonal of the scaled normal equations, so that nearly parallel directions do not get huge
/// coefficients.
constexpr double regularisation = 1e-14;

using Products = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, max_directions, max_directions>;
using Coefficients = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, max_directions, 1>;

/// Normal equations of a least-squares problem: products of the columns with each other and with minus the
/// residual.
struct NormalEquations {
    Products products;  ///< only the lower half is set
    Coefficients right_hand_side;

    NormalEquations() : NormalEquations(0) {}
    explicit NormalEquations(int count)
        : products(Products::Zero(count, count)), right_hand_side(Coefficients::Zero(count)) {}
};

/// Scalar product of the rows [begin, end) of two columns.
double product(const std::vector<double>& a, const std::vector<double>& b, std::size_t begin,
               std::size_t end) {
    const auto size = static_cast<Eigen::Index>(end - begin);
    return Eigen::Map<const Eigen::VectorXd>(a.data() + begin, size)
        .dot(Eigen::Map<const Eigen::VectorXd>(b.data() + begin, size));
}

/// Coefficients of the columns that minimise the residual norm.
Coefficients least_squares(const NormalEquations& equations) {
    auto [products, right_hand_side] = equations;
    products.triangularView<Eigen::StrictlyUpper>() = products.transpose();
    Coefficients scale(right_hand_side.size());
    for (Eigen::Index j = 0; j < scale.size(); ++j)
        scale[j] = products(j, j) > 0 ? 1 / std::sqrt(products(j, j)) : 0;
    products = (scale.asDiagonal() * products * scale.asDiagonal()).eval();
    products.diagonal().array() += regularisation;
    right_hand_side = scale.cwiseProduct(right_hand_side).eval();
    return scale.cwiseProduct(products.ldlt().solve(right_hand_side));
}

}  // namespace

FrictionCoupling::FrictionCoupling(const StepProblem& problem, StepContacts& contacts, LinearSolver& solver,
                                   const ThreadPool& pool)
    : p_(problem),
      trials_(contacts.trials),
      bounds_(contacts.bounds),
      dilation_(contacts.dilation),
      solver_(solver),
      pool_(pool) {
    directions_.reserve(max_directions);
}

void FrictionCoupling::find_sliding(std::span<const Vec6> d) {
    const auto slides = [&](std::size_t k) {
        return !trials_[k].has_shear_spring && (trials_[k].has_normal_spring || trials_.coheres(k));
    };
    parallel_filter(pool_, trials_.count(), slides, slides_, sliding_contacts_);
    sliding_.reserve(trials_.count());
    sliding_.resize(sliding_contacts_.size());
    pool_.parallel_for(sliding_.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const ContactIndex k = sliding_contacts_[i];
            Sliding& sliding = sliding_[i];
            sliding = {};
            sliding.contact = k;
            const ContactSprings& springs = p_.springs[k];
            sliding.sign = trials_[k].slides_forward ? 1 : -1;
            sliding.bonded = trials_.is_bonded(k);
            sliding.coheres = trials_.coheres(k);
            sliding.friction_force = trials_[k].friction_force;
            sliding.by_hardening = trials_[k].sliding_stiffness * trials_[k].held_shearing;
            sliding.normal = trials_[k].linear_normal(springs.rows.measure(trials_.normal_measure(k), d));
            sliding.tilt = trials_[k].tilt;
            sliding.line = bounds_.line(sliding.contact, sliding.normal, d);
        }
    });
    complete_lines(d);
    find_dilating(d);
}

void FrictionCoupling::find_dilating(std::span<const Vec6> d) {
    const auto dilations = dilation_.by_force();
    for (std::size_t i = 0; i < dilations.size(); ++i) {
        Sliding segment;
        segment.contact = ContactIndex::none();
        segment.dilation = i;
        for (const ContactIndex k : dilations[i].contacts) {
            if (!trials_[k].has_normal_spring) continue;
            const double opening = p_.springs[k].rows.measure(trials_.normal_measure(k), d);
            segment.spring += trials_[k].tangent.stiffness;
            segment.normal += trials_[k].linear_normal(opening);
        }
        if (!(segment.spring > 0)) continue;
        segment.line.slope = segment.spring * dilations[i].slope;
        segment.line.cohesion = -segment.line.slope * dilations[i].normal_force;
        segment.friction_force = segment.spring * dilations[i].change;
        sliding_.push_back(segment);
    }
}

/// Most lines exist already: a joint segment keeps its line for the step.
void FrictionCoupling::complete_lines(std::span<const Vec6> d) {
    for (const Sliding& sliding : sliding_)
        if (sliding.line.is_missing) bounds_.request_line(sliding.contact);
    bounds_.find_requested_lines();
    for (Sliding& sliding : sliding_)
        if (sliding.line.is_missing) sliding.line = bounds_.line(sliding.contact, sliding.normal, d);
}

double FrictionCoupling::update_residuals() {
    const auto largest_of_chunk = [&](std::size_t begin, std::size_t end) {
        double largest = 0;
        for (Sliding& sliding : std::span(sliding_).subspan(begin, end - begin)) {
            sliding.residual = sliding.bound() - sliding.friction_force;
            largest = std::max(largest, std::abs(sliding.residual));
        }
        return largest;
    };
    return pool_.parallel_reduce(sliding_.size(), 0.0, largest_of_chunk,
                                 [](double a, double b) { return std::max(a, b); });
}

double FrictionCoupling::residual_norm() const {
    double squares = 0;
    for (const Sliding& sliding : sliding_) squares += sliding.residual * sliding.residual;
    return std::sqrt(squares);
}

void FrictionCoupling::set_load(std::span<Vec6> load) {
    force_change_.assign(trials_.count(), 0);
    normal_change_.assign(trials_.count(), 0);
    for (const Sliding& sliding : sliding_) {
        if (!sliding.dilates()) {
            force_change_[sliding.contact] = sliding.residual;
            continue;
        }
        for (const ContactIndex k : dilation_.by_force()[sliding.dilation].contacts) {
            if (trials_[k].has_normal_spring)
                normal_change_[k] = trials_[k].tangent.stiffness * sliding.residual / sliding.spring;
        }
    }
    pool_.parallel_for(load.size(), [&](std::size_t begin, std::size_t end) {
        for (const RowIndex row : indices<RowIndex>(begin, end)) {
            load[row].setZero();
            for (const ContactIndex k : p_.row_contacts.of(row)) {
                if (force_change_[k] == 0 && normal_change_[k] == 0) continue;
                const ContactSprings& springs = p_.springs[k];
                const Vec2 force = normal_change_[k] * trials_.normal_measure(k).direction -
                                   force_change_[k] * springs.shear.direction;
                load[row] += springs.rows.project_on_row(row, force);
            }
        }
    });
}

void FrictionCoupling::apply_operator(Direction& direction, std::size_t rows) {
    direction.coefficient = 0;
    for (std::vector<double>* of_sliding :
         {&direction.friction_force, &direction.normal, &direction.residual}) {
        of_sliding->reserve(trials_.count());  // once per step, whatever the number of sliding contacts
        of_sliding->resize(sliding_.size());
    }
    direction.displacement.resize(rows);
    set_load(direction.displacement);
    solver_.apply_factor(direction.displacement);
    const auto change_of_normal = [&](ContactIndex k) {
        const double opening = trials_.normal_measure(k).direction.dot(
            p_.springs[k].rows.relative_displacement(direction.displacement));
        return normal_change_[k] - trials_[k].tangent.stiffness * opening;
    };
    pool_.parallel_for(sliding_.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const Sliding& sliding = sliding_[i];
            direction.friction_force[i] = sliding.residual;
            direction.normal[i] = sliding.dilates() ? 0 : change_of_normal(sliding.contact);
            if (!sliding.dilates()) continue;
            for (const ContactIndex k : dilation_.by_force()[sliding.dilation].contacts)
                if (trials_[k].has_normal_spring) direction.normal[i] += change_of_normal(k);
        }
    });
}

void FrictionCoupling::minimize_residual(int count) {
    const std::span<Direction> directions = std::span(directions_).first(count);
    const auto chunk_value = [&](std::size_t begin, std::size_t end) {
        NormalEquations equations(count);
        for (int j = 0; j < count; ++j) {
            Direction& direction = directions[j];
            for (std::size_t i = begin; i < end; ++i) {
                direction.residual[i] =
                    sliding_[i].bound_slope() * direction.normal[i] - direction.friction_force[i];
                equations.right_hand_side[j] -= direction.residual[i] * sliding_[i].residual;
            }
            for (int k = 0; k <= j; ++k)
                equations.products(j, k) = product(direction.residual, directions[k].residual, begin, end);
        }
        return equations;
    };
    const auto add = [](NormalEquations sum, const NormalEquations& more) {
        sum.products += more.products;
        sum.right_hand_side += more.right_hand_side;
        return sum;
    };
    const Coefficients coefficients =
        least_squares(pool_.parallel_reduce(sliding_.size(), NormalEquations(count), chunk_value, add));
    for (int j = 0; j < count; ++j) directions[j].coefficient += coefficients[j];
    pool_.parallel_for(sliding_.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            for (int j = 0; j < count; ++j) {
                const Direction& direction = directions[j];
                sliding_[i].friction_force += coefficients[j] * direction.friction_force[i];
                sliding_[i].normal += coefficients[j] * direction.normal[i];
            }
        }
    });
}

void FrictionCoupling::store() {
    for (const Sliding& sliding : sliding_)
        if (sliding.dilates())
            dilation_.set_change(sliding.dilation, sliding.friction_force / sliding.spring);
    pool_.parallel_for(sliding_.size(), [&](std::size_t begin, std::size_t end) {
        for (const Sliding& sliding : std::span(sliding_).subspan(begin, end - begin)) {
            if (sliding.dilates()) continue;
            trials_[sliding.contact].set_friction(sliding.friction_force, sliding.normal);
        }
    });
}

/// Solves the fixed point of Eq. (35) by minimal residuals.
int FrictionCoupling::solve(std::span<Vec6> d) {
    find_sliding(d);
    double largest_residual = update_residuals();
    const double target_residual =
        std::max(force_ratio * trials_.tolerance(), relative_tolerance * largest_residual);
    int count = 0;
    for (int stagnations = 0;
         largest_residual > target_residual && stagnations < max_stagnations && count < max_directions;) {
        const double before = residual_norm();
        if (std::cmp_equal(directions_.size(), count)) directions_.emplace_back();
        apply_operator(directions_[count++], d.size());
        minimize_residual(count);
        largest_residual = update_residuals();
        if (residual_norm() > stagnation_ratio * before) ++stagnations;
    }
    pool_.parallel_for(count == 0 ? 0 : d.size(), [&](std::size_t begin, std::size_t end) {
        for (const Direction& direction : std::span(directions_).first(count)) {
            for (std::size_t r = begin; r < end; ++r)
                d[r] += direction.coefficient * direction.displacement[r];
        }
    });
    store();
    return count;
}

}  // namespace rockslope::dda
