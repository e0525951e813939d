#include <map>
#include <set>

#include "checks.hpp"

namespace rockslope::sources {

namespace {

using Names = std::set<std::string>;

/// Names of the headers of the standard library, as far as we use them.
const std::map<std::string, Names> standard_names = {
    {"<algorithm>",
     {"all_of",      "any_of",   "binary_search",  "clamp",       "copy",        "copy_n",      "count",
      "count_if",    "equal",    "equal_range",    "fill",        "fill_n",      "find",        "find_if",
      "for_each",    "generate", "is_sorted",      "lower_bound", "max",         "max_element", "min",
      "min_element", "minmax",   "minmax_element", "none_of",     "nth_element", "remove",      "remove_if",
      "replace",     "reverse",  "rotate",         "sort",        "stable_sort", "transform",   "unique",
      "upper_bound", "ranges"}},
    {"<array>", {"array", "to_array"}},
    {"<atomic>", {"atomic", "atomic_flag", "memory_order_relaxed"}},
    {"<bit>", {"bit_cast", "endian", "rotr", "rotl", "bit_width", "countr_zero", "popcount"}},
    {"<chrono>", {"chrono"}},
    {"<cmath>", {"abs", "acos",  "asin",  "atan",  "atan2",  "cbrt",      "ceil",     "cos",       "cosh",
                 "erf", "exp",   "expm1", "floor", "fmod",   "hypot",     "isfinite", "isnan",     "llround",
                 "log", "log10", "log1p", "log2",  "lround", "nextafter", "pow",      "remainder", "round",
                 "sin", "sinh",  "sqrt",  "tan",   "tanh",   "copysign",  "frexp",    "ldexp",     "trunc"}},
    {"<complex>", {"complex"}},
    {"<concepts>", {"same_as", "convertible_to", "invocable", "integral", "floating_point", "derived_from"}},
    {"<condition_variable>", {"condition_variable"}},
    {"<cstddef>", {"size_t", "ptrdiff_t", "byte", "nullptr_t", "offsetof"}},
    {"<cstdint>",
     {"int8_t", "int16_t", "int32_t", "int64_t", "uint8_t", "uint16_t", "uint32_t", "uint64_t", "uintptr_t"}},
    {"<cstdio>", {"printf", "snprintf", "fprintf", "FILE", "fopen", "fputs", "stderr", "stdout"}},
    {"<cstdlib>", {"free", "malloc", "aligned_alloc", "exit", "getenv", "strtod", "abort", "posix_memalign"}},
    {"<cstring>", {"memcpy", "memset", "memmove", "strlen", "strcmp", "memcmp", "strerror"}},
    {"<exception>", {"exception", "exception_ptr", "current_exception", "rethrow_exception"}},
    {"<filesystem>", {"filesystem"}},
    {"<fstream>", {"ifstream", "ofstream", "fstream"}},
    {"<functional>",
     {"function", "hash", "less", "greater", "plus", "minus", "multiplies", "invoke", "reference_wrapper"}},
    {"<initializer_list>", {"initializer_list"}},
    {"<iostream>", {"cout", "cerr", "clog", "cin"}},
    {"<iosfwd>", {"basic_ostream", "ostream", "istream"}},
    {"<iterator>",
     {"back_inserter", "distance", "next", "prev", "advance", "iterator_traits", "random_access_iterator_tag",
      "forward_iterator_tag", "input_iterator_tag", "istreambuf_iterator", "size", "ssize"}},
    {"<limits>", {"numeric_limits"}},
    {"<map>", {"map", "multimap"}},
    {"<memory>",
     {"addressof", "unique_ptr", "shared_ptr", "make_unique", "make_shared", "weak_ptr", "allocator",
      "assume_aligned"}},
    {"<mutex>", {"mutex", "lock_guard", "unique_lock", "scoped_lock", "once_flag", "call_once"}},
    {"<new>", {"bad_alloc", "align_val_t", "nothrow"}},
    {"<numbers>", {"numbers"}},
    {"<numeric>",
     {"accumulate", "iota", "inner_product", "partial_sum", "reduce", "midpoint", "lerp", "gcd"}},
    {"<optional>", {"optional", "nullopt", "make_optional"}},
    {"<ostream>", {"ostream", "endl", "flush"}},
    {"<queue>", {"queue", "priority_queue"}},
    {"<random>",
     {"mt19937", "mt19937_64", "uniform_real_distribution", "uniform_int_distribution",
      "normal_distribution"}},
    {"<set>", {"set", "multiset"}},
    {"<span>", {"span", "as_bytes", "dynamic_extent"}},
    {"<sstream>", {"stringstream", "ostringstream", "istringstream"}},
    {"<stdexcept>", {"runtime_error", "logic_error", "invalid_argument", "out_of_range", "domain_error"}},
    {"<string>", {"string", "to_string", "stoi", "stod", "getline"}},
    {"<string_view>", {"string_view"}},
    {"<thread>", {"thread", "this_thread", "jthread"}},
    {"<tuple>", {"tuple", "tie", "make_tuple", "get", "apply", "tuple_size", "tuple_element", "ignore"}},
    {"<type_traits>",
     {"is_same_v",
      "decay_t",
      "remove_cvref_t",
      "conditional_t",
      "enable_if_t",
      "invoke_result_t",
      "is_trivially_copyable_v",
      "true_type",
      "false_type",
      "type_identity",
      "is_const_v",
      "remove_const_t",
      "underlying_type_t",
      "is_arithmetic_v",
      "is_enum_v",
      "is_integral_v",
      "is_floating_point_v",
      "is_invocable_v",
      "is_convertible_v",
      "is_void_v",
      "is_base_of_v",
      "remove_reference_t",
      "add_const_t",
      "is_aggregate_v",
      "is_empty_v"}},
    {"<unordered_map>", {"unordered_map", "unordered_multimap"}},
    {"<unordered_set>", {"unordered_set"}},
    {"<utility>",
     {"pair", "move", "swap", "forward", "exchange", "declval", "make_pair", "index_sequence",
      "make_index_sequence", "index_sequence_for", "as_const", "in_place"}},
    {"<variant>",
     {"variant", "visit", "get", "get_if", "holds_alternative", "monostate", "variant_size_v",
      "variant_alternative_t"}},
    {"<vector>", {"vector", "erase", "erase_if"}},
};

/// What other files can use of a header: all that it declares outside of classes, and its macros.
Names offered_names(const SourceFile& header) {
    Names names(header.tokens.macros.begin(), header.tokens.macros.end());
    for (const Declaration& one : header.declarations) {
        const bool in_class = !one.owner.empty() && one.kind != Declaration::Kind::enumerator;
        if (!in_class) names.insert(one.name);
    }
    return names;
}

/// The names that a file uses.
struct UsedNames {
    Names all;
    Names standard;  ///< behind std::
};

/// Adds the names of a row of tokens.
void add_names(const std::vector<Token>& tokens, UsedNames& used) {
    for (std::size_t k = 0; k < tokens.size(); ++k) {
        if (tokens[k].kind != Token::Kind::name) continue;
        used.all.insert(tokens[k].text);
        if (k >= 2 && tokens[k - 1].text == "::" && tokens[k - 2].text == "std")
            used.standard.insert(tokens[k].text);
    }
}

UsedNames used_names(const SourceFile& file) {
    UsedNames used;
    add_names(file.tokens.all, used);
    for (const std::string& directive : file.tokens.directive_text)
        add_names(tokenize(directive.substr(1)).all, used);
    return used;
}

/// Whether the names of a header may stand without std::, as those of a header that C has as well, or of our
/// own.
bool may_be_bare(const std::string& include) {
    return include.starts_with("\"") || include.starts_with("<c") || include == "<new>";
}

bool meet(const Names& first, const Names& second) {
    for (const std::string& name : first)
        if (second.contains(name)) return true;
    return false;
}

}  // namespace

Faults check_includes(const std::vector<SourceFile>& files) {
    std::map<std::string, Names> offers = standard_names;
    for (const SourceFile& file : files)
        if (file.is_header()) offers["\"" + file.include_path() + "\""] = offered_names(file);
    Faults faults;
    for (const SourceFile& file : files) {
        if (!file.is_header()) continue;
        const UsedNames used = used_names(file);
        for (const std::string& include : file.tokens.includes) {
            const auto offered = offers.find(include);
            const Names& names = may_be_bare(include) ? used.all : used.standard;
            if (offered != offers.end() && !meet(offered->second, names))
                faults.push_back(file.path + " includes " + include + " and uses nothing of it");
        }
    }
    return faults;
}

}  // namespace rockslope::sources
