#include "dda/monitor/measured_joint.hpp"
#include "dda/writers/csv_writer.hpp"

namespace rockslope::dda {

namespace {

constexpr const char* joint_quantities[] = {"displacement (m)",
                                            "dilation (m)",
                                            "shear stress over bearing length (Pa)",
                                            "normal stress over bearing length (Pa)",
                                            "strength (Pa)",
                                            "slip (m)",
                                            "state",
                                            "stage",
                                            "mobilised ratio",
                                            "reversals",
                                            "cycle",
                                            "shear stress over whole joint (Pa)",
                                            "normal stress over whole joint (Pa)"};

const char* state_name(ContactState state) {
    switch (state) {
        case ContactState::open:
            return "open";
        case ContactState::sliding:
            return "sliding";
        case ContactState::locked:
            return "locked";
    }
    return "";
}

class JointsCsv : public CsvWriter {
  public:
    explicit JointsCsv(const WriterContext& context)
        : CsvWriter(context, "joints.csv"), model_(context.model) {
        if (!context.resume_from) table().append(heading());
    }

    void history(const State& state, const Stage& stage) override {
        CsvRow row = table().row();
        row.number(state.time, "the time").text(stage.name);
        for (const MeasuredJoint& joint : model_.measured_joints) {
            const JointReading reading = read_joint(model_, state, joint);
            const std::string what = "the joint '" + joint.name + "'";
            for (const double value : {reading.displacement, reading.dilation, reading.shear_stress,
                                       reading.normal_stress, reading.strength, reading.slip})
                row.number(value, what);
            row.text(state_name(reading.state)).text(stage_name(reading.record.stage));
            row.number(reading.record.mobilised_ratio, what);
            row.integer(reading.record.reversals).integer(reading.record.cycle);
            row.number(reading.shear_stress_over_joint, what).number(reading.normal_stress_over_joint, what);
        }
        table().append(row.line());
    }

  private:
    std::string heading() const {
        CsvRow row = table().row();
        row.text("time (s)").text("stage");
        for (const MeasuredJoint& joint : model_.measured_joints)
            for (const char* quantity : joint_quantities) row.text(joint.name + " " + quantity);
        return row.line();
    }

    const Model& model_;
};

}  // namespace

WriterEntry joints_csv() {
    return {"measured joints", "joints.csv", PositionUnit::bytes,
            [](const WriterContext& context) { return !context.model.measured_joints.empty(); },
            make_writer<JointsCsv>};
}

}  // namespace rockslope::dda
