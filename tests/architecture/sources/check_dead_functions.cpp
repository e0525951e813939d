#include <map>
#include <set>

#include "checks.hpp"

namespace rockslope::sources {

namespace {

/// Names that a range-based loop, a structured binding or the standard library calls.
const std::set<std::string> called_by_language = {"begin", "end", "size", "get", "what"};
/// Functions by which tests see what no program asks for: how many lines a joint set drew, and the text of a
/// block file without a file.
const std::set<std::string> called_by_tests = {"draw_count", "block_file_text"};

/// Whether a name may be that of a function: called, given as an argument, or behind an operator that selects
/// it. A variable of the name is not.
bool may_name_function(const std::vector<Token>& all, std::size_t k) {
    const std::string before = k > 0 ? all[k - 1].text : "",
                      after = k + 1 < all.size() ? all[k + 1].text : "";
    const bool is_called = after == "(" || after == "<" || after == "{";
    const bool is_selected = before == "::" || before == "." || before == "->" || before == "&";
    const bool is_argument = (before == "(" || before == ",") && (after == "," || after == ")");
    return is_called || is_selected || is_argument;
}

/// Adds the names of a file that are uses: all but those where a function or type is declared.
void add_uses(const SourceFile& file, std::set<std::string>& used) {
    std::set<std::size_t> declared;
    for (const Declaration& one : file.declarations) declared.insert(one.place);
    const std::vector<Token>& all = file.tokens.all;
    for (std::size_t k = 0; k < all.size(); ++k) {
        const bool is_use = all[k].kind == Token::Kind::name && !declared.contains(k);
        if (is_use && may_name_function(all, k)) used.insert(all[k].text);
    }
    for (const std::string& directive : file.tokens.directive_text) {
        for (const Token& token : tokenize(directive.substr(1)).all) used.insert(token.text);
    }
}

}  // namespace

Faults check_dead_functions(const std::vector<SourceFile>& files) {
    std::set<std::string> used = called_by_language;
    used.insert(called_by_tests.begin(), called_by_tests.end());
    for (const SourceFile& file : files)
        if (!file.path.starts_with("tests/")) add_uses(file, used);
    Faults faults;
    for (const SourceFile& file : files) {
        if (!file.is_in_library() || !file.is_header()) continue;
        for (const Declaration& one : file.declarations) {
            const bool is_function = one.kind == Declaration::Kind::function && !one.needs_no_text;
            if (is_function && one.name != one.owner && !used.contains(one.name))
                faults.push_back(file.path + ": nothing calls " + one.name);
        }
    }
    return faults;
}

}  // namespace rockslope::sources
