#include "blockgen/report/vtk_text.hpp"

#include <cmath>
#include <limits>
#include <unordered_map>
#include <utility>

#include "blockgen/mesh/measures.hpp"
#include "blockgen/report/water_line_across.hpp"
#include "common/base/text.hpp"
#include "common/geometry/orientation.hpp"

namespace rockslope::blockgen {

namespace {

using Corners = std::vector<VertexIndex>;

/// The corners of a block as one closed line without holes.
class BlockOutline {
  public:
    BlockOutline(const BlockMesh& mesh, BlockIndex block) : mesh_(mesh) {
        for (std::size_t r = 0; r < mesh.ring_count(block); ++r) {
            const auto ring = mesh.ring(block, r);
            rings_.emplace_back(ring.begin(), ring.end());
        }
    }

    Corners run() {
        Corners outline = rings_[0];
        for (std::size_t r = 1; r < rings_.size(); ++r) join(rings_[r], outline);
        return outline;
    }

  private:
    const Point& at(VertexIndex v) const { return mesh_.vertices[v]; }

    /// Whether the line between two corners meets no ring but in corners at its ends.
    bool is_free(VertexIndex a, VertexIndex b) const {
        for (const Corners& ring : rings_)
            for (std::size_t k = 0; k < ring.size(); ++k) {
                const VertexIndex p = ring[k], q = ring[(k + 1) % ring.size()];
                const SegmentRelation how = segment_relation(at(a), at(b), at(p), at(q));
                const bool shares_end = p == a || p == b || q == a || q == b;
                if (how != SegmentRelation::apart && !(shares_end && how == SegmentRelation::endpoint))
                    return false;
            }
        return true;
    }

    void join(const Corners& hole, Corners& outline) const {
        double shortest = std::numeric_limits<double>::infinity();
        std::size_t from = 0, to = 0;
        for (std::size_t i = 0; i < outline.size(); ++i)
            for (std::size_t k = 0; k < hole.size(); ++k) {
                const Point &p = at(outline[i]), &q = at(hole[k]);
                const double length = std::hypot(q.x - p.x, q.y - p.y);
                // A hole that touches the ring needs no slit.
                if (length >= shortest || (length > 0 && !is_free(outline[i], hole[k]))) continue;
                shortest = length, from = i, to = k;
            }
        Corners detour(hole.begin() + static_cast<std::ptrdiff_t>(to), hole.end());
        detour.insert(detour.end(), hole.begin(), hole.begin() + static_cast<std::ptrdiff_t>(to) + 1);
        detour.push_back(outline[from]);
        outline.insert(outline.begin() + static_cast<std::ptrdiff_t>(from) + 1, detour.begin(), detour.end());
    }

    const BlockMesh& mesh_;
    std::vector<Corners> rings_;
};

/// A string as VTK encodes it: blanks, quotes and what is not ASCII by their bytes, %20 for a space.
std::string encoded(const std::string& text) {
    std::string result;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte > 32 && byte < 127 && c != '"' && c != '%')
            result += c;
        else
            ((result += '%') += "0123456789ABCDEF"[byte / 16]) += "0123456789ABCDEF"[byte % 16];
    }
    return result;
}

/// Text of a part of the file, a line at a time.
class VtkText {
  public:
    void line(const std::string& text) { (text_ += text) += '\n'; }
    void point(const Point& p) { line(shortest_text(p.x) + " " + shortest_text(p.y) + " 0"); }
    /// Values of all cells; lines come before polygons.
    template <class OfLine, class OfBlock>
    void cell_values(const std::string& name, const char* type, std::size_t lines, const OfLine& of_line,
                     const BlockMesh& mesh, const OfBlock& of_block) {
        line("SCALARS " + name + " " + type + " 1\nLOOKUP_TABLE default");
        for (std::size_t k = 0; k < lines; ++k) line(of_line(k));
        for (const BlockIndex b : mesh.blocks()) line(of_block(b));
    }
    void names(const std::string& name, const std::vector<std::string>& all) {
        line(name + " 1 " + std::to_string(all.size()) + " string");
        for (const std::string& text : all) line(encoded(text));
    }
    std::string take() { return std::move(text_); }

  private:
    std::string text_;
};

/// The names of traces in the order in which they come, and the number of that of each trace.
struct SetNumbers {
    explicit SetNumbers(const std::vector<Trace>& traces) {
        std::unordered_map<std::string, std::size_t> number_of;
        for (const Trace& trace : traces) {
            const auto [found, is_new] = number_of.emplace(trace.name, names.size());
            if (is_new) names.push_back(trace.name);
            number.push_back(found->second);
        }
    }
    std::vector<std::string> names;
    std::vector<std::size_t> number;
};

/// The lines of the file: the traces, then the water table if there is one.
class FileLines {
  public:
    FileLines(const BlockMesh& mesh, const std::vector<Trace>& traces)
        : traces_(traces), water_(water_line_across(mesh)) {}

    std::size_t size() const { return traces_.size() + (water_.empty() ? 0 : 1); }
    bool is_trace(std::size_t line) const { return line < traces_.size(); }
    const std::vector<Point>& points(std::size_t line) const {
        return is_trace(line) ? traces_[line].points : water_;
    }
    std::size_t point_count() const {
        std::size_t count = 0;
        for (std::size_t k = 0; k < size(); ++k) count += points(k).size();
        return count;
    }

  private:
    const std::vector<Trace>& traces_;
    std::vector<Point> water_;
};

void append_cells(VtkText& text, const BlockMesh& mesh, const FileLines& lines) {
    std::size_t points = mesh.vertices.size();
    if (lines.size() > 0)
        text.line("LINES " + std::to_string(lines.size()) + " " +
                  std::to_string(lines.size() + lines.point_count()));
    for (std::size_t line = 0; line < lines.size(); ++line) {
        std::string cell = std::to_string(lines.points(line).size());
        for (std::size_t k = 0; k < lines.points(line).size(); ++k) cell += " " + std::to_string(points++);
        text.line(cell);
    }
    std::size_t numbers = 0;
    std::string polygons;
    for (const BlockIndex b : mesh.blocks()) {
        const Corners outline = BlockOutline(mesh, b).run();
        numbers += outline.size() + 1;
        polygons += std::to_string(outline.size());
        for (const VertexIndex v : outline) polygons += " " + std::to_string(v.value());
        polygons += '\n';
    }
    text.line("POLYGONS " + std::to_string(mesh.block_count()) + " " + std::to_string(numbers));
    if (!polygons.empty()) polygons.pop_back();
    text.line(polygons);
}

void append_data(VtkText& text, const BlockMesh& mesh, const FileLines& lines, const SetNumbers& sets) {
    const std::size_t count = lines.size();
    const auto none = [](std::size_t) { return std::string("-1"); };
    const auto no_block = [](BlockIndex) { return std::string("-1"); };
    text.line("CELL_DATA " + std::to_string(count + mesh.block_count()));
    text.cell_values("block", "int", count, none, mesh,
                     [](BlockIndex b) { return std::to_string(b.value()); });
    text.cell_values("block_material", "int", count, none, mesh,
                     [&](BlockIndex b) { return std::to_string(mesh.block_material[b].value()); });
    text.cell_values("motion", "int", count, none, mesh,
                     [&](BlockIndex b) { return std::to_string(static_cast<int>(mesh.motion[b])); });
    text.cell_values(
        "area", "double", count, [](std::size_t) { return std::string("0"); }, mesh,
        [&](BlockIndex b) { return shortest_text(block_area(mesh, b)); });
    text.cell_values(
        "trace", "int", count, [&](std::size_t k) { return lines.is_trace(k) ? std::to_string(k) : "-1"; },
        mesh, no_block);
    text.cell_values(
        "set", "int", count,
        [&](std::size_t k) { return lines.is_trace(k) ? std::to_string(sets.number[k]) : "-1"; }, mesh,
        no_block);
    text.cell_values(
        "kind", "int", count, [&](std::size_t k) { return std::string(lines.is_trace(k) ? "1" : "2"); }, mesh,
        [](BlockIndex) { return std::string("0"); });
}

}  // namespace

std::string vtk_text(const BlockMesh& mesh, const std::vector<Trace>& traces) {
    const SetNumbers sets(traces);
    VtkText text;
    text.line("# vtk DataFile Version 3.0\nblocks and joints of a rock section, m\nASCII\nDATASET POLYDATA");
    text.line("FIELD FieldData 3");
    text.names("block_material_names", mesh.block_materials);
    text.names("set_names", sets.names);
    text.names("kind_names", {"block", "trace", "water_table"});
    const FileLines lines(mesh, traces);
    text.line("POINTS " + std::to_string(mesh.vertices.size() + lines.point_count()) + " double");
    for (const Point& p : mesh.vertices) text.point(p);
    for (std::size_t k = 0; k < lines.size(); ++k)
        for (const Point& p : lines.points(k)) text.point(p);
    append_cells(text, mesh, lines);
    append_data(text, mesh, lines, sets);
    return text.take();
}

}  // namespace rockslope::blockgen
