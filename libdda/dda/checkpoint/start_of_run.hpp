#pragma once

#include <optional>
#include <string>

#include "dda/checkpoint/checkpoint.hpp"
#include "dda/writers/result_writer.hpp"

namespace rockslope::dda {

/// The part of a run's fingerprint (RunInput::fingerprint) that the state after its first `stages` stages
/// depends on: all but the later stages, measured regions and most of the output.
std::string start_of_run(const std::string& fingerprint, int stages);

/// The first difference between two starts of a run, "[joint_material.bedding] has 'cohesion = 0.0', the
/// saved run has 'cohesion = 5.0'"; nothing where they are equal.
std::optional<std::string> first_difference(const std::string& start, const std::string& saved);

/// The state that a run saved at the end of a stage, for a run with this fingerprint to begin with.
/// @throws InputError if the file cannot be read or is no such state, or if the run differs from the saved
/// one in what the state depends on.
Checkpoint read_saved_state(const std::filesystem::path& path, const std::string& fingerprint, int stages);

/// The name of the file for the state at the end of a stage, counted from 0: "stage-1.saved.h5".
std::string saved_state_name(int stage);

/// Checks that the results which copy_earlier_results() will copy are those that the run wrote. @throws
/// InputError that names the file.
void check_earlier_results(const std::filesystem::path& from, const WriterContext& context,
                           const Checkpoint& saved);

/// Copies the results that the run of a saved state wrote up to it, so that a run that begins with it goes on
/// with them. Results that are not there, or that `context` does not ask for, are taken out of the positions:
/// they begin with the new run. @param from folder of the saved state. @throws OutputError.
void copy_earlier_results(const std::filesystem::path& from, const WriterContext& context, Checkpoint& saved);

}  // namespace rockslope::dda
