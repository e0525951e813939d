#include "support/command_page.hpp"

#include <algorithm>
#include <cstdio>
#include <sstream>

namespace rockslope::tool_support {

namespace {

bool is_subcommand(const CommandPage& page) {
    return page.name.find(' ') != std::string::npos;
}

/// "ground-motion-scale" of the subcommand "ground-motion scale".
std::string page_title(const CommandPage& page) {
    std::string title = page.name;
    std::replace(title.begin(), title.end(), ' ', '-');
    return title;
}

std::string table(const std::string& title, const std::vector<PageEntry>& entries) {
    std::size_t widest = 0;
    for (const PageEntry& entry : entries) widest = std::max(widest, entry.name.size());
    std::string text = entries.empty() ? "" : "\n" + title + ":\n";
    for (const PageEntry& entry : entries)
        text += "  " + entry.name + std::string(widest + 2 - entry.name.size(), ' ') + entry.meaning + "\n";
    return text;
}

/// Text with the characters escaped that roff takes for its own.
std::string roff(const std::string& text) {
    std::string result;
    for (const char c : text) {
        if (c == '\\')
            result += "\\e";
        else if (c == '-')
            result += "\\-";
        else if ((c == '.' || c == '\'') && (result.empty() || result.back() == '\n'))
            result += std::string("\\&") + c;
        else
            result += c;
    }
    return result;
}

std::string option_entry(const boost::program_options::option_description& option) {
    std::string entry = ".TP\n.B " + roff(option.format_name()) + "\n";
    const std::string parameter = option.format_parameter();
    if (!parameter.empty()) entry.insert(entry.size() - 1, " " + roff(parameter));
    return entry + roff(option.description()) + "\n";
}

bool takes_value(const boost::program_options::option_description& option) {
    return option.semantic()->max_tokens() > 0;
}

}  // namespace

std::string help_text(const CommandPage& page) {
    std::ostringstream text;
    text << "Usage: " << page.name << ' ' << page.synopsis << "\n\n" << page.purpose << ".\n";
    if (!page.description.empty()) text << page.description << '\n';
    text << table("Subcommands", page.subcommands);
    if (!page.subcommands.empty()) text << "\n" << page.name << " SUBCOMMAND --help lists its options.\n";
    text << '\n' << page.options << table("Exit codes", page.exit_codes);
    return text.str();
}

std::string man_page(const CommandPage& page) {
    std::string text = ".TH \"" + roff(page_title(page)) + "\" 1 \"\" \"rockslope " + page.version +
                       "\" \"rockslope\"\n.SH NAME\n" + roff(page_title(page)) + " \\- " +
                       roff(page.purpose) + "\n.SH SYNOPSIS\n.B " + roff(page.name) + "\n" +
                       roff(page.synopsis) + "\n.SH DESCRIPTION\n" + roff(page.purpose) + ".\n" +
                       roff(page.description) + "\n";
    if (!page.subcommands.empty()) text += ".SH SUBCOMMANDS\n";
    for (const PageEntry& entry : page.subcommands)
        text += ".TP\n.B " + roff(entry.name) + "\n" + roff(entry.meaning) + ". See " +
                roff(page_title(page) + "-" + entry.name) + "(1).\n";
    text += ".SH OPTIONS\n";
    for (const auto& option : page.options.options()) text += option_entry(*option);
    text += ".SH EXIT STATUS\n";
    for (const PageEntry& entry : page.exit_codes)
        text += ".TP\n.B " + roff(entry.name) + "\n" + roff(entry.meaning) + "\n";
    return text;
}

std::string completion_words(const CommandPage& page) {
    std::string text;
    for (const PageEntry& entry : page.subcommands) text += entry.name + " \n";
    for (const auto& option : page.options.options())
        text += "--" + option->long_name() + (takes_value(*option) ? "=\n" : " \n");
    return text;
}

std::optional<std::string> requested_text(const CommandPage& page,
                                          const std::vector<std::string>& arguments) {
    for (const std::string& argument : arguments) {
        if (argument == "--") break;
        if (argument == "--help" || argument == "-h") return help_text(page);
        if (argument == "--help-man") return man_page(page);
        if (argument == "--help-words") return completion_words(page);
        if (argument == "--version" && !is_subcommand(page)) return page.name + " " + page.version + "\n";
    }
    return std::nullopt;
}

std::optional<int> print_requested_text(const CommandPage& page, const std::vector<std::string>& arguments) {
    const std::optional<std::string> text = requested_text(page, arguments);
    if (!text) return std::nullopt;
    if (std::fputs(text->c_str(), stdout) >= 0 && std::fflush(stdout) == 0) return 0;
    std::fprintf(stderr, "%s: the standard output cannot be written\n", page.name.c_str());
    return 1;
}

}  // namespace rockslope::tool_support
