#include <algorithm>

#include "blockgen/input/read_shapes.hpp"
#include "common/geometry/clip_line.hpp"
#include "common/geometry/point_text.hpp"

namespace rockslope::blockgen {

namespace {

/// The number of the highest vertex, or the lowest, on the left or right side of a ring's bounding box.
std::size_t vertex_on_side(const Ring& ring, double x, bool highest) {
    std::size_t found = ring.size();
    for (std::size_t k = 0; k < ring.size(); ++k) {
        if (ring[k].x != x) continue;
        if (found == ring.size() || (highest ? ring[k].y > ring[found].y : ring[k].y < ring[found].y))
            found = k;
    }
    return found;
}

double not_negative_length(const ConfigTable& table, const char* key) {
    return table.checked(
        key, table.number(key, Dimension::length, 0.0), [](double d) { return d >= 0; },
        "a length of zero or more");
}

/// The piece of a counter-clockwise ring from one vertex to another.
std::vector<Point> chain_of(const Ring& ring, std::size_t from, std::size_t to) {
    std::vector<Point> chain;
    for (std::size_t k = from;; k = (k + 1) % ring.size()) {
        chain.push_back(ring[k]);
        if (k == to) return chain;
    }
}

/// The ring round the chain along which the base touches the slope.
Ring ring_around(const std::vector<Point>& chain, double left, double right, double bottom) {
    Ring ring(chain.rbegin(), chain.rend());
    for (const Point& p : {Point{left, chain.front().y}, Point{left, bottom}, Point{right, bottom},
                           Point{right, chain.back().y}})
        if (p != ring.back() && p != ring.front()) ring.push_back(p);
    return ring;
}

/// The outline of all parts of the domain together, which must share edges; counter-clockwise.
Ring joint_outline(const ConfigTable& table, const EnclosedAreaFunction& enclosed_area,
                   const SlopeModel& model) {
    if (model.further_outlines.empty()) return model.outline;
    std::vector<std::pair<Point, Point>> edges;
    const auto add = [&edges](const Ring& ring) {
        for (std::size_t k = 0; k < ring.size(); ++k)
            edges.emplace_back(ring[k], ring[(k + 1) % ring.size()]);
    };
    add(model.outline);
    for (const Ring& part : model.further_outlines) add(part);
    const std::vector<Ring> outlines = enclosed_area(edges, {}, model.grid).outlines;
    if (outlines.size() > 1)
        table.fail("below",
                   "a part of the domain shares no edge with the others, at " + text_of(outlines[1][0]),
                   "[base] for parts that share edges, so that one line runs below all");
    if (const auto fault = find_ring_fault(std::vector<Ring>{outlines[0]}))
        table.fail("below", "parts of the domain meet only in the point " + text_of(fault->place),
                   "[base] for parts that share edges");
    return outlines[0];
}

}  // namespace

void read_base(const ConfigTable& root, const EnclosedAreaFunction& enclosed_area, SlopeModel& model) {
    const auto table = root.optional_table("base");
    if (!table) return;
    const Ring outline = joint_outline(*table, enclosed_area, model);
    BaseBlock base;
    base.place = table->place();
    base.name = table->string("name", "base");
    base.block_material = read_name(*table, "material");
    base.joint_material = table->string("joint_material", "base");
    base.is_fixed = table->choice("motion", {"prescribed", "fixed"}, "prescribed") == "fixed";
    const double below = table->checked(
        "below", table->number("below", Dimension::length), [](double d) { return d > 0; },
        "a positive length");
    const double behind = not_negative_length(*table, "behind"), ahead = not_negative_length(*table, "ahead");

    const Bounds box = Bounds::of(outline);
    const auto top = [&](double x) { return outline[vertex_on_side(outline, x, true)].y; };
    const bool crest_is_left = top(box.low.x) >= top(box.high.x);
    const double left = crest_is_left ? behind : ahead, right = crest_is_left ? ahead : behind;
    base.contact = chain_of(outline, vertex_on_side(outline, box.low.x, left > 0),
                            vertex_on_side(outline, box.high.x, right > 0));
    base.outline = ring_around(base.contact, box.low.x - left, box.high.x + right, box.low.y - below);
    if (find_ring_fault(std::vector<Ring>{base.outline}))
        table->fail("below", "the outline has no lower side that a base could lie against",
                    "an outline that reaches its leftmost and rightmost points once");
    if (twice_signed_area(base.outline) < 0) std::reverse(base.outline.begin(), base.outline.end());
    base.inside = {(box.low.x + box.high.x) / 2, box.low.y - below / 2};
    check_coordinate_range(*table, "below", base.outline, model);
    model.base = std::move(base);
}

}  // namespace rockslope::blockgen
