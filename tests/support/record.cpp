#include "support/record.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <stdexcept>

#include "support/catalogue.hpp"

namespace rockslope::verification {

namespace {

/// The folder of the report; empty if the environment variable is not set.
std::filesystem::path report_folder() {
    const char* folder = std::getenv("DDA_VERIFICATION_REPORT");
    return folder == nullptr ? std::filesystem::path() : std::filesystem::path(folder);
}

std::string test_name() {
    const testing::TestInfo* info = testing::UnitTest::GetInstance()->current_test_info();
    if (info == nullptr) throw std::logic_error("a verification case must be inside a test");
    std::string name = std::string(info->test_suite_name()) + "." + info->name();
    for (char& c : name) {
        if (c == '/') c = '-';
    }
    return name;
}

/// Appends a row to the test's own file, which is truncated at its first row: tests may run in parallel.
void append(const Row& row) {
    const std::filesystem::path folder = report_folder();
    if (folder.empty()) return;
    std::filesystem::create_directories(folder);
    static std::set<std::string> started;
    const std::string name = test_name();
    const bool first = started.insert(name).second;
    std::ofstream out(folder / (name + ".tsv"), first ? std::ios::trunc : std::ios::app);
    if (first) write_header(out);
    write_row(out, row);
    if (!out.flush()) throw std::runtime_error("cannot write the rows of the report to " + folder.string());
}

void fail(const Row& row, const std::string& what, TestLine at) {
    ADD_FAILURE_AT(at.file, at.line) << row.id << ", " << row.set_up << ": " << row.quantity << " is "
                                     << row.ours << ' ' << row.unit << ", expected " << row.expected << " ("
                                     << to_text(row.kind) << ' ' << row.tolerance << ", error " << row.error
                                     << ")" << what;
}

void record_verdict(Row row, bool within, TestLine at) {
    row.verdict = within ? Verdict::passes : Verdict::fails;
    append(row);
    if (!within) fail(row, "", at);
}

bool within_tolerance(double ours, double expected, Tolerance tolerance) {
    const double allowed =
        tolerance.kind == ToleranceKind::relative ? tolerance.value * std::abs(expected) : tolerance.value;
    return std::abs(ours - expected) <= allowed;
}

}  // namespace

Case::Case(std::string id, std::string set_up, std::string reason)
    : id_(std::move(id)), set_up_(std::move(set_up)), reason_(std::move(reason)) {
    catalogue_case(id_);
    for (const std::string& text : {set_up_, reason_}) {
        if (text.find_first_of("\t\n|") != std::string::npos)
            throw std::invalid_argument("the text of a row must not contain a tab, line end or bar: " + text);
    }
}

Case& Case::contact_frequency_step(double value) {
    contact_frequency_step_ = value;
    return *this;
}

Row Case::row(const std::string& quantity, const std::string& unit) const {
    Row row;
    row.id = id_;
    row.set_up = set_up_;
    row.quantity = quantity;
    row.unit = unit;
    if (!std::isnan(contact_frequency_step_)) row.contact_frequency_step = to_text(contact_frequency_step_);
    row.reason = reason_;
    return row;
}

Row Case::compared(const std::string& quantity, const std::string& unit, double ours, double expected,
                   Tolerance tolerance) const {
    if (tolerance.kind == ToleranceKind::relative && expected == 0)
        throw std::invalid_argument("a relative tolerance needs an expected value other than zero");
    Row made = row(quantity, unit);
    made.expected = to_text(expected);
    made.ours = to_text(ours);
    const double scale = tolerance.kind == ToleranceKind::relative ? std::abs(expected) : 1;
    made.error = to_text((ours - expected) / scale);
    made.tolerance = to_text(tolerance.value);
    made.kind = tolerance.kind;
    return made;
}

void Case::expect(const std::string& quantity, const std::string& unit, double ours, double expected,
                  Tolerance tolerance, TestLine at) const {
    record_verdict(compared(quantity, unit, ours, expected, tolerance),
                   within_tolerance(ours, expected, tolerance), at);
}

void Case::expect_below(const std::string& quantity, const std::string& unit, double ours, double limit,
                        TestLine at) const {
    Row made = row(quantity, unit);
    made.ours = to_text(std::abs(ours));
    made.tolerance = to_text(limit);
    made.kind = ToleranceKind::below;
    record_verdict(made, std::abs(ours) < limit, at);
}

void Case::expect_above(const std::string& quantity, const std::string& unit, double ours, double limit,
                        TestLine at) const {
    Row made = row(quantity, unit);
    made.ours = to_text(ours);
    made.tolerance = to_text(limit);
    made.kind = ToleranceKind::above;
    record_verdict(made, ours > limit, at);
}

void Case::expect_outcome(const std::string& quantity, const std::string& ours, const std::string& expected,
                          TestLine at) const {
    Row made = row(quantity, {});
    made.expected = expected;
    made.ours = ours;
    made.kind = ToleranceKind::outcome;
    record_verdict(made, ours == expected, at);
}

void Case::inform(const std::string& quantity, const std::string& unit, double ours, double reference) const {
    Row made = row(quantity, unit);
    made.expected = to_text(reference);
    made.ours = to_text(ours);
    append(made);
}

void Case::inform(const std::string& quantity, const std::string& unit, double ours) const {
    Row made = row(quantity, unit);
    made.ours = to_text(ours);
    append(made);
}

void Case::expect_miss(const std::string& quantity, const std::string& unit, double ours, double expected,
                       const KnownMiss& miss, TestLine at) const {
    Row made = compared(quantity, unit, ours, expected, miss.tolerance);
    made.verdict = Verdict::misses;
    made.reason = miss.reason;
    append(made);
    if (within_tolerance(ours, expected, miss.tolerance))
        fail(made, ": no longer a miss; use expect() instead", at);
}

void record_picture(const std::string& id, const std::string& slug, const std::string& title,
                    const std::string& x_label, const std::string& y_label,
                    const std::vector<Curve>& curves) {
    catalogue_case(id);
    const std::filesystem::path folder = report_folder();
    if (folder.empty()) return;
    std::filesystem::create_directories(folder);
    std::ofstream out(folder / (id + "-" + slug + ".curves"));
    out << title << '\n' << x_label << '\n' << y_label << '\n';
    out.precision(9);
    for (const Curve& curve : curves) {
        out << curve.x.size() << ' ' << curve.name << '\n';
        for (std::size_t k = 0; k < curve.x.size(); ++k) out << curve.x[k] << ' ' << curve.y.at(k) << '\n';
    }
    if (!out.flush()) throw std::runtime_error("cannot write the curves of a picture to " + folder.string());
}

}  // namespace rockslope::verification
