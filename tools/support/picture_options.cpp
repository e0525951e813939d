#include "support/picture_options.hpp"

namespace rockslope::tool_support {

namespace po = boost::program_options;

void add_picture_options(po::options_description& options) {
    auto add = options.add_options();
    add("width", po::value<std::string>()->value_name("LENGTH"),
        "width of a picture, such as 85mm or 3.3in (default: as the drawing needs)");
    add("font", po::value<std::string>()->value_name("NAME"),
        "font of the pictures, an installed one (default: DejaVu Sans)");
    add("font-size", po::value<double>()->value_name("PT"),
        "size of most letters of a picture, pt (default: 9)");
}

PageStyle picture_style(const po::variables_map& values, const std::string& program) {
    PageRequest request;
    if (values.count("width")) request.width = values["width"].as<std::string>();
    if (values.count("font")) request.font = values["font"].as<std::string>();
    if (values.count("font-size")) request.font_size = values["font-size"].as<double>();
    return page_style(request, program);
}

}  // namespace rockslope::tool_support
