// Checks of the sources that need their declarations.
//   check_sources <check> <root>
// Prints each fault and returns 1 if there is any. See checks.hpp for the checks.
#include <cstdio>
#include <exception>
#include <functional>
#include <map>
#include <string>

#include "checks.hpp"

using namespace rockslope::sources;

int main(int argc, char** argv) try {
    using Files = std::vector<SourceFile>;
    const std::filesystem::path root = argc == 3 ? argv[2] : "";
    const std::map<std::string, std::function<Faults(const Files&)>> checks = {
        {"function_size", check_function_size},
        {"unused_includes", check_includes},
        {"dead_functions", check_dead_functions},
        {"docstrings", [&](const Files& files) { return check_docstrings(files, root); }},
        {"constants", check_constants},
        {"equations", [&](const Files& files) { return check_equations(files, root); }},
    };
    const auto check = checks.find(argc == 3 ? argv[1] : "");
    if (check == checks.end()) {
        std::fputs("usage: check_sources <check> <root>\n", stderr);
        return 2;
    }
    const Files files = read_sources(root);
    const Faults faults = check->second(files);
    for (const std::string& fault : faults) std::printf("%s\n", fault.c_str());
    std::printf("%s: %zu faults in %zu files\n", argv[1], faults.size(), files.size());
    return faults.empty() ? 0 : 1;
} catch (const std::exception& error) {
    std::fprintf(stderr, "check_sources: %s\n", error.what());
    return 2;
}
