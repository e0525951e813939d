import { Chart } from "./charts";
import { element, section, table } from "./dom";
import { readModel, readQuantities, type Model } from "./model";
import type { PageData } from "./page_data";
import { StageView } from "./stage_view";
import { materialTables } from "./strengths";
import * as units from "./units";
import { checks, energyRows, mechanism, story } from "./words";

const gravity = 9.80665;

/** Charts that are made once their place in the page is known. */
class Charts {
    private readonly made: Chart[] = [];
    private readonly waiting: (() => Chart)[] = [];

    add(make: () => Chart): void {
        this.waiting.push(make);
    }
    make(): void {
        for (const make of this.waiting) this.made.push(make());
    }
    mark(time: number): void {
        for (const chart of this.made) chart.mark(time);
    }
}

/** The time axis of the histories: from the beginning of their stage, if they are of one. */
function timeAxis(page: PageData): { x: string; start: number } {
    const stage = page.history?.stage;
    return stage ? { x: `time of stage '${stage}' (s)`, start: page.history?.time[0] ?? 0 } : { x: "time (s)", start: 0 };
}

function historyPanel(page: PageData, charts: Charts, seek: (time: number) => void): HTMLElement | null {
    const history = page.history;
    if (!history || history.points.length === 0) return null;
    const largest = Math.max(...history.points.flatMap((point) => point.x.map((x, i) => Math.hypot(x, point.y[i]))));
    const [unit, factor] = largest < 1 ? ["mm", 1e3] : ["m", 1];
    const holder = element("div", { id: "history" });
    charts.add(() => new Chart(holder, { ...timeAxis(page), y: `displacement (${unit})`, seek }, history.time,
        history.points.map((point) => ({
            label: point.name,
            values: point.x.map((x, i) => factor * Math.hypot(x, point.y[i])),
        }))));
    return section(history.relative ? "Displacement from the base" : "Displacement", holder);
}

function basePanels(page: PageData, charts: Charts, seek: (time: number) => void): HTMLElement[] {
    const base = page.base_motion;
    if (!base) return [];
    const inGravities = (values: number[]) => values.map((a) => a / gravity);
    const directions = (["x", "y"] as const).filter((direction) => base[direction]);
    const motion = element("div");
    const spectrum = element("div");
    charts.add(() => new Chart(motion, { ...timeAxis(page), y: "acceleration (g)", height: 180, seek }, base.time,
        directions.map((d) => ({ label: d, values: inGravities(base[d]!.acceleration) }))));
    charts.add(() => new Chart(spectrum, { x: "period (s)", y: "acceleration (g)", logarithmic: true, height: 180 }, base.period,
        directions.map((d) => ({ label: d, values: inGravities(base[d]!.spectrum) }))));
    return [section("Motion of the base", motion), section("Response spectrum of the base, 5 % damping", spectrum)];
}

function checksPanel(list: { kind: string; text: string }[]): HTMLElement {
    const items = list.map(({ kind, text }) => element("li", { className: kind, textContent: text }));
    return section("Checks", element("ul", { className: "checks" }, ...items));
}

function movedPanel(page: PageData): HTMLElement | null {
    if (!page.moved?.length) return null;
    const rows = page.moved.map((row) => {
        const text = (column: string) => String(row[column] ?? "");
        const first = text("first slip (s of shaking)");
        const newmark = text("Newmark slip (m)");
        return [
            text("block"),
            text("material"),
            units.length(row.distance),
            units.plain((Number(text("rotation (rad)")) * 180) / Math.PI),
            first && units.plain(Number(first)),
            [text("slipped on block"), text("joint material")].filter(Boolean).join(", "),
            newmark && units.length(Number(newmark)),
        ];
    });
    return section("Blocks that moved most",
        table(["block#", "material", "moved#", "turned (°)#", "first slip (s)#", "slipped on", "Newmark's block#"], rows));
}

function pointsPanel(page: PageData): HTMLElement | null {
    const points = page.summary?.points?.filter((point) => point.kind === "measured point") ?? [];
    if (points.length === 0) return null;
    const maybe = (value: number | null | undefined, text: (v: number) => string) => (value == null ? "" : text(value));
    const rows = points.map((point) => [
        point.name,
        maybe(point.permanent_displacement && Math.hypot(...point.permanent_displacement), units.length),
        maybe(point.peak_relative_displacement, units.length),
        units.speed(point.peak_velocity),
        units.gravities(point.peak_acceleration),
        maybe(point.relative_speed, units.speed),
    ]);
    return section("Measured points", table(
        ["point", "at the end#", "farthest#", "largest speed#", "largest acceleration#", "speed at the end#"], rows));
}

function strengthsPanel(page: PageData): HTMLElement | null {
    if (!page.model) return null;
    const rows = materialTables(page.model).map((material) => [
        material.name,
        material.kind,
        material.values.filter((v) => !v.isDefault).map((v) => `${v.key} ${v.value}`).join(", "),
    ]);
    const whole = element("details", {}, element("summary", { textContent: "The whole model, with every default" }),
        element("pre", { textContent: page.model }));
    return section("Model and strengths", table(["material", "of", "values that the model file gives"], rows), whole);
}

function provenancePanel(page: PageData): HTMLElement {
    const { summary } = page;
    const rows = (summary?.inputs ?? []).map(({ file, sha256 }) => [file, sha256]);
    return section("Provenance",
        element("p", { textContent:
            `Computed by dda-run ${summary?.version ?? ""}, drawn by dda-plot ${page.program}. SI units, for each metre of thickness.` }),
        rows.length ? table(["input", "SHA-256"], rows) : null);
}

/** Waits until the browser has painted; a page that is not in view does not paint. */
function painted(): Promise<void> {
    return new Promise((resolve) => {
        requestAnimationFrame(() => setTimeout(resolve));
        setTimeout(resolve, 200);
    });
}

function panels(page: PageData, model: Model, charts: Charts, seek: (time: number) => void): HTMLElement[] {
    const summary = page.summary;
    return [
        element("div", { className: "two" },
            ...[historyPanel(page, charts, seek), checksPanel(checks(page, model)), ...basePanels(page, charts, seek)]
                .filter((panel): panel is HTMLElement => panel !== null)),
        ...[
            pointsPanel(page),
            movedPanel(page),
            summary ? section("Energy balance", element("div", { className: "narrow" }, table(["", "energy#"], energyRows(summary)))) : null,
            strengthsPanel(page),
            provenancePanel(page),
        ].filter((panel): panel is HTMLElement => panel !== null),
    ];
}

/** The section first, then what is below it, then what costs time and can wait. */
async function start(): Promise<void> {
    const app = document.getElementById("app")!;
    const page = JSON.parse(document.getElementById("data-page")!.textContent!) as PageData;
    const model = await readModel(page.motion);
    const charts = new Charts();
    const view = new StageView(model, (time) => charts.mark(time), mechanism(page));
    app.replaceChildren(
        element("header", {}, element("h1", { textContent: page.name }),
            ...story(page).map((text) => element("p", { textContent: text }))),
        view.holder,
    );
    view.draw();
    await painted();
    const { dataset } = document.documentElement;
    dataset.shown = performance.now().toFixed();
    app.append(...panels(page, model, charts, (time) => view.player.seek(time)));
    charts.make();
    charts.mark(view.player.time);
    await painted();
    await readQuantities(model);
    view.quantitiesRead();
    if (location.hash !== "#canvas") view.accelerate();
    dataset.ready = performance.now().toFixed();
}

start().catch((error: unknown) => {
    document.getElementById("app")!.textContent = `This page cannot be shown: ${String(error)}`;
});
