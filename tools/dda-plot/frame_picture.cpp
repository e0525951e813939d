#include "frame_picture.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "colour_bar.hpp"
#include "colour_scale.hpp"
#include "common/base/input_error.hpp"
#include "common/drawing/axes.hpp"
#include "frame_layout.hpp"

namespace rockslope {

namespace {

constexpr double horizontal_bar_length = 260;

// Columns of the frames that the picture reads, and values in them.
const std::vector<std::string> block_columns = {"displacement", "motion", "block"};
const std::vector<std::string> contact_columns = {"state"};
constexpr float unconstrained = 0, prescribed = 2, state_open = 0, state_sliding = 1;

const Colour sliding_colour{0.84, 0.37, 0.0};
const Colour open_colour{0.0, 0.45, 0.70};
const Colour worst_colour{0.80, 0.0, 0.25};
constexpr double caption_height = 18;
/// Half-width of the view around a contact over the size of the smaller of its blocks.
constexpr double half_width_ratio = 2;

struct Vector {
    double x = 0, y = 0;
};

Vector displacement_of(const dda::GridFrame& frame, std::size_t block) {
    return {frame.columns[0][3 * block], frame.columns[0][3 * block + 1]};
}

/// Displacement of the base, the first prescribed block; zero when there is none.
Vector base_displacement(const dda::GridFrame& frame) {
    const auto& motion = frame.columns[1];
    const auto base = std::find(motion.begin(), motion.end(), prescribed);
    return base == motion.end() ? Vector{} : displacement_of(frame, base - motion.begin());
}

std::vector<double> magnitudes(const dda::GridFrame& frame) {
    const Vector base = base_displacement(frame);
    std::vector<double> result;
    for (std::size_t block = 0; block < frame.cells.count(); ++block) {
        const Vector u = displacement_of(frame, block);
        result.push_back(std::hypot(u.x - base.x, u.y - base.y));
    }
    return result;
}

bool has_base(const dda::GridFrame& frame) {
    return std::find(frame.columns[1].begin(), frame.columns[1].end(), prescribed) != frame.columns[1].end();
}

double area_of(const std::vector<Point>& ring) {
    const Point& origin = ring.front();
    double twice = 0;
    for (std::size_t i = 1; i + 1 < ring.size(); ++i)
        twice += (ring[i].x - origin.x) * (ring[i + 1].y - origin.y) -
                 (ring[i + 1].x - origin.x) * (ring[i].y - origin.y);
    return twice / 2;
}

std::vector<DisplacedArea> free_blocks(const dda::GridFrame& frame) {
    const std::vector<double> moved = magnitudes(frame);
    std::vector<DisplacedArea> blocks;
    for (std::size_t block = 0; block < frame.cells.count(); ++block)
        if (frame.columns[1][block] == unconstrained)
            blocks.push_back({area_of(cell_points(frame, block)), moved[block]});
    return blocks;
}

void draw_blocks(Canvas& canvas, const Axes& axes, const dda::GridFrame& frame, double largest) {
    const std::vector<double> moved = magnitudes(frame);
    for (std::size_t block = 0; block < frame.cells.count(); ++block) {
        const Ring ring = axes.to_page(cell_points(frame, block));
        canvas.polygon(std::span(&ring, 1), scale_colour(moved[block] / largest), Stroke{black, 0.25});
    }
}

void draw_contacts(Canvas& canvas, const Axes& axes, const dda::GridFrame& frame) {
    for (std::size_t cell = 0; cell < frame.cells.count(); ++cell) {
        const float state = frame.columns[0][cell];
        if (state != state_open && state != state_sliding) continue;
        const Colour colour = state == state_sliding ? sliding_colour : open_colour;
        std::vector<Point> points = cell_points(frame, cell);
        for (Point& point : points) point = axes.to_page(point);
        if (points.size() == 1)
            canvas.circle(points.front(), 1.2, colour, std::nullopt);
        else
            canvas.polyline(points, {colour, 1.1});
    }
}

void draw_contact_key(Canvas& canvas, double right) {
    const double y = FrameLayout::top - 12;
    canvas.polyline(std::vector<Point>{{right - 170, y - 3}, {right - 150, y - 3}}, {sliding_colour, 1.6});
    canvas.text({right - 146, y}, "sliding contact", {8.5});
    canvas.polyline(std::vector<Point>{{right - 74, y - 3}, {right - 54, y - 3}}, {open_colour, 1.6});
    canvas.text({right - 50, y}, "open joint", {8.5});
}

/// The cell of a block, by its number; none when the block has been removed.
std::optional<std::size_t> cell_of(const dda::GridFrame& frame, int block) {
    const auto& numbers = frame.columns[2];
    const auto found = std::find(numbers.begin(), numbers.end(), static_cast<float>(block));
    if (found == numbers.end()) return std::nullopt;
    return found - numbers.begin();
}

void draw_worst_contact(Canvas& canvas, const Axes& axes, const dda::GridFrame& frame,
                        const dda::WorstContact& worst) {
    for (const int block : {worst.corner_block, worst.edge_block}) {
        const std::optional<std::size_t> cell = cell_of(frame, block);
        if (!cell) continue;
        const Ring ring = axes.to_page(cell_points(frame, *cell));
        canvas.polygon(std::span(&ring, 1), std::nullopt, Stroke{worst_colour, 1.4});
    }
    canvas.circle(axes.to_page({worst.at.x(), worst.at.y()}), 7, std::nullopt, Stroke{worst_colour, 2.2});
}

void draw_worst_caption(Canvas& canvas, const FrameLayout& layout, const dda::WorstContact& worst) {
    const double y = layout.page_height - 8;
    canvas.circle({layout.header_left + 6, y - 3}, 4.5, std::nullopt, Stroke{worst_colour, 1.8});
    canvas.text({layout.header_left + 16, y},
                "worst contact: block " + std::to_string(worst.corner_block) + " on block " +
                    std::to_string(worst.edge_block) + ", " + worst.joint_material,
                {8.5});
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

}  // namespace

RunFrames::RunFrames(const std::filesystem::path& folder) {
    const std::string of_contacts = ".joints.vtkhdf", extension = ".vtkhdf";
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
        const std::string file = entry.path().filename().string();
        if (file.ends_with(extension) && !file.ends_with(of_contacts))
            name_ = file.substr(0, file.size() - extension.size());
    }
    if (name_.empty())
        throw InputError({folder.string()}, "contains no NAME.vtkhdf", "the output folder of dda-run");
    blocks_.emplace(folder / (name_ + extension));
    times_ = blocks_->times();
    if (!std::filesystem::exists(folder / (name_ + of_contacts))) return;
    contacts_.emplace(folder / (name_ + of_contacts));
    times_.resize(std::min(times_.size(), contacts_->times().size()));
}

dda::GridFrame RunFrames::blocks(std::int64_t index) const {
    dda::GridFrame frame = blocks_->frame(index, block_columns);
    const std::size_t count = frame.cells.count();
    if (frame.columns[0].size() != 3 * count || frame.columns[1].size() != count)
        throw InputError({name_ + ".vtkhdf"}, "is damaged", "the frames of dda-run");
    return frame;
}
dda::GridFrame RunFrames::contacts(std::int64_t index) const {
    return contacts(index, contact_columns);
}
dda::GridFrame RunFrames::contacts(std::int64_t index, const std::vector<std::string>& columns) const {
    if (contacts_) return contacts_->frame(index, columns);
    dda::GridFrame none;
    none.columns.resize(columns.size());
    return none;
}

PictureScale common_scale(const RunFrames& run, const std::vector<std::int64_t>& frames,
                          std::optional<double> largest) {
    PictureScale scale{0, 0, 1e300, -1e300, 1e300, -1e300, false};
    for (const std::int64_t index : frames) {
        const dda::GridFrame frame = run.blocks(index);
        const std::vector<DisplacedArea> moved = free_blocks(frame);
        for (const DisplacedArea& block : moved) scale.farthest = std::max(scale.farthest, block.distance);
        scale.largest = std::max(scale.largest, area_weighted_quantile(moved, coloured_fraction));
        for (std::size_t i = 0; i + 2 < frame.points.size(); i += 3) {
            scale.left = std::min<double>(scale.left, frame.points[i]);
            scale.right = std::max<double>(scale.right, frame.points[i]);
            scale.bottom = std::min<double>(scale.bottom, frame.points[i + 1]);
            scale.top = std::max<double>(scale.top, frame.points[i + 1]);
        }
        scale.relative_to_base = scale.relative_to_base || has_base(frame);
    }
    scale.largest = largest ? *largest : scale.largest > 0 ? round_length_above(scale.largest) : 1e-3;
    const double margin = 0.02 * std::max(scale.right - scale.left, scale.top - scale.bottom);
    scale.left -= margin;
    scale.right += margin;
    scale.bottom -= margin;
    scale.top += margin;
    return scale;
}

PictureScale scale_around_contact(const dda::WorstContact& contact, const RunFrames& run, std::int64_t index,
                                  PictureScale scale) {
    const dda::GridFrame frame = run.blocks(index);
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

Canvas draw_frame(const RunFrames& run, std::int64_t index, const PictureScale& scale,
                  const std::optional<dda::WorstContact>& worst) {
    FrameLayout layout(scale.right - scale.left, scale.top - scale.bottom);
    if (worst) layout.page_height += caption_height;
    Canvas canvas(layout.page_width, layout.page_height);
    const Axes axes(layout.upper_left, layout.lower_right, {scale.left, scale.right},
                    {scale.bottom, scale.top});
    canvas.clip(axes.upper_left(), axes.lower_right());
    const dda::GridFrame blocks = run.blocks(index);
    draw_blocks(canvas, axes, blocks, scale.largest);
    draw_contacts(canvas, axes, run.contacts(index));
    if (worst) draw_worst_contact(canvas, axes, blocks, *worst);
    canvas.unclip();
    if (worst) draw_worst_caption(canvas, layout, *worst);
    axes.draw(canvas, "x (m)", "y (m)");
    const ColourBar bar{scale.relative_to_base ? "displacement from the base" : "displacement", scale.largest,
                        scale.farthest};
    if (layout.bar_is_vertical)
        draw_vertical_bar(canvas, bar, {layout.lower_right.x + FrameLayout::bar_gap, layout.lower_right.y},
                          layout.lower_right.y - layout.upper_left.y);
    else
        draw_horizontal_bar(canvas, bar, {layout.header_left, layout.lower_right.y + FrameLayout::below_axes},
                            horizontal_bar_length);
    draw_contact_key(canvas, layout.header_right);
    char title[64];
    std::snprintf(title, sizeof title, "t = %.3f s", run.times()[index]);
    canvas.text({layout.header_left, FrameLayout::top - 12}, title,
                {11, black, Anchor::start, Anchor::start, true});
    return canvas;
}

}  // namespace rockslope
