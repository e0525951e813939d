#include "tokens.hpp"

#include <cctype>
#include <string_view>

namespace rockslope::sources {

namespace {

bool is_name_start(char c) {
    return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_';
}

bool is_name_part(char c) {
    return is_name_start(c) || std::isdigit(static_cast<unsigned char>(c)) != 0;
}

class Tokenizer {
  public:
    explicit Tokenizer(const std::string& text) : text_(text) {}

    Tokens run() {
        while (at_ < text_.size()) step();
        return std::move(tokens_);
    }

  private:
    bool starts(std::string_view what) const { return std::string_view(text_).substr(at_).starts_with(what); }

    void step() {
        const char c = text_[at_];
        if (c == '\n') {
            ++line_;
            ++at_;
            line_is_empty_ = true;
        } else if (std::isspace(static_cast<unsigned char>(c)) != 0) {
            ++at_;
        } else if (starts("//")) {
            take_comment();
        } else if (c == '#' && line_is_empty_) {
            take_directive();
        } else {
            line_is_empty_ = false;
            take_token();
        }
    }

    std::string rest_of_line() {
        const std::size_t end = std::min(text_.find('\n', at_), text_.size());
        std::string rest = text_.substr(at_, end - at_);
        at_ = end;
        return rest;
    }

    void take_comment() {
        tokens_.fills_line[line_] = line_is_empty_;
        tokens_.comments[line_] = rest_of_line();
    }

    void take_directive() {
        std::string directive = rest_of_line();
        while (directive.ends_with('\\')) {
            ++at_;
            ++line_;
            directive += rest_of_line();
        }
        const std::string_view view = directive;
        if (view.starts_with("#include")) {
            if (view.find("// IWYU pragma: ") != std::string_view::npos) return;
            const std::size_t begin = view.find_first_of("\"<");
            const std::size_t end = view.find_first_of("\">", begin + 1);
            tokens_.includes.emplace_back(view.substr(begin, end - begin + 1));
            return;
        }
        if (view.starts_with("#define ")) {
            std::size_t end = 8;
            while (end < view.size() && is_name_part(view[end])) ++end;
            tokens_.macros.emplace_back(view.substr(8, end - 8));
        }
        tokens_.directive_text.push_back(directive);
    }

    void take_token() {
        const char c = text_[at_];
        if (starts("R\"")) {
            take_raw_string();
        } else if (c == '"' || c == '\'') {
            take_literal(c);
        } else if (is_name_start(c)) {
            take_while(Token::Kind::name, is_name_part);
        } else if (std::isdigit(static_cast<unsigned char>(c)) != 0) {
            take_number();
        } else {
            const bool pair = starts("::") || starts("->");
            add(Token::Kind::sign, pair ? 2 : 1);
        }
    }

    void add(Token::Kind kind, std::size_t length) {
        const std::string text = text_.substr(at_, length);
        tokens_.all.push_back({kind, text, line_});
        for (const char c : text) line_ += c == '\n' ? 1 : 0;
        at_ += length;
    }

    void take_while(Token::Kind kind, bool (*belongs)(char)) {
        std::size_t end = at_ + 1;
        while (end < text_.size() && belongs(text_[end])) ++end;
        add(kind, end - at_);
    }

    void take_number() {
        std::size_t end = at_ + 1;
        const auto continues = [&](char c) {
            const char before = text_[end - 1];
            const bool sign = (c == '+' || c == '-') && (before == 'e' || before == 'E');
            return is_name_part(c) || c == '.' || c == '\'' || sign;
        };
        while (end < text_.size() && continues(text_[end])) ++end;
        add(Token::Kind::number, end - at_);
    }

    void take_literal(char quote) {
        std::size_t end = at_ + 1;
        while (end < text_.size() && text_[end] != quote) end += text_[end] == '\\' ? 2 : 1;
        add(Token::Kind::literal, end + 1 - at_);
    }

    void take_raw_string() {
        const std::size_t open = text_.find('(', at_);
        const std::string close = ")" + text_.substr(at_ + 2, open - at_ - 2) + "\"";
        add(Token::Kind::literal, text_.find(close, open) + close.size() - at_);
    }

    const std::string& text_;
    Tokens tokens_;
    std::size_t at_ = 0;
    int line_ = 1;
    bool line_is_empty_ = true;
};

}  // namespace

Tokens tokenize(const std::string& text) {
    return Tokenizer(text).run();
}

}  // namespace rockslope::sources
