#include <limits>

#include "dda/linear/linear_solver.hpp"
#include "dda/linear/multifrontal_factor.hpp"
#include "dda/linear/refined_factor.hpp"

namespace dda {

namespace {

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

/// In double precision up to so many submatrices of the factor; beyond, memory is worth more than the time
/// that refining takes.
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
    void solve(std::vector<Vec6>& right_hand_side) override {
        if (single_ && !instead_) {
            if (refined_.solve(right_hand_side, crew_)) return;
            if (!factorize_instead()) {
                // Indefinite by less than single precision tells: the step is refused for what is no number.
                right_hand_side.assign(right_hand_side.size(), Vec6::Constant(no_number));
                return;
            }
        }
        factor_.solve(right_hand_side, crew_);
    }

  private:
    static SupernodeTree tree_of(const BlockPattern& pattern) {
        return find_supernodes(pattern, fill_reducing_order(pattern));
    }
    /// The present matrix in double precision, where single precision is too little for it.
    bool factorize_instead() {
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
