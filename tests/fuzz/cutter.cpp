// Cuts random slopes with nearly coincident joints until the time is up. Every cut is verified, compared
// with an exact sweep, checked as a mesh and read back from its block file. A failure is reported with its
// seed.
//   fuzz_cutter SECONDS [FIRST_SEED [STEP]]        fuzz_cutter --seeds FILE replays seeds, one per line
#include <cmath>
#include <cstdio>
#include <random>
#include <string>

#include "blockgen/arrangement/arrange.hpp"
#include "blockgen/cut/cut_blocks.hpp"
#include "blockgen/mesh/block_file.hpp"
#include "common/base/input_error.hpp"
#include "fuzz/run_seeds.hpp"

using namespace rockslope;

namespace {

using namespace blockgen;

class RandomSlope {
  public:
    explicit RandomSlope(unsigned long seed) : random_(seed) {}

    SlopeModel model() {
        SlopeModel m;
        m.block_material = "rock";
        m.grid = std::ldexp(1.0, -pick(21));
        const Point corner = pick(4) == 0 ? Point{466000, 6691582} : Point{0, 0};
        shift_ = corner;
        m.outline = {at(0, 0), at(4, 0), at(4, pick(2) == 0 ? 4 : 2.5), at(2, 4), at(0, 4)};
        if (pick(3) == 0) m.holes.push_back(box(1 + fraction(), 1 + fraction(), 0.3 + fraction()));
        for (int k = pick(3); k > 0; --k)
            m.tunnels.push_back({"t", box(4 * fraction(), 4 * fraction(), 1), {}});
        if (pick(3) == 0)
            m.regions.push_back({"r", "soil", "contact", box(4 * fraction() - 1, 4 * fraction() - 1, 2), {}});
        m.islands = static_cast<IslandPolicy>(pick(3));
        m.small_blocks = {static_cast<SmallBlockPolicy>(pick(3)), 0.3 * fraction() * fraction(), 0.02};
        const int joints = 1 + pick(60);
        for (int k = 0; k < joints; ++k) add_joint(m);
        return m;
    }

  private:
    int pick(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }
    /// Uniform in [0, 1).
    double fraction() { return static_cast<double>(random_()) * 0x1p-32; }
    /// Random offset of 5e-3 m to 5e-16 m at most.
    double tiny_offset() { return (fraction() - 0.5) * std::pow(10.0, -2 - pick(14)); }
    Point at(double x, double y) const { return {shift_.x + x, shift_.y + y}; }
    Ring box(double x, double y, double size) {
        return {at(x, y), at(x + size, y), at(x + size, y + size), at(x, y + size)};
    }
    Point random_point() {
        const double x = pick(3) == 0 ? pick(5) : 6 * fraction() - 1;
        const double y = pick(3) == 0 ? pick(5) : 6 * fraction() - 1;
        return at(x, y);
    }
    static Point between(const Point& a, const Point& b, double t) {
        return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
    }

    /// A joint at random, through a common point, along an older joint, or ending on it, each with a tiny
    /// offset.
    void add_joint(SlopeModel& m) {
        Point a = random_point(), b = random_point();
        if (!m.traces.empty()) {
            const auto& old = m.traces[pick(static_cast<int>(m.traces.size()))].points;
            const Point &p = old[0], &q = old[1];
            const int kind = pick(6);
            if (kind == 0) a = between(p, q, fraction());
            if (kind == 1) a = between(p, q, -0.5), b = between(p, q, 1.5 * fraction());
            if (kind == 2) a = p, b = q;
            if (kind == 3) a = at(2, 2), b = between(a, b, 0.7);
            if (kind == 4) a = m.outline[pick(5)];
        }
        a = {a.x + tiny_offset(), a.y + tiny_offset()};
        b = {b.x + tiny_offset(), b.y + tiny_offset()};
        m.traces.push_back({"set " + std::to_string(pick(3)), "joint", {a, b}});
    }

    std::mt19937 random_;
    Point shift_;
};

/// @return what is wrong; empty if nothing is.
std::string failure_of(unsigned long seed) {
    try {
        const SlopeModel model = RandomSlope(seed).model();
        CutOptions options;
        options.verify = true;
        const CutResult result = cut_blocks(model, model.traces, options);
        if (!result.report.area_proved || !result.report.verified)
            return "the area or the cut is not verified";
        const SourceTable table(model);
        const NodedEdges noded = node_joints(source_segments(model, model.traces, table), model.grid);
        const ArrangementSummary swept = summarize(noded, arrange(noded)),
                                 walked = summarize(noded, walk_faces(noded));
        if (swept.twice_areas != walked.twice_areas || swept.adjacency != walked.adjacency)
            return "the face walk and the exact sweep disagree";
        if (!(parse_block_file(block_file_text(result.mesh), "file") == result.mesh))
            return "the block file reads back to another mesh";
    } catch (const InputError&) {
        ++fuzz::refused;  // for example an island of another material
    } catch (const std::exception& error) {
        return error.what();
    }
    return {};
}

bool passes(unsigned long seed) {
    const std::string fault = failure_of(seed);
    if (!fault.empty()) std::printf("seed %lu: %s\n", seed, fault.c_str());
    return fault.empty();
}

}  // namespace

int main(int argc, char** argv) {
    return fuzz::run_seeds(argc, argv, passes);
}
