// Eq. (1), and Eq. (4) with Eqs. (6) to
// (8). A number of the paper's, Ma et al. Eq. (11), is not ours.
constexpr double tolerance = 1e-7;
constexpr int most_rounds = 14;
double compute();
