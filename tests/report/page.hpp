#pragma once

#include <string>
#include <vector>

#include "support/report_row.hpp"

namespace rockslope::verification {

/// What the page says of a picture that lies beside it.
struct PictureLink {
    std::string id;    ///< of the case
    std::string path;  ///< relative to the page
    std::string title;
};

/// The rows in the catalogue's order, those of one case in the order they were recorded in. Throws
/// std::runtime_error when two rows have the same case, set-up and quantity.
std::vector<Row> in_order(std::vector<Row> rows);

/// The report as Markdown: a summary with a line for each case of the catalogue, then each case's table.
std::string page(const std::vector<Row>& rows, const std::vector<PictureLink>& pictures);

/// The dynamic cases that have rows but no energy balance, one line each.
std::vector<std::string> missing_balances(const std::vector<Row>& rows);

/// What differs between a committed report and a new run, one line each: rows that are missing or new, and
/// rows whose verdict, expectation or tolerance has changed. The results' digits may differ by machine and
/// are not compared.
std::vector<std::string> differences(const std::vector<Row>& committed, const std::vector<Row>& fresh);

}  // namespace rockslope::verification
