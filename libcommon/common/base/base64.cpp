#include "common/base/base64.hpp"

#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>
#include <cstddef>

namespace rockslope {

std::string base64(const std::string& bytes) {
    namespace it = boost::archive::iterators;
    using Encoder = it::base64_from_binary<it::transform_width<std::string::const_iterator, 6, 8>>;
    const std::size_t padding = (3 - bytes.size() % 3) % 3;
    const std::string whole = bytes + std::string(padding, '\0');
    std::string text(Encoder(whole.begin()), Encoder(whole.end()));
    return text.replace(text.size() - padding, padding, padding, '=');
}

}  // namespace rockslope
