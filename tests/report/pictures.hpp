#pragma once

#include <string>
#include <vector>

#include "support/record.hpp"

namespace rockslope::verification {

/// A picture as the tests recorded it.
struct Picture {
    std::string id;    ///< of the case
    std::string stem;  ///< file name without its ending
    std::string title;
    std::string x_label;
    std::string y_label;
    std::vector<Curve> curves;
};

/// All pictures in a folder, in order of their names. Throws std::runtime_error, naming the file, on a
/// malformed one.
std::vector<Picture> read_pictures(const std::string& folder);

/// The picture as a scalable drawing: the first curve thick and pale, the reference; the others thin over it.
std::string draw(const Picture& picture);

}  // namespace rockslope::verification
