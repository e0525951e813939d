#include "report.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "common/base/atomic_file.hpp"
#include "common/base/base64.hpp"
#include "common/base/input_error.hpp"
#include "common/base/sha256.hpp"
#include "common/base/text.hpp"
#include "report_assets.hpp"
#include "report_motion.hpp"
#include "report_tables.hpp"

namespace rockslope {

namespace {

using ReportJson = nlohmann::json;

/// Frames that a page keeps, and the steps from zero to the largest value of an item: fewer for a large
/// model, whose page would be too long.
constexpr std::size_t most_frames = 500;
constexpr std::size_t large_model = 1'000'000;  ///< blocks times frames
constexpr int fine_levels = 1000, coarse_levels = 100, stress_levels = 40, coarse_stress_levels = 12;
/// Steps of a large model from zero to the displacement that nine of ten blocks do not exceed: none is finer,
/// and none of a rotation moves a usual corner by less.
constexpr double finest_of_usual = 200;
/// A block that moves less than this part of the largest displacement is shown at rest.
constexpr double still = 1e-4;
/// Steps of a coordinate over the size of the section.
constexpr double grid = 1 << 18;

float largest_of(const ItemSeries& series) {
    float largest = 0;
    for (const float value : series.values) largest = std::max(largest, std::abs(value));
    return largest;
}

/// The corners of the blocks and the lines of the pairs in steps of a grid.
class Geometry {
  public:
    explicit Geometry(const ReportMotion& motion) {
        Point high{-1e300, -1e300};
        for (const ReportBlock& block : motion.blocks)
            for (const Point& p : block.corners) {
                origin_ = {std::min(origin_.x, p.x), std::min(origin_.y, p.y)};
                high = {std::max(high.x, p.x), std::max(high.y, p.y)};
            }
        step_ = std::max(high.x - origin_.x, high.y - origin_.y) / grid;
    }

    ReportJson json() const { return {{"x", origin_.x}, {"y", origin_.y}, {"step", step_}}; }

    std::string blocks(const ReportMotion& motion) const {
        std::string bytes;
        std::int64_t x = 0, y = 0;
        for (const ReportBlock& block : motion.blocks) {
            append_number(bytes, static_cast<std::uint64_t>(block.number));
            append_number(bytes, 2 * static_cast<std::uint64_t>(block.material) + (block.moves ? 1 : 0));
            append_number(bytes, block.corners.size());
            for (const Point& p : block.corners) {
                const std::int64_t to_x = std::llround((p.x - origin_.x) / step_);
                const std::int64_t to_y = std::llround((p.y - origin_.y) / step_);
                append_signed(bytes, to_x - x);
                append_signed(bytes, to_y - y);
                x = to_x;
                y = to_y;
            }
        }
        return bytes;
    }

    std::string pairs(const ReportMotion& motion) const {
        std::string bytes;
        for (const ReportPair& pair : motion.pairs) {
            append_number(bytes, pair.block);
            append_number(bytes, pair.other);
            append_number(bytes, static_cast<std::uint64_t>(pair.joint_material));
            append_number(bytes, static_cast<std::uint64_t>(std::int64_t{pair.joint} + 1));
            for (const double value : {pair.from.x, pair.from.y, pair.to.x, pair.to.y})
                append_signed(bytes, std::llround(value / step_));
        }
        return bytes;
    }

  private:
    Point origin_{1e300, 1e300};
    double step_ = 1;
};

/// The text of a script element that holds data. Nothing in it ends the element.
std::string data_element(const std::string& name, const std::string& type, const std::string& text) {
    return "<script type=\"" + type + "\" id=\"" + name + "\">" + text + "</script>\n";
}

std::string section(const std::string& name, const std::string& bytes) {
    return data_element("data-" + name, "text/plain", compressed_text(bytes));
}

/// The largest magnitude of each item, in ascending order.
std::vector<float> largest_of_items(const ItemSeries& series) {
    std::vector<float> largest(series.items);
    for (std::size_t at = 0; at < series.values.size(); ++at) {
        float& of_item = largest[at / series.frames];
        of_item = std::max(of_item, std::abs(series.values[at]));
    }
    std::sort(largest.begin(), largest.end());
    return largest;
}

/// A value that nine of ten items do not exceed.
double usual_end(const ItemSeries& series) {
    const std::vector<float> largest = largest_of_items(series);
    return largest.empty() ? 0 : largest[(largest.size() - 1) * 9 / 10];
}

/// The median distance of the corners of a block from its centroid, m.
double usual_radius(const ReportMotion& motion) {
    std::vector<double> radii;
    for (const ReportBlock& block : motion.blocks)
        for (const Point& p : block.corners)
            radii.push_back(std::hypot(p.x - block.centroid.x, p.y - block.centroid.y));
    const auto middle = radii.begin() + static_cast<std::ptrdiff_t>(radii.size() / 2);
    std::nth_element(radii.begin(), middle, radii.end());
    return *middle;
}

/// How finely the quantities of a page are kept.
struct PageResolution {
    Resolution place, rotation, stress, slip;

    explicit PageResolution(const ReportMotion& motion) {
        const bool is_large = motion.x.values.size() > large_model;
        const int levels = is_large ? coarse_levels : fine_levels;
        const double floor = still * std::max(largest_of(motion.x), largest_of(motion.y));
        place = {levels, floor};
        rotation = {levels, still * largest_of(motion.rotation)};
        stress = {is_large ? coarse_stress_levels : stress_levels};
        slip = {is_large ? coarse_stress_levels : coarse_levels, floor};
        if (!is_large) return;
        place.finest = slip.finest = std::max(usual_end(motion.x), usual_end(motion.y)) / finest_of_usual;
        rotation.finest = place.finest / usual_radius(motion);
        stress.finest = usual_end(motion.stress) / (2 * coarse_stress_levels);
    }
};

std::string motion_sections(const ReportMotion& motion, const Geometry& geometry) {
    const PageResolution kept(motion);
    std::string text = section("blocks", geometry.blocks(motion)) + section("pairs", geometry.pairs(motion));
    text += section("x", packed_series(motion.x, kept.place));
    text += section("y", packed_series(motion.y, kept.place));
    text += section("rotation", packed_series(motion.rotation, kept.rotation));
    text += section("stress", packed_series(motion.stress, kept.stress));
    text += section("slip", packed_series(motion.slip, kept.slip));
    if (largest_of(motion.roughness) > 0)
        text += section("roughness", packed_series(motion.roughness, {stress_levels}));
    text += section("states", packed_states(motion.states, motion.frames.size()));
    if (std::any_of(motion.removed.begin(), motion.removed.end(), [](std::uint8_t r) { return r != 0; }))
        text += section("removed", packed_states(motion.removed, motion.frames.size()));
    return text;
}

ReportJson motion_json(const RunFrames& run, const ReportMotion& motion, const Geometry& geometry) {
    ReportJson times = ReportJson::array(), stages = ReportJson::array(), base_x, base_y;
    for (std::size_t k = 0; k < motion.frames.size(); ++k) {
        times.push_back(run.times()[static_cast<std::size_t>(motion.frames[k])]);
        stages.push_back(run.stage(motion.frames[k]));
        base_x.push_back(motion.base[k].x);
        base_y.push_back(motion.base[k].y);
    }
    return {{"times", times},
            {"stages", stages},
            {"base", {{"x", base_x}, {"y", base_y}}},
            {"blocks", motion.blocks.size()},
            {"pairs", motion.pairs.size()},
            {"grid", geometry.json()},
            {"materials", run.block_materials()},
            {"joint_materials", run.joint_materials()},
            {"joints", run.joints()}};
}

/// JSON that cannot end the element it stands in.
std::string safe_json(const ReportJson& json) {
    std::string text = json.dump(-1, ' ', false, ReportJson::error_handler_t::replace), result;
    for (const char c : text) {
        if (c == '<')
            result += "\\u003c";
        else
            result += c;
    }
    return result;
}

/// The source of a content security policy that allows this text alone.
std::string hash_source(std::string_view text) {
    const std::string digits = sha256(text);
    std::string bytes;
    for (std::size_t i = 0; i < digits.size(); i += 2)
        bytes += static_cast<char>(std::stoi(digits.substr(i, 2), nullptr, 16));
    return "'sha256-" + base64(bytes) + "'";
}

/// A page with its marks replaced. @param marks in the order in which they stand in the page.
std::string filled(std::string_view page, const std::vector<std::pair<std::string, std::string>>& marks) {
    std::string text;
    std::size_t start = 0;
    for (const auto& [mark, value] : marks) {
        const std::size_t at = page.find("@" + mark + "@", start);
        if (at == std::string_view::npos) throw std::logic_error("the page has no mark " + mark);
        text += page.substr(start, at - start);
        text += value;
        start = at + mark.size() + 2;
    }
    return text.append(page.substr(start));
}

}  // namespace

void write_report(const std::filesystem::path& folder, const std::filesystem::path& report) {
    const RunFrames run(folder);
    if (run.times().empty())
        throw InputError({run.name() + ".vtkhdf"}, "contains no frames yet", "a run that has begun");
    const ReportMotion motion = read_motion(run, report_frames(run, most_frames));
    const Geometry geometry(motion);
    ReportJson json = report_tables(folder);
    json["name"] = run.name();
    json["program"] = ROCKSLOPE_VERSION;
    json["motion"] = motion_json(run, motion, geometry);
    const std::string data =
        motion_sections(motion, geometry) + data_element("data-page", "application/json", safe_json(json));
    const std::string policy = "default-src 'none'; script-src " + hash_source(report_script) +
                               "; style-src " + hash_source(report_style) +
                               "; base-uri 'none'; form-action 'none'";
    write_file_atomically(report, filled(report_page, {{"policy", policy},
                                                       {"title", xml_escaped(run.name())},
                                                       {"style", std::string(report_style)},
                                                       {"data", data},
                                                       {"script", std::string(report_script)}}));
}

}  // namespace rockslope
