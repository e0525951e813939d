#include <algorithm>
#include <cmath>

#include "colour_scale.hpp"
#include "common/base/input_error.hpp"
#include "frame_picture.hpp"

namespace rockslope {

namespace {

/// Half-width of the view around a contact over the size of the smaller of its blocks.
constexpr double half_width_ratio = 2;

/// The magnitudes of a field, each with the area or the length that it holds for.
std::vector<DisplacedArea> weighted_magnitudes(const RunFrames& run, std::int64_t index,
                                               const FrameField& field) {
    const std::vector<std::optional<double>> values = field_values(run, index, field);
    std::vector<DisplacedArea> parts;
    if (field.kind == FieldKind::contacts) {
        const dda::GridFrame contacts = run.contacts(index, {});
        for (std::size_t c = 0; c < values.size(); ++c) {
            const std::vector<Point> line = cell_points(contacts, c);
            if (values[c] && line.size() == 2)
                parts.push_back(
                    {std::hypot(line[1].x - line[0].x, line[1].y - line[0].y), std::abs(*values[c])});
        }
        return parts;
    }
    const dda::GridFrame blocks = run.blocks(index);
    for (std::size_t b = 0; b < values.size(); ++b)
        if (blocks.columns.back()[b] == motion_free)
            parts.push_back({cell_area(blocks, b), std::abs(*values[b])});
    return parts;
}

/// The cell of a block, by its number; none when the block has been removed.
std::optional<std::size_t> cell_of(const dda::GridFrame& frame, int block) {
    const auto& numbers = frame.columns[0];
    const auto found = std::find(numbers.begin(), numbers.end(), static_cast<float>(block));
    if (found == numbers.end()) return std::nullopt;
    return static_cast<std::size_t>(found - numbers.begin());
}

/// The longer side of a block's bounding box, m.
double size_of(const dda::GridFrame& frame, std::size_t block) {
    const std::vector<Point> points = cell_points(frame, block);
    const auto [west, east] =
        std::minmax_element(points.begin(), points.end(), [](auto& p, auto& q) { return p.x < q.x; });
    const auto [low, high] =
        std::minmax_element(points.begin(), points.end(), [](auto& p, auto& q) { return p.y < q.y; });
    return std::max(east->x - west->x, high->y - low->y);
}

void extend_to(PictureScale& scale, const dda::GridFrame& frame) {
    for (std::size_t i = 0; i + 2 < frame.points.size(); i += 3) {
        scale.left = std::min<double>(scale.left, frame.points[i]);
        scale.right = std::max<double>(scale.right, frame.points[i]);
        scale.bottom = std::min<double>(scale.bottom, frame.points[i + 1]);
        scale.top = std::max<double>(scale.top, frame.points[i + 1]);
    }
}

}  // namespace

PictureScale common_scale(const RunFrames& run, const std::vector<std::int64_t>& frames,
                          const FrameContent& content, std::optional<double> largest) {
    // The palest quarter of the colours would not be seen as a line.
    const double pale = content.field->kind == FieldKind::contacts ? 0.25 : 0;
    PictureScale scale{{0, 0, content.field->is_signed, pale}, 1e300, -1e300, 1e300, -1e300, false};
    for (const std::int64_t index : frames) {
        const std::vector<DisplacedArea> parts = weighted_magnitudes(run, index, *content.field);
        for (const DisplacedArea& part : parts)
            scale.colours.farthest = std::max(scale.colours.farthest, part.distance);
        scale.colours.largest =
            std::max(scale.colours.largest, area_weighted_quantile(parts, coloured_fraction));
        const dda::GridFrame blocks = exaggerated_blocks(run, index, content.exaggeration);
        extend_to(scale, blocks);
        scale.relative_to_base = scale.relative_to_base || base_cell(blocks).has_value();
    }
    double& end = scale.colours.largest;
    const double factor = readable_unit(content.field->unit, end).factor;
    end = largest ? *largest : end > 0 ? round_length_above(end * factor) / factor : 1e-3;
    const double margin = 0.02 * std::max(scale.right - scale.left, scale.top - scale.bottom);
    scale.left -= margin;
    scale.right += margin;
    scale.bottom -= margin;
    scale.top += margin;
    return scale;
}

PictureScale scale_around_contact(const dda::WorstContact& contact, const RunFrames& run, std::int64_t index,
                                  PictureScale scale) {
    const dda::GridFrame frame = run.blocks(index, {"block"});
    const auto corner = cell_of(frame, contact.corner_block);
    const auto edge = cell_of(frame, contact.edge_block);
    if (!corner || !edge)
        throw InputError({run.name() + ".vtkhdf"}, "has no block of the worst contact",
                         "the frames of the run whose summary.json names it");
    const double reach = half_width_ratio * std::min(size_of(frame, *corner), size_of(frame, *edge));
    scale.left = std::max(scale.left, contact.at.x() - reach);
    scale.right = std::min(scale.right, contact.at.x() + reach);
    scale.bottom = std::max(scale.bottom, contact.at.y() - reach);
    scale.top = std::min(scale.top, contact.at.y() + reach);
    if (!(scale.left < scale.right) || !(scale.bottom < scale.top))
        throw InputError({run.name() + ".vtkhdf"}, "does not contain the position of the worst contact",
                         "the frames of the run whose summary.json names it");
    return scale;
}

dda::GridFrame exaggerated_blocks(const RunFrames& run, std::int64_t index, double factor,
                                  const std::vector<std::string>& columns) {
    if (factor == 1) return run.blocks(index, columns);
    if (!run.has_point_displacements())
        throw InputError({run.name() + ".vtkhdf"}, "has no displacements of corners, which --scale needs",
                         "the frames of this version of dda-run");
    std::vector<std::string> all = columns;
    all.insert(all.begin(), "displacement");
    dda::GridFrame frame = run.blocks(index, all, {"displacement"});
    const std::optional<std::size_t> base = base_cell(frame);
    const std::vector<float>& moved = frame.point_columns[0];
    for (std::size_t i = 0; i < frame.points.size(); ++i) {
        const double of_base = base && i % 3 < 2 ? frame.columns[0][3 * *base + i % 3] : 0.0;
        frame.points[i] += (factor - 1) * (moved[i] - of_base);
    }
    frame.columns.erase(frame.columns.begin());
    return frame;
}

}  // namespace rockslope
