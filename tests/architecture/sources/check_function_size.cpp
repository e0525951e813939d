#include "checks.hpp"

namespace rockslope::sources {

namespace {

constexpr int most_lines = 60;
constexpr int most_parameters = 6;

}  // namespace

Faults check_function_size(const std::vector<SourceFile>& files) {
    Faults faults;
    for (const SourceFile& file : files) {
        for (const Declaration& one : file.declarations) {
            if (one.kind != Declaration::Kind::function) continue;
            const std::string where = file.path + ":" + std::to_string(one.first_line) + ": " + one.name;
            if (one.body_lines > most_lines)
                faults.push_back(where + " has " + std::to_string(one.body_lines) + " lines");
            if (one.parameters > most_parameters)
                faults.push_back(where + " has " + std::to_string(one.parameters) + " parameters");
        }
    }
    return faults;
}

}  // namespace rockslope::sources
