#pragma once

#include <map>
#include <string>
#include <vector>

namespace rockslope::sources {

/// A word, number, literal or sign of C++ source text.
struct Token {
    enum class Kind { name, number, literal, sign };
    Kind kind = Kind::sign;
    std::string text;
    int line = 0;  ///< from 1
};

/// Source text without spaces: the tokens, and apart from them the comments and the directives.
struct Tokens {
    std::vector<Token> all;
    std::map<int, std::string> comments;      ///< by line, with their slashes
    std::map<int, bool> fills_line;           ///< whether a comment has its line to itself
    std::vector<std::string> includes;        ///< with quotes or brackets; without those of an "IWYU pragma"
    std::vector<std::string> macros;          ///< the names that the text defines
    std::vector<std::string> directive_text;  ///< every directive but the includes
};

/// Splits the text of a source file. Only comments of the form `//` are known, which are all that we write.
Tokens tokenize(const std::string& text);

}  // namespace rockslope::sources
