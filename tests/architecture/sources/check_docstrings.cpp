#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "checks.hpp"

namespace rockslope::sources {

namespace {

constexpr const char* list_path = "tests/architecture/undocumented.txt";

/// The lines "header name" of the list.
std::set<std::string> read_list(const std::filesystem::path& root) {
    std::set<std::string> lines;
    std::istringstream text(read_file(root / list_path));
    for (std::string line; std::getline(text, line);)
        if (!line.empty() && line[0] != '#') lines.insert(line);
    return lines;
}

/// Folders whose types fulfil a contract, and the header whose comments say what each of its functions gives.
const std::map<std::string, std::string> contracts = {
    {"libdda/dda/joint/", "libdda/dda/joint/joint_law_contract.hpp"},
    {"libdda/dda/model/loads/", "libdda/dda/model/load.hpp"}};

/// The functions of the contract of a folder: those that a comment of its header lists as "- name(...): ...".
std::set<std::string> contract_of(const std::vector<SourceFile>& files, const std::string& folder) {
    static const std::regex item(R"(^///? - `?([a-z_]+)\()");
    std::set<std::string> names;
    const auto contract = contracts.find(folder);
    for (const SourceFile& file : files) {
        if (contract == contracts.end() || file.path != contract->second) continue;
        for (const auto& [line, comment] : file.tokens.comments) {
            std::smatch parts;
            if (std::regex_search(comment, parts, item)) names.insert(parts[1]);
        }
    }
    return names;
}

std::string line_of(const SourceFile& file, const Declaration& function) {
    return file.path + " " + (function.owner.empty() ? "" : function.owner + "::") + function.name;
}

/// The public functions of a header that need a docstring and have none. One docstring serves all overloads.
/// @param contract names of member functions that are documented elsewhere.
std::set<std::string> undocumented(const SourceFile& file, const std::set<std::string>& contract) {
    std::set<std::string> without, with;
    for (const Declaration& one : file.declarations) {
        if (one.kind != Declaration::Kind::function || !one.is_public || one.needs_no_text) continue;
        if (!one.owner.empty() && contract.contains(one.name)) continue;
        (docstring(file, one).empty() ? without : with).insert(line_of(file, one));
    }
    for (const std::string& line : with) without.erase(line);
    return without;
}

}  // namespace

Faults check_docstrings(const std::vector<SourceFile>& files, const std::filesystem::path& root) {
    std::set<std::string> listed = read_list(root);
    Faults faults;
    for (const SourceFile& file : files) {
        if (!file.is_in_library() || !file.is_header()) continue;
        const std::string folder = file.path.substr(0, file.path.rfind('/') + 1);
        for (const std::string& line : undocumented(file, contract_of(files, folder)))
            if (listed.erase(line) == 0) faults.push_back(line + " has no docstring");
    }
    for (const std::string& line : listed)
        faults.push_back(line + " is documented or gone: delete its line in " + list_path);
    return faults;
}

}  // namespace rockslope::sources
