#include "frame_picture.hpp"

#include <algorithm>
#include <cmath>

#include "common/drawing/axes.hpp"
#include "common/geometry/polygon.hpp"
#include "frame_labels.hpp"
#include "frame_layout.hpp"

namespace rockslope {

namespace {

constexpr double horizontal_bar_length = 260;

const Colour sliding_colour{0.84, 0.37, 0.0};
const Colour open_colour{0.0, 0.45, 0.70};
const Colour worst_colour{0.80, 0.0, 0.25};
const Colour plain_rock{0.95, 0.94, 0.92};
const Colour compression_colour{0.13, 0.40, 0.67}, tension_colour{0.70, 0.09, 0.17};
constexpr double caption_height = 18;

/// A picture in the making.
struct Drawing {
    Canvas& canvas;
    const Axes& axes;
    const RunFrames& run;
    std::int64_t index;
    const PictureScale& scale;
    const FrameContent& content;

    /// Width of a line that marks a contact or a stress, pt: thinner on a small page.
    double line_width(double usual) const {
        const double plot_width = axes.lower_right().x - axes.upper_left().x;
        return usual * std::clamp(plot_width / 400, 0.35, 1.0);
    }
};

void fill_block(const Drawing& d, const dda::GridFrame& frame, std::size_t block, const Colour& colour) {
    const Ring ring = d.axes.to_page(cell_points(frame, block));
    d.canvas.polygon(std::span(&ring, 1), colour, Stroke{black, 0.25});
}

void draw_blocks(const Drawing& d, const dda::GridFrame& frame) {
    const FrameField& field = *d.content.field;
    const bool has_values = field.kind == FieldKind::blocks || field.kind == FieldKind::material;
    const std::vector<std::optional<double>> values =
        has_values ? field_values(d.run, d.index, field) : std::vector<std::optional<double>>{};
    for (std::size_t b = 0; b < frame.cells.count(); ++b) {
        if (field.kind == FieldKind::blocks)
            fill_block(d, frame, b, d.scale.colours.colour_of(*values[b]));
        else if (field.kind == FieldKind::material)
            fill_block(d, frame, b, rock_colour(static_cast<std::size_t>(*values[b])));
        else
            fill_block(d, frame, b, plain_rock);
    }
}

/// One line of a cross: through a place of the page, along a direction of the plane.
void draw_stress(const Drawing& d, const Point& centre, double angle, double half_length, double stress) {
    const double dx = half_length * std::cos(angle), dy = -half_length * std::sin(angle);
    d.canvas.polyline(std::vector<Point>{{centre.x - dx, centre.y - dy}, {centre.x + dx, centre.y + dy}},
                      {stress < 0 ? compression_colour : tension_colour, d.line_width(0.9)});
}

/// Principal stresses at the centres of the blocks: lines as long as the stress, at most as the block's size.
void draw_crosses(const Drawing& d, const dda::GridFrame& frame) {
    const dda::GridFrame stresses = d.run.blocks(d.index, {"stress"});
    for (std::size_t b = 0; b < frame.cells.count(); ++b) {
        if (stresses.columns.back()[b] != motion_free) continue;
        const float* s = &stresses.columns[0][3 * b];
        const double mean = (s[0] + s[1]) / 2.0;
        const double radius = std::hypot((s[0] - s[1]) / 2.0, s[2]);
        const double angle = 0.5 * std::atan2(2.0 * s[2], double{s[0]} - s[1]);
        const double size = d.axes.scale() * std::sqrt(std::abs(cell_area(frame, b)));
        const auto half_length = [&](double stress) {
            return 0.45 * size * std::min(1.0, std::abs(stress) / d.scale.colours.largest);
        };
        const Point place = d.axes.to_page(centroid(cell_points(frame, b)));
        draw_stress(d, place, angle, half_length(mean + radius), mean + radius);
        draw_stress(d, place, angle + M_PI / 2, half_length(mean - radius), mean - radius);
    }
}

/// A contact as a line, or as a dot where it is a point.
void draw_contact(const Drawing& d, const dda::GridFrame& contacts, std::size_t cell, const Stroke& stroke) {
    std::vector<Point> points = cell_points(contacts, cell);
    for (Point& point : points) point = d.axes.to_page(point);
    if (points.size() == 1)
        d.canvas.circle(points.front(), d.line_width(1.2), stroke.colour, std::nullopt);
    else
        d.canvas.polyline(points, stroke);
}

void draw_states(const Drawing& d) {
    const dda::GridFrame contacts = d.run.contacts(d.index, {"state"});
    for (std::size_t c = 0; c < contacts.cells.count(); ++c) {
        const float state = contacts.columns[0][c];
        if (state == state_open || state == state_sliding)
            draw_contact(d, contacts, c,
                         {state == state_sliding ? sliding_colour : open_colour, d.line_width(1.1)});
    }
}

void draw_contact_values(const Drawing& d) {
    const dda::GridFrame contacts = d.run.contacts(d.index, {});
    const std::vector<std::optional<double>> values = field_values(d.run, d.index, *d.content.field);
    for (std::size_t c = 0; c < contacts.cells.count(); ++c)
        if (values[c])
            draw_contact(d, contacts, c, {d.scale.colours.colour_of(*values[c]), d.line_width(2.2)});
}

/// Whether the picture marks sliding contacts and open joints. They are not where exaggerated blocks are, and
/// would be taken for lines of a cross.
bool shows_states(const FrameContent& content) {
    const FieldKind kind = content.field->kind;
    return kind != FieldKind::contacts && kind != FieldKind::crosses && content.exaggeration == 1;
}

void draw_line_key(Canvas& canvas, const Point& place, const Colour& colour, const std::string& text) {
    canvas.polyline(std::vector<Point>{{place.x, place.y - 3}, {place.x + 20, place.y - 3}}, {colour, 1.6});
    canvas.text({place.x + 24, place.y}, text, {8.5});
}

/// The keys of the line colours, right-aligned. @return the width they take, pt.
double draw_keys(Canvas& canvas, const FrameLayout& layout, const FrameContent& content, double y) {
    std::vector<std::pair<std::string, Colour>> keys;
    if (content.field->kind == FieldKind::crosses)
        keys = {{"compression", compression_colour}, {"tension", tension_colour}};
    else if (shows_states(content))
        keys = {{"sliding contact", sliding_colour}, {"open joint", open_colour}};
    double x = layout.header_right;
    std::reverse(keys.begin(), keys.end());  // the rightmost first
    for (const auto& [text, colour] : keys) {
        x -= canvas.text_width(text, {8.5}) + 24;
        draw_line_key(canvas, {x, y}, colour, text);
        x -= 10;
    }
    return layout.header_right - x;
}

/// The stage and its time, or the mechanism: the time of a strength reduction counts the steps of its trials.
std::string title_of(const Drawing& d) {
    const bool is_last = d.index + 1 == static_cast<std::int64_t>(d.run.times().size());
    std::string title = d.run.title(d.index);
    if (is_last && !d.content.mechanism.empty()) title = d.run.stage(d.index) + ": " + d.content.mechanism;
    if (d.content.exaggeration != 1) title += ", displacements × " + tick_text(d.content.exaggeration, 1);
    return title;
}

/// The title, and the keys beside it, or below it on a narrow page. A long title begins at the edge of the
/// page, with smaller letters.
void draw_header(const Drawing& d, const FrameLayout& layout) {
    constexpr double edge = 8, smallest = 7.5;
    const std::string title = title_of(d);
    TextStyle style{11, black, Anchor::start, Anchor::start, true};
    const double keys = draw_keys(d.canvas, layout, d.content, layout.top - 8);
    const double room = layout.header_right - layout.header_left;
    const double wide = d.canvas.text_width(title, style);
    if (wide + keys < room) {
        d.canvas.text({layout.header_left, layout.top - 8}, title, style);
        return;
    }
    const double page = layout.page_width - 2 * edge;
    style.size = std::max(smallest, style.size * std::min(1.0, page / wide));
    d.canvas.text({wide < room ? layout.header_left : edge, layout.top - 21},
                  shortened(d.canvas, title, style, page), style);
}

std::string bar_title(const Drawing& d) {
    const bool is_relative = d.content.field->component < 0 && d.scale.relative_to_base;
    return d.content.field->title + std::string(is_relative ? " from the base" : "");
}

void draw_materials(const Drawing& d, const FrameLayout& layout) {
    const std::vector<std::string> names = d.run.block_materials();
    double x = layout.header_left;
    const double y = layout.page_height - 10;
    for (std::size_t k = 0; k < names.size(); ++k) {
        const Ring box = {{x, y - 8}, {x + 12, y - 8}, {x + 12, y}, {x, y}};
        d.canvas.polygon(std::span(&box, 1), rock_colour(k), Stroke{black, 0.4});
        const double room = (layout.header_right - x) / static_cast<double>(names.size() - k) - 30;
        const std::string name = shortened(d.canvas, names[k], {8.5}, room);
        d.canvas.text({x + 16, y - 0.5}, name, {8.5});
        x += 30 + d.canvas.text_width(name, {8.5});
    }
}

void draw_bar(const Drawing& d, const FrameLayout& layout) {
    if (d.content.field->kind == FieldKind::material) return draw_materials(d, layout);
    const ColourBar bar{bar_title(d), d.content.field->unit, d.scale.colours};
    if (d.content.field->kind == FieldKind::crosses) {
        const ReadableUnit unit = readable_unit(bar.unit, bar.range.largest);
        const double longest = bar.range.largest * unit.factor;
        const std::string text =
            "a line across a block: " + tick_text(longest, longest) + " " + unit.name + " or more";
        const std::string long_text = "principal stresses; " + text;
        const bool fits = d.canvas.text_width(long_text, {8.5}) < layout.header_right - layout.header_left;
        d.canvas.text({layout.header_left, layout.page_height - 10}, fits ? long_text : text, {8.5});
        return;
    }
    if (layout.bar_is_vertical)
        draw_vertical_bar(d.canvas, bar, {layout.lower_right.x + FrameLayout::bar_gap, layout.lower_right.y},
                          layout.lower_right.y - layout.upper_left.y);
    else
        draw_horizontal_bar(
            d.canvas, bar, {layout.header_left, layout.lower_right.y + layout.below_axes},
            std::min(horizontal_bar_length, 0.75 * (layout.header_right - layout.header_left)));
}

void draw_worst_contact(const Drawing& d, const dda::GridFrame& frame, const dda::WorstContact& worst) {
    for (std::size_t b = 0; b < frame.cells.count(); ++b) {
        const long block = std::lround(frame.columns[0][b]);
        if (block != worst.corner_block && block != worst.edge_block) continue;
        const Ring ring = d.axes.to_page(cell_points(frame, b));
        d.canvas.polygon(std::span(&ring, 1), std::nullopt, Stroke{worst_colour, 1.4});
    }
    d.canvas.circle(d.axes.to_page({worst.at.x(), worst.at.y()}), 7, std::nullopt, Stroke{worst_colour, 2.2});
}

void draw_worst_caption(Canvas& canvas, const FrameLayout& layout, const dda::WorstContact& worst) {
    const double y = layout.page_height - 8;
    canvas.circle({layout.header_left + 6, y - 3}, 4.5, std::nullopt, Stroke{worst_colour, 1.8});
    canvas.text({layout.header_left + 16, y},
                "worst contact: block " + std::to_string(worst.corner_block) + " on block " +
                    std::to_string(worst.edge_block) + ", " + worst.joint_material,
                {8.5});
}

/// A key of crosses or materials stands below the axes, without a colour bar.
FrameLayout layout_for(const PictureScale& scale, const FrameContent& content, const PageStyle& style) {
    FrameLayout layout(scale.right - scale.left, scale.top - scale.bottom, style);
    if (content.field->kind != FieldKind::crosses && content.field->kind != FieldKind::material)
        return layout;
    layout.page_height = layout.lower_right.y + layout.below_axes + 16;
    return layout;
}

}  // namespace

Canvas draw_frame(const RunFrames& run, std::int64_t index, const PictureScale& scale,
                  const FrameContent& content, const PageStyle& style,
                  const std::optional<dda::WorstContact>& worst) {
    FrameLayout layout = layout_for(scale, content, style);
    if (worst) layout.page_height += caption_height;
    Canvas canvas(layout.page_width, layout.page_height, style);
    const Axes axes(layout.upper_left, layout.lower_right, {scale.left, scale.right},
                    {scale.bottom, scale.top});
    const Drawing drawing{canvas, axes, run, index, scale, content};
    const dda::GridFrame blocks = exaggerated_blocks(run, index, content.exaggeration, {"block"});
    canvas.clip(axes.upper_left(), axes.lower_right());
    draw_blocks(drawing, blocks);
    if (content.field->kind == FieldKind::crosses) draw_crosses(drawing, blocks);
    if (content.field->kind == FieldKind::contacts) draw_contact_values(drawing);
    if (shows_states(content)) draw_states(drawing);
    if (worst) draw_worst_contact(drawing, blocks, *worst);
    canvas.unclip();
    Labels labels(axes.upper_left(), axes.lower_right());
    if (content.labels_joints)
        label_joints(canvas, axes, run.contacts(index, {"joint"}), run.joints(), labels);
    if (content.labels_blocks) label_blocks(canvas, axes, blocks, labels);
    if (worst) draw_worst_caption(canvas, layout, *worst);
    axes.draw(canvas, "x (m)", "y (m)");
    draw_bar(drawing, layout);
    draw_header(drawing, layout);
    return canvas;
}

}  // namespace rockslope
