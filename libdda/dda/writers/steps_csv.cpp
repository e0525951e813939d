#include "dda/writers/csv_writer.hpp"

namespace rockslope::dda {

namespace {

constexpr const char* step_headings[] = {"time (s)",
                                         "stage",
                                         "step (s)",
                                         "iterations",
                                         "factorizations",
                                         "fallbacks",
                                         "cuts",
                                         "open",
                                         "sliding",
                                         "locked",
                                         "largest penetration (m)",
                                         "dilation left (m)",
                                         "largest displacement (m)",
                                         "unbalanced force (weight)",
                                         "omega_contact dt",
                                         "kinetic (J/m)",
                                         "strain (J/m)",
                                         "contact (J/m)",
                                         "constraint (J/m)",
                                         "gravity (J/m)",
                                         "friction loss (J/m)",
                                         "damping loss (J/m)",
                                         "contact damping loss (J/m)",
                                         "numerical loss (J/m)",
                                         "released (J/m)",
                                         "boundary loss (J/m)",
                                         "excavated (J/m)",
                                         "external work (J/m)",
                                         "residual (J/m)"};

class StepsCsv : public CsvWriter {
  public:
    explicit StepsCsv(const WriterContext& context) : CsvWriter(context, "steps.csv") {
        if (context.resume_from) return;
        CsvRow row = table().row();
        for (const char* heading : step_headings) row.text(heading);
        table().append(row.line());
    }

    void step(const State& state, const Stage& stage, const StepReport& report) override {
        const Energy& e = state.energy;
        CsvRow row = table().row();
        row.number(report.time, "the time").text(stage.name).number(report.step, "the step");
        for (const int count : {report.iterations, report.factorizations, report.fallbacks, report.cuts,
                                report.open, report.sliding, report.locked})
            row.integer(count);
        for (const double value :
             {report.largest_penetration, report.remaining_dilation, report.largest_displacement,
              report.unbalanced_force, report.contact_frequency_step})
            row.number(value, "a figure of the step");
        for (const double value : {e.kinetic, e.strain, e.contact, e.constraint, e.gravity, e.friction_loss,
                                   e.damping_loss, e.contact_damping_loss, e.numerical_loss, e.released,
                                   e.boundary_loss, e.excavated, e.external_work, e.residual()})
            row.number(value, "an energy");
        table().append(row.line());
    }
};

}  // namespace

WriterEntry steps_csv() {
    return {"steps", "steps.csv", PositionUnit::bytes,
            [](const WriterContext& context) { return context.step_log; }, make_writer<StepsCsv>};
}

}  // namespace rockslope::dda
