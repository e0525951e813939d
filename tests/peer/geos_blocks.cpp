#include "peer/geos_blocks.hpp"

#include <geos_c.h>

#include <cstdarg>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string>

namespace rockslope::peer {

namespace {

/// A GEOS session; it must outlive all geometries created in it.
class Session {
  public:
    Session() : handle_(GEOS_init_r()) {
        GEOSContext_setErrorMessageHandler_r(handle_, &Session::note, this);
    }
    ~Session() { GEOS_finish_r(handle_); }
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    using Geometry = std::unique_ptr<GEOSGeometry, void (*)(GEOSGeometry*)>;

    Geometry polyline(const std::vector<Point>& points, bool closed) const {
        const auto n = static_cast<unsigned>(points.size() + (closed ? 1 : 0));
        GEOSCoordSequence* sequence = GEOSCoordSeq_create_r(handle_, n, 2);
        for (unsigned k = 0; k < n; ++k) {
            const Point& p = points[k % points.size()];
            GEOSCoordSeq_setXY_r(handle_, sequence, k, p.x, p.y);
        }
        return owned(GEOSGeom_createLineString_r(handle_, sequence));
    }

    Geometry collection(std::vector<Geometry> parts) const {
        std::vector<GEOSGeometry*> raw;
        for (Geometry& part : parts) raw.push_back(part.release());
        return owned(GEOSGeom_createCollection_r(handle_, GEOS_MULTILINESTRING, raw.data(),
                                                 static_cast<unsigned>(raw.size())));
    }

    Geometry owned(GEOSGeometry* geometry) const {
        if (geometry == nullptr) throw std::runtime_error("GEOS: " + error_);
        // The C interface frees a geometry through its session, which a captureless deleter cannot store.
        thread_local GEOSContextHandle_t current = nullptr;
        current = handle_;
        return {geometry, [](GEOSGeometry* g) { GEOSGeom_destroy_r(current, g); }};
    }

    GEOSContextHandle_t handle() const { return handle_; }

  private:
    static void note(const char* message, void* session) { static_cast<Session*>(session)->error_ = message; }

    GEOSContextHandle_t handle_;
    std::string error_;
};

Point inner_point(const Session& session, const GEOSGeometry* polygon) {
    const auto point = session.owned(GEOSPointOnSurface_r(session.handle(), polygon));
    Point p;
    GEOSGeomGetX_r(session.handle(), point.get(), &p.x);
    GEOSGeomGetY_r(session.handle(), point.get(), &p.y);
    return p;
}

}  // namespace

std::vector<GeosBlock> geos_blocks(const Ring& outline, const std::vector<blockgen::Trace>& traces) {
    const Session session;
    std::vector<Session::Geometry> lines;
    lines.push_back(session.polyline(outline, true));
    for (const blockgen::Trace& trace : traces) lines.push_back(session.polyline(trace.points, false));
    const auto all = session.collection(std::move(lines));
    const auto noded = session.owned(GEOSUnaryUnion_r(session.handle(), all.get()));
    const GEOSGeometry* input[] = {noded.get()};
    const auto faces = session.owned(GEOSPolygonize_r(session.handle(), input, 1));

    std::vector<GeosBlock> blocks;
    const int count = GEOSGetNumGeometries_r(session.handle(), faces.get());
    for (int k = 0; k < count; ++k) {
        const GEOSGeometry* face = GEOSGetGeometryN_r(session.handle(), faces.get(), k);
        GeosBlock block{0, inner_point(session, face)};
        GEOSArea_r(session.handle(), face, &block.area);
        if (side_of_ring(outline, block.inside) > 0) blocks.push_back(block);
    }
    return blocks;
}

}  // namespace rockslope::peer
