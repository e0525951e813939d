#include <algorithm>
#include <charconv>

#include "blockgen/mesh/block_file.hpp"
#include "blockgen/mesh/names.hpp"
#include "common/base/atomic_file.hpp"

namespace rockslope::blockgen {

namespace {

template <class Number>
void append_number(std::string& out, Number value) {
    char digits[32];
    const auto result = std::to_chars(digits, digits + sizeof digits, value);
    out.append(digits, result.ptr);
}

template <class Kind>
void append_number(std::string& out, Index<Kind> index) {
    append_number(out, index.value());
}

void append_count(std::string& out, std::string_view noun, std::size_t count) {
    (out += ' ').append(noun) += ' ';
    append_number(out, count);
}

void append_point(std::string& out, const Point& point) {
    out += ' ';
    append_number(out, point.x);
    out += ' ';
    append_number(out, point.y);
}

template <class Kind>
void append_index(std::string& out, Index<Kind> index) {
    if (index.exists())
        append_number(out, index);
    else
        out += '-';
}

void append_mark(std::string& out, const EdgeMark& mark) {
    out += ' ';
    append_index(out, mark.joint_material);
    if (mark.joint_material < 0 && mark.joint < 0) return;
    out += ':';
    append_index(out, mark.joint);
}

std::string_view motion_word(BlockMotion motion) {
    switch (motion) {
        case BlockMotion::fixed:
            return "fixed";
        case BlockMotion::prescribed:
            return "prescribed";
        case BlockMotion::free:
            break;
    }
    return "free";
}

void append_names(std::string& out, std::string_view noun, const std::vector<std::string>& names) {
    for (const std::string& name : names) (((out += noun) += ' ') += quoted_name(name)) += '\n';
}

int version_of(const BlockMesh& mesh) {
    if (!mesh.water_table.empty()) return 3;
    return mesh.excavations.empty() ? 1 : 2;
}

void append_header(std::string& out, const BlockMesh& mesh) {
    out += "ddablk ";
    const int version = version_of(mesh);
    append_number(out, version);
    out += "\ncounts";
    append_count(out, "provenance", mesh.provenance.size());
    append_count(out, "block_materials", mesh.block_materials.size());
    append_count(out, "joint_materials", mesh.joint_materials.size());
    append_count(out, "joints", mesh.joints.size());
    append_count(out, "vertices", mesh.vertices.size());
    append_count(out, "blocks", mesh.block_count());
    append_count(out, "rings", mesh.ring_corners.size() - 1);
    append_count(out, "corners", mesh.corners.size());
    append_count(out, "measured_points", mesh.measured_points.size());
    append_count(out, "bolts", mesh.bolts.size());
    if (version >= 2) append_count(out, "excavations", mesh.excavations.size());
    if (version >= 3) append_count(out, "water_table_points", mesh.water_table.size());
    out += '\n';
}

void append_block(std::string& out, const BlockMesh& mesh, BlockIndex block) {
    out += "block ";
    append_number(out, mesh.block_material[block]);
    out += ' ';
    append_number(out, mesh.ring_count(block));
    (out += ' ') += motion_word(mesh.motion[block]);
    if (!mesh.motion_name[block].empty()) (out += ' ') += quoted_name(mesh.motion_name[block]);
    out += '\n';
    for (std::size_t r = 0; r < mesh.ring_count(block); ++r) {
        out += "ring";
        for (const VertexIndex vertex : mesh.ring(block, r)) {
            out += ' ';
            append_number(out, vertex);
        }
        out += "\nedges";
        for (const EdgeMark& mark : mesh.ring_marks(block, r)) append_mark(out, mark);
        out += '\n';
    }
}

void append_bolt(std::string& out, const Bolt& bolt) {
    (((out += "bolt ") += quoted_name(bolt.name)) += ' ') += quoted_name(bolt.material);
    out += ' ';
    append_number(out, bolt.first_block);
    append_point(out, bolt.first);
    out += ' ';
    append_number(out, bolt.second_block);
    append_point(out, bolt.second);
    out += '\n';
}

void append_excavation(std::string& out, const ExcavatedBlocks& excavation) {
    ((out += "excavation ") += quoted_name(excavation.name)) += ' ';
    append_number(out, excavation.stage);
    for (const BlockIndex block : excavation.blocks) {
        out += ' ';
        append_number(out, block);
    }
    out += '\n';
}

using Append = FunctionRef<void(std::string_view)>;

/// Appends the texts of [0, count), each written by text_of(index, out), in order. Threads write the texts of
/// ranges, a few at a time.
template <class TextOf>
void append_all(std::size_t count, const TextOf& text_of, const ThreadPool& pool, Append append) {
    constexpr std::size_t range = 4096;
    std::vector<std::string> texts(2 * static_cast<std::size_t>(pool.size()));
    for (std::size_t start = 0; start < count; start += range * texts.size()) {
        pool.parallel_for_dynamic(texts.size(), [&](std::size_t k, std::size_t) {
            texts[k].clear();
            const std::size_t begin = start + range * k;
            for (std::size_t i = begin; i < std::min(begin + range, count); ++i) text_of(i, texts[k]);
        });
        for (const std::string& text : texts) append(text);
    }
}

void append_header_and_names(const BlockMesh& mesh, Append append) {
    std::string out;
    append_header(out, mesh);
    append_names(out, "provenance", mesh.provenance);
    append_names(out, "block_material", mesh.block_materials);
    append_names(out, "joint_material", mesh.joint_materials);
    for (const Joint& joint : mesh.joints) ((out += "joint ") += quoted_name(joint.set)) += '\n';
    append(out);
}

void append_end(const BlockMesh& mesh, Append append) {
    std::string out;
    for (const MeasuredPoint& point : mesh.measured_points) {
        ((out += "measured_point ") += quoted_name(point.name)) += ' ';
        append_number(out, point.block);
        append_point(out, point.position);
        out += '\n';
    }
    for (const Bolt& bolt : mesh.bolts) append_bolt(out, bolt);
    for (const ExcavatedBlocks& excavation : mesh.excavations) append_excavation(out, excavation);
    for (const Point& point : mesh.water_table) {
        out += "water_table_point";
        append_point(out, point);
        out += '\n';
    }
    append(out += "end\n");
}

void append_block_file(const BlockMesh& mesh, const ThreadPool& pool, Append append) {
    append_header_and_names(mesh, append);
    append_all(
        mesh.vertices.size(),
        [&](VertexIndex k, std::string& text) {
            text += "vertex";
            append_point(text, mesh.vertices[k]);
            text += '\n';
        },
        pool, append);
    append_all(
        mesh.block_count(), [&](BlockIndex k, std::string& text) { append_block(text, mesh, k); }, pool,
        append);
    append_end(mesh, append);
}

}  // namespace

std::string block_file_text(const BlockMesh& mesh) {
    std::string out;
    append_block_file(mesh, ThreadPool(), [&](std::string_view text) { out += text; });
    return out;
}

void write_block_file(const std::filesystem::path& path, const BlockMesh& mesh, const ThreadPool& pool) {
    write_pieces_atomically(path, [&](Append append) { append_block_file(mesh, pool, append); });
}

}  // namespace rockslope::blockgen
