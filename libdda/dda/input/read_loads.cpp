#include "dda/input/read_loads.hpp"

#include <optional>
#include <type_traits>

#include "common/base/read_file.hpp"
#include "common/base/text.hpp"
#include "dda/input/read_face_loads.hpp"
#include "dda/input/read_materials.hpp"
#include "dda/input/read_mesh.hpp"
#include "record/two_columns.hpp"

namespace rockslope::dda {

namespace {

Vec2 vector_of(const std::array<double, 2>& pair) {
    return {pair[0], pair[1]};
}

/// The point `at = [x, y]`, in the model's coordinates.
Vec2 read_place(const ConfigTable& table, const Model& model) {
    return vector_of(table.pair("at", Dimension::length)) - model.origin;
}

std::string point_text(const Vec2& point) {
    return "[" + shortest_text(point.x()) + ", " + shortest_text(point.y()) + "]";
}

BlockIndex block_at(const ConfigTable& table, const Vec2& point, const Model& model) {
    const std::optional<BlockIndex> block = find_block(model, point);
    if (!block)
        table.fail("at",
                   "'at' in [" + table.path() + "] is " + point_text(point + model.origin) +
                       ", where there is no block",
                   "a point inside a block");
    return *block;
}

BlockIndex block_index(const ConfigTable& table, const Model& model) {
    const std::int64_t block = table.integer("block");
    if (block < 0 || block >= model.block_count())
        table.fail("block", "'block' in [" + table.path() + "] is " + std::to_string(block),
                   "an index from 0 to " + std::to_string(model.block_count() - 1));
    return block;
}

PointIndex measured_point(const ConfigTable& table, const Model& model) {
    const std::string name = table.string("measured_point");
    std::vector<std::string> names;
    for (const MeasuredPointSpec& point : model.measured_points) {
        if (point.name == name) return point.point;
        names.push_back(point.name);
    }
    const auto nearest = nearest_word(name, names);
    table.fail("measured_point", "there is no measured point '" + name + "' in the block file",
               nearest ? "perhaps '" + *nearest + "'"
                       : "the name of one of its " + std::to_string(names.size()) + " measured points");
}

/// The material point named by `measured_point = NAME` or `at = [x, y]`.
PointIndex read_point(const ConfigTable& table, Model& model) {
    if (table.has("measured_point")) return measured_point(table, model);
    const Vec2 point = read_place(table, model);
    return add_material_point(model, block_at(table, point, model), point);
}

/// The table of a load, passed to the load's `read`: values in SI, indices of the model.
class LoadTable {
  public:
    LoadTable(const ConfigTable& table, std::span<const Point> water_table, Model& model, InputFiles& files)
        : table_(table), water_table_(water_table), model_(model), files_(files) {}

    /// `measured_point = NAME` or `at = [x, y]`.
    PointIndex point() { return read_point(table_, model_); }
    /// `block = INDEX` or `at = [x, y]`.
    BlockIndex block() const { return read_block(table_, model_); }
    /// The same; none, for all blocks, if the table has neither key.
    BlockIndex block_or_all() const {
        return table_.has("block") || table_.has("at") ? block() : BlockIndex::none();
    }
    double number(std::string_view key) const { return table_.number(key); }
    Vec2 force(std::string_view key) const { return vector_of(table_.pair(key, Dimension::force)); }
    Vec2 acceleration(std::string_view key) const {
        return vector_of(table_.pair(key, Dimension::acceleration));
    }
    double pressure(std::string_view key) const { return positive(table_, key, Dimension::stress); }
    double unit_weight_of_water() const {
        return positive(table_, "unit_weight", Dimension::none, water_unit_weight);
    }
    LineLoad line_load() const { return read_line_load(table_, model_, files_); }
    std::vector<EdgeIndex> wetted_joints() const { return read_wetted_faces(table_, model_, false); }
    std::vector<EdgeIndex> wetted_faces() const { return read_wetted_faces(table_, model_, true); }
    std::vector<Vec2> head() const { return read_head(table_, water_table_, model_); }
    /// The optional table `history`; the factor 1 if it is absent.
    TimeTable history() const { return read_history(table_, files_); }

  private:
    const ConfigTable& table_;
    std::span<const Point> water_table_;
    Model& model_;
    InputFiles& files_;
};

template <class... Loads>
void read_each_load(std::type_identity<std::variant<Loads...>>, const ConfigTable& run,
                    std::span<const Point> water_table, Model& model, InputFiles& files) {
    const auto read_all = [&]<class AnyLoad>(std::type_identity<AnyLoad>) {
        for (const ConfigTable& config : run.array_of_tables(AnyLoad::key)) {
            LoadTable table(config, water_table, model, files);
            model.loads.emplace_back(AnyLoad::read(table));
        }
    };
    (read_all(std::type_identity<Loads>{}), ...);
}

void read_fixed_points(const ConfigTable& run, Model& model) {
    for (const ConfigTable& table : run.array_of_tables("fixed_point")) {
        FixedPoint point;
        point.point = read_point(table, model);
        const std::string direction = table.choice("direction", {"both", "x", "y"}, "both");
        point.hold_x = direction != "y";
        point.hold_y = direction != "x";
        model.fixed_points.push_back(point);
    }
}

void read_initial_velocities(const ConfigTable& run, Model& model) {
    for (const ConfigTable& table : run.array_of_tables("initial_velocity")) {
        model.initial_velocity.resize(model.block_count(), Vec6::Zero());
        const BlockIndex block = read_block(table, model);
        if (model.motion[block] != Motion::free)
            table.fail("velocity",
                       "'velocity' in [" + table.path() + "] is of block " + std::to_string(block.value()) +
                           ", whose motion is fixed or prescribed",
                       "a block that is free to move");
        Vec6& velocity = model.initial_velocity[block];
        velocity.head<2>() = vector_of(table.pair("velocity", Dimension::velocity));
        velocity[2] = table.number("angular_velocity", Dimension::none, 0);
    }
}

TimeTable checked_times(const std::vector<double>& times, const std::vector<double>& values,
                        const ConfigTable& table) {
    if (times.size() != values.size() || times.empty())
        table.fail("values",
                   "'values' in [" + table.path() + "] has " + std::to_string(values.size()) +
                       " entries and 'times' " + std::to_string(times.size()),
                   "as many values as times, at least one");
    for (std::size_t i = 1; i < times.size(); ++i)
        if (times[i] <= times[i - 1])
            table.fail("times",
                       "'times' in [" + table.path() + "] do not increase at entry " + std::to_string(i + 1),
                       "strictly increasing times");
    return {times, values};
}

}  // namespace

TimeTable read_history(const ConfigTable& table, InputFiles& files) {
    const auto history = table.optional_table("history");
    return history ? read_time_table(*history, Dimension::none, files) : TimeTable{};
}

BlockIndex read_block(const ConfigTable& table, const Model& model) {
    if (table.has("block")) return block_index(table, model);
    return block_at(table, read_place(table, model), model);
}

TimeTable read_time_table(const ConfigTable& table, Dimension dimension, InputFiles& files) {
    if (!table.has("file"))
        return checked_times(table.numbers("times", Dimension::time), table.numbers("values", dimension),
                             table);
    const std::filesystem::path file = table.file_path("file");
    files.push_back(file);
    const std::string text = read_text_file(file);
    const record::TwoColumns columns = record::parse_two_columns(record::RecordLines(text, file.string()));
    return {columns.times, columns.values};
}

void read_loads(const ConfigTable& run, std::span<const Point> water_table, Model& model, InputFiles& files) {
    read_each_load(std::type_identity<Load>{}, run, water_table, model, files);
    read_fixed_points(run, model);
    read_initial_velocities(run, model);
}

}  // namespace rockslope::dda
