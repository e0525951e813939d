#include "report/page.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>

#include "support/catalogue.hpp"

namespace rockslope::verification {

namespace {

std::string key(const Row& row) {
    return row.id + ", " + row.set_up + ", " + row.quantity;
}

std::vector<Row> rows_of(const std::vector<Row>& rows, std::string_view id) {
    std::vector<Row> found;
    std::copy_if(rows.begin(), rows.end(), std::back_inserter(found),
                 [&](const Row& row) { return row.id == id; });
    return found;
}

std::string with_unit(const std::string& value, const std::string& unit) {
    return unit.empty() || value.empty() ? value : value + " " + unit;
}

std::string percent(const std::string& fraction) {
    return to_text(100 * std::strtod(fraction.c_str(), nullptr)) + " %";
}

std::string expected_of(const Row& row) {
    switch (row.kind) {
        case ToleranceKind::below:
            return "below " + with_unit(row.tolerance, row.unit);
        case ToleranceKind::above:
            return "above " + with_unit(row.tolerance, row.unit);
        default:
            return with_unit(row.expected, row.unit);
    }
}

std::string short_number(const std::string& text, const char* format) {
    char made[32];
    std::snprintf(made, sizeof made, format, std::strtod(text.c_str(), nullptr));
    return made;
}

std::string error_of(const Row& row) {
    if (row.error.empty()) return {};
    if (row.kind == ToleranceKind::relative) return short_number(percent(row.error), "%.2g") + " %";
    return with_unit(short_number(row.error, "%.2g"), row.unit);
}

std::string tolerance_of(const Row& row) {
    if (row.kind == ToleranceKind::relative) return percent(row.tolerance);
    return row.kind == ToleranceKind::absolute ? with_unit(row.tolerance, row.unit) : std::string();
}

std::string verdict_of(const Row& row) {
    switch (row.verdict) {
        case Verdict::passes:
            return "within";
        case Verdict::fails:
            return "**outside**";
        case Verdict::misses:
            return "**misses**";
        case Verdict::informs:
            return "for information";
    }
    return {};
}

bool is_energy(const Row& row) {
    return row.quantity == energy_residual || row.quantity == friction_work ||
           row.quantity == integration_loss;
}

/// Largest error of a case over its tolerance, in per cent, of the rows that have a tolerance.
std::string worst_error_ratio(const std::vector<Row>& rows) {
    double worst = -1;
    for (const Row& row : rows) {
        const double tolerance = std::strtod(row.tolerance.c_str(), nullptr);
        if (row.verdict == Verdict::informs || tolerance <= 0) continue;
        const std::string& measured = row.error.empty() ? row.ours : row.error;
        if (row.kind == ToleranceKind::above || row.kind == ToleranceKind::outcome || is_energy(row))
            continue;
        worst = std::max(worst, std::abs(std::strtod(measured.c_str(), nullptr)) / tolerance);
    }
    return worst < 0 ? std::string() : short_number(to_text(100 * worst), "%.3g") + " %";
}

std::string summary_verdict(const std::vector<Row>& rows) {
    if (rows.empty()) return "not covered yet";
    const auto has = [&](Verdict v) {
        return std::any_of(rows.begin(), rows.end(), [&](const Row& row) { return row.verdict == v; });
    };
    return has(Verdict::fails) ? "**outside**" : has(Verdict::misses) ? "**misses**" : "within";
}

std::string range_of_steps(const std::vector<Row>& rows) {
    double least = INFINITY;
    double most = -INFINITY;
    for (const Row& row : rows) {
        if (row.contact_frequency_step.empty()) continue;
        const double value = std::strtod(row.contact_frequency_step.c_str(), nullptr);
        least = std::min(least, value);
        most = std::max(most, value);
    }
    if (most < least) return {};
    const std::string low = short_number(to_text(least), "%.2g");
    const std::string high = short_number(to_text(most), "%.2g");
    return low == high ? low : low + "–" + high;
}

void write_summary(std::ostream& out, const std::vector<Row>& rows) {
    out << "| id | case | rows | largest error over its tolerance | ω_c Δt | verdict "
           "|\n|---|---|---|---|---|---|\n";
    for (const CatalogueCase& entry : catalogue) {
        const std::vector<Row> own = rows_of(rows, entry.id);
        out << "| "
            << (own.empty() ? std::string(entry.id)
                            : "[" + std::string(entry.id) + "](#" + std::string(entry.id) + ")")
            << " | " << entry.title << " | " << own.size() << " | " << worst_error_ratio(own) << " | "
            << range_of_steps(own) << " | " << summary_verdict(own) << " |\n";
    }
}

void write_misses(std::ostream& out, const std::vector<Row>& rows) {
    if (std::none_of(rows.begin(), rows.end(), [](const Row& row) { return row.verdict == Verdict::misses; }))
        return;
    out << "\nKnown misses, each with its reason at the case:\n\n";
    for (const Row& row : rows) {
        if (row.verdict != Verdict::misses) continue;
        out << "- [" << row.id << "](#" << row.id << "), " << row.set_up << ": " << row.quantity << " is "
            << with_unit(row.ours, row.unit) << ", expected " << expected_of(row) << ".\n";
    }
}

/// One line for each set-up with an energy balance, in place of three in the table of its case.
void write_energy(std::ostream& out, const std::vector<Row>& rows) {
    if (std::none_of(rows.begin(), rows.end(), is_energy)) return;
    out << "\n## Energy\n\nThe energy balance of every dynamic case, relative to the energy exchanged: the "
           "largest kinetic "
           "energy or\nchange of another account of the ledger ([theory](theory.md), sec. 8) since the start "
           "of the "
           "dynamic stage. The largest\nresidual of the ledger must be below 1e-3. The work of friction must "
           "not be "
           "negative in any step, except for rounding. The\nloss by the time integration, Eq. (42) of the "
           "theory, is "
           "not an error of the balance.\n\n"
           "| id | set-up | residual | least work of friction in a step | lost by the time integration | "
           "verdict |\n|---|---|---|---|---|---|\n";
    for (const Row& row : rows) {
        if (row.quantity != energy_residual) continue;
        const auto of = [&](const char* quantity) {
            const auto same = std::find_if(rows.begin(), rows.end(), [&](const Row& r) {
                return r.id == row.id && r.set_up == row.set_up && r.quantity == quantity;
            });
            return same == rows.end() ? Row() : *same;
        };
        const Row friction = of(friction_work);
        const bool fails = row.verdict == Verdict::fails || friction.verdict == Verdict::fails;
        out << "| [" << row.id << "](#" << row.id << ") | " << row.set_up << " | "
            << short_number(row.ours, "%.2g") << " | " << short_number(friction.ours, "%.2g") << " | "
            << short_number(of(integration_loss).ours, "%.3g") << " | "
            << (fails ? "**outside**" : verdict_of(row)) << " |\n";
    }
}

void write_reasons(std::ostream& out, const std::vector<Row>& rows, bool misses) {
    std::vector<std::string> written;
    for (const Row& row : rows) {
        if ((row.verdict == Verdict::misses) != misses || is_energy(row)) continue;
        if (row.reason.empty() || std::find(written.begin(), written.end(), row.reason) != written.end())
            continue;
        written.push_back(row.reason);
        out << (misses ? "\nMisses: " : "\nTolerance: ") << row.reason << "\n";
    }
}

void write_case(std::ostream& out, const CatalogueCase& entry, const std::vector<Row>& rows,
                const std::vector<PictureLink>& pictures) {
    out << "\n### <a id=\"" << entry.id << "\"></a>" << entry.id << " " << entry.title
        << "\n\nExpected from: " << entry.basis << ".\n\n"
        << "| set-up | quantity | expected | ours | error | tolerance | ω_c Δt | verdict |\n"
        << "|---|---|---|---|---|---|---|---|\n";
    for (const Row& row : rows) {
        if (is_energy(row)) continue;
        out << "| " << row.set_up << " | " << row.quantity << " | " << expected_of(row) << " | "
            << with_unit(row.ours, row.unit) << " | " << error_of(row) << " | " << tolerance_of(row) << " | "
            << (row.contact_frequency_step.empty() ? std::string()
                                                   : short_number(row.contact_frequency_step, "%.2g"))
            << " | " << verdict_of(row) << " |\n";
    }
    write_reasons(out, rows, false);
    write_reasons(out, rows, true);
    for (const PictureLink& picture : pictures) {
        if (picture.id == entry.id) out << "\n![" << picture.title << "](" << picture.path << ")\n";
    }
}

}  // namespace

std::vector<Row> in_order(std::vector<Row> rows) {
    std::stable_sort(rows.begin(), rows.end(), [](const Row& a, const Row& b) { return a.id < b.id; });
    std::set<std::string> seen;
    for (const Row& row : rows) {
        if (!seen.insert(key(row)).second) throw std::runtime_error("two rows for " + key(row));
    }
    return rows;
}

std::string page(const std::vector<Row>& rows, const std::vector<PictureLink>& pictures) {
    std::ostringstream out;
    out << "# Verification\n\n"
           "Written by the verification tests; do not edit. To write it again:\n\n"
           "    cmake --build --preset release --target verification_report\n\n"
           "Each row is one assertion of a test: the tolerance shown is the one asserted. ω_c Δt is the "
           "frequency of the "
           "contact\nspring on the lightest block times the step ([theory](theory.md), sec. 7); rows without "
           "it have no "
           "contact. The [notes](verification-notes.md)\nderive the expected values. The numbers are also in "
           "[verification.tsv](verification.tsv).\n\n## Summary\n\n";
    write_summary(out, rows);
    write_misses(out, rows);
    write_energy(out, rows);
    out << "\n## Cases\n";
    for (const CatalogueCase& entry : catalogue) {
        const std::vector<Row> own = rows_of(rows, entry.id);
        if (!own.empty()) write_case(out, entry, own, pictures);
    }
    return out.str();
}

std::vector<std::string> missing_balances(const std::vector<Row>& rows) {
    std::vector<std::string> missing;
    for (const CatalogueCase& entry : catalogue) {
        const std::vector<Row> own = rows_of(rows, entry.id);
        const bool balanced = std::any_of(own.begin(), own.end(),
                                          [](const Row& row) { return row.quantity == energy_residual; });
        if (entry.dynamic && !own.empty() && !balanced)
            missing.push_back(std::string(entry.id) + ": a dynamic case without an energy balance");
    }
    return missing;
}

std::vector<std::string> differences(const std::vector<Row>& committed, const std::vector<Row>& fresh) {
    std::map<std::string, const Row*> by_key;
    for (const Row& row : committed) by_key[key(row)] = &row;
    std::vector<std::string> found;
    for (const Row& row : fresh) {
        const auto old = by_key.find(key(row));
        if (old == by_key.end()) {
            found.push_back(key(row) + ": not in the committed report");
            continue;
        }
        const Row& was = *old->second;
        if (was.verdict != row.verdict) {
            found.push_back(key(row) + ": " + to_text(row.verdict) + ", committed: " + to_text(was.verdict));
        }
        const auto promise = [](const Row& r) { return expected_of(r) + ", tolerance " + tolerance_of(r); };
        // The reference of a row for information is computed by us, and its digits may differ.
        if (row.kind != ToleranceKind::none && promise(row) != promise(was)) {
            found.push_back(key(row) + ": expected " + promise(row) + ", committed: " + promise(was));
        }
        by_key.erase(old);
    }
    for (const auto& [name, row] : by_key) found.push_back(name + ": committed, but no test records it");
    return found;
}

}  // namespace rockslope::verification
