#pragma once

#include <cpl_conv.h>
#include <cpl_error.h>
#include <gdal.h>
#include <ogr_api.h>
#include <ogr_srs_api.h>

namespace rockslope::blockgen {

/// GDAL's functions, by their own names: gdal().GDALOpenEx(...). The library is loaded when the first file or
/// coordinate system needs it. Linked to the program it would load a hundred others each time: 57 ms instead
/// of 5 ms for a cut of a few blocks.
struct GdalLibrary {
// NOLINTNEXTLINE(bugprone-macro-parentheses): the name of a function and of a member
#define GDAL_FUNCTION(name) decltype(&::name) name = nullptr;
#include "blockgen/input/gdal_functions.def"
#undef GDAL_FUNCTION
};

/// The loaded library, with its drivers registered. @throws std::runtime_error when it is not installed.
const GdalLibrary& gdal();

/// Keeps GDAL from writing to the standard error stream.
class GdalErrorSilencer {
  public:
    /// Until the end of its life.
    GdalErrorSilencer() { gdal().CPLPushErrorHandler(gdal().CPLQuietErrorHandler); }
    ~GdalErrorSilencer() { gdal().CPLPopErrorHandler(); }
    GdalErrorSilencer(const GdalErrorSilencer&) = delete;
    GdalErrorSilencer& operator=(const GdalErrorSilencer&) = delete;
};

}  // namespace rockslope::blockgen
