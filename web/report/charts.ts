import uPlot from "../vendor/uplot/uPlot.esm";
import { lineColours } from "./colours";
import { element, themed } from "./dom";
import { plain } from "./units";

export interface Curve {
    label: string;
    values: number[];
}

/** A chart of curves over a common abscissa. */
export class Chart {
    private readonly plot: uPlot;
    /** Whether the abscissa is the time of the run. */
    private readonly isLinked: boolean;
    /** What is taken off the abscissa. */
    private readonly start: number;
    private readonly now = element("div", { className: "now" });

    constructor(
        readonly holder: HTMLElement,
        options: { x: string; y: string; logarithmic?: boolean; height?: number; seek?: (x: number) => void; start?: number },
        abscissa: number[],
        curves: Curve[],
    ) {
        this.start = options.start ?? 0;
        this.isLinked = options.seek !== undefined;
        const ink = () => themed("--dim");
        const grid = { stroke: () => themed("--line"), width: 1 };
        const value = (_: uPlot, v: number | null) => (v === null ? "" : plain(v));
        const axis = { stroke: ink, grid, ticks: grid, font: "12px system-ui, sans-serif", labelFont: "12px system-ui, sans-serif" };
        this.plot = new uPlot(
            {
                width: this.width(),
                height: options.height ?? 230,
                scales: { x: { time: false, distr: options.logarithmic ? 3 : 1 } },
                axes: [
                    { ...axis, label: options.x, labelSize: 20, size: 34 },
                    { ...axis, label: options.y, labelSize: 20, size: 56 },
                ],
                cursor: { drag: { x: true, y: false } },
                legend: { live: true },
                series: [
                    { label: options.x, value },
                    ...curves.map((curve, k) => ({
                        label: curve.label,
                        value,
                        stroke: lineColours[k % lineColours.length],
                        width: 1.4,
                        points: { show: false },
                    })),
                ],
            },
            [abscissa.map((x) => x - this.start), ...curves.map((curve) => curve.values)] as uPlot.AlignedData,
            holder,
        );
        if (options.seek) {
            this.plot.over.append(this.now);
            this.plot.over.addEventListener("click", (event) => options.seek?.(this.plot.posToVal(event.offsetX, "x") + this.start));
        }
        new ResizeObserver(() => this.plot.setSize({ width: this.width(), height: options.height ?? 230 })).observe(holder);
        matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.plot.redraw());
    }

    private width(): number {
        return Math.max(this.holder.clientWidth, 240);
    }

    /** Marks a time, if the chart is over time. */
    mark(x: number): void {
        if (!this.isLinked) return;
        const place = this.plot.valToPos(x - this.start, "x");
        const inside = place >= 0 && place <= this.plot.over.clientWidth;
        this.now.style.display = inside ? "" : "none";
        if (inside) this.now.style.left = `${place}px`;
        // The legend has the values of that time, unless the pointer asks for another one.
        if ((this.plot.cursor.left ?? -1) < 0) this.plot.setLegend({ idx: this.plot.valToIdx(x - this.start) });
    }
}
