#pragma once

#include <string>
#include <vector>

#include "support/record.hpp"

namespace rockslope::verification {

/// A picture recorded by a test.
struct Picture {
    std::string id;    ///< of the case
    std::string stem;  ///< file name without extension
    std::string title;
    std::string x_label;
    std::string y_label;
    std::vector<Curve> curves;
};

/// All pictures in a folder, sorted by name. @throws std::runtime_error that names a malformed file.
std::vector<Picture> read_pictures(const std::string& folder);

/// The picture as SVG: the first curve, the reference, thick and pale, the others thin on top of it.
std::string draw(const Picture& picture);

}  // namespace rockslope::verification
