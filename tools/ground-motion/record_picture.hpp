#pragma once

#include <string>
#include <vector>

#include "common/drawing/canvas.hpp"
#include "record/accelerogram.hpp"

namespace rockslope {

/// A record and its name in the picture.
struct NamedRecord {
    std::string name;
    record::Accelerogram record;
};

/// Draws acceleration (g), velocity (m/s) and displacement (m) of records against time, and their 5 %
/// response spectra up to 4 s; several records get a legend. @param records at least one.
Canvas record_picture(const std::vector<NamedRecord>& records, const std::string& title,
                      const PageStyle& style = {});

/// A line of a picture.
struct PictureCurve {
    std::string name;
    std::vector<double> x;
    std::vector<double> y;
};

/// Draws displacements in x and y, m, against time, one panel each, with a legend. @param x, y curves of the
/// same runs.
Canvas displacement_picture(const std::vector<PictureCurve>& x, const std::vector<PictureCurve>& y,
                            const std::string& title, const PageStyle& style = {});

/// Draws curves against the period, s, with a legend.
Canvas period_picture(const std::vector<PictureCurve>& curves, const std::string& title,
                      const std::string& y_title, const PageStyle& style = {});

}  // namespace rockslope
