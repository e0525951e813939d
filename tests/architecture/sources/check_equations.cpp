#include <regex>
#include <sstream>

#include "checks.hpp"

namespace rockslope::sources {

namespace {

/// A row of the index: | 20 | what it is | `function` | [file](link) | number of the paper |
struct IndexRow {
    int equation = 0;
    std::string function;
    std::string path;
};

std::vector<IndexRow> read_index(const std::filesystem::path& root) {
    static const std::regex row(R"(\| *([0-9]+) *\|[^|]*\| *`([A-Za-z0-9_]+)` *\| *\[([^\]]+)\].*)");
    std::vector<IndexRow> rows;
    std::istringstream page(read_file(root / "docs/theory.md"));
    bool in_index = false;
    for (std::string line; std::getline(page, line);) {
        if (line.starts_with("## ")) in_index = line == "## Index of equations";
        std::smatch parts;
        if (in_index && std::regex_match(line, parts, row))
            rows.push_back({std::stoi(parts[1]), parts[2], parts[3]});
    }
    return rows;
}

/// Docstring and comments of a declaration.
std::string comments_of(const SourceFile& file, const Declaration& one) {
    std::string text = docstring(file, one, "//");
    const auto& comments = file.tokens.comments;
    for (auto line = comments.lower_bound(one.first_line);
         line != comments.end() && line->first <= one.last_line; ++line)
        text += line->second.substr(2) + " ";
    return text;
}

/// Whether a text has "Eq. (n)", "Eqs. (n) and (m)" or a range "Eqs. (m) to (n)" with the equation.
bool cites(const std::string& text, int equation) {
    static const std::regex citation(R"(Eqs?\. +(\([0-9]+\)(?:, and |, or |, | and | or | to |-)?)+)");
    static const std::regex part(R"((to |-)?\(([0-9]+)\))");
    for (std::sregex_iterator all(text.begin(), text.end(), citation), end; all != end; ++all) {
        const std::string numbers = all->str();
        int last = 0;
        for (std::sregex_iterator one(numbers.begin(), numbers.end(), part); one != end; ++one) {
            const int number = std::stoi((*one)[2]);
            if (number == equation) return true;
            if ((*one)[1].matched && last < equation && equation < number) return true;
            last = number;
        }
    }
    return false;
}

}  // namespace

Faults check_equations(const std::vector<SourceFile>& files, const std::filesystem::path& root) {
    Faults faults;
    for (const IndexRow& row : read_index(root)) {
        bool declared = false, cited = false;
        for (const SourceFile& file : files) {
            if (file.path != row.path) continue;
            for (const Declaration& one : file.declarations) {
                if (one.name != row.function) continue;
                declared = true;
                cited = cited || cites(comments_of(file, one), row.equation);
            }
        }
        const std::string number = "Eq. (" + std::to_string(row.equation) + "): ";
        if (!declared) faults.push_back(number + row.path + " declares no " + row.function);
        if (declared && !cited)
            faults.push_back(number + row.function + " in " + row.path + " does not cite it");
    }
    return faults;
}

}  // namespace rockslope::sources
