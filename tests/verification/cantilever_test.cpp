// A cantilever cut into glued blocks: triangles bend, rectangles do not.

#include <gtest/gtest.h>

#include "support/record.hpp"
#include "support/scene.hpp"

namespace rockslope::cantilever_test {
namespace {

using namespace scene;
using namespace verification;

enum class Cut { rectangles, crossed_triangles };

/// A cantilever of 20 m x 2 m under its weight, cut into square cells.
class Cantilever {
  public:
    /// @param rows of cells over the height. @param stiffness of the glue times the length of a cell over
    /// Young's modulus.
    Cantilever(Cut cut, int rows, double stiffness, dda::Plane plane = dda::Plane::stress)
        : sim_(scene(cut, rows, stiffness, plane)) {
        dda::Stage stage;
        stage.kind = dda::StageKind::static_equilibrium;
        stage.step_limit = 500;
        stage.control.step = .05;
        stage.reset_displacements = false;
        settled_ = sim_.run(stage).status == dda::RunStatus::completed;
    }
    bool settled() const { return settled_; }
    /// m, sinking of the lower corner at the free end.
    double deflection() const {
        for (const dda::CornerIndex k : sim_.model.topology.corners()) {
            const Vec2& at = sim_.model.vertices[k];
            if ((at - Vec2(length, 0)).norm() < 1e-9) return -sim_.state.blocks.vertices[k].y();
        }
        return 0;
    }
    double frequency_step() const { return sim_.contact_frequency_step(); }
    /// Bending and shear of a beam: w L^4/8EI + w L^2/(2 5/6 G A).
    static double timoshenko(dda::Plane plane = dda::Plane::stress) {
        const double bending = plane == dda::Plane::stress ? modulus : modulus / (1 - .25 * .25);
        const double weight = 2500 * g * height;
        const double inertia = std::pow(height, 3) / 12;
        const double shear_modulus = modulus / 2 / 1.25;
        return weight * std::pow(length, 4) / (8 * bending * inertia) +
               weight * length * length / (2 * 5. / 6 * shear_modulus * height);
    }

  private:
    static constexpr double length = 20;     // m
    static constexpr double height = 2;      // m
    static constexpr double modulus = 10e9;  // Pa, of the catalogue's rock

    static Scene scene(Cut cut, int rows, double stiffness, dda::Plane plane) {
        const double cell = height / rows;
        Scene s;
        s.model.plane = plane;
        s.model.joint_materials[0] = elastic_joint(stiffness * modulus / cell, stiffness * modulus / cell);
        std::vector<Vec2> wall = {{-1, 0}};
        for (int j = 0; j <= rows; ++j) wall.emplace_back(0, j * cell);
        wall.emplace_back(-1, height);
        s.block({wall}, dda::Motion::fixed);
        const auto node = [&](double i, double j) { return Vec2(i * cell, j * cell); };
        for (int i = 0; i < 10 * rows; ++i) {
            for (int j = 0; j < rows; ++j) {
                const std::vector<Vec2> corners = {node(i, j), node(i + 1, j), node(i + 1, j + 1),
                                                   node(i, j + 1)};
                if (cut == Cut::rectangles) {
                    s.block({corners});
                    continue;
                }
                for (std::size_t k = 0; k < 4; ++k)
                    s.block({{corners[k], corners[(k + 1) % 4], node(i + .5, j + .5)}});
            }
        }
        return s;
    }
    Simulation sim_;
    bool settled_ = false;
};

// V55. Uniform strain cannot follow a curvature. Crossed triangles are finite elements of the lowest order:
// two rows of cells, joined without compliance, are 16 % too stiff and four rows 4.5 %. Glue of k h = 12 E
// adds to two rows what they lack. The deflection is that of Timoshenko's beam with the shear correction 5/6,
// in plane strain with E/(1 - nu^2).
TEST(Cantilever, OfCrossedTrianglesBends) {
    const auto expect_deflection = [](int rows, double stiffness, dda::Plane plane) {
        const Cantilever beam(Cut::crossed_triangles, rows, stiffness, plane);
        const std::string set_up = to_text(10 * rows) + " x " + to_text(rows) +
                                   " cells of four triangles, k h/E = " + to_text(stiffness) +
                                   (plane == dda::Plane::stress ? ", plane stress" : ", plane strain");
        Case row("V55", set_up, "required");
        row.contact_frequency_step(beam.frequency_step());
        row.expect_outcome("static stage", beam.settled() ? "settles" : "does not", "settles");
        row.expect("deflection", "m", beam.deflection(), Cantilever::timoshenko(plane), relative(.05));
    };
    for (const dda::Plane plane : {dda::Plane::stress, dda::Plane::strain}) expect_deflection(2, 12, plane);
    expect_deflection(4, 100, dda::Plane::stress);
    expect_deflection(4, 1000, dda::Plane::stress);
    const auto inform = [](Cut cut, double stiffness, const std::string& set_up) {
        const Cantilever beam(cut, 2, stiffness);
        EXPECT_TRUE(beam.settled()) << set_up;
        Case("V55", set_up, "for comparison")
            .inform("deflection", "m", beam.deflection(), Cantilever::timoshenko());
    };
    inform(Cut::crossed_triangles, 1000, "20 x 2 cells of four triangles, k h/E = 1000, plane stress");
    inform(Cut::rectangles, 12, "20 x 2 rectangles, k h/E = 12, plane stress");
}

}  // namespace
}  // namespace rockslope::cantilever_test
