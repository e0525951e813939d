#include "dda/terms/loads.hpp"

namespace rockslope::dda {

void visit_tractions(const Model& model, const MidStep& mid, const LineLoad& load,
                     const TractionVisit& visit) {
    for (const LoadedFace& loaded : load.faces) {
        for (const FacePoint& point : face_points(model, mid, loaded.face)) {
            // The traction of Eq. (54).
            const double pressure =
                loaded.pressure_from + point.fraction * (loaded.pressure_to - loaded.pressure_from);
            const Vec2 traction =
                loaded.traction_from + point.fraction * (loaded.traction_to - loaded.traction_from);
            visit(point, traction - pressure * point.normal);
        }
    }
}

}  // namespace rockslope::dda
