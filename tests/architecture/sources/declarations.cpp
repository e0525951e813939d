#include "declarations.hpp"

#include <algorithm>
#include <set>

namespace rockslope::sources {

namespace {

bool opens(const std::string& sign) {
    return sign == "(" || sign == "{" || sign == "[";
}
bool closes(const std::string& sign) {
    return sign == ")" || sign == "}" || sign == "]";
}

/// Reads statement after statement of a scope, and walks into namespaces and classes.
class Reader {
  public:
    explicit Reader(const std::vector<Token>& tokens) : tokens_(tokens) {}

    std::vector<Declaration> run() {
        read_scope({});
        return std::move(found_);
    }

  private:
    struct Scope {
        std::string owner = {};
        bool is_public = true;
        bool is_local = false;
    };

    bool done() const { return at_ >= tokens_.size(); }
    bool is(std::size_t k, const char* text) const { return k < tokens_.size() && tokens_[k].text == text; }
    bool is_name(std::size_t k) const { return k < tokens_.size() && tokens_[k].kind == Token::Kind::name; }

    /// The token behind the bracket that closes the one at `open`.
    std::size_t behind_brackets(std::size_t open) const {
        int depth = 0;
        std::size_t k = open;
        for (; k < tokens_.size(); ++k) {
            if (tokens_[k].kind != Token::Kind::sign) continue;
            depth += opens(tokens_[k].text) ? 1 : 0;
            depth -= closes(tokens_[k].text) ? 1 : 0;
            if (depth == 0) break;
        }
        return k + 1;
    }

    /// The token behind the angle bracket that closes the one at `open`.
    std::size_t behind_angles(std::size_t open) const {
        int depth = 0;
        std::size_t k = open;
        while (k < tokens_.size()) {
            if (is(k, "(") || is(k, "{")) {
                k = behind_brackets(k);
                continue;
            }
            depth += is(k, "<") ? 1 : 0;
            depth -= is(k, ">") ? 1 : 0;
            ++k;
            if (depth == 0) break;
        }
        return k;
    }

    void read_scope(Scope scope) {
        while (!done() && !is(at_, "}")) {
            if (is(at_, ";")) {
                ++at_;
            } else if (is_name(at_) && is(at_ + 1, ":") && !is(at_ + 1, "::")) {
                scope.is_public = is(at_, "public");
                at_ += 2;
            } else {
                read_statement(scope);
            }
        }
        ++at_;
    }

    void read_statement(const Scope& scope) {
        begin_ = at_;
        while (is(at_, "template") || is(at_, "[")) skip_prefix();
        if (is(at_, "namespace") || (is(at_, "inline") && is(at_ + 1, "namespace"))) {
            read_namespace(scope);
        } else if (is(at_, "using") || is(at_, "typedef") || is(at_, "concept")) {
            read_alias(scope);
        } else if (is(at_, "struct") || is(at_, "class") || is(at_, "union") || is(at_, "enum")) {
            read_type(scope);
        } else {
            read_object(scope);
        }
    }

    void skip_prefix() {
        if (is(at_, "[")) {
            at_ = behind_brackets(at_);
            return;
        }
        ++at_;
        if (is(at_, "<")) at_ = behind_angles(at_);
        if (is(at_, "requires")) ++at_;
        if (is(at_, "(")) at_ = behind_brackets(at_);
    }

    void read_namespace(const Scope& scope) {
        Scope inner = scope;
        ++at_;
        if (is(at_, "{")) inner.is_local = true;
        while (!done() && !is(at_, "{") && !is(at_, ";")) ++at_;
        if (is(at_++, "{")) read_scope(inner);
    }

    Declaration& add(const Scope& scope, Declaration::Kind kind, std::size_t place) {
        Declaration declaration;
        declaration.kind = kind;
        declaration.name = tokens_[place].text;
        declaration.owner = scope.owner;
        declaration.place = place;
        declaration.first_line = tokens_[begin_].line;
        declaration.last_line = declaration.first_line;
        declaration.is_public = scope.is_public;
        declaration.is_local = scope.is_local;
        found_.push_back(declaration);
        return found_.back();
    }

    void close(Declaration& declaration) {
        declaration.last_line = tokens_[std::min(at_, tokens_.size() - 1)].line;
        if (is(at_, ";")) ++at_;
    }

    /// Moves to the semicolon that ends the statement.
    void skip_to_semicolon() {
        while (!done() && !is(at_, ";")) at_ = opens(tokens_[at_].text) ? behind_brackets(at_) : at_ + 1;
    }

    void read_alias(const Scope& scope) {
        const bool renames = is(at_ + 2, "=");
        std::size_t place = at_ + 1;
        skip_to_semicolon();
        if (!renames) place = at_ - 1;  // using dda::Vec2;
        if (is_name(place)) {
            close(add(scope, Declaration::Kind::alias, place));
        } else {
            ++at_;
        }
    }

    void read_type(const Scope& scope) {
        const bool enumeration = is(at_, "enum");
        const bool open_class = is(at_, "class");
        std::size_t k = at_ + 1;
        if (is(k, "class") || is(k, "struct")) ++k;
        const std::size_t place = k;
        while (k < tokens_.size() && !is(k, "{") && !is(k, ";") && !is(k, "(") && !is(k, "="))
            k = is(k, "<") ? behind_angles(k) : k + 1;
        if (!is(k, "{")) {
            // A type that is only declared, or an object of a type that is called "struct ...".
            at_ = k;
            skip_to_semicolon();
            ++at_;
            return;
        }
        const std::size_t index = found_.size();
        add(scope, Declaration::Kind::type, place);
        at_ = k + 1;
        if (enumeration) {
            read_enumerators(scope);
        } else {
            Scope inner = scope;
            inner.owner = tokens_[place].text;
            inner.is_public = scope.is_public && !open_class;
            const bool reachable = scope.is_public;
            read_members(inner, reachable);
        }
        skip_to_semicolon();
        close(found_[index]);
    }

    /// Members of a class that is itself private stay private behind `public:`.
    void read_members(const Scope& scope, bool reachable) {
        const std::size_t first = found_.size();
        read_scope(scope);
        for (std::size_t k = first; k < found_.size() && !reachable; ++k) found_[k].is_public = false;
    }

    void read_enumerators(const Scope& scope) {
        while (!done() && !is(at_, "}")) {
            begin_ = at_;
            if (is_name(at_)) add(scope, Declaration::Kind::enumerator, at_);
            while (!done() && !is(at_, ",") && !is(at_, "}"))
                at_ = is(at_, "(") ? behind_brackets(at_) : at_ + 1;
            if (is(at_, ",")) ++at_;
        }
        ++at_;
    }

    /// A function or a variable.
    void read_object(const Scope& scope) {
        std::set<std::string> words;
        std::size_t name = at_;
        while (!done()) {
            if (is(at_, "operator")) {
                read_operator(scope);
                return;
            }
            if (is_name(at_)) {
                words.insert(tokens_[at_].text);
                name = at_++;
            } else if (is(at_, "<") && is_name(at_ - 1)) {
                at_ = behind_angles(at_);
            } else if (is(at_, "(") && is(at_ + 1, "*") && is(at_ + 3, ")")) {
                read_variable(scope, at_ + 2, false);  // a pointer to a function
                return;
            } else if (is(at_, "(")) {
                break;
            } else if (is(at_, "=") || is(at_, ";") || is(at_, "{") || is(at_, "[") || is(at_, ",")) {
                read_variable(scope, name, words.contains("constexpr"));
                return;
            } else {
                ++at_;
            }
        }
        if (words.contains("decltype") || words.contains("static_assert")) {
            skip_to_semicolon();
            return;
        }
        read_function(scope, name, words.contains("friend"));
    }

    void read_operator(const Scope& scope) {
        const std::size_t place = at_++;
        if (is(at_, "(")) at_ += 2;
        while (!done() && !is(at_, "(")) ++at_;
        read_function(scope, place, true);
    }

    void read_variable(const Scope& scope, std::size_t name, bool is_constexpr) {
        const std::size_t begin = is(at_, "=") ? at_ + 1 : at_;
        skip_to_semicolon();
        Declaration& variable = add(scope, Declaration::Kind::variable, name);
        variable.is_constexpr = is_constexpr;
        for (std::size_t k = begin; k < at_ && k < tokens_.size(); ++k) variable.value += tokens_[k].text;
        close(variable);
    }

    int count_parameters(std::size_t open) const {
        const std::size_t end = behind_brackets(open) - 1;
        int count = end > open + 1 ? 1 : 0;
        for (std::size_t k = open + 1; k < end;) {
            if (opens(tokens_[k].text)) {
                k = behind_brackets(k);
            } else if (is(k, "<") && is_name(k - 1)) {
                k = behind_angles(k);
            } else {
                count += is(k++, ",") ? 1 : 0;
            }
        }
        return count;
    }

    void read_function(const Scope& scope, std::size_t name, bool needs_no_text) {
        const std::size_t index = found_.size();
        add(scope, Declaration::Kind::function, name).parameters = count_parameters(at_);
        if (tokens_[name].text.find("TEST") != std::string::npos) found_[index].name = tokens_[name + 2].text;
        if (is(name - 1, "::")) found_[index].owner = tokens_[name - 2].text;
        if (is(name - 1, "~")) needs_no_text = true;
        at_ = behind_brackets(at_);
        while (!done() && !is(at_, "{") && !is(at_, ";")) {
            if (is(at_, "override") || is(at_, "default") || is(at_, "delete")) needs_no_text = true;
            if (is(at_, ":")) {
                skip_initializers();
            } else {
                at_ = is(at_, "(") ? behind_brackets(at_) : at_ + 1;
            }
        }
        Declaration& function = found_[index];
        function.needs_no_text = needs_no_text;
        if (is(at_, "{")) {
            function.body_begin = at_;
            at_ = behind_brackets(at_);
            function.body_end = at_--;
            function.body_lines = tokens_[at_].line - tokens_[function.body_begin].line;
            function.last_line = tokens_[at_++].line;
        } else {
            close(function);
        }
    }

    /// Moves from the colon to the body of a constructor.
    void skip_initializers() {
        do {
            ++at_;
            while (!done() && !is(at_, "(") && !is(at_, "{"))
                at_ = is(at_, "<") ? behind_angles(at_) : at_ + 1;
            at_ = behind_brackets(at_);
        } while (is(at_, ","));
    }

    const std::vector<Token>& tokens_;
    std::vector<Declaration> found_;
    std::size_t at_ = 0;
    std::size_t begin_ = 0;  ///< first token of the statement
};

}  // namespace

std::vector<Declaration> find_declarations(const Tokens& tokens) {
    return Reader(tokens.all).run();
}

}  // namespace rockslope::sources
