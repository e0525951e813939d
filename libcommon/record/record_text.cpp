#include "record/record_text.hpp"

#include <array>
#include <cstdio>

#include "common/base/text.hpp"
#include "record/measures.hpp"

namespace rockslope::record {

namespace {

template <class... Values>
std::string formatted(const char* format, Values... values) {
    std::array<char, 64> buffer{};
    std::snprintf(buffer.data(), buffer.size(), format, values...);
    return buffer.data();
}

}  // namespace

std::string at2_text(const Accelerogram& record, const std::string& title, const std::string& heading) {
    std::string text = heading + "\n" + title + "\nACCELERATION TIME SERIES IN UNITS OF G\n";
    text += formatted("NPTS= %6zu, DT= %8.6f SEC,\n", record.values.size(), record.step);
    for (std::size_t k = 0; k < record.values.size(); ++k) {
        text += formatted("%15.7E", record.values[k] / standard_gravity);
        if (k % 5 == 4 || k + 1 == record.values.size()) {
            text += '\n';
        }
    }
    return text;
}

std::string csv_text(const Accelerogram& record, const std::string& title) {
    std::string text = "# " + title + "\ntime (s),acceleration (m/s2)\n";
    for (std::size_t k = 0; k < record.values.size(); ++k) {
        text += shortest_text(static_cast<double>(k) * record.step) + ',' + shortest_text(record.values[k]) +
                '\n';
    }
    return text;
}

}  // namespace rockslope::record
