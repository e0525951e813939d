#include "support/catalogue.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace rockslope::verification {

const std::array<CatalogueCase, 70> catalogue = {{
    {"V01", "Free fall", "y = -g t²/2, v = -g t"},
    {"V02", "Block at rest", "penetration W / (2 k_n)", false},
    {"V03", "Stress of self-weight", "virial: σ_y = -ρ g h/2, σ_x = 0", false},
    {"V04", "Smooth column of ten blocks", "σ_y(k) = -ρ g h (k - 1/2)", false},
    {"V05", "Uniaxial compression", "Hooke, plane stress and plane strain", false},
    {"V06", "Simple shear", "γ = τ/G", false},
    {"V07", "Chain of blocks and joints", "1/E_eff = 1/E + 1/(k h)", false},
    {"V08", "Sliding on an incline", "s = (sin ψ - cos ψ tan φ) g t²/2"},
    {"V09", "Threshold of sticking", "a = g (sin ψ - cos ψ tan φ) for φ < ψ, none for φ > ψ"},
    {"V10", "Braking by friction", "s = v²/(2 μ g), t = v/(μ g)"},
    {"V11", "Work of friction", "m v²/2"},
    {"V12", "Rectangular pulse on a flat base", "sliding block of Newmark 1965, closed"},
    {"V13", "Half-sine pulse on a flat base", "sliding block, closed up to two transcendental roots"},
    {"V14", "Incline 20°, φ = 30°, 0.3 g at 1 Hz", "one-way sliding block, its equation integrated"},
    {"V15", "Incline 10°, φ = 20°, 0.4 g at 2 Hz", "one-way sliding block, its equation integrated"},
    {"V16", "Shaking table, φ = 20°, 0.1 m at 2 Hz", "two-way sliding block, its equation integrated"},
    {"V17", "Moving base against body force", "d'Alembert: the same relative motion"},
    {"V18", "Yield acceleration", "k_y = tan(φ - ψ)"},
    {"V19", "Modes of a block on an incline", "statics: slides for φ < ψ, topples for b/h < tan ψ"},
    {"V20", "Sliding and toppling together", "Newton's law with the toe as hinge: tan φ_c"},
    {"V21", "Toppling of sixteen blocks", "limit equilibrium of Goodman and Bray 1976"},
    {"V22", "Free rocking, 0.5 m x 2 m", "Housner 1963: I θ'' = -m g R sin(α - θ)"},
    {"V23", "Free rocking, two more blocks", "Housner 1963: I θ'' = -m g R sin(α - θ)"},
    {"V24", "Threshold of uplift", "a = g B/H"},
    {"V25", "Overturning by one sine pulse", "Housner's equation with base acceleration, integrated"},
    {"V26", "Restitution of a penalty contact", "recurrence of Newmark's relations with a one-sided spring"},
    {"V27", "Damping by the time integration", "amplification matrix of Newmark (1/2, 1)"},
    {"V28", "Spinning block", "area, kinetic energy and angle of a rigid turn"},
    {"V29", "Collision of two blocks", "momentum"},
    {"V30", "Wave speed in a chain of blocks", "c² = M/ρ with the modulus of each constraint"},
    {"V31", "Reflection at free and fixed ends", "velocity or stress doubles"},
    {"V32", "Viscous boundary", "R = (Z_b - Z)/(Z_b + Z)"},
    {"V33", "Transmission through one joint", "T = 1/sqrt(1 + (z ω/(2 k))²)"},
    {"V34", "Fixed-free bar", "f₁ = c/(4 L)"},
    {"V35", "Direct shear, Mohr-Coulomb", "τ = c + σ tan φ, then σ tan φ"},
    {"V36", "Barton's strength", "τ = σ tan(JRC log₁₀(JCS/σ) + φ_b)", false},
    {"V37", "Cyclic joint, two cycles", "reference of the cyclic joint law", false},
    {"V38", "Cyclic joint, partial reversals", "reference of the cyclic joint law", false},
    {"V39", "Seismic motions of several blocks", "reference of the cyclic joint law", false},
    {"V40", "Infinite slope", "FS = tan φ/tan ψ + c/(γ z sin ψ cos ψ)"},
    {"V41", "Bolt across a sliding plane", "limit equilibrium of a block on a plane"},
    {"V42", "Elastic bolt", "T = W, elongation W L/(E A)", false},
    {"V43", "Water uplift on a plane", "effective stress"},
    {"V44", "Point load with a history", "m x'' = F sin ω t"},
    {"V45", "Block in a notch", "statics of a wedge between two faces", false},
    {"V46", "Wedge that splits two blocks", "S = P/(2 tan(α + φ))", false},
    {"V47", "Wedge in a roof", "relaxation of Brady and Brown, derived anew"},
    {"V48", "Arch of two blocks", "three hinges: thrust w s²/(8 t)"},
    {"V49", "Semicircular arch", "line of thrust: t/R = 0.1075"},
    {"V50", "Order of the time integration", "Euler and Maclaurin"},
    {"V51", "Isolated pile", "conservation of linear and angular momentum"},
    {"V52", "Readers of records", "number of samples, interval and peak", false},
    {"V53", "Excavation between stages", "weight of the column left; free fall without support", false},
    {"V54", "Normal closure of a joint", "hyperbola of Bandis; energy stored", false},
    {"V55", "Cantilever of glued blocks", "Timoshenko's beam", false},
    {"V56", "Shaken block on a rough joint", "rigid block of two degrees of freedom on the same law"},
    {"P02", "Tilted arch", "limit state of rigid stones: linear inequalities of statics"},
    {"P03", "Least semicircular arch", "limit state of rigid stones: linear inequalities of statics"},
    {"P04", "Overhang of stacked bricks", "statics: L/2 (1 + 1/2 + ... + 1/n)"},
    {"P05", "Toppling of sixteen blocks under a horizontal acceleration",
     "limit equilibrium of Goodman and Bray 1976"},
    {"P06", "Incline 11.37°, φ = 16°, table at 2.66 Hz", "sliding block, its equation integrated"},
    {"P07", "Plane slide with a tension crack and water", "limit equilibrium of Hoek and Bray 1974", false},
    {"P09", "Voussoir beam", "iteration of Beer and Meek 1982, Diederichs and Kaiser 1999", false},
    {"P10", "Rolling polygon", "inelastic impact of corner after corner"},
    {"P11", "Two blocks on a bilinear plane", "two force polygons with one interface force", false},
    {"P12", "Semicircular arch on spreading abutments", "Heyman: three hinges, the least thrust"},
    {"P13", "Stack of five under a rising acceleration", "k = b/h, k = μ"},
    {"P14", "Shaking in both directions; slip at every level of a stack",
     "sliding blocks, their equations integrated"},
    {"P15", "Wave speed in a jointed column", "c² = E_eff/ρ, 1/E_eff = 1/E + 1/(k h)"},
    {"P16", "Impacts at speed", "conservation of momentum; no gain of energy"},
}};

const CatalogueCase& catalogue_case(std::string_view id) {
    const auto found = std::find_if(catalogue.begin(), catalogue.end(),
                                    [&](const CatalogueCase& entry) { return entry.id == id; });
    if (found == catalogue.end())
        throw std::out_of_range("no case '" + std::string(id) + "' in the catalogue");
    return *found;
}

}  // namespace rockslope::verification
