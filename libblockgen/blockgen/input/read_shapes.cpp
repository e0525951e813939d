#include "blockgen/input/read_shapes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "blockgen/input/domain.hpp"
#include "blockgen/input/geometry_file.hpp"
#include "blockgen/input/place_coordinates.hpp"
#include "blockgen/input/read_geology.hpp"
#include "blockgen/input/read_profile.hpp"
#include "common/base/text.hpp"
#include "common/geometry/point_text.hpp"

namespace rockslope::blockgen {

namespace {

std::string text_of_edge(const Ring& ring, std::size_t edge) {
    return "edge " + std::to_string(edge + 1) + " from " + text_of(ring[edge]) + " to " +
           text_of(ring[(edge + 1) % ring.size()]);
}

/// Why a ring is not a simple polygon; empty when it is.
std::string describe_fault(const Ring& ring) {
    if (ring.size() < 3) return std::to_string(ring.size()) + " corners enclose no area";
    const auto fault = find_ring_fault(std::vector<Ring>{ring});
    if (!fault) return {};
    if (fault->first_edge == fault->second_edge)
        return text_of_edge(ring, fault->first_edge) + " has no length";
    return text_of_edge(ring, fault->first_edge) + " and " + text_of_edge(ring, fault->second_edge) +
           " meet at " + text_of(fault->place);
}

constexpr const char* ring_expected = "a simple polygon of three corners or more";

Ring ring_of(const std::vector<std::array<double, 2>>& pairs) {
    Ring ring;
    for (const auto& pair : pairs) ring.push_back(point_of(pair));
    if (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
    return ring;
}

void make_counter_clockwise(Ring& ring) {
    if (twice_signed_area(ring) < 0) std::reverse(ring.begin(), ring.end());
}

double positive(const ConfigTable& table, std::string_view key) {
    return table.checked(
        key, table.number(key, Dimension::length), [](double x) { return x > 0; }, "a positive length");
}

Ring circle(const Point& centre, double radius, std::int64_t segments) {
    Ring ring;
    for (std::int64_t k = 0; k < segments; ++k) {
        const double angle =
            2 * std::numbers::pi * (static_cast<double>(k) + 0.5) / static_cast<double>(segments);
        ring.push_back({centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)});
    }
    return ring;
}

/// A rectangle below a half circle. @param floor midpoint of the floor.
Ring horseshoe(const Point& floor, double width, double height, std::int64_t segments) {
    const double radius = width / 2;
    const Point crown{floor.x, floor.y + height - radius};
    Ring ring = {{floor.x - radius, floor.y}, {floor.x + radius, floor.y}};
    if (!(height > radius)) ring.clear();
    for (std::int64_t k = 0; k <= segments; ++k) {
        const double angle = std::numbers::pi * static_cast<double>(k) / static_cast<double>(segments);
        ring.push_back({crown.x + radius * std::cos(angle), crown.y + radius * std::sin(angle)});
    }
    return ring;
}

Ring read_opening_shape(const ConfigTable& table) {
    const std::string shape = table.choice("shape", {"circle", "horseshoe", "polygon"});
    if (shape == "polygon") return read_ring(table, "polygon");
    const auto segments = table.integer("segments", 32);
    if (segments < 8 || segments > 10000)
        table.fail("segments", "too few or too many segments", "8 to 10000");
    if (shape == "circle")
        return circle(point_of(table.pair("centre", Dimension::length)), positive(table, "radius"), segments);
    const double width = positive(table, "width");
    const double height = table.checked(
        "height", table.number("height", Dimension::length), [width](double h) { return h >= width / 2; },
        "at least half the width");
    return horseshoe(point_of(table.pair("floor", Dimension::length)), width, height, segments);
}

Ring read_opening(const ConfigTable& table, const SlopeModel& model) {
    Ring outline = read_opening_shape(table);
    check_coordinate_range(table, "shape", outline, model);
    return outline;
}

Excavation read_excavation(const ConfigTable& table, const std::string& default_name,
                           const SlopeModel& model) {
    Excavation excavation;
    excavation.place = table.place();
    excavation.name = table.string("name", default_name);
    const std::int64_t stage = table.integer("stage");
    if (stage < 1 || stage > 1'000'000)
        table.fail("stage", "there is no stage " + std::to_string(stage), "an integer from 1 to 1000000");
    excavation.stage = stage;
    if (table.has("joint_material")) excavation.joint_material = read_name(table, "joint_material");
    excavation.outline = read_opening(table, model);
    return excavation;
}

/// Checks a ring and turns it counter-clockwise. @param what its name in an error message.
void check_ring(const ConfigTable& domain, const std::string& key, const std::string& what, Ring& ring) {
    if (const std::string fault = describe_fault(ring); !fault.empty())
        domain.fail(key, what + ": " + fault, ring_expected);
    make_counter_clockwise(ring);
}

void add_part(const ConfigTable& domain, const std::string& key, const std::string& what, Ring outer,
              SlopeModel& model) {
    check_ring(domain, key, what, outer);
    (model.outline.empty() ? model.outline : model.further_outlines.emplace_back()) = std::move(outer);
}

void add_hole(const ConfigTable& domain, const std::string& key, const std::string& where, Ring hole,
              SlopeModel& model) {
    const std::string what = "hole " + std::to_string(model.holes.size() + 1) + where;
    check_ring(domain, key, what, hole);
    model.holes_location = domain.place(key);
    model.holes.push_back(std::move(hole));
}

/// Which of the keys outline, outlines, outline_file and profile_file is given; `outline` when none is.
std::string outline_key(const ConfigTable& domain) {
    std::string given;
    for (const char* key : {"outline", "outlines", "outline_file", "profile_file"}) {
        if (!domain.has(key)) continue;
        if (!given.empty()) domain.fail(key, given + " and " + key + " are both given", "one of them");
        given = key;
    }
    return given.empty() ? "outline" : given;
}

void read_outline(const ConfigTable& root, const ConfigTable& domain, SlopeModel& model) {
    const std::string key = outline_key(domain);
    std::vector<std::vector<Ring>> parts;
    std::string where;
    if (key == "outline_file") {
        model.files.push_back(domain.file_path(key));
        where = " in " + model.files.back().string();
        PlacedFile file{domain, key, model.files.back(), {}, {}};
        parts = read_outline_file(file.path, &file.notes);
        for (std::vector<Ring>& rings : parts)
            for (Ring& ring : rings) file.lines.push_back(&ring);
        place_coordinates(file, model);
    } else if (key == "profile_file") {
        parts.push_back({read_profile(root, domain, model)});
    } else if (key == "outlines") {
        for (const auto& pairs : domain.rings(key)) parts.push_back({ring_of(pairs)});
        if (parts.empty()) domain.fail(key, "no part of the domain", "[[[x, y], ...], ...]");
    } else {
        parts.push_back({ring_of(domain.pairs(key, Dimension::length))});
    }
    model.outlines_location = domain.place(key);
    for (std::size_t k = 0; k < parts.size(); ++k)
        add_part(domain, key,
                 (parts.size() == 1 ? "the outline" : "outline " + std::to_string(k + 1)) + where,
                 std::move(parts[k][0]), model);
    for (const std::vector<Ring>& rings : parts)
        for (std::size_t r = 1; r < rings.size(); ++r) add_hole(domain, key, where, rings[r], model);
    for (const auto& pairs : domain.rings("holes")) add_hole(domain, "holes", "", ring_of(pairs), model);
}

double read_grid(const ConfigTable& domain) {
    const double grid = domain.number("grid", Dimension::length, 0x1p-20);
    int exponent = 0;
    if (!(grid > 0) || std::frexp(grid, &exponent) != 0.5)
        domain.fail("grid", shortest_text(grid) + " m is not a power of two",
                    "a power of two, such as 2^-20 = 9.5367431640625e-7");
    return grid;
}

IslandPolicy read_island_policy(const ConfigTable& domain) {
    const std::string word = domain.choice("islands", {"keep", "cut", "fill", "error"}, "keep");
    if (word == "cut") return IslandPolicy::cut;
    if (word == "fill") return IslandPolicy::fill;
    return word == "keep" ? IslandPolicy::keep : IslandPolicy::error;
}

/// Default of `below_share`: chips between joints that nearly meet in one point. Thousands of them weigh less
/// than one block, and a run cannot end while one of them still moves.
constexpr double chip_share = 1e-4;

/// What a model file without the table asks for: chips are merged, slender blocks are kept.
SmallBlocks default_small_blocks() {
    SmallBlocks small;
    small.policy = SmallBlockPolicy::merge;
    small.below_share = chip_share;
    small.merges_slivers = false;
    return small;
}

SmallBlocks read_small_blocks(const ConfigTable& table) {
    SmallBlocks small;
    const std::string word = table.choice("policy", {"keep", "merge", "drop"});
    if (word == "merge") small.policy = SmallBlockPolicy::merge;
    if (word == "drop") small.policy = SmallBlockPolicy::drop;
    small.below_area = table.checked(
        "below_area", table.number("below_area", Dimension::none, small.below_area),
        [](double a) { return a >= 0; }, "an area in m2 of zero or more");
    small.below_share = table.checked(
        "below_share", table.number("below_share", Dimension::none, chip_share),
        [](double s) { return s >= 0 && s < 1; }, "a share of the median area from 0 to below 1");
    small.below_roundness = table.checked(
        "below_roundness", table.number("below_roundness", Dimension::none, small.below_roundness),
        [](double r) { return r >= 0 && r < 0.6; }, "a number from 0 to below 0.6: a square has 0.785");
    return small;
}

void check_extent(const ConfigTable& domain, const SlopeModel& model) {
    const std::string key = domain.has("grid")       ? "grid"
                            : domain.has("geo_file") ? "geo_file"
                                                     : outline_key(domain);
    check_coordinate_range(domain, key, model.outline, model);
    const Bounds bounds = domain_bounds(model);
    if (std::min(bounds.high.x - bounds.low.x, bounds.high.y - bounds.low.y) < 16 * model.grid)
        domain.fail(key, "the domain is hardly larger than the grid", "a finer grid");
    for (const Ring& hole : model.holes)
        check_coordinate_range(domain, domain.has("holes") ? "holes" : key, hole, model);
}

}  // namespace

Point point_of(const std::array<double, 2>& pair) {
    return {pair[0], pair[1]};
}

std::string read_name(const ConfigTable& table, std::string_view key) {
    std::string name = table.string(key);
    if (name.empty())
        table.fail(key, "'" + std::string(key) + "' in [" + table.path() + "] is empty", "a name");
    return name;
}

namespace {

/// @throws InputError: a length that has to stay below so many cells of the grid does not.
[[noreturn]] void fail_for_grid(const ConfigTable& table, std::string_view key, double grid, double length,
                                double cells, const std::string& what) {
    int exponent = 0;
    std::frexp(length / cells, &exponent);
    table.fail(key,
               "grid = " + shortest_text(grid) + " m in [domain] is too fine: it allows " + what + " below " +
                   shortest_text(cells * grid) + " m, not " + shortest_text(length) + " m",
               "a grid of " + shortest_text(std::ldexp(1.0, exponent)) + " m or coarser");
}

}  // namespace

void check_coordinate_range(const ConfigTable& table, std::string_view key, const Ring& points,
                            const SlopeModel& model) {
    Ring all = points;  // the model has no outline yet when a line file is read
    all.insert(all.end(), model.outline.begin(), model.outline.end());
    for (const Ring& part : model.further_outlines) all.insert(all.end(), part.begin(), part.end());
    const auto [low, high] = Bounds::of(all);
    const double extent = std::max(high.x - low.x, high.y - low.y);
    const double farthest = std::max({std::abs(low.x), std::abs(high.x), std::abs(low.y), std::abs(high.y)});
    constexpr double most_cells = 0x1p37, farthest_cell = 0x1p51;
    if (!(extent / model.grid < most_cells))
        fail_for_grid(table, key, model.grid, extent, most_cells, "a width");
    if (!(farthest / model.grid < farthest_cell))
        fail_for_grid(table, key, model.grid, farthest, farthest_cell, "coordinates");
}

Ring read_ring(const ConfigTable& table, std::string_view key) {
    Ring ring = ring_of(table.pairs(key, Dimension::length));
    if (const std::string fault = describe_fault(ring); !fault.empty()) table.fail(key, fault, ring_expected);
    make_counter_clockwise(ring);
    return ring;
}

void read_domain(const ConfigTable& root, const EnclosedAreaFunction& enclosed_area, SlopeModel& model) {
    const ConfigTable domain = root.table("domain");
    model.domain_location = domain.place();
    model.grid = read_grid(domain);
    read_project(domain, model);
    if (domain.has("geo_file")) {
        for (const char* key : {"outline", "outlines", "outline_file", "profile_file", "holes"})
            if (domain.has(key))
                domain.fail(key, std::string(key) + " and geo_file are both given", "one of them");
        read_geo_domain(domain, enclosed_area, model);
    } else {
        read_outline(root, domain, model);
    }
    model.block_material = read_name(domain, "block_material");
    model.islands = read_island_policy(domain);
    check_extent(domain, model);
    const auto small = root.optional_table("small_blocks");
    model.small_blocks = small ? read_small_blocks(*small) : default_small_blocks();
}

void read_regions(const ConfigTable& root, SlopeModel& model) {
    for (const ConfigTable& table : root.array_of_tables("region")) {
        Region region;
        region.place = table.place();
        region.name = read_name(table, "name");
        region.block_material = table.string("block_material", model.block_material);
        region.joint_material = table.string("joint_material", "");
        region.polygon = read_ring(table, "polygon");
        check_coordinate_range(table, "polygon", region.polygon, model);
        add_region(table, std::move(region), model);
    }
}

void read_tunnels(const ConfigTable& root, SlopeModel& model) {
    for (const ConfigTable& table : root.array_of_tables("tunnel")) {
        if (table.has("stage")) {
            model.excavations.push_back(read_excavation(
                table, "tunnel " + std::to_string(model.tunnels.size() + model.excavations.size() + 1),
                model));
            continue;
        }
        Tunnel tunnel;
        tunnel.place = table.place();
        tunnel.name = table.string(
            "name", "tunnel " + std::to_string(model.tunnels.size() + model.excavations.size() + 1));
        tunnel.outline = read_opening(table, model);
        model.tunnels.push_back(std::move(tunnel));
    }
    for (const ConfigTable& table : root.array_of_tables("excavation"))
        model.excavations.push_back(
            read_excavation(table, "excavation " + std::to_string(model.excavations.size() + 1), model));
}

}  // namespace rockslope::blockgen
