#include <limits>
#include <utility>

#include "dda/linear/linear_solver.hpp"
#include "dda/linear/multifrontal_factor.hpp"
#include "dda/linear/refined_factor.hpp"

namespace dda {

namespace {

/// The share of the right-hand side that is left in the residual of a solution that is near. At 1e-3 the
/// walls that `bench_steps` lets go took three iterations for two, at 1e-4 as many as exactly.
constexpr double near_share = 1e-5;

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

/// In double precision up to so many submatrices of the factor.
class MultifrontalSolver final : public LinearSolver {
  public:
    MultifrontalSolver(const Crew& crew, double most_submatrices) : crew_(crew), most_(most_submatrices) {}

    void analyze(const BlockPattern& pattern) override {
        pattern_ = pattern;
        const SupernodeTree tree = tree_of(pattern);
        single_ = submatrices(tree) > most_;
        if (single_)
            refined_.analyze(pattern, tree);
        else
            factor_.analyze(pattern, tree);
    }
    bool factorize(const BlockMatrix& matrix) override { return refactorize(matrix, {}); }
    bool refactorize(const BlockMatrix& matrix, std::span<const char> changed) override {
        matrix_ = &matrix;
        instead_ = false;
        if (!single_) return factor_.factorize(matrix, crew_, changed);
        return refined_.factorize(matrix, crew_, changed) || factorize_instead();
    }
    int fallbacks() const override { return fallbacks_; }
    void solve(std::vector<Vec6>& right_hand_side) override {
        std::vector<Vec6> x(right_hand_side.size(), Vec6::Zero());
        solve_from(x, right_hand_side, exact_residual);
        right_hand_side = std::move(x);
    }
    int approach(std::vector<Vec6>& x, const std::vector<Vec6>& b) override {
        return solve_from(x, b, near_share);
    }
    void solve_roughly(std::vector<Vec6>& right_hand_side) override {
        if (is_rough())
            refined_.solve_roughly(right_hand_side, crew_);
        else
            factor_.solve(right_hand_side, crew_);
    }
    int refine(std::vector<Vec6>& x, const std::vector<Vec6>& b, double share) override {
        return is_rough() ? solve_from(x, b, share) : 0;
    }

  private:
    static SupernodeTree tree_of(const BlockPattern& pattern) {
        return find_supernodes(pattern, fill_reducing_order(pattern));
    }
    /// Whether the present factor is in single precision.
    bool is_rough() const { return single_ && !instead_; }
    /// Brings x to A^-1 b: a rough factor to a residual of that share. @return substitutions taken.
    int solve_from(std::vector<Vec6>& x, const std::vector<Vec6>& b, double share) {
        int taken = 0;
        if (is_rough()) {
            const RefinedFactor::Outcome outcome = refined_.refine(x, b, share, crew_);
            taken = outcome.substitutions;
            if (outcome.converged) return taken;
            if (!factorize_instead()) {
                // Indefinite by less than single precision tells: the step is refused for what is no number.
                x.assign(x.size(), Vec6::Constant(no_number));
                return taken;
            }
        }
        x = b;
        factor_.solve(x, crew_);
        return taken + 1;
    }
    /// The present matrix in double precision, where single precision is too little for it.
    bool factorize_instead() {
        ++fallbacks_;
        factor_.analyze(pattern_, tree_of(pattern_));
        instead_ = factor_.factorize(*matrix_, crew_);
        return instead_;
    }

    const Crew& crew_;
    double most_;
    BlockPattern pattern_;
    const BlockMatrix* matrix_ = nullptr;
    bool single_ = false;   ///< the pattern's factors are in single precision
    bool instead_ = false;  ///< but not the present one
    int fallbacks_ = 0;
    MultifrontalFactor<double> factor_;
    RefinedFactor refined_;
};

}  // namespace

std::unique_ptr<LinearSolver> make_multifrontal_solver(const Crew& crew, double most_submatrices) {
    return std::make_unique<MultifrontalSolver>(crew, most_submatrices);
}

std::unique_ptr<LinearSolver> make_linear_solver(SolverKind kind, const Crew& crew) {
    switch (kind) {
        case SolverKind::cholmod:
            return make_cholmod_solver();
        case SolverKind::refined:
            return make_multifrontal_solver(crew, 0);
        default:
            return make_multifrontal_solver(crew);
    }
}

}  // namespace dda
