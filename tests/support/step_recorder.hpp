#pragma once

#include <cmath>
#include <optional>
#include <vector>

#include "dda/analysis/bonds.hpp"
#include "dda/analysis/step_equations.hpp"
#include "dda/solve/contact_solution.hpp"
#include "dda/solve/methods/limited_contacts.hpp"
#include "dda/solve/outer/break_bonds.hpp"
#include "dda/trial/step_contacts.hpp"
#include "support/recorded_step.hpp"

namespace rockslope::recorded_step {

/// Solves a step as a run does in its first attempt, and records its equations and its solution.
class StepRecorder {
  public:
    explicit StepRecorder(const dda::Model& model)
        : model_(model), rows_(model.motion), scale_(model, rows_), setting_{model_, rows_, scale_, pool_} {}

    /// @param state at the step's start; @param dt s, its size. @return nothing if it does not converge.
    std::optional<RecordedStep> record(const dda::Stage& stage, const dda::State& state, double dt) const {
        dda::RowContacts row_contacts;
        const dda::StepEquations step = dda::step_equations(
            setting_, stage, state, dt, dda::initial_prediction(setting_, stage, state, dt), row_contacts);
        const std::size_t count = step.contacts.contacts.size();
        const dda::PerContact<const dda::EvaluatedContact*> no_guess(count, nullptr);
        dda::PerContact<double> held;
        if (dda::bonds_hold(model_, stage)) held = dda::held_shares(model_, step.contacts.contacts);
        dda::StepProblem problem = dda::step_problem(setting_, stage, state, step, row_contacts);
        problem.guess = no_guess;
        problem.held_shares = held;
        const dda::OpenCloseResult result = solve(problem);
        if (!result.converged) return std::nullopt;

        RecordedStep recorded;
        recorded.iterations = result.iterations;
        recorded.factorizations = result.factorizations;
        for (const dda::RowIndex row : rows_.rows())
            recorded.rows.push_back({std::sqrt(state.blocks.moments[rows_.block_of[row]].area),
                                     step.base.stiffness[row], step.base.load[row],
                                     result.displacement[row]});
        const std::vector<dda::Piece> start = start_pieces(problem);
        dda::PerContact<const dda::EvaluatedContact*> solution;
        for (const dda::EvaluatedContact& contact : result.contacts) solution.push_back(&contact);
        problem.guess = solution;
        dda::StepContacts step_contacts(problem, pool_);
        const dda::TrialContacts& trials = step_contacts.trials;
        evaluate(problem, step_contacts, result);
        recorded.tolerance = trials.tolerance();
        dda::PerContact<dda::LimitedContact> contacts;
        dda::limit_contacts(problem, trials, step_contacts.bounds, result.displacement, pool_, contacts);
        for (const dda::ContactIndex k : contacts.indices())
            if (contacts[k].may_close)
                recorded.contacts.push_back({*contacts[k].rows, contacts[k], start[k]});
        return recorded;
    }

  private:
    dda::OpenCloseResult solve(const dda::StepProblem& problem) const {
        std::vector<std::pair<dda::RowIndex, dda::RowIndex>> pairs;
        const auto add = [&](const dda::BlockPair& rows) {
            if (rows.first.exists() && rows.second.exists()) pairs.emplace_back(rows.first, rows.second);
        };
        for (const dda::ContactSprings& springs : problem.springs) add(springs.rows);
        for (const dda::BoltSpring& bolt : problem.bolts) add(bolt.rows);
        const auto pattern = dda::BlockPattern::from_pairs(rows_.count(), std::move(pairs));
        const auto solver = dda::make_linear_solver(model_.solver, pool_);
        solver->analyze(pattern);
        dda::IterationWorkspace work;
        return dda::solve_contacts(problem, pattern, *solver, work, pool_);
    }
    /// The pieces that contacts and bolts are on at the step's start.
    std::vector<dda::Piece> start_pieces(const dda::StepProblem& problem) const {
        const dda::TrialContacts trials(problem, pool_);
        std::vector<dda::Piece> pieces(trials.count() + problem.bolts.size());
        for (std::size_t k = 0; k < trials.count(); ++k) {
            const dda::ContactTrial& trial = trials[dda::ContactIndex(k)];
            if (trial.has_normal_spring) pieces[k].normal = dda::Piece::Normal::pressed;
            if (!trial.has_shear_spring) pieces[k].slides = trial.slides_forward ? 1 : -1;
        }
        return pieces;
    }
    /// Evaluates the laws at the solution.
    static void evaluate(const dda::StepProblem& problem, dda::StepContacts& contacts,
                         const dda::OpenCloseResult& result) {
        contacts.trials.set_displacement(result.displacement, result.displacement);
        contacts.entrances.select_first();
        contacts.bounds.update_all();
        while (dda::break_bonds(problem, contacts.trials)) contacts.bounds.update_all();
        contacts.trials.update_active_set();
        contacts.bounds.update_all();
        contacts.trials.force_change();
    }

    const dda::Model& model_;
    ThreadPool pool_{1};
    dda::RowMap rows_;
    dda::ModelScale scale_;
    dda::StepSetting setting_;
};

}  // namespace rockslope::recorded_step
