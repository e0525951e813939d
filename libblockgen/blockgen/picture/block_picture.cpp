#include "blockgen/picture/block_picture.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "blockgen/mesh/measures.hpp"
#include "blockgen/picture/water_line.hpp"
#include "common/drawing/axes.hpp"
#include "common/drawing/fitted_text.hpp"

namespace rockslope::blockgen {

namespace {

constexpr double usual_width = 760, left = 62, right = 16, top = 24, bottom = 74;
/// Width of the legends beside the section, and the narrowest page that has them there and not below it.
constexpr double legend_width = 169, least_page_beside = 480;
/// Heights of the section on the page.
constexpr double least_height = 230, largest_height = 900;

struct BlockExtent {
    Range x, y;
};

BlockExtent extent_of(const BlockMesh& mesh) {
    BlockExtent e{{mesh.vertices[0].x, mesh.vertices[0].x}, {mesh.vertices[0].y, mesh.vertices[0].y}};
    for (const Point& p : mesh.vertices) {
        e.x = {std::min(e.x.low, p.x), std::max(e.x.high, p.x)};
        e.y = {std::min(e.y.low, p.y), std::max(e.y.high, p.y)};
    }
    const double margin = 0.02 * std::max(e.x.high - e.x.low, e.y.high - e.y.low);
    const double label =
        mesh.measured_points.empty() ? 0 : 1.5 * margin;  // room for a name above the highest point
    return {{e.x.low - margin, e.x.high + margin}, {e.y.low - margin, e.y.high + margin + label}};
}

/// A shade for each block, by greedy colouring: different from the shades of its neighbours if possible.
PerBlock<std::size_t> shades_of(const BlockMesh& mesh) {
    std::vector<std::pair<std::pair<VertexIndex, VertexIndex>, BlockIndex>> edges;
    for (const BlockIndex b : mesh.blocks())
        for (std::size_t r = 0; r < mesh.ring_count(b); ++r) {
            const auto ring = mesh.ring(b, r);
            for (std::size_t k = 0; k < ring.size(); ++k)
                edges.push_back({std::minmax({ring[k], ring[(k + 1) % ring.size()]}), b});
        }
    std::sort(edges.begin(), edges.end());
    PerBlock<std::vector<BlockIndex>> neighbours(mesh.block_count());
    for (std::size_t i = 1; i < edges.size(); ++i)
        if (edges[i].first == edges[i - 1].first) {
            neighbours[edges[i].second].push_back(edges[i - 1].second);
            neighbours[edges[i - 1].second].push_back(edges[i].second);
        }
    PerBlock<std::size_t> shade(mesh.block_count(), shade_count);
    for (const BlockIndex b : shade.indices()) {
        bool taken[shade_count + 1] = {};
        for (const BlockIndex n : neighbours[b]) taken[shade[n]] = true;
        std::size_t s = b.value() % 2;
        for (std::size_t k = 0; k < shade_count && taken[s]; ++k) s = (s + 1) % shade_count;
        shade[b] = s;
    }
    return shade;
}

class BlockPicture {
  public:
    BlockPicture(const BlockMesh& mesh, const BlockLayer& layer, const PageStyle& style)
        : mesh_(mesh),
          layer_(layer),
          is_excavated_(mesh.block_count()),
          canvas_(1, 1, style),
          axes_({}, {}, {}, {}) {
        for (const Joint& joint : mesh.joints)
            if (std::find(sets_.begin(), sets_.end(), joint.set) == sets_.end()) sets_.push_back(joint.set);
        for (const ExcavatedBlocks& excavation : mesh.excavations)
            for (const BlockIndex b : excavation.blocks) is_excavated_[b] = true;
        lay_out(style);
    }

    Canvas draw() {
        fill_blocks();
        draw_edges();
        if (!mesh_.water_table.empty()) draw_water_line(canvas_, axes_, mesh_.water_table);
        for (const Bolt& bolt : mesh_.bolts) draw_bolt(bolt);
        Labels labels(axes_.upper_left(), axes_.lower_right());
        for (const MeasuredPoint& point : mesh_.measured_points) draw_point(point, labels);
        axes_.draw(canvas_, "x (m)", "y (m)");
        draw_scale_bar(canvas_, {axes_.upper_left().x, axes_.lower_right().y + 42}, axes_.scale(), 130);
        draw_legends(legends_at_);
        return std::move(canvas_);
    }

  private:
    /// The legends are beside the section, or below it on a narrow page: they are drawn once to learn their
    /// height.
    void lay_out(const PageStyle& style) {
        const double width = style.width_in_units(usual_width);
        const bool is_beside = width >= least_page_beside;
        const double plot_width = width - left - right - (is_beside ? legend_width : 0);
        const BlockExtent extent = extent_of(mesh_);
        const double scale = plot_width / (extent.x.high - extent.x.low);
        const double least = is_beside ? least_height : 0;
        const double plot_height = std::clamp(scale * (extent.y.high - extent.y.low), least, largest_height);
        axes_ = Axes::of_equal_scale({left, top}, {left + plot_width, top + plot_height}, extent.x, extent.y);
        double height = top + plot_height + bottom;
        legend_room_ = is_beside ? legend_width - 18 : width - left - right;
        legends_at_ =
            is_beside ? Point{axes_.lower_right().x + 18, axes_.upper_left().y} : Point{left, height};
        const double end = draw_legends(legends_at_);
        if (!is_beside) height = end + 10;
        canvas_ = Canvas(width, height, style);
    }

    std::vector<Ring> page_rings(BlockIndex b) const {
        std::vector<Ring> rings;
        for (std::size_t r = 0; r < mesh_.ring_count(b); ++r)
            rings.push_back(axes_.to_page(ring_points(mesh_, b, r)));
        return rings;
    }

    void fill_blocks() {
        const PerBlock<std::size_t> shades = shades_of(mesh_);
        for (const BlockIndex b : mesh_.blocks()) {
            const std::int32_t entry = layer_.entries.empty() ? -1 : layer_.entry_of_block[b];
            const Colour rock = rock_colour(mesh_.block_material[b]);
            const Colour fill = entry < 0 ? shaded(rock, shades[b]) : layer_.entries[entry].colour;
            const std::vector<Ring> rings = page_rings(b);
            canvas_.polygon(rings, fill, Stroke{fill, 0.3});
            if (is_excavated_[b]) canvas_.hatch(rings, excavated_hatch, 5, 0);
            if (mesh_.motion[b] == BlockMotion::fixed)
                canvas_.hatch(rings, fixed_hatch, 7, std::numbers::pi / 4);
            if (mesh_.motion[b] == BlockMotion::prescribed)
                canvas_.hatch(rings, prescribed_hatch, 7, -std::numbers::pi / 4);
        }
    }

    /// Line width, narrower when the blocks are small on the page.
    double line_width() const {
        const double block_size = std::sqrt(area_summary(block_areas(mesh_)).d10) * axes_.scale();
        return std::clamp(block_size / 16, 0.25, 1.2);
    }

    void draw_edges() {
        const double width = line_width();
        for (const bool free_faces : {false, true})
            for (const BlockIndex b : mesh_.blocks())
                for (std::size_t r = 0; r < mesh_.ring_count(b); ++r) {
                    const Ring ring = axes_.to_page(ring_points(mesh_, b, r));
                    const auto marks = mesh_.ring_marks(b, r);
                    for (std::size_t k = 0; k < ring.size(); ++k) {
                        const bool is_free = marks[k] == EdgeMark{};
                        if (is_free != free_faces) continue;
                        const Stroke stroke = is_free ? Stroke{black, std::max(0.9, width)}
                                                      : Stroke{colour_of(marks[k]), width};
                        canvas_.polyline(std::vector<Point>{ring[k], ring[(k + 1) % ring.size()]}, stroke);
                    }
                }
    }

    Colour colour_of(const EdgeMark& mark) const {
        if (mark.joint == EdgeMark::no_joint) return contact_colour;
        const std::string& set = mesh_.joints[mark.joint].set;
        return line_colour(std::find(sets_.begin(), sets_.end(), set) - sets_.begin());
    }

    void draw_bolt(const Bolt& bolt) {
        const Point from = axes_.to_page(bolt.first), to = axes_.to_page(bolt.second);
        canvas_.polyline(std::vector<Point>{from, to}, {white, 3.2});
        canvas_.polyline(std::vector<Point>{from, to}, bolt_stroke);
        canvas_.circle(from, 2.4, bolt_stroke.colour, Stroke{white, 0.6});
    }

    void draw_point(const MeasuredPoint& point, Labels& labels) {
        const Point place = axes_.to_page(point.position);
        canvas_.circle(place, 3.2, point_colour, Stroke{white, 0.9});
        TextStyle style{9, black, Anchor::start, Anchor::start, true};
        style.halo = white;
        const double left_of = place.x - 4, right_of = place.x + 4, above = place.y - 8, below = place.y + 15;
        labels.put(canvas_,
                   {{{right_of, above}, Anchor::start},
                    {{left_of, above}, Anchor::end},
                    {{right_of, below}, Anchor::start},
                    {{left_of, below}, Anchor::end},
                    {{right_of + 3, place.y + 3}, Anchor::start},
                    {{left_of - 3, place.y + 3}, Anchor::end}},
                   point.name, style);
    }

    /// @return the y at the end of the legends.
    double draw_legends(const Point& start) {
        const double x = start.x;
        double y = start.y;
        std::vector<LegendEntry> rocks, lines, others;
        for (const BlockMaterialIndex m : mesh_.block_materials.indices())
            rocks.push_back({mesh_.block_materials[m], rock_colour(m), Stroke{grey, 0.6}});
        for (std::size_t s = 0; s < sets_.size(); ++s)
            lines.push_back({sets_[s], {}, Stroke{line_colour(s), 1.6}, true});
        const auto is_contact = [](const EdgeMark& m) {
            return m.joint == EdgeMark::no_joint && m.joint_material != EdgeMark::no_joint;
        };
        if (std::any_of(mesh_.edge_marks.begin(), mesh_.edge_marks.end(), is_contact))
            lines.push_back({mesh_.excavations.empty() ? "contact of materials" : "contact or cut",
                             {},
                             Stroke{contact_colour, 1.6},
                             true});
        const auto has = [&](BlockMotion m) {
            return std::find(mesh_.motion.begin(), mesh_.motion.end(), m) != mesh_.motion.end();
        };
        y = draw_legend(canvas_, {x, y}, mesh_.block_materials.size() == 1 ? "Rock" : "Rocks", rocks,
                        legend_room_);
        std::vector<LegendEntry> colours;
        for (const BlockLayer::Entry& entry : layer_.entries)
            colours.push_back({entry.text, entry.colour, Stroke{grey, 0.6}});
        if (!colours.empty()) y = draw_legend(canvas_, {x, y}, layer_.title, colours, legend_room_);
        if (!lines.empty()) y = draw_legend(canvas_, {x, y}, "Joints", lines, legend_room_);
        if (has(BlockMotion::fixed)) y = draw_hatched(x, y, "fixed block", fixed_hatch, std::numbers::pi / 4);
        if (has(BlockMotion::prescribed))
            y = draw_hatched(x, y, "prescribed block", prescribed_hatch, -std::numbers::pi / 4);
        if (!mesh_.excavations.empty())
            y = draw_hatched(x, y, "excavated in a stage", excavated_hatch, 0, rock_colour(0));
        if (!mesh_.measured_points.empty()) {
            canvas_.circle({x + 8, y + 5}, 3.2, point_colour, Stroke{white, 0.9});
            canvas_.text({x + 22, y + 5}, "measured point", {9, black, Anchor::start, Anchor::middle});
            y += 15;
        }
        if (!mesh_.bolts.empty()) {
            canvas_.polyline(std::vector<Point>{{x, y + 5}, {x + 16, y + 5}}, bolt_stroke);
            canvas_.text({x + 22, y + 5}, "bolt", {9, black, Anchor::start, Anchor::middle});
            y += 15;
        }
        if (!mesh_.water_table.empty()) y = draw_water_legend(canvas_, {x, y});
        const std::string count =
            std::to_string(mesh_.block_count()) + (mesh_.block_count() == 1 ? " block" : " blocks");
        canvas_.text({x, y + 8}, count, {9, grey, Anchor::start, Anchor::end});
        return y + 18;
    }

    double draw_hatched(double x, double y, const std::string& text, const Stroke& hatch, double angle,
                        const Colour& ground = white) {
        const std::vector<Ring> box = {{{x, y}, {x + 16, y}, {x + 16, y + 9}, {x, y + 9}}};
        canvas_.polygon(box, ground, Stroke{grey, 0.6});
        canvas_.hatch(box, hatch, 3.5, angle);
        canvas_.text({x + 22, y + 4.5}, text, {9, black, Anchor::start, Anchor::middle});
        return y + 15;
    }

    inline static const Stroke fixed_hatch{{0.25, 0.25, 0.28, 0.6}, 0.6};
    inline static const Stroke prescribed_hatch{{0.70, 0.10, 0.16, 0.6}, 0.7};
    inline static const Stroke excavated_hatch{{1.0, 1.0, 1.0, 0.8}, 1.4};
    inline static const Stroke bolt_stroke{{0.12, 0.12, 0.40}, 1.5};
    inline static const Colour point_colour{0.80, 0.12, 0.15};
    inline static const Colour contact_colour{0.45, 0.36, 0.26};

    const BlockMesh& mesh_;
    const BlockLayer& layer_;
    std::vector<bool> is_excavated_;  ///< per block
    Canvas canvas_;
    Axes axes_;
    std::vector<std::string> sets_;
    Point legends_at_{};
    double legend_room_ = 0;
};

}  // namespace

Canvas draw_blocks(const BlockMesh& mesh, const BlockLayer& layer, const PageStyle& style) {
    if (mesh.vertices.empty()) return {style.width_in_units(usual_width), 200, style};
    return BlockPicture(mesh, layer, style).draw();
}

}  // namespace rockslope::blockgen
