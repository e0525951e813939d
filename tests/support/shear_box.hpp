#pragma once

#include "support/cyclic_joints.hpp"
#include "support/scene.hpp"

namespace rockslope::scene {

/// A joint of 0.1 m in the direct shear test of Ma et al. (2017), Fig. 4, and its load.
struct ShearedRock {
    dda::CyclicBartonBandis law;
    double normal_stress;    ///< Pa
    double strength;         ///< Pa, at the peak
    double shear_stiffness;  ///< N/m per metre, of one of the joint's two contacts
};
inline ShearedRock sheared_granite() {
    return {joint_tests::granite(), 1e6, 1.92024e6, 7.681e7};
}
inline ShearedRock sheared_marble() {
    return {joint_tests::marble(), 0.5e6, 1.13060e6, 1.884e8};
}

/// The shear test as two blocks. The upper one, 0.1 m wide, is fixed along the joint at its lower corners and
/// loaded normal to it. The lower one moves; it is wide enough for the joint to keep its length.
class ShearBox {
  public:
    static constexpr double length = 0.1;  ///< m, of the joint

    /// Readings of the test, relative to the settled start.
    struct Reading {
        double displacement = 0;  ///< m, of the lower block relative to the upper one
        double stress = 0;        ///< Pa
        double dilation = 0;      ///< m
    };

    explicit ShearBox(const ShearedRock& rock) : sim_(scene_of(rock)) {
        settled_ = sim_.settle().status == dda::RunStatus::completed;
        height_ = corner().y();
    }
    bool settled() const { return settled_; }

    /// Moves the lower block by `displacement`, m, in equal increments, m, and calls observe(reading) after
    /// each.
    dda::RunOutcome go(double displacement, double increment,
                       const std::function<void(const Reading&)>& observe) {
        dda::Stage stage;
        stage.name = "shear";
        stage.control.step = 1e-3;
        stage.duration = std::abs(displacement) / increment * stage.control.step;
        stage.dynamic_coefficient = 0;
        sim_.velocity(lower)[0] = std::copysign(increment / stage.control.step, displacement);
        sim_.on_step = [&](const dda::State&, const dda::StepReport&) { observe(reading()); };
        return sim_.run(stage);
    }
    Reading reading() const {
        Reading now{sim_.moved(lower).x() - corner().x(), 0, corner().y() - height_};
        for (const dda::Contact& contact : sim_.state.contacts.contacts)
            now.stress += contact.shear_force / length;
        return now;
    }
    double frequency_step() const { return sim_.contact_frequency_step(); }

  private:
    static constexpr int lower = 0, upper = 1, upper_corner = 4;

    const Vec2& corner() const { return sim_.state.blocks.vertices[upper_corner]; }

    static Scene scene_of(const ShearedRock& rock) {
        Scene s;
        s.model.gravity.setZero();
        s.model.joint_materials[0].law = rock.law;
        s.model.joint_materials[0].shear_penalty = rock.shear_stiffness;
        s.model.block_materials[0].poissons_ratio = 0;
        s.box({-0.1, -0.1}, 0.3, 0.1, dda::Motion::prescribed, 0, "lower");
        s.box({0, 0}, length, length);
        const double half_load = rock.normal_stress * length / 2;
        for (const double x : {0.0, length}) {
            s.model.fixed_points.push_back({s.material_point(upper, {x, 0}), true, false});
            s.model.loads.push_back(
                dda::PointLoad{s.material_point(upper, {x, length}), {0, -half_load}, {}});
        }
        return s;
    }

    Simulation sim_;
    bool settled_ = false;
    double height_ = 0;  ///< m, of the upper block's corner at the start
};

}  // namespace rockslope::scene
