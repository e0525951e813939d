#pragma once

#include <string>
#include <vector>

#include "support/report_row.hpp"

namespace rockslope::verification {

/// A picture of the page.
struct PictureLink {
    std::string id;    ///< of the case
    std::string path;  ///< relative to the page
    std::string title;
};

/// The rows sorted by case; those of one case stay in the order in which they were recorded.
/// @throws std::runtime_error if two rows have the same case, set-up and quantity.
std::vector<Row> in_order(std::vector<Row> rows);

/// The report as Markdown: a summary with a line per case of the catalogue, then a table per case.
std::string page(const std::vector<Row>& rows, const std::vector<PictureLink>& pictures);

/// One line for each dynamic case that has rows but no energy balance.
std::vector<std::string> missing_balances(const std::vector<Row>& rows);

/// One line for each difference between a committed report and a new run: rows that are missing or new, and
/// rows with another verdict, expected value or tolerance. Results are not compared, since their digits may
/// differ by machine.
std::vector<std::string> differences(const std::vector<Row>& committed, const std::vector<Row>& fresh);

}  // namespace rockslope::verification
