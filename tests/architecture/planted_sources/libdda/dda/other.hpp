#pragma once

namespace rockslope::dda {

struct Other {};

}  // namespace rockslope::dda
