#include "dda/linear/linear_solver.hpp"
#include "dda/linear/multifrontal_factor.hpp"

namespace dda {

namespace {

class MultifrontalSolver final : public LinearSolver {
  public:
    explicit MultifrontalSolver(const Crew& crew) : crew_(crew) {}

    void analyze(const BlockPattern& pattern) override {
        factor_.analyze(pattern, find_supernodes(pattern, fill_reducing_order(pattern)));
    }
    bool factorize(const BlockMatrix& matrix) override { return factor_.factorize(matrix, crew_); }
    bool refactorize(const BlockMatrix& matrix, std::span<const char> changed) override {
        return factor_.factorize(matrix, crew_, changed);
    }
    void solve(std::vector<Vec6>& right_hand_side) override { factor_.solve(right_hand_side, crew_); }

  private:
    const Crew& crew_;
    MultifrontalFactor<double> factor_;
};

}  // namespace

std::unique_ptr<LinearSolver> make_multifrontal_solver(const Crew& crew) {
    return std::make_unique<MultifrontalSolver>(crew);
}

std::unique_ptr<LinearSolver> make_linear_solver(SolverKind kind, const Crew& crew) {
    return kind == SolverKind::cholmod ? make_cholmod_solver() : make_multifrontal_solver(crew);
}

}  // namespace dda
