import type { Model } from "./model";
import type { PageData, Summary } from "./page_data";
import * as units from "./units";

/** A sentence about the run. */
export interface Check {
    kind: "fine" | "warning" | "note";
    text: string;
}

const endings: Record<string, string> = {
    completed: "The run is complete",
    "not converged": "The run ended early: a step did not converge",
    "not settled": "The run ended early: a static stage did not come to rest",
    "energy created": "The run ended early: friction returned energy. Do not trust its displacements",
    stopped: "The run was stopped",
    "not written": "The run ended early: its results could not be written",
};

function sentence(text: string): string {
    return text.charAt(0).toUpperCase() + text.slice(1) + (text.endsWith(".") ? "" : ".");
}

/** What happened, in a few sentences. */
export function story(page: PageData): string[] {
    const { summary } = page;
    if (!summary) return ["The run has not ended yet: it has written no summary."];
    const ending = endings[summary.status] ?? `The run ended with the status '${summary.status}'`;
    const lines = [
        `${ending}: ${summary.blocks} blocks, ${summary.steps} steps to t = ${units.plain(summary.time)} s` +
            ` in ${units.plain(summary.wall_time)} s of computing.${summary.message ? " " + sentence(summary.message) : ""}`,
    ];
    const points = (summary.points ?? []).filter((point) => point.kind === "measured point");
    const far = points
        .map((point) => ({ point, distance: Math.hypot(...(point.permanent_displacement ?? [0, 0])) }))
        .sort((a, b) => b.distance - a.distance)[0];
    if (far && far.distance > 0)
        lines.push(
            `Point '${far.point.name}' moved farthest: ${units.length(far.distance)} from ` +
                `${summary.reference ?? "where it was"} at the end.`,
        );
    const slip = summary.first_slip;
    if (slip)
        lines.push(
            `${slip.blocks} blocks slipped; block ${slip.first} first, ` +
                `${units.plain(slip.first_time_of_shaking)} s after shaking began.`,
        );
    const safety = safetyText(summary);
    if (safety) lines.push(safety);
    return lines;
}

/** What is known of the factor of safety; nothing for a run that did not look for it. */
function safetyText(summary: Summary): string | null {
    const safety = summary.factor_of_safety;
    if (!safety) return null;
    const { stands, fails } = safety;
    if (stands !== null && fails !== null)
        return (
            `Factor of safety ${units.factor(Math.sqrt(stands * fails))}: the slope stands with strengths divided by ` +
            `${units.factor(stands)}, and fails at ${units.factor(fails)}. The last frame shows the mechanism.`
        );
    if (stands !== null) return `Factor of safety above ${units.factor(stands)}: no trial failed.`;
    return fails !== null ? `Factor of safety below ${units.factor(fails)}: no trial stood.` : null;
}

/** What the last frame shows in a strength reduction; empty for other runs. */
export function mechanism(page: PageData): string {
    const safety = page.summary?.factor_of_safety;
    if (!safety || safety.stands === null || safety.fails === null) return "";
    return `mechanism, factor of safety ${units.factor(Math.sqrt(safety.stands * safety.fails))}`;
}

/** Checks of the numbers, each in plain words. */
export function checks(page: PageData, model: Model): Check[] {
    return [...numerics(page, model), ...energies(page), ...motions(page)];
}

function medianSize(model: Model): number {
    const { blocks } = model;
    const sizes = Array.from(blocks.radius).filter((_, b) => blocks.moves[b]);
    sizes.sort((a, b) => a - b);
    return sizes.length ? 2 * sizes[Math.floor(sizes.length / 2)] : 0;
}

function numerics(page: PageData, model: Model): Check[] {
    const depth = page.penetration;
    if (depth == null) return [];
    const part = depth / medianSize(model);
    const size = `${units.length(depth)}, ${units.percent(part)} of a block's size`;
    if (part < 2e-3) return [{ kind: "fine", text: `Largest penetration in the last stage ${size}: fine.` }];
    const advice = "a larger normal_penalty or a penetration_tolerance makes it smaller";
    return [{ kind: part < 1e-2 ? "note" : "warning", text: `Largest penetration in the last stage ${size}: ${advice}.` }];
}

function energies(page: PageData): Check[] {
    const energy = page.summary?.energy;
    const turned = energy?.turned_over ?? 0;
    if (!energy || !(turned > 0)) return [];
    const list: Check[] = [];
    const missing = Math.abs(energy.residual) / turned;
    list.push({
        kind: missing < 1e-2 ? "fine" : "warning",
        text:
            `The energy balance closes to ${units.percent(missing)} of what was turned over` +
            (missing < 1e-2 ? ": fine." : ": too much; take smaller steps."),
    });
    const returned = energy.friction_returned / turned;
    list.push({
        kind: returned < 1e-3 ? "fine" : "warning",
        text:
            returned < 1e-3
                ? "Friction returned no energy."
                : `Friction returned ${units.percent(returned)} of the energy turned over, which it cannot: ` +
                  "displacements may be wrong by more than that.",
    });
    const damped = energy.numerical_loss / turned;
    list.push({
        kind: damped < 0.2 ? "note" : "warning",
        text:
            `The integration took ${units.percent(damped)} of the energy turned over` +
            (damped < 0.2 ? "." : ": smaller steps would damp less."),
    });
    return list;
}

function motions(page: PageData): Check[] {
    const list: Check[] = [];
    for (const point of page.summary?.points ?? []) {
        if (point.kind !== "measured point" || !((point.relative_speed ?? 0) > 0.01)) continue;
        list.push({
            kind: "warning",
            text: `Point '${point.name}' still moves at ${units.speed(point.relative_speed ?? 0)} at the end: run longer.`,
        });
    }
    if (page.summary && page.summary.status !== "completed")
        list.unshift({ kind: "warning", text: (endings[page.summary.status] ?? page.summary.status) + "." });
    return list;
}

const shares: [string, string][] = [
    ["external_work", "loads and base motion put in"],
    ["friction_loss", "friction took"],
    ["damping_loss", "viscous damping of the rock took"],
    ["contact_damping_loss", "dashpots of contacts took"],
    ["numerical_loss", "the integration took"],
    ["boundary_loss", "viscous boundaries took"],
    ["kinetic", "is kinetic at the end"],
    ["strain", "strains the blocks at the end"],
    ["contact", "is in the springs of contacts at the end"],
];

/** Rows of the energy balance: what, and how much. */
export function energyRows(summary: Summary): string[][] {
    const { energy } = summary;
    const rows: string[][] = [["gravity gave", units.energy(-energy.gravity)]];
    for (const [key, words] of shares) if (energy[key]) rows.push([words, units.energy(energy[key])]);
    rows.push(["left unexplained", units.energy(energy.residual)]);
    return rows;
}
