#pragma once

#include <limits>
#include <span>
#include <vector>

#include "dda/linear/envelope_lu.hpp"
#include "dda/path/limited_forces.hpp"

namespace rockslope::dda {

/// The displacements of a step, and the elastic forces of the contacts there.
struct LimitedIterate {
    RowSpan<Vec6> displacement;  ///< m
    ContactSpan<ElasticForces> elastic;
};

/// Which paths are followed in a patch: that from the iterate, Eq. (99), which arrives at the state next to
/// it; where this does not end that from open contacts, Eq. (100), as well; or, in a patch of very many
/// contacts, paths on which only those begin open that the paths before have crossed a border of, for often
/// these few led them round. With much friction several states may balance, and another path may arrive at
/// another one.
enum class PathStarts { iterate, iterate_then_apart, iterate_then_crossed_apart };

/// How paths are followed in a patch.
struct PathAims {
    PathStarts starts = PathStarts::iterate_then_apart;
    /// The search for borders may look at so many contacts. Then the paths are given up.
    double visit_limit = std::numeric_limits<double>::infinity();
    /// Most borders on a path from the iterate.
    int border_limit = 400;
};

/// The path that leads the blocks of a patch to balance, while those around it stay. From where the blocks
/// are the unbalanced forces fall in proportion, F(d) = (1 - lambda) F(d0), Eq. (99). Where this path does
/// not end, one that begins with open contacts is followed: a gap in all of them closes, Eq. (100). F is
/// linear in pieces, so a path is straight from border to border. At each border the matrix changes by one
/// product of two vectors. Where its determinant changes sign the path turns back in lambda [katzenelson1965;
/// fujisawakuh1972]. A path may close on itself; it ends where it comes back to its start. Memory is kept
/// from patch to patch.
class PatchPath {
  public:
    struct Outcome {
        bool balanced = false;
        bool began_apart = false;  ///< the path that arrived began with open contacts
        int borders = 0;           ///< crossed on the way
        double visits = 0;         ///< contacts that the search for borders looked at
        double thrown = 0;         ///< N per metre, largest change of a force on a block around the patch

        /// Adds the borders and visits of a path that is followed next; the rest is of that path.
        Outcome& operator+=(const Outcome& next) {
            return *this = {next.balanced, next.began_apart, borders + next.borders, visits + next.visits,
                            next.thrown};
        }
    };
    /// Follows the paths to the end of one. Where that is not reached, the iterate stays as it was.
    /// @param rows the patch.
    Outcome follow(const LimitedStep& step, std::span<const RowIndex> rows, LimitedIterate iterate,
                   const PathAims& aims);

  private:
    /// A contact of the patch.
    struct Local {
        ContactIndex contact;
        const LimitedContact* law = nullptr;
        int first = -1;  ///< its blocks in the patch; -1 outside
        int second = -1;
        bool at_rim = false;                 ///< between a block of the patch and one around it
        Vec6 opening_first, opening_second;  ///< gradients by the unknowns of its blocks
        Vec6 shearing_first, shearing_second;
        Piece piece;
        Piece first_piece;      ///< at the start of the path
        PieceBorders borders;   ///< of the piece
        bool crossed = false;   ///< a border of it on an earlier path or on this one
        bool is_apart = false;  ///< a path begins with it open
        double approach = 0;    ///< normal force by which the contact's gap closes, N per metre
        ElasticForces at;       ///< on the path
        ElasticForces rate;     ///< change for a change of lambda by 1
    };
    /// A change of the matrix: the forces of a contact follow its elastic forces in another way.
    struct Change {
        std::vector<Vec6> response;  ///< displacements by the forces' change
        std::size_t contact = 0;     ///< index in contacts_
        Vec2 normal;                 ///< of the border
        double pivot = 1;            ///< ratio of the determinants after and before
    };

    void order(std::span<const RowIndex> rows);
    /// Walks from a block to its neighbours that are not met yet. @param met receives the blocks in the order
    /// in which they are met, behind those that it has.
    void walk_from(RowIndex root, std::vector<RowIndex>& met);
    void find_contacts(const LimitedIterate& iterate);
    void add_contact(ContactIndex contact, const LimitedIterate& iterate);
    /// Adds the forces of a contact to the unbalanced forces. @param forces normal and shear, N per metre
    static void add_forces(const Local& local, const Vec2& forces, std::span<Vec6> unbalanced);
    Outcome follow_from_starts(const LimitedIterate& iterate, PathStarts starts);
    Outcome follow_from_iterate(const LimitedIterate& iterate);
    /// @param most_borders on the way that closes the gap.
    Outcome follow_from_apart(const LimitedIterate& iterate, int most_borders);
    /// Lets the contacts that are apart bear their least normal force wherever the blocks are.
    void hold_open();
    /// Lets them follow their laws again.
    void release(const LimitedIterate& iterate);
    /// Sets the gap that opens these contacts at the present displacements.
    void set_gap();
    /// Begins a path at the present displacements and pieces: finds the forces that do not balance there.
    void begin(RowSpan<const Vec6> displacement);
    /// Takes away what rounding on the way left unbalanced, if no border is as near.
    void remove_rounding(const LimitedIterate& iterate);
    /// Follows a path until lambda is 1, or until it has crossed too many borders or visits_left_ is used up.
    Outcome walk(int most_borders);
    /// Factorises the matrix of the present pieces, and finds the direction of the path.
    /// @return the sign of the determinant.
    int find_direction();
    /// Factorises the matrix of the present pieces. @return the sign of its determinant.
    int factorize();
    void add_springs(const Local& local);
    /// Solves with the matrix of the present pieces.
    void solve(std::span<Vec6> x) const;
    ElasticForces change_of(const Local& local, std::span<const Vec6> x) const;
    /// Sets the elastic forces of the contacts to those of the displacements and the gap.
    void find_elastic_forces();
    /// The next border. @param sense 1 or -1: lambda grows or falls. @return its contact's index, or none.
    std::size_t next_border(int sense, Border& border) const;
    void move(double distance);
    /// Whether a contact bears other forces on a piece than on that of the path's start.
    static bool is_away(const Local& local, const Piece& piece);
    /// Crosses a border. @return the ratio of the determinants after and before.
    double cross(std::size_t contact, const Border& border);
    void store(LimitedIterate iterate) const;
    /// The largest change of a force on a block around the patch, N per metre.
    double largest_thrown() const;

    const LimitedStep* step_ = nullptr;
    EnvelopeLu factors_;
    std::vector<int> last_;       ///< per row of the matrix, the last one with a submatrix
    PerRow<int> local_row_;       ///< per row: its place in rows_, or a mark below
    std::vector<RowIndex> met_;   ///< work space
    std::vector<RowIndex> rows_;  ///< the patch, in the order of the matrix
    std::vector<Local> contacts_;
    std::vector<Vec6> unbalanced_;      ///< at the start of the path
    double lambda_ = 0;                 ///< on the path
    int away_ = 0;                      ///< contacts that are away from the pieces of the path's start
    std::vector<Vec6> moved_;           ///< displacements from the iterate
    std::vector<Vec6> direction_;       ///< displacements for a change of lambda by 1
    std::vector<ElasticForces> start_;  ///< per contact of the patch, at the iterate
    std::vector<LimitedContact> open_laws_;
    std::vector<Change> changes_;  ///< since the last factorisation
    std::size_t change_count_ = 0;
    double visits_left_ = 0;
    int border_limit_ = 0;  ///< of a path from the iterate
};

}  // namespace rockslope::dda
