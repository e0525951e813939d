#include "dda/monitor/point_motion.hpp"
#include "dda/writers/csv_writer.hpp"

namespace rockslope::dda {

namespace {

/// The motion of the tracked points, absolute or relative to one of them.
class HistoryCsv : public CsvWriter {
  public:
    HistoryCsv(const WriterContext& context, const char* file, const std::string& relative_to)
        : CsvWriter(context, file), model_(context.model) {
        points_ = tracked_points(context.model);
        if (const auto reference = find_point(points_, relative_to)) {
            reference_ = points_[*reference];
            points_.erase(points_.begin() + static_cast<std::ptrdiff_t>(*reference));
        }
        if (!context.resume_from) table().append(heading());
    }

    void history(const State& state, const Stage& stage) override {
        CsvRow row = table().row();
        row.number(state.time, "the time").text(stage.name);
        const PointMotion reference_motion =
            reference_ ? motion_of(model_, state, *reference_) : PointMotion{};
        for (const TrackedPoint& point : points_) {
            const PointMotion motion = relative(motion_of(model_, state, point), reference_motion);
            for (const Vec2& v : {motion.displacement, motion.velocity, motion.acceleration})
                row.number(v.x(), "the motion of '" + point.name + "'")
                    .number(v.y(), "the motion of '" + point.name + "'");
        }
        table().append(row.line());
    }

  private:
    static PointMotion relative(const PointMotion& point, const PointMotion& to) {
        return {point.displacement - to.displacement, point.velocity - to.velocity,
                point.acceleration - to.acceleration};
    }
    std::string heading() const {
        CsvRow row = table().row();
        row.text("time (s)").text("stage");
        for (const TrackedPoint& point : points_)
            for (const char* quantity :
                 {" ux (m)", " uy (m)", " vx (m/s)", " vy (m/s)", " ax (m/s2)", " ay (m/s2)"})
                row.text((point.block >= 0 ? "prescribed " : "") + point.name + quantity);
        return row.line();
    }

    const Model& model_;
    std::vector<TrackedPoint> points_;
    std::optional<TrackedPoint> reference_;
};

std::unique_ptr<ResultWriter> make_history_csv(const WriterContext& context) {
    return std::make_unique<HistoryCsv>(context, "history.csv", "");
}

std::unique_ptr<ResultWriter> make_relative_csv(const WriterContext& context) {
    return std::make_unique<HistoryCsv>(context, "relative.csv", context.relative_to);
}

}  // namespace

WriterEntry history_csv() {
    return {"history", "history.csv", PositionUnit::bytes, is_always_written, make_history_csv};
}

WriterEntry relative_csv() {
    return {"relative", "relative.csv", PositionUnit::bytes,
            [](const WriterContext& context) { return !context.relative_to.empty(); }, make_relative_csv};
}

}  // namespace rockslope::dda
