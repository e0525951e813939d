// A block slides over a floor that is cut at random places; its own face has straight corners. It must slide
// as on an undivided floor: contacts are transferred from edge to edge all the time, with their forces and
// histories.

#include <gtest/gtest.h>

#include <algorithm>

#include "support/random_shapes.hpp"
#include "support/scene.hpp"

namespace rockslope::slide_over_joints_test {
namespace {

using namespace scene;

constexpr double duration = 1;   // s
constexpr double step = .002;    // s
constexpr double floor_end = 4;  // m, from the slider's lower corner at the start

/// The random parameters of a slide, with coordinates along the floor and normal to it, m.
struct Slide {
    double slope = 0;     ///< rad
    double friction = 0;  ///< rad
    double speed = 0;     ///< m/s, at the start
    double width = 0, height = 0;
    std::vector<double> own;   ///< straight corners in the slider's lower face
    std::vector<double> cuts;  ///< of the floor, ascending
    std::vector<double> thickness;
    bool neighbours = false;  ///< the cuts divide the floor; else straight corners

    Vec2 along() const { return {std::cos(slope), -std::sin(slope)}; }
    Vec2 up() const { return dda::perpendicular(along()); }
};

Slide random_slide(unsigned seed) {
    RandomSource random(seed);
    Slide s;
    s.slope = random.between(0, radians(15));
    s.friction = random.between(radians(16), radians(40));
    s.speed = random.between(1, 2);
    s.width = random.between(.3, 1.5);
    s.height = random.between(.1, .3) * s.width;
    for (unsigned k = random.index_below(4); k > 0; --k) s.own.push_back(random.between(.01, .99) * s.width);
    std::sort(s.own.begin(), s.own.end());
    // Some cuts are so close that several are passed in one step.
    for (double x = -.5; x < floor_end; x += random.magnitude(.002, 2)) s.cuts.push_back(x);
    for (std::size_t k = 0; k <= s.cuts.size(); ++k) s.thickness.push_back(random.between(.5, 1));
    s.neighbours = random.index_below(2) == 0;
    return s;
}

Slide undivided(Slide s) {
    s.own.clear();
    s.cuts.clear();
    s.neighbours = false;
    return s;
}

Ring placed_on(const Slide& slide, const Ring& ring) {
    return placed(ring, -slide.slope, Vec2(0, 0));
}

void add_floor(const Slide& slide, Scene& s) {
    std::vector<double> ends{-2};
    ends.insert(ends.end(), slide.cuts.begin(), slide.cuts.end());
    ends.push_back(floor_end + 2);
    if (!slide.neighbours) {
        Ring ring{{ends.front(), -1}, {ends.back(), -1}};
        for (auto x = ends.rbegin(); x != ends.rend(); ++x) ring.emplace_back(*x, 0);
        s.block({placed_on(slide, ring)}, dda::Motion::fixed);
        return;
    }
    for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
        const double bottom = -slide.thickness[k];
        s.block(
            {placed_on(slide, {{ends[k], bottom}, {ends[k + 1], bottom}, {ends[k + 1], 0}, {ends[k], 0}})},
            dda::Motion::fixed);
    }
}

Scene built(const Slide& slide, const dda::JointLaw& law) {
    Scene s;
    s.model.joint_materials[0].law = law;
    Ring ring{{0, 0}};
    for (const double x : slide.own) ring.emplace_back(x, 0);
    ring.insert(ring.end(), {{slide.width, 0}, {slide.width, slide.height}, {0, slide.height}});
    s.block({placed_on(slide, ring)});
    add_floor(slide, s);
    return s;
}

/// The slider is the first block. It is settled and then gets its initial velocity.
class Motion {
  public:
    Motion(const Slide& slide, const dda::JointLaw& law) : slide_(slide), sim_(built(slide, law)) {
        EXPECT_EQ(sim_.settle(.005, 1e-8).status, dda::RunStatus::completed);
        start_ = centroid();
        sim_.velocity(0).head<2>() += slide.speed * slide.along();
        sim_.restart_ledger();
        sim_.on_step = [this](const dda::State& state, const dda::StepReport&) { record(state); };
        dda::Stage stage;
        stage.duration = duration;
        stage.control.step = step;
        stage.control.force_tolerance = 1e-10;
        const dda::RunOutcome outcome = sim_.run(stage);
        EXPECT_EQ(outcome.status, dda::RunStatus::completed) << outcome.message;
    }

    /// The displacement of the slider since its start, m.
    double slid() const { return (centroid() - start_).dot(slide_.along()); }
    /// The number of distinct corner-edge pairs in contact with the slider.
    std::size_t pairs() const { return pairs_.size(); }
    /// The penetration of one contact under the weight of the slider, m.
    double penetration() const { return sim_.state.blocks.mass[0] * g / sim_.model.normal_penalty; }

  private:
    Vec2 centroid() const { return sim_.state.blocks.moments[0].centroid; }

    void record(const dda::State& state) {
        for (const dda::Contact& c : state.contacts.contacts) {
            if ((c.corner_block != 0 && c.edge_block != 0) || c.state == dda::ContactState::open) continue;
            const std::pair pair(c.corner, c.edge);
            if (std::find(pairs_.begin(), pairs_.end(), pair) == pairs_.end()) pairs_.push_back(pair);
        }
    }

    Slide slide_;
    Simulation sim_;
    Vec2 start_{0, 0};
    std::vector<std::pair<dda::CornerIndex, dda::EdgeIndex>> pairs_;
};

class SlideOverJoints : public testing::TestWithParam<unsigned> {
  protected:
    const Slide slide = random_slide(GetParam());
};

// Friction is proportional to the normal force, so the cuts can change the displacement only by the
// deformation of the contacts, once for each run.
TEST_P(SlideOverJoints, IsBrakedByFrictionAlone) {
    const dda::MohrCoulomb law{slide.friction, 0, 0, slide.friction, 0};
    const Motion cut(slide, law);
    const Motion uncut(undivided(slide), law);
    EXPECT_GT(cut.pairs(), uncut.pairs());
    EXPECT_GT(uncut.slid(), .05) << "m, it must pass joints";
    EXPECT_NEAR(cut.slid(), uncut.slid(), 2 * uncut.penetration());
}

// Friction decreases with the slip, and new contacts start at residual friction. A new contact inherits the
// slip of its face except for that of the last step: at most 4 mm of the 0.8 m over which half of the
// friction is lost, 0.25 % of the friction of one of two to five contacts. Without inheritance six of twenty
// runs were wrong by more than 0.1 %.
TEST_P(SlideOverJoints, InheritsItsSlip) {
    dda::Weakening law;
    law.friction_angle = slide.friction;
    law.residual_friction_angle = slide.friction / 2;
    law.slip = .8;
    const Motion cut(slide, law);
    const Motion uncut(undivided(slide), law);
    EXPECT_NEAR(cut.slid(), uncut.slid(), 1e-3 * uncut.slid());
}

INSTANTIATE_TEST_SUITE_P(Seeds, SlideOverJoints, testing::Range(1U, 21U), testing::PrintToStringParamName());

}  // namespace
}  // namespace rockslope::slide_over_joints_test
