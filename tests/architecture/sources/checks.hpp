#pragma once

#include <filesystem>

#include "source_file.hpp"

namespace rockslope::sources {

/// What a check finds wrong, one sentence for each fault; empty if nothing is.
using Faults = std::vector<std::string>;

/// Functions of more than 60 lines or six parameters. A test case has no limit of lines of its own: the same.
Faults check_function_size(const std::vector<SourceFile>& files);

/// Includes of headers that nothing in the including header uses. Known are the project's own headers, by the
/// names that they declare, and the common headers of the standard library.
Faults check_includes(const std::vector<SourceFile>& files);

/// Functions that a header of a library declares and that neither a library nor a program nor a benchmark
/// calls. A function is told by its name, so that one of two functions of the same name hides the other.
Faults check_dead_functions(const std::vector<SourceFile>& files);

/// Functions that a header of a library declares without a docstring, unless listed in
/// tests/architecture/undocumented.txt below the root; and lines of that list that are no longer needed.
Faults check_docstrings(const std::vector<SourceFile>& files, const std::filesystem::path& root);

/// Constants of one name that have several values in the libraries and programs.
Faults check_constants(const std::vector<SourceFile>& files);

/// Rows of the index of equations in docs/theory.md whose function does not cite the equation, in its
/// docstring or in its body.
Faults check_equations(const std::vector<SourceFile>& files, const std::filesystem::path& root);

}  // namespace rockslope::sources
