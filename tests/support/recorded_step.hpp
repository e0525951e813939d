#pragma once

#include <filesystem>
#include <vector>

#include "dda/path/limited_forces.hpp"

namespace rockslope::recorded_step {

/// The equations of a step as a run met them, with the laws of its contacts frozen at the solution but for
/// their limits, and the solution that the run found.
///
/// A file is text: words that name a number, and numbers of twelve digits, in this order. SI units, per metre
/// thickness.
///
///     recorded_step 1                      version of the format
///     iterations I factorizations F        of the open-close iteration that found the solution
///     tolerance T                          N per metre, of forces, Eq. (36)
///     rows R                               then per row: length (m, square root of the block's area);
///                                          21 numbers of the matrix, the lower triangle row by row;
///                                          6 of the load; 6 of the displacement found
///     contacts C                           then per contact or bolt that may bear a force:
///                                          first and second row, -1 for none; arms, 2 and 2 (m); directions
///                                          of opening and shearing, 2 and 2; normal and shear stiffness;
///                                          normal and shear force without a displacement; least normal force
///                                          (-inf: none); floor; tilt; forward and backward bound, each at no
///                                          normal force and its slope; state at the step's start: 0 open, 1
///                                          below the floor, 2 in compression; 1, -1 sliding, 0 locked
struct RecordedStep {
    struct Row {
        double length = 0;
        dda::Mat6 stiffness = dda::Mat6::Zero();
        dda::Vec6 load = dda::Vec6::Zero();
        dda::Vec6 displacement = dda::Vec6::Zero();
    };
    struct Contact {
        dda::BlockPair rows;
        dda::LimitedContact law;  ///< without `rows`
        dda::Piece start;         ///< the piece that it was on at the step's start
    };
    int iterations = 0;
    int factorizations = 0;
    double tolerance = 0;
    std::vector<Row> rows;
    std::vector<Contact> contacts;
};

/// @throws std::runtime_error with the file's name, if it is no recording.
RecordedStep read_step(const std::filesystem::path& file);
void write_step(const RecordedStep& step, const std::filesystem::path& file);

/// A recorded step as the engine's solvers take it.
class Equations {
  public:
    explicit Equations(const RecordedStep& recorded);
    // The contacts point to their rows.
    Equations(const Equations&) = delete;
    Equations& operator=(const Equations&) = delete;

    dda::LimitedStep step() const { return {base_, row_contacts_, contacts_}; }
    dda::RowSpan<const double> length() const { return length_; }
    /// The displacement that the run found.
    const dda::PerRow<dda::Vec6>& found() const { return found_; }

  private:
    dda::BaseSystem base_;
    dda::PerContact<dda::ContactSprings> springs_;
    dda::PerContact<dda::LimitedContact> contacts_;
    dda::RowContacts row_contacts_;
    dda::PerRow<double> length_;
    dda::PerRow<dda::Vec6> found_;
};

}  // namespace rockslope::recorded_step
