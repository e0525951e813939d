#include "dda/solve/methods/interior_point.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>

namespace rockslope::dda {

namespace {

constexpr int iteration_limit = 40;
/// Errors of a solution over the force tolerance: of the contact forces and of the blocks' balance.
constexpr double law_ratio = 0.5;
constexpr double balance_ratio = 0.1;
/// Root of the first products of a later solution: over the scale of the forces at most, and over the largest
/// error of the forces.
constexpr double later_root_ratio = 1e-2;
constexpr double root_over_change = 3;
/// Roots of the mean product, over the scale of the forces, at which the first entrances are selected again.
constexpr std::array<double, 2> selection_ratios = {1e-2, 1e-4};
/// Fraction of the largest step that keeps all unknowns positive.
constexpr double step_ratio = 0.99;
/// The power of the ratio of the predicted to the present mean product by which the products fall.
constexpr double centering_power = 3;
/// Smallest root of the products, over the force tolerance.
constexpr double smallest_root_ratio = 1e-2;
/// A step below this is short: the path folds back there. So many of them are the last.
constexpr double short_step = 0.1;
constexpr int interior_short_step_limit = 8;
/// The contacts that block a short step are those that allow less than this many times it.
constexpr double blocking_reach = 3;
/// N per metre; a joint with more cohesion has no bound.
constexpr double unbounded_cohesion = 1e15;

double square(double x) {
    return x * x;
}

}  // namespace

InteriorPoint::InteriorPoint(const StepProblem& problem, StepContacts& contacts, StepMatrix& matrix,
                             LinearSolver& solver, const ThreadPool& pool, PhaseTimes* times)
    : p_(problem),
      trials_(contacts.trials),
      bounds_(contacts.bounds),
      entrances_(contacts.entrances),
      matrix_(matrix),
      solver_(solver),
      pool_(pool),
      times_(times) {}

InteriorPointResult InteriorPoint::solve(PerRow<Vec6>& d, const PathStart& from) {
    InteriorPointResult result;
    substitutions_ = 0;
    displacement_ = d;
    find_contacts(d);
    if (from.hold_bounds) for_contacts([](PathContact& c) { c.hold_bounds(); });
    const double scale = scale_of_forces();
    if (!(scale > 0)) return result;
    const bool is_first = !from.force_change;
    const double root =
        is_first ? scale : std::min(later_root_ratio * scale, root_over_change * *from.force_change);
    for_contacts([&](PathContact& c) { c.place_on_path(square(root)); });
    std::size_t selections = is_first && !from.hold_bounds ? 0 : selection_ratios.size();
    int short_steps = 0;
    for (; result.iterations < iteration_limit && short_steps < interior_short_step_limit;
         ++result.iterations) {
        Errors errors = evaluate();
        const double tolerance =
            std::max(p_.control.force_tolerance * errors.largest_force, p_.rounding_force);
        if (!std::isfinite(errors.mean_product)) return result;
        result.converged = errors.law <= law_ratio * tolerance && errors.balance <= balance_ratio * tolerance;
        if (result.converged) break;
        if (selections < selection_ratios.size() &&
            errors.mean_product < square(selection_ratios[selections] * scale)) {
            ++selections;
            select_first_entrances(errors.mean_product);
            errors = evaluate();
        }
        if (!factorize()) break;
        for_contacts([](PathContact& c) { c.target = {}; });
        find_change(Change::prediction);
        const double predicted = mean_product(std::min(1.0, largest_step()));
        const double product =
            std::max(std::pow(predicted / errors.mean_product, centering_power) * errors.mean_product,
                     square(smallest_root_ratio * tolerance));
        for_contacts([product](PathContact& c) { c.target = c.corrected_target(product); });
        find_change(Change::correction);
        result.substitutions = substitutions_;
        const double step = std::min(1.0, step_ratio * largest_step());
        advance(step);
        if (step >= short_step) continue;
        ++short_steps;
        hold_blocking(step);
    }
    d = displacement_;
    return result;
}

void InteriorPoint::set_linear_forces() {
    for (const ContactIndex k : path_of_.indices()) {
        Forces forces;
        if (path_of_[k] != no_path) {
            const PathContact& c = contacts_[path_of_[k]];
            forces = {c.normal_force(), c.at.shear};
        }
        trials_.set_linear_forces(k, forces);
    }
}

// --- contacts

template <class Body>
void InteriorPoint::for_contacts(const Body& body) {
    pool_.parallel_for(contacts_.size(), [&](std::size_t begin, std::size_t end) {
        for (PathContact& c : std::span(contacts_).subspan(begin, end - begin)) body(c);
    });
}

void InteriorPoint::find_contacts(RowSpan<const Vec6> d) {
    contacts_.clear();
    path_of_.assign(trials_.count(), no_path);
    for (const ContactIndex k : path_of_.indices()) {
        if (!trials_[k].may_close) continue;
        if (bounds_.is_on_segment(k) && !bounds_.has_line(k)) bounds_.request_line(k);
        path_of_[k] = contacts_.size();
        contacts_.emplace_back().contact = k;
    }
    bounds_.find_requested_lines();
    for_contacts([&](PathContact& c) { set_limits(c, d); });
}

void InteriorPoint::set_limits(PathContact& c, RowSpan<const Vec6> d) const {
    const ContactIndex k = c.contact;
    const double least_normal = trials_.least_normal_force(k);
    c.bonded = std::isinf(least_normal);
    c.least_normal = c.bonded ? 0 : least_normal;
    c.opening = trials_.normal_measure(k);
    c.shear_stiffness = p_.springs[k].shear_stiffness;
    const double spring = trials_.law(k).normal(p_.springs[k].rows.measure(c.opening, d));
    c.at.normal = c.bonded ? spring : std::max(spring - c.least_normal, 0.0);
    const ShearLine line = bounds_.line(k, c.normal_force(), d);
    const double slope = std::max(line.slope, 0.0);
    c.cohesion = std::max(line.cohesion + slope * c.least_normal, 0.0);
    c.forward = slope - trials_[k].tilt;
    c.backward = slope + trials_[k].tilt;
    c.shear = slope == 0 && c.cohesion == 0 ? PathContact::Shear::none : PathContact::Shear::bounded;
    if (c.cohesion > unbounded_cohesion) c.shear = PathContact::Shear::elastic;
    set_springs(c, d);
}

void InteriorPoint::set_springs(PathContact& c, RowSpan<const Vec6> d) const {
    const ContactSprings& s = p_.springs[c.contact];
    const Vec2 relative = s.rows.relative_displacement(d);
    const TrialContacts::SpringForce normal =
        trials_.normal_tangent(c.contact, c.normal_force(), c.opening.at(relative));
    c.spring_normal = normal.force - c.least_normal;
    c.normal_stiffness = normal.stiffness;
    c.spring_shear = trials_.law(c.contact).shear_origin + c.shear_stiffness * s.shear.at(relative);
}

double InteriorPoint::scale_of_forces() const {
    double squares = 0;
    std::size_t count = 0;
    for (const PathContact& c : contacts_) {
        if (!(c.at.normal > 0)) continue;
        squares += square(c.at.normal);
        ++count;
    }
    return count == 0 ? 0 : std::sqrt(squares / static_cast<double>(count));
}

void InteriorPoint::select_first_entrances(double product) {
    trials_.set_displacement(displacement_, displacement_);
    entrances_.select_first();
    const std::vector<PathContact> before = std::exchange(contacts_, {});
    for (const ContactIndex k : path_of_.indices()) {
        const std::size_t i = std::exchange(path_of_[k], no_path);
        if (!trials_[k].may_close) continue;
        path_of_[k] = contacts_.size();
        if (i != no_path) {
            contacts_.push_back(before[i]);
            continue;
        }
        PathContact& c = contacts_.emplace_back();
        c.contact = k;
        set_limits(c, displacement_);
        c.place_on_path(product);
    }
}

void InteriorPoint::hold_blocking(double step) {
    for (const PathContact& c : contacts_) {
        if (c.largest_step() > blocking_reach * step) continue;
        const BlockPair& rows = p_.springs[c.contact].rows;
        for (const RowIndex row : {rows.first, rows.second}) {
            if (!row.exists()) continue;
            for (const ContactIndex k : p_.row_contacts.of(row))
                if (path_of_[k] != no_path) contacts_[path_of_[k]].hold_bounds();
        }
    }
}

// --- evaluation

InteriorPoint::Errors InteriorPoint::evaluate() {
    const auto errors_of_chunk = [&](std::size_t begin, std::size_t end) {
        Errors errors;
        for (PathContact& c : std::span(contacts_).subspan(begin, end - begin)) {
            set_springs(c, displacement_);
            errors.law = std::max(errors.law, c.law_error());
            errors.largest_force =
                std::max({errors.largest_force, std::abs(c.normal_force()), std::abs(c.at.shear)});
            errors.mean_product += c.products(0).sum();
        }
        return errors;
    };
    Errors errors = pool_.parallel_reduce(
        contacts_.size(), Errors(), errors_of_chunk, [](const Errors& a, const Errors& b) {
            return Errors{0, std::max(a.law, b.law), std::max(a.largest_force, b.largest_force),
                          a.mean_product + b.mean_product};
        });
    errors.mean_product /= 3 * static_cast<double>(contacts_.size());
    errors.balance = evaluate_balance();
    return errors;
}

double InteriorPoint::evaluate_balance() {
    residual_.resize(displacement_.size());
    pool_.parallel_for(residual_.size(), [&](std::size_t begin, std::size_t end) {
        for (const RowIndex row : indices<RowIndex>(begin, end))
            residual_[row] = p_.base.load[row] - p_.base.stiffness[row] * displacement_[row];
    });
    const auto force_of = [&](std::size_t i) {
        const PathContact& c = contacts_[i];
        return c.normal_force() * c.opening.direction - c.at.shear * p_.springs[c.contact].shear.direction;
    };
    add_forces(force_of, residual_);
    for (std::size_t k = 0; k < p_.bolts.size(); ++k) {
        const BoltSpring& b = p_.bolts[k];
        const double elongation = b.rows.measure(b.elongation, displacement_);
        b.rows.add_force(b.elongation, -trials_.bolts().linear_force(k, elongation), residual_);
    }
    const auto largest_of_chunk = [&](std::size_t begin, std::size_t end) {
        double largest = 0;
        for (const RowIndex row : indices<RowIndex>(begin, end)) {
            Vec6 force = residual_[row];
            force.tail<4>() /= std::sqrt(p_.blocks.moments[p_.rows.block_of[row]].area);
            largest = std::max(largest, force.cwiseAbs().maxCoeff());
        }
        return largest;
    };
    return pool_.parallel_reduce(residual_.size(), 0.0, largest_of_chunk,
                                 [](double a, double b) { return std::max(a, b); });
}

// --- an iteration

bool InteriorPoint::factorize() {
    end_of(Phase::evaluation, times_);
    springs_.assign(trials_.count(), {});
    for_contacts([&](PathContact& c) {
        c.set_fractions();
        springs_[c.contact] = {c.normal_fraction * c.normal_stiffness, c.shear_fraction * c.shear_stiffness,
                               trials_[c.contact].tilt};
    });
    matrix_.assemble(trials_, springs_);
    end_of(Phase::assembly, times_);
    const bool definite = solver_.refactorize(matrix_.matrix(), matrix_.changed());
    end_of(Phase::factorisation, times_);
    return definite;
}

/// The change of Eq. (93).
void InteriorPoint::find_change(Change kind) {
    for_contacts([](PathContact& c) { c.set_constants(); });
    change_ = residual_;
    const auto force_of = [&](std::size_t i) {
        const PathContact& c = contacts_[i];
        return c.normal_constant * c.opening.direction -
               (c.shear_constant + c.coupling * c.normal_constant) * p_.springs[c.contact].shear.direction;
    };
    add_forces(force_of, change_);
    end_of(Phase::evaluation, times_);
    solve_coupled(change_, kind);
    end_of(Phase::solution, times_);
    for_contacts([&](PathContact& c) {
        const ContactSprings& s = p_.springs[c.contact];
        const Vec2 relative = s.rows.relative_displacement(change_);
        c.set_change(c.opening.direction.dot(relative), s.shear.direction.dot(relative));
    });
}

double InteriorPoint::largest_step() const {
    const auto smallest_of_chunk = [&](std::size_t begin, std::size_t end) {
        double step = std::numeric_limits<double>::infinity();
        for (const PathContact& c : std::span(contacts_).subspan(begin, end - begin))
            step = std::min(step, c.largest_step());
        return step;
    };
    return pool_.parallel_reduce(contacts_.size(), std::numeric_limits<double>::infinity(), smallest_of_chunk,
                                 [](double a, double b) { return std::min(a, b); });
}

double InteriorPoint::mean_product(double step) const {
    const auto sum_of_chunk = [&](std::size_t begin, std::size_t end) {
        double sum = 0;
        for (const PathContact& c : std::span(contacts_).subspan(begin, end - begin))
            sum += c.products(step).sum();
        return sum;
    };
    return pool_.parallel_reduce(contacts_.size(), 0.0, sum_of_chunk, std::plus<>()) /
           (3 * static_cast<double>(contacts_.size()));
}

void InteriorPoint::advance(double step) {
    for_contacts([step](PathContact& c) { c.advance(step); });
    pool_.parallel_for(displacement_.size(), [&](std::size_t begin, std::size_t end) {
        for (const RowIndex row : indices<RowIndex>(begin, end)) displacement_[row] += step * change_[row];
    });
}

}  // namespace rockslope::dda
