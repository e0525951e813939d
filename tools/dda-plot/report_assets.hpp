#pragma once

#include <string_view>

namespace rockslope {

/// The page of a report with the marks @title@, @policy@, @style@, @data@ and @script@; CMake makes its
/// source from the files of web/report.
extern const std::string_view report_page;
/// The style of a report.
extern const std::string_view report_style;
/// The program of a report, bundled from web/report.
extern const std::string_view report_script;

}  // namespace rockslope
