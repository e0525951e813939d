#include "dda/io/csv_file.hpp"
#include "dda/io/point_motion.hpp"
#include "dda/io/result_writer.hpp"

namespace dda {

namespace {

class HistoryCsv : public ResultWriter {
  public:
    explicit HistoryCsv(const WriterContext& context)
        : model_(context.model),
          points_(tracked_points(context.model)),
          file_(context.folder / "history.csv", context.resume_from) {
        if (!context.resume_from) file_.append(heading());
    }

    void history(const State& state, const Stage& stage) override {
        CsvRow row = file_.row();
        row.number(state.time, "the time").text(stage.name);
        for (const TrackedPoint& point : points_) {
            const PointMotion motion = motion_of(model_, state, point);
            for (const Vec2& v : {motion.displacement, motion.velocity, motion.acceleration})
                row.number(v.x(), "the motion of '" + point.name + "'")
                    .number(v.y(), "the motion of '" + point.name + "'");
        }
        file_.append(row.line());
    }
    std::int64_t position() const override { return file_.size(); }

  private:
    std::string heading() const {
        CsvRow row = file_.row();
        row.text("time (s)").text("stage");
        for (const TrackedPoint& point : points_)
            for (const char* quantity :
                 {" ux (m)", " uy (m)", " vx (m/s)", " vy (m/s)", " ax (m/s2)", " ay (m/s2)"})
                row.text((point.block >= 0 ? "prescribed " : "") + point.name + quantity);
        return row.line();
    }

    const Model& model_;
    std::vector<TrackedPoint> points_;
    CsvFile file_;
};

}  // namespace

std::unique_ptr<ResultWriter> make_history_csv(const WriterContext& context) {
    return std::make_unique<HistoryCsv>(context);
}

}  // namespace dda
