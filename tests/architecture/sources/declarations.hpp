#pragma once

#include <string>
#include <vector>

#include "tokens.hpp"

namespace rockslope::sources {

/// What a source file declares at namespace scope or in a class.
struct Declaration {
    enum class Kind { function, type, variable, alias, enumerator };
    Kind kind = Kind::variable;
    std::string name;       ///< of a test: its suite
    std::string owner;      ///< name of the class it is a member of, or that its name is qualified by
    int first_line = 0;     ///< of the declaration, with its template line
    int last_line = 0;      ///< with the body
    std::size_t place = 0;  ///< index of the token that is the name
    bool is_public = true;
    bool is_local = false;      ///< in a namespace without a name
    bool is_constexpr = false;  ///< a variable's
    bool needs_no_text =
        false;           ///< a function that overrides, is defaulted, deleted or an operator or a friend
    int parameters = 0;  ///< of a function
    int body_lines = 0;  ///< of a function; 0: it has none here
    std::size_t body_begin = 0, body_end = 0;  ///< tokens of a function's body; equal: it has none here
    std::string value;                         ///< of a variable: the tokens of its initial value
};

/// Finds the declarations among the tokens of a file. The text is one that the compiler accepts.
std::vector<Declaration> find_declarations(const Tokens& tokens);

}  // namespace rockslope::sources
