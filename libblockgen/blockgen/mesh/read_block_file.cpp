#include <charconv>
#include <limits>
#include <span>

#include "blockgen/mesh/block_file.hpp"
#include "blockgen/mesh/record_scanner.hpp"
#include "common/base/read_file.hpp"

namespace rockslope::blockgen {

namespace {

/// The numbers of records in the counts line.
struct Counts {
    std::int64_t provenance = 0, block_materials = 0, joint_materials = 0, joints = 0, vertices = 0;
    std::int64_t blocks = 0, rings = 0, corners = 0, measured_points = 0, bolts = 0, excavations = 0;
    std::int64_t water_table_points = 0;
};

class BlockFileParser {
  public:
    BlockFileParser(std::string_view text, const std::string& file_name) : scan_(text, file_name) {}

    BlockMesh parse() {
        read_version();
        read_counts();
        reserve();
        read_names("provenance", counts_.provenance, mesh_.provenance);
        read_names("block_material", counts_.block_materials, mesh_.block_materials);
        read_names("joint_material", counts_.joint_materials, mesh_.joint_materials);
        for (std::int64_t i = 0; i < counts_.joints; ++i) read_joint(i);
        for (std::int64_t i = 0; i < counts_.vertices; ++i) read_vertex(i);
        for (std::int64_t i = 0; i < counts_.blocks; ++i) read_block(i);
        check_total("ring", mesh_.ring_corners.size() - 1, counts_.rings);
        check_total("corner", mesh_.corners.size(), counts_.corners);
        for (std::int64_t i = 0; i < counts_.measured_points; ++i) read_measured_point(i);
        for (std::int64_t i = 0; i < counts_.bolts; ++i) read_bolt(i);
        for (std::int64_t i = 0; i < counts_.excavations; ++i) read_excavation(i);
        for (std::int64_t i = 0; i < counts_.water_table_points; ++i) read_water_table_point(i);
        read_end();
        return std::move(mesh_);
    }

  private:
    void read_version() {
        const std::string expected = "'ddablk " + std::to_string(block_file_version) + "' on the first line";
        if (!scan_.next_line()) scan_.fail("the file is empty", expected);
        if (scan_.word(expected) != "ddablk") scan_.fail("this is not a block file", expected);
        version_ = scan_.index("a version", std::numeric_limits<std::int32_t>::max());
        if (version_ > block_file_version)
            scan_.fail("this block file is version " + std::to_string(version_),
                       "at most version " + std::to_string(block_file_version) +
                           ", the newest this program reads; update the program");
        if (version_ < 1) scan_.fail("there is no block file version 0", expected);
        scan_.expect_line_end();
    }

    void read_counts() {
        const std::pair<std::string_view, std::int64_t*> fields[] = {
            {"provenance", &counts_.provenance},
            {"block_materials", &counts_.block_materials},
            {"joint_materials", &counts_.joint_materials},
            {"joints", &counts_.joints},
            {"vertices", &counts_.vertices},
            {"blocks", &counts_.blocks},
            {"rings", &counts_.rings},
            {"corners", &counts_.corners},
            {"measured_points", &counts_.measured_points},
            {"bolts", &counts_.bolts},
            {"excavations", &counts_.excavations},
            {"water_table_points", &counts_.water_table_points},
        };
        constexpr std::size_t fields_of_version[] = {0, 10, 11, 12};
        begin_record("counts", 0, 1);
        for (const auto& [noun, count] : std::span(fields).first(fields_of_version[version_])) {
            if (scan_.word(noun) != noun) scan_.fail("unexpected word in the counts line", std::string(noun));
            *count = scan_.index("a count", std::numeric_limits<std::int32_t>::max());
            // Each record takes at least two bytes; the check keeps a damaged count from exhausting memory.
            if (*count > static_cast<std::int64_t>(scan_.size()) / 2)
                scan_.fail("the file is too short for " + std::to_string(*count) + " " + std::string(noun),
                           "a complete block file");
        }
        scan_.expect_line_end();
    }

    void reserve() {
        const std::size_t blocks = counts_.blocks;
        const std::size_t rings = counts_.rings;
        const std::size_t corners = counts_.corners;
        mesh_.vertices.reserve(counts_.vertices);
        mesh_.joints.reserve(counts_.joints);
        mesh_.corners.reserve(corners);
        mesh_.edge_marks.reserve(corners);
        mesh_.ring_corners.reserve(rings + 1);
        mesh_.block_rings.reserve(blocks + 1);
        mesh_.block_material.reserve(blocks);
        mesh_.motion.reserve(blocks);
        mesh_.motion_name.reserve(blocks);
    }

    /// Moves to the next line, which must start with `keyword`. It is record `done` + 1 of `total`.
    void begin_record(std::string_view keyword, std::int64_t done, std::int64_t total) {
        const auto expected = [&] {
            return std::string(keyword) + " line " + std::to_string(done + 1) + " of " +
                   std::to_string(total);
        };
        if (!scan_.next_line()) scan_.fail("the file is truncated: it ends early", expected());
        const std::string_view word = scan_.word(keyword);
        if (word != keyword) scan_.fail("'" + std::string(word) + "' is out of place", expected());
    }

    void read_names(std::string_view keyword, std::int64_t count, std::vector<std::string>& names) {
        for (std::int64_t i = 0; i < count; ++i) {
            begin_record(keyword, i, count);
            names.push_back(scan_.name("a name"));
            scan_.expect_line_end();
        }
    }

    void read_joint(std::int64_t i) {
        begin_record("joint", i, counts_.joints);
        mesh_.joints.push_back({scan_.name("the name of a joint set")});
        scan_.expect_line_end();
    }

    Point read_point() {
        const double x = scan_.number("an x coordinate");
        return {x, scan_.number("a y coordinate")};
    }

    void read_vertex(std::int64_t i) {
        begin_record("vertex", i, counts_.vertices);
        mesh_.vertices.push_back(read_point());
        scan_.expect_line_end();
    }

    BlockMotion read_motion() {
        const std::string_view word = scan_.word("free, fixed or prescribed");
        if (word == "free") return BlockMotion::free;
        if (word == "fixed") return BlockMotion::fixed;
        if (word == "prescribed") return BlockMotion::prescribed;
        scan_.fail("'" + std::string(word) + "' is not a motion", "free, fixed or prescribed");
    }

    void read_block(std::int64_t i) {
        begin_record("block", i, counts_.blocks);
        const BlockMaterialIndex material = scan_.index("a block material", counts_.block_materials);
        const std::int32_t rings = scan_.index("a number of rings", counts_.rings + 1);
        if (rings < 1) scan_.fail("a block without a ring", "one ring or more");
        const BlockMotion motion = read_motion();
        std::string name = scan_.at_line_end() ? std::string() : scan_.name("a name");
        scan_.expect_line_end();
        mesh_.begin_block(material, motion, std::move(name));
        for (std::int32_t r = 0; r < rings; ++r) read_ring(r, rings);
    }

    void read_ring(std::int32_t r, std::int32_t rings) {
        begin_record("ring", r, rings);
        ring_.clear();
        while (!scan_.at_line_end()) ring_.push_back(scan_.index("a vertex", counts_.vertices));
        if (ring_.size() < 3) scan_.fail("a ring of fewer than three vertices", "three vertices or more");
        begin_record("edges", r, rings);
        marks_.clear();
        while (!scan_.at_line_end()) marks_.push_back(read_mark());
        if (marks_.size() != ring_.size())
            scan_.fail(std::to_string(marks_.size()) + " edges in a ring of " + std::to_string(ring_.size()) +
                           " vertices",
                       "one edge for each vertex");
        mesh_.add_ring(ring_, marks_);
    }

    /// An edge is `-` on a free face, otherwise MATERIAL:JOINT, where the joint may be `-`.
    EdgeMark read_mark() {
        constexpr const char* expected = "'-' or MATERIAL:JOINT";
        const std::string_view word = scan_.word(expected);
        if (word == "-") return {};
        const std::size_t colon = word.find(':');
        if (colon == std::string_view::npos)
            scan_.fail("'" + std::string(word) + "' is not an edge mark", expected);
        const std::string_view joint = word.substr(colon + 1);
        return {read_mark_part(word.substr(0, colon), counts_.joint_materials, "a joint material"),
                joint == "-" ? EdgeMark::no_joint : read_mark_part(joint, counts_.joints, "a joint")};
    }

    std::int32_t read_mark_part(std::string_view digits, std::int64_t limit, const char* noun) {
        std::int32_t value = -1;
        const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
        if (error != std::errc() || end != digits.data() + digits.size() || value < 0 || value >= limit)
            scan_.fail("'" + std::string(digits) + "' is not the index of " + noun,
                       "an integer from 0, below " + std::to_string(limit));
        return value;
    }

    void read_measured_point(std::int64_t i) {
        begin_record("measured_point", i, counts_.measured_points);
        MeasuredPoint point;
        point.name = scan_.name("a name");
        point.block = scan_.index("a block", counts_.blocks);
        point.position = read_point();
        scan_.expect_line_end();
        mesh_.measured_points.push_back(std::move(point));
    }

    void read_bolt(std::int64_t i) {
        begin_record("bolt", i, counts_.bolts);
        Bolt bolt;
        bolt.name = scan_.name("a name");
        bolt.material = scan_.name("a bolt material");
        bolt.first_block = scan_.index("a block", counts_.blocks);
        bolt.first = read_point();
        bolt.second_block = scan_.index("a block", counts_.blocks);
        bolt.second = read_point();
        scan_.expect_line_end();
        mesh_.bolts.push_back(std::move(bolt));
    }

    void read_excavation(std::int64_t i) {
        begin_record("excavation", i, counts_.excavations);
        ExcavatedBlocks excavation;
        excavation.name = scan_.name("a name");
        excavation.stage = scan_.index("a stage", std::numeric_limits<std::int32_t>::max());
        if (excavation.stage < 1) scan_.fail("there is no stage 0", "a stage, counted from 1");
        is_excavated_.resize(mesh_.block_count());
        while (!scan_.at_line_end()) {
            const BlockIndex block = scan_.index("a block", counts_.blocks);
            if (!excavation.blocks.empty() && block <= excavation.blocks.back())
                scan_.fail("block " + std::to_string(block.value()) + " is out of order", "ascending blocks");
            if (is_excavated_[block])
                scan_.fail("block " + std::to_string(block.value()) + " is in two excavations",
                           "at most one excavation per block");
            is_excavated_[block] = true;
            excavation.blocks.push_back(block);
        }
        mesh_.excavations.push_back(std::move(excavation));
    }

    void read_water_table_point(std::int64_t i) {
        begin_record("water_table_point", i, counts_.water_table_points);
        const Point point = read_point();
        if (!mesh_.water_table.empty() && point.x <= mesh_.water_table.back().x)
            scan_.fail("x does not grow along the water table", "points from left to right");
        scan_.expect_line_end();
        mesh_.water_table.push_back(point);
    }

    void check_total(std::string_view noun, std::size_t found, std::int64_t announced) const {
        if (static_cast<std::int64_t>(found) == announced) return;
        scan_.fail("the file contains " + std::to_string(found) + " " + std::string(noun) + "s",
                   std::to_string(announced) + ", the number in the counts line");
    }

    void read_end() {
        begin_record("end", 0, 1);
        scan_.expect_line_end();
        if (scan_.next_line()) scan_.fail("text after the end line", "nothing");
    }

    RecordScanner scan_;
    Counts counts_;
    BlockMesh mesh_;
    std::int32_t version_ = 0;
    std::vector<bool> is_excavated_;
    std::vector<VertexIndex> ring_;
    std::vector<EdgeMark> marks_;
};

}  // namespace

BlockMesh parse_block_file(std::string_view text, const std::string& file_name) {
    return BlockFileParser(text, file_name).parse();
}

BlockMesh read_block_file(const std::filesystem::path& path) {
    return parse_block_file(read_text_file(path), path.string());
}

}  // namespace rockslope::blockgen
