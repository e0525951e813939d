#include "blockgen/input/geo_file.hpp"

#include <cmath>
#include <cstddef>
#include <string>

#include "common/base/input_error.hpp"
#include "common/base/magnitude.hpp"
#include "common/base/read_file.hpp"
#include "common/base/text.hpp"

namespace rockslope::blockgen {

namespace {

class GeoReader {
  public:
    explicit GeoReader(const std::filesystem::path& path)
        : text_(read_text_file(path)), file_(path.string()) {
        skip_blanks();
        if (at_ < text_.size() && text_[at_] == '<')
            throw InputError(place(), "this is XML", "a text file of lines, as Shi's program reads it");
    }

    double number(const char* what) {
        skip_blanks();
        word_place_ = place();
        const std::size_t start = at_;
        while (at_ < text_.size() && !is_blank(text_[at_])) ++at_;
        const std::string word = text_.substr(start, at_ - start);
        if (word.empty()) throw InputError(word_place_, "the file ends", what);
        const auto value = parse_number(word[0] == '+' ? word.substr(1) : word);
        if (!value || !is_in_allowed_range(*value))
            throw InputError(word_place_, "'" + word + "' is not a number", what);
        return *value;
    }

    std::size_t count(const char* what) {
        const double value = number(what);
        if (value != std::floor(value) || value < 0 || value > 1e7)
            throw InputError(word_place_, shortest_text(value) + " is not a count", what);
        return static_cast<std::size_t>(value);
    }

    Point point(const char* what) {
        const double x = number(what);
        return {x, number(what)};
    }

    std::vector<GeoLine> lines(std::size_t n, bool with_number, const char* what) {
        std::vector<GeoLine> result;
        for (std::size_t k = 0; k < n; ++k) {
            GeoLine line;
            line.a = point(what);
            line.b = point(what);
            if (with_number) {
                const double value = number(what);
                if (value != std::floor(value) || value < 0 || value > 1e6)
                    throw InputError(word_place_, shortest_text(value) + " is not a material number",
                                     "a whole number");
                line.number = value;
            }
            result.push_back(line);
        }
        return result;
    }

    std::vector<Point> points(std::size_t n, const char* what) {
        std::vector<Point> result;
        for (std::size_t k = 0; k < n; ++k) result.push_back(point(what));
        return result;
    }

    void expect_end() {
        skip_blanks();
        if (at_ < text_.size())
            throw InputError(place(), "words after the last point", "as many records as the counts say");
    }

  private:
    static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == ','; }

    void skip_blanks() {
        for (; at_ < text_.size() && is_blank(text_[at_]); ++at_)
            if (text_[at_] == '\n') {
                ++line_;
                line_start_ = at_ + 1;
            }
    }
    SourceLocation place() const { return {file_, line_, static_cast<int>(at_ - line_start_) + 1}; }

    std::string text_, file_;
    std::size_t at_ = 0, line_start_ = 0;
    int line_ = 1;
    SourceLocation word_place_;
};

}  // namespace

GeoFile read_geo_file(const std::filesystem::path& path) {
    GeoReader reader(path);
    GeoFile geo;
    geo.edge_node_distance = reader.number("the least distance of a node from an edge");
    const std::size_t joints = reader.count("the number of joint lines");
    reader.count("the number of boundary lines");
    const std::size_t materials = reader.count("the number of material lines");
    const std::size_t bolts = reader.count("the number of bolts");
    const std::size_t fixed = reader.count("the number of fixed lines");
    const std::size_t loaded = reader.count("the number of loaded points");
    const std::size_t measured = reader.count("the number of measured points");
    const std::size_t holes = reader.count("the number of hole points");
    geo.joints = reader.lines(joints, true, "a joint line: x1 y1 x2 y2 material");
    geo.material_lines = reader.lines(materials, true, "a material line: x1 y1 x2 y2 material");
    for (std::size_t k = 0; k < bolts; ++k) {
        constexpr const char* what = "a bolt: x1 y1 x2 y2 stiffness strength preload";
        geo.bolts.push_back(reader.lines(1, false, what)[0]);
        for (int word = 0; word < 3; ++word) reader.number(what);
    }
    geo.fixed_lines = reader.lines(fixed, false, "a fixed line: x1 y1 x2 y2");
    geo.loaded_points = reader.points(loaded, "a loaded point: x y");
    geo.measured_points = reader.points(measured, "a measured point: x y");
    geo.hole_points = reader.points(holes, "a hole point: x y");
    reader.expect_end();
    return geo;
}

}  // namespace rockslope::blockgen
