#include "dda/analysis/open_close_iteration.hpp"

#include <algorithm>
#include <cmath>

#include "dda/contact/detect.hpp"
#include "dda/linear/anderson.hpp"

namespace dda {

namespace {

/// Iterations in which the shear bounds follow every iterate; past these they wait for the minimum of the
/// potential.
constexpr int following_iterations = 30;
/// Back-substitutions spent on the coupling of shear bounds and normal forces in one iteration, and the
/// earlier ones remembered.
constexpr int friction_iterations = 12;
constexpr int friction_memory = 6;
/// Evaluations of the potential's slope in a line search; each halves the bracket at worst.
constexpr int line_search_evaluations = 40;

/// A contact during the iteration. With the bounds held, its normal force depends on the gap alone and its
/// shear force on the elastic trial force alone, both without a jump: that makes the potential convex. What
/// couples them is the bounds, zero where it is open.
struct Trial {
    bool pressed = false;   ///< has its normal spring in the linear system
    bool locked = false;    ///< has its shear spring in the linear system
    double held_force = 0;  ///< shear force in the linear system when not locked, N per metre
    bool forward = true;    ///< the direction it slides in
    Strength bounds;        ///< that the shear force is clipped to
    double gap_offset = 0;  ///< m, gap less the linear measure of the present displacement
    bool torn = false;
    bool may_close = true;
};

/// A contact's forces at one displacement.
struct Forces {
    double normal = 0;
    double shear = 0;
};

class Iteration {
  public:
    Iteration(const StepProblem& problem, const BlockPattern& pattern, LinearSolver& solver,
              BlockMatrix& work, const Crew& crew)
        : p_(problem), pattern_(pattern), solver_(solver), matrix_(work), crew_(crew) {
        trials_.resize(p_.contacts.size());
        yielding_.assign(p_.bolts.size(), 0);
        displacement_.assign(static_cast<std::size_t>(p_.rows.count()), Vec6::Zero());
        for (std::size_t k = 0; k < trials_.size(); ++k) start(p_.contacts[k], trials_[k]);
    }

    OpenCloseResult run() {
        OpenCloseResult result;
        bool changed = true;
        bool at_minimum = false;
        while (result.iterations < p_.control.iteration_limit) {
            if (changed) {
                assemble();
                ++result.factorizations;
                if (!solver_.factorize(matrix_)) {
                    result.singular = true;
                    return result;
                }
            }
            ++result.iterations;
            const bool follow = result.iterations <= following_iterations || at_minimum;
            const std::vector<Vec6> target = follow ? solve_with_friction() : solve_as_held();
            const bool full_step = advance_towards(target, result.iterations == 1);

            update_geometry();
            if (follow) choose_lines();
            double change = force_change(result);
            at_minimum = full_step && change <= tolerance();
            if (follow || at_minimum) {
                update_bounds();
                change = force_change(result);
            }
            if (full_step && change <= tolerance() && !tear()) {
                result.converged = true;
                break;
            }
            changed = choose_springs();
        }
        finish(result);
        return result;
    }

  private:
    void start(const Contact& contact, Trial& trial) {
        trial.may_close = !contact.held_back;
        trial.gap_offset = contact.gap;
        const bool was_closed = contact.state != ContactState::open;
        trial.pressed = trial.may_close && (was_closed || (contact.gap < 0 && contact.group < 0));
        trial.locked = trial.pressed && contact.state != ContactState::sliding;
        if (trial.pressed) trial.bounds = bounds_of(contact, contact.normal_force);
        trial.held_force = contact.shear_force;
        trial.forward = contact.shear_force >= 0;
    }

    Strength bounds_of(const Contact& contact, double normal_force) const {
        const JointMaterial& material =
            p_.model.joint_materials[static_cast<std::size_t>(contact.joint_material)];
        return strength(material.law, contact.history, normal_force, contact.length);
    }

    // --- the linear system
    // -----------------------------------------------------------------------------------------

    void assemble() {
        matrix_.reset(pattern_);
        for (std::size_t r = 0; r < p_.base.stiffness.size(); ++r) matrix_.diagonal[r] = p_.base.stiffness[r];
        for (std::size_t k = 0; k < trials_.size(); ++k) {
            const ContactSprings& s = p_.springs[k];
            if (trials_[k].pressed) s.rows.add_stiffness(s.normal, s.normal_stiffness, pattern_, matrix_);
            if (trials_[k].locked) s.rows.add_stiffness(s.shear, s.shear_stiffness, pattern_, matrix_);
        }
        for (std::size_t k = 0; k < p_.bolts.size(); ++k) {
            if (yielding_[k] == 0)
                p_.bolts[k].rows.add_stiffness(p_.bolts[k].elongation, p_.bolts[k].stiffness, pattern_,
                                               matrix_);
        }
    }

    std::vector<Vec6> right_hand_side() const {
        std::vector<Vec6> load = p_.base.load;
        for (std::size_t k = 0; k < trials_.size(); ++k) {
            const Trial& trial = trials_[k];
            const ContactSprings& s = p_.springs[k];
            // Forces at zero unknowns: the known displacement of blocks without unknowns is in
            // Relative::known.
            if (trial.pressed)
                s.rows.add_force(s.normal, -s.normal_stiffness * (trial.gap_offset + s.normal.known), load);
            const double shear = trial.locked ? p_.contacts[k].shear_force + s.shear_stiffness * s.shear.known
                                              : trial.held_force;
            if (shear != 0) s.rows.add_force(s.shear, -shear, load);
        }
        for (std::size_t k = 0; k < p_.bolts.size(); ++k) {
            const BoltSpring& b = p_.bolts[k];
            const double force = yielding_[k] == 0 ? p_.bolt_force[k] + b.stiffness * b.elongation.known
                                                   : yielding_[k] * p_.model.bolts[k].yield_force;
            b.rows.add_force(b.elongation, -force, load);
        }
        return load;
    }

    std::vector<Vec6> solve_as_held() {
        std::vector<Vec6> d = right_hand_side();
        solver_.solve(d);
        return d;
    }

    /// Solves the linear system with the sliding contacts' shear forces at the bounds that belong to its own
    /// normal forces. The coupling makes the equations unsymmetric; instead of a second kind of factor, the
    /// held forces are found as a fixed point, accelerated, at one back-substitution each.
    std::vector<Vec6> solve_with_friction() {
        std::vector<std::size_t> sliding;
        for (std::size_t k = 0; k < trials_.size(); ++k) {
            if (trials_[k].pressed && !trials_[k].locked) sliding.push_back(k);
        }
        std::vector<Vec6> d = solve_as_held();
        Eigen::VectorXd held(static_cast<Eigen::Index>(sliding.size()));
        Eigen::VectorXd image(held.size());
        AndersonMixing mixing(friction_memory);
        for (int k = 0; k < friction_iterations && !sliding.empty(); ++k) {
            for (std::size_t s = 0; s < sliding.size(); ++s) {
                const auto row = static_cast<Eigen::Index>(s);
                held[row] = trials_[sliding[s]].held_force;
                image[row] = bound_at(sliding[s], d);
            }
            if ((image - held).cwiseAbs().maxCoeff() <= tolerance() / 2) break;
            const Eigen::VectorXd next = mixing.next(held, image);
            for (std::size_t s = 0; s < sliding.size(); ++s)
                trials_[sliding[s]].held_force = next[static_cast<Eigen::Index>(s)];
            d = solve_as_held();
        }
        for (const std::size_t k : sliding) {
            Strength& bounds = trials_[k].bounds;
            (trials_[k].forward ? bounds.forward : bounds.backward) = std::abs(trials_[k].held_force);
        }
        return d;
    }

    /// The shear bound of a sliding contact, with its sign, at the normal force that the linear system gives
    /// for a displacement.
    double bound_at(std::size_t k, const std::vector<Vec6>& d) const {
        const ContactSprings& s = p_.springs[k];
        const Contact& contact = p_.contacts[k];
        const double normal = -s.normal_stiffness * (trials_[k].gap_offset + s.rows.measure(s.normal, d));
        if (normal <= 0 && !is_bonded(k)) return 0;
        const Strength bounds = bounds_of(contact, normal);
        return trials_[k].forward ? bounds.forward : -bounds.backward;
    }

    /// What the linear system takes the contact's forces to be.
    Forces linear_forces(std::size_t k, double opening, double shearing) const {
        const Trial& trial = trials_[k];
        const ContactSprings& s = p_.springs[k];
        return {trial.pressed ? -s.normal_stiffness * (trial.gap_offset + opening) : 0,
                trial.locked ? p_.contacts[k].shear_force + s.shear_stiffness * shearing : trial.held_force};
    }

    // --- the law
    // ---------------------------------------------------------------------------------------------------

    bool is_bonded(std::size_t k) const { return p_.contacts[k].bonded && !trials_[k].torn; }

    /// What the law says they are, with the shear bounds held.
    Forces law_forces(std::size_t k, double opening, double shearing) const {
        const Trial& trial = trials_[k];
        if (!trial.may_close) return {};
        const ContactSprings& s = p_.springs[k];
        const double normal = -s.normal_stiffness * (trial.gap_offset + opening);
        const double elastic = p_.contacts[k].shear_force + s.shear_stiffness * shearing;
        return {is_bonded(k) ? normal : std::max(normal, 0.0),
                std::clamp(elastic, -trial.bounds.backward, trial.bounds.forward)};
    }

    /// Whether the joint bears an elastic shear force without slipping. Without strength nothing is locked.
    static bool within(double force, const Strength& bounds) {
        return force <= bounds.forward && force >= -bounds.backward && bounds.forward + bounds.backward > 0;
    }

    double bolt_law_force(std::size_t k, double elongation) const {
        const double elastic = p_.bolt_force[k] + p_.bolts[k].stiffness * elongation;
        const double yield = p_.model.bolts[k].yield_force;
        return yield > 0 ? std::clamp(elastic, -yield, yield) : elastic;
    }
    double bolt_linear_force(std::size_t k, double elongation) const {
        return yielding_[k] == 0 ? p_.bolt_force[k] + p_.bolts[k].stiffness * elongation
                                 : yielding_[k] * p_.model.bolts[k].yield_force;
    }

    // --- one Newton step
    // -------------------------------------------------------------------------------------------

    /// Goes from the present displacement towards the linear system's solution, as far as the potential
    /// falls.
    /// @return whether it went all the way.
    bool advance_towards(const std::vector<Vec6>& target, bool first) {
        double share = 1;
        if (!first) {
            LineSearch search(*this, target);
            share = search.step();
        }
        for (std::size_t r = 0; r < displacement_.size(); ++r)
            displacement_[r] += share * (target[r] - displacement_[r]);
        if (share == 1) displacement_ = target;
        return share == 1;
    }

    /// The slope of the potential along the way to the linear system's solution. At the solution the linear
    /// forces balance, so the slope is the work of what the law's forces differ from those, less what the way
    /// still to go takes from the quadratic part.
    class LineSearch {
      public:
        LineSearch(const Iteration& iteration, const std::vector<Vec6>& target) : it_(iteration) {
            std::vector<Vec6> way(target.size());
            for (std::size_t r = 0; r < target.size(); ++r) {
                way[r] = target[r] - it_.displacement_[r];
                curvature_ += way[r].dot(it_.p_.base.stiffness[r] * way[r]);
            }
            const auto line = [&](const PairRows& rows, const Relative& relative) {
                const double end = rows.measure(relative, target);
                return Line{end, rows.measure(relative, way) - relative.known};
            };
            for (const ContactSprings& s : it_.p_.springs) {
                opening_.push_back(line(s.rows, s.normal));
                shearing_.push_back(line(s.rows, s.shear));
            }
            for (const BoltSpring& b : it_.p_.bolts) elongation_.push_back(line(b.rows, b.elongation));
        }

        double step() const {
            // Where the law agrees with the linear system its solution is the minimum, whatever rounding
            // makes of the slope.
            if (largest_difference() <= it_.tolerance()) return 1;
            if (slope(1) <= 0) return 1;
            double low = 0;
            double high = 1;
            for (int k = 0; k < line_search_evaluations && high - low > 1e-6; ++k) {
                const double middle = (low + high) / 2;
                (slope(middle) > 0 ? high : low) = middle;
            }
            return high;
        }

      private:
        struct Line {
            double end = 0;
            double rate = 0;
            double at(double share) const { return end - (1 - share) * rate; }
        };

        double largest_difference() const {
            double largest = 0;
            for (std::size_t k = 0; k < opening_.size(); ++k) {
                const Forces linear = it_.linear_forces(k, opening_[k].end, shearing_[k].end);
                const Forces law = it_.law_forces(k, opening_[k].end, shearing_[k].end);
                largest = std::max(
                    {largest, std::abs(law.normal - linear.normal), std::abs(law.shear - linear.shear)});
            }
            return largest;
        }

        double slope(double share) const {
            double sum = -(1 - share) * curvature_;
            for (std::size_t k = 0; k < opening_.size(); ++k) {
                const Forces linear = it_.linear_forces(k, opening_[k].end, shearing_[k].end);
                const Forces law = it_.law_forces(k, opening_[k].at(share), shearing_[k].at(share));
                sum += -(law.normal - linear.normal) * opening_[k].rate +
                       (law.shear - linear.shear) * shearing_[k].rate;
            }
            for (std::size_t k = 0; k < elongation_.size(); ++k) {
                sum += (it_.bolt_law_force(k, elongation_[k].at(share)) -
                        it_.bolt_linear_force(k, elongation_[k].end)) *
                       elongation_[k].rate;
            }
            return sum;
        }

        const Iteration& it_;
        double curvature_ = 0;
        std::vector<Line> opening_;
        std::vector<Line> shearing_;
        std::vector<Line> elongation_;
    };

    // --- judging
    // ---------------------------------------------------------------------------------------------------

    /// Measures and true gaps at the present displacement; the linear measure of the gap is kept exact there.
    void update_geometry() {
        std::vector<BlockMap> maps;
        maps.reserve(p_.prescribed.size());
        for (std::size_t b = 0; b < p_.prescribed.size(); ++b) {
            const int row = p_.rows.row_of[b];
            maps.emplace_back(p_.blocks.moments[b].centroid,
                              row < 0 ? p_.prescribed[b] : displacement_[static_cast<std::size_t>(row)]);
        }
        opening_.resize(trials_.size());
        shearing_.resize(trials_.size());
        linear_.resize(trials_.size());
        crew_.for_ranges(trials_.size(), [&](std::size_t begin, std::size_t end) {
            for (std::size_t k = begin; k < end; ++k) {
                const Contact& contact = p_.contacts[k];
                const ContactSprings& s = p_.springs[k];
                opening_[k] = s.rows.measure(s.normal, displacement_);
                shearing_[k] = s.rows.measure(s.shear, displacement_);
                linear_[k] = linear_forces(k, opening_[k], shearing_[k]);
                const auto vertex = [&](int corner) {
                    return p_.blocks.vertices[static_cast<std::size_t>(corner)];
                };
                const BlockMap& edge_map = maps[static_cast<std::size_t>(contact.edge_block)];
                const BlockMap& corner_map = maps[static_cast<std::size_t>(contact.corner_block)];
                const int edge_end = p_.model.topology.next[static_cast<std::size_t>(contact.edge)];
                const double gap =
                    corner_edge_geometry(corner_map(vertex(contact.corner)), edge_map(vertex(contact.edge)),
                                         edge_map(vertex(edge_end)))
                        .gap;
                trials_[k].gap_offset = gap - opening_[k];
            }
        });
    }

    /// Of a group of vertex-vertex lines only the one with the largest gap, the last that is crossed, may
    /// close.
    void choose_lines() {
        std::vector<std::size_t>& chosen = chosen_;
        chosen.clear();
        for (std::size_t k = 0; k < trials_.size(); ++k) {
            const int group = p_.contacts[k].group;
            if (group < 0 || p_.contacts[k].held_back) continue;
            const auto g = static_cast<std::size_t>(group);
            if (chosen.size() <= g) chosen.resize(g + 1, trials_.size());
            std::size_t& best = chosen[g];
            if (best == trials_.size() || gap(k) > gap(best)) best = k;
        }
        for (std::size_t k = 0; k < trials_.size(); ++k) {
            const int group = p_.contacts[k].group;
            if (group >= 0 && !p_.contacts[k].held_back)
                trials_[k].may_close = chosen[static_cast<std::size_t>(group)] == k;
        }
    }

    double gap(std::size_t k) const { return trials_[k].gap_offset + opening_[k]; }

    /// The largest movement between the forces of the linear system and those of the law, N per metre.
    double force_change(OpenCloseResult& result) {
        double largest = 0;
        reference_ = 0;
        for (std::size_t k = 0; k < trials_.size(); ++k) {
            const Forces law = law_forces(k, opening_[k], shearing_[k]);
            const double moved =
                std::max(std::abs(law.normal - linear_[k].normal), std::abs(law.shear - linear_[k].shear));
            reference_ = std::max({reference_, std::abs(law.normal), std::abs(law.shear)});
            if (moved > largest) {
                largest = moved;
                result.worst_contact = static_cast<int>(k);
            }
        }
        for (std::size_t k = 0; k < p_.bolts.size(); ++k) {
            const double elongation = p_.bolts[k].rows.measure(p_.bolts[k].elongation, displacement_);
            largest =
                std::max(largest, std::abs(bolt_law_force(k, elongation) - bolt_linear_force(k, elongation)));
        }
        result.force_change = largest;
        return largest;
    }

    double tolerance() const { return std::max(p_.control.force_tolerance * reference_, p_.smallest_force); }

    /// Moves the shear bounds to those of the present normal forces.
    void update_bounds() {
        for (std::size_t k = 0; k < trials_.size(); ++k) {
            const Forces forces = law_forces(k, opening_[k], shearing_[k]);
            const bool open = !trials_[k].may_close || (forces.normal <= 0 && !is_bonded(k));
            trials_[k].bounds = open ? Strength{} : bounds_of(p_.contacts[k], forces.normal);
        }
    }

    /// Opens, for the rest of the step, the bonded contacts whose tension exceeds the strength. @return
    /// whether there were any.
    bool tear() {
        bool any = false;
        for (std::size_t k = 0; k < trials_.size(); ++k) {
            if (!is_bonded(k)) continue;
            if (law_forces(k, opening_[k], shearing_[k]).normal < -trials_[k].bounds.tensile) {
                trials_[k].torn = true;
                any = true;
            }
        }
        return any;
    }

    ContactState judged_state(std::size_t k) const {
        const ContactSprings& s = p_.springs[k];
        const Forces forces = law_forces(k, opening_[k], shearing_[k]);
        if (forces.normal <= 0 && !(is_bonded(k) && trials_[k].may_close)) return ContactState::open;
        const double elastic = p_.contacts[k].shear_force + s.shear_stiffness * shearing_[k];
        return within(elastic, trials_[k].bounds) ? ContactState::locked : ContactState::sliding;
    }

    /// Sets the linear system's springs to the judged states. @return whether its matrix changes.
    bool choose_springs() {
        bool changed = false;
        for (std::size_t k = 0; k < trials_.size(); ++k) {
            Trial& trial = trials_[k];
            const Forces law = law_forces(k, opening_[k], shearing_[k]);
            const double elastic = p_.contacts[k].shear_force + p_.springs[k].shear_stiffness * shearing_[k];
            const bool pressed = trial.may_close && (law.normal > 0 || is_bonded(k));
            const bool locked = trial.may_close && within(elastic, trial.bounds);
            changed = changed || pressed != trial.pressed || locked != trial.locked;
            trial.pressed = pressed;
            trial.locked = locked;
            trial.held_force = law.shear;
            trial.forward = elastic >= 0;
        }
        for (std::size_t k = 0; k < p_.bolts.size(); ++k) {
            const double elongation = p_.bolts[k].rows.measure(p_.bolts[k].elongation, displacement_);
            const double elastic = p_.bolt_force[k] + p_.bolts[k].stiffness * elongation;
            const double law = bolt_law_force(k, elongation);
            const int yielding = elastic == law ? 0 : (elastic > law ? 1 : -1);
            changed = changed || yielding != yielding_[k];
            yielding_[k] = yielding;
        }
        return changed;
    }

    void finish(OpenCloseResult& result) {
        result.displacement = displacement_;
        result.contacts.resize(trials_.size());
        for (std::size_t k = 0; k < trials_.size(); ++k) {
            JudgedContact& judged = result.contacts[k];
            const Forces forces = law_forces(k, opening_[k], shearing_[k]);
            judged.state = judged_state(k);
            judged.gap = gap(k);
            judged.normal_force = forces.normal;
            judged.shear_force = forces.shear;
            judged.displacement = shearing_[k];
            judged.torn = trials_[k].torn;
            if (judged.state != ContactState::open) {
                const double elastic =
                    p_.contacts[k].shear_force + p_.springs[k].shear_stiffness * shearing_[k];
                judged.slip = (elastic - forces.shear) / p_.springs[k].shear_stiffness;
            }
        }
        for (std::size_t k = 0; k < p_.bolts.size(); ++k) {
            result.bolt_force.push_back(
                bolt_law_force(k, p_.bolts[k].rows.measure(p_.bolts[k].elongation, displacement_)));
        }
    }

    const StepProblem& p_;
    const BlockPattern& pattern_;
    LinearSolver& solver_;
    BlockMatrix& matrix_;
    const Crew& crew_;
    std::vector<Trial> trials_;
    std::vector<int> yielding_;  ///< per bolt: the sign of its yielding force, 0 when elastic
    std::vector<Vec6> displacement_;
    std::vector<double> opening_;   ///< per contact, linear measure of the normal displacement, m
    std::vector<double> shearing_;  ///< per contact, of the tangential displacement, m
    std::vector<Forces> linear_;    ///< per contact, in the linear system
    std::vector<std::size_t> chosen_;
    double reference_ = 0;
};

}  // namespace

OpenCloseResult iterate_open_close(const StepProblem& problem, const BlockPattern& pattern,
                                   LinearSolver& solver, BlockMatrix& work, const Crew& crew) {
    return Iteration(problem, pattern, solver, work, crew).run();
}

}  // namespace dda
