#pragma once

#include <iosfwd>
#include <string>
#include <vector>

namespace rockslope::verification {

enum class ToleranceKind { relative, absolute, below, above, outcome, none };
enum class Verdict { passes, fails, misses, informs };

/// A row of the report. Numbers are stored as their printed text, so that reading and writing change nothing.
struct Row {
    std::string id;
    std::string set_up;
    std::string quantity;
    std::string unit;
    std::string expected;
    std::string ours;
    std::string error;  ///< as the tolerance: relative, or absolute in `unit`
    std::string tolerance;
    ToleranceKind kind = ToleranceKind::none;
    std::string contact_frequency_step;  ///< omega_contact * dt; empty without contact
    Verdict verdict = Verdict::informs;
    std::string reason;  ///< reason of the tolerance or of the miss
};

/// Quantities of the energy balance, over the energy exchanged. The report has a separate table for them.
inline constexpr const char* energy_residual = "energy residual";
inline constexpr const char* friction_work = "least work of friction in a step";
inline constexpr const char* integration_loss = "lost by the time integration";

std::string to_text(double value);
std::string to_text(ToleranceKind kind);
std::string to_text(Verdict verdict);

/// Column names, tab-separated.
void write_header(std::ostream& out);
/// One line of tab-separated fields.
void write_row(std::ostream& out, const Row& row);
/// Reads a file that begins with the header. @throws std::runtime_error that names file and line, for another
/// header, a wrong number of fields or an unknown word.
std::vector<Row> read_rows(const std::string& path);

}  // namespace rockslope::verification
