import { CanvasView } from "./canvas_view";
import { css, gradient, materialColours, type Rgb } from "./colours";
import type { Series } from "./decode";
import { element, themed } from "./dom";
import { at, fieldsOf, paleOfLines, type Field } from "./fields";
import { GlView } from "./gl_view";
import type { Model } from "./model";
import { Player } from "./player";
import { Scene, type Camera, type View } from "./scene";
import * as units from "./units";

function rgbOf(property: string): Rgb {
    const digits = themed(property).replace("#", "");
    const wide = digits.length === 3 ? digits.replace(/./g, "$&$&") : digits;
    return [0, 2, 4].map((i) => parseInt(wide.slice(i, i + 2), 16)) as Rgb;
}

/** The section in motion, with its controls. */
export class StageView {
    readonly holder = element("section");
    readonly player: Player;
    private fields: Field[];
    private readonly scene: Scene;
    private view: View;
    private readonly camera: Camera = { x: 0, y: 0, scale: 1 };
    private canvas = element("canvas");
    private readonly when = element("div", { className: "when" });
    private readonly legend = element("div", { className: "legend" });
    private readonly scaleBar = element("div", { className: "scale" });
    private readonly tip = element("div", { className: "tip" });
    private readonly frame = element("div", { className: "view" }, this.canvas, this.when, this.legend, this.scaleBar, this.tip);
    private readonly playButton = element("button", { id: "play", textContent: "▶ Play", type: "button" });
    private readonly scrub = element("input", { id: "time", type: "range", step: "any" });
    private readonly fieldChoice = element("select", { id: "field" });
    private drawn = false;
    private fitted = true;

    constructor(
        private readonly model: Model,
        private readonly onTime: (time: number) => void,
        private readonly mechanism: string,
    ) {
        this.fields = fieldsOf(model);
        this.scene = new Scene(model, this.fields[0], true);
        this.player = new Player(model.data.times, () => this.timeChanged());
        this.canvas.dataset.kind = "canvas";
        this.view = new CanvasView(this.canvas);
        this.holder.append(this.frame, this.controls());
        this.listen();
    }

    private controls(): HTMLElement {
        const { player } = this;
        Object.assign(this.scrub, { min: String(player.start), max: String(player.end), value: String(player.time) });
        const speed = element("select", { id: "speed" });
        for (const factor of [0.1, 0.25, 0.5, 1, 2, 4, 8])
            speed.append(element("option", { value: String(factor), textContent: `× ${factor}`, selected: factor === 1 }));
        const colour = this.fieldChoice;
        this.offerFields();
        const factor = element("input", { id: "exaggeration", className: "factor", type: "range", min: "0", max: "2", step: "0.01", value: "0" });
        const factorText = element("span", { textContent: "× 1" });
        const states = element("input", { id: "states", type: "checkbox", checked: true });
        const fit = element("button", { type: "button", textContent: "Fit" });
        this.playButton.addEventListener("click", () => player.toggle());
        this.scrub.addEventListener("input", () => player.seek(Number(this.scrub.value)));
        speed.addEventListener("change", () => (player.speed = Number(speed.value)));
        colour.addEventListener("change", () => this.choose(this.fields.find((field) => field.name === colour.value)!));
        factor.addEventListener("input", () => {
            this.scene.exaggeration = Number((10 ** Number(factor.value)).toPrecision(2));
            factorText.textContent = `× ${this.scene.exaggeration}`;
            this.invalidate();
        });
        states.addEventListener("change", () => {
            this.scene.showsStates = states.checked;
            this.choose(this.scene.field);
        });
        fit.addEventListener("click", () => this.fit());
        return element("div", { className: "controls" }, this.playButton,
            element("label", { className: "time" }, "time", this.scrub),
            element("label", {}, "speed", speed), element("label", {}, "colour", colour),
            element("label", {}, states, "open and sliding joints"),
            element("label", {}, "displacements", factor, factorText), fit);
    }

    private offerFields(): void {
        const options = this.fields.map((field) => element("option", { value: field.name, textContent: field.title }));
        this.fieldChoice.replaceChildren(...options);
        this.fieldChoice.value = this.scene.field.name;
    }

    /** Offers the quantities that the model has by now. */
    quantitiesRead(): void {
        this.fields = fieldsOf(this.model);
        this.offerFields();
        this.choose(this.fields.find((field) => field.name === this.scene.field.name)!);
    }

    /** Draws by WebGL2 from now on, if the browser has it: its start takes half a second where there is no graphics card. */
    accelerate(): void {
        const canvas = element("canvas");
        const gl = GlView.on(canvas, this.model);
        if (!gl) return;
        canvas.addEventListener("webglcontextlost", () => this.use(element("canvas"), null));
        this.use(canvas, gl);
    }

    /** Draws on another canvas: one with a context of one kind gives none of the other. */
    private use(canvas: HTMLCanvasElement, gl: GlView | null): void {
        canvas.dataset.kind = gl ? "webgl2" : "canvas";
        this.view = gl ?? new CanvasView(canvas);
        this.canvas.replaceWith(canvas);
        this.canvas = canvas;
        this.resize();
    }

    private choose(field: Field): void {
        this.scene.field = field;
        this.drawLegend();
        this.invalidate();
    }

    private drawLegend(): void {
        const { field } = this.scene;
        const key = (colour: Rgb | string, text: string) => {
            const mark = element("span", { className: "key" });
            mark.style.background = typeof colour === "string" ? colour : css(colour);
            return element("span", {}, mark, text);
        };
        this.legend.replaceChildren(element("div", { textContent: field.title }));
        if (field.largest > 0) {
            const bar = element("div", { className: "bar" });
            bar.style.background = gradient(field.ofPairs ? paleOfLines : 0);
            this.legend.append(bar, element("div", { className: "ends" }, "0",
                element("span", { textContent: field.text(field.largest / 2) }),
                element("span", { textContent: field.text(field.largest) })));
        } else if (field.name === "material") {
            this.model.data.materials.forEach((name, k) => this.legend.append(key(materialColours[k % 8], name)));
        } else {
            for (const state of [1, 2, 3]) this.legend.append(key(field.colour(state), field.text(state)));
        }
        if (!field.ofPairs && this.scene.showsStates)
            this.legend.append(element("div", {}, key([214, 94, 0], "sliding"), key([0, 114, 178], "open joint")));
    }

    private listen(): void {
        const { frame, camera } = this;
        new ResizeObserver(() => this.resize()).observe(frame);
        const toModel = (event: MouseEvent): [number, number] => {
            const box = frame.getBoundingClientRect();
            return [
                camera.x + (event.clientX - box.left - box.width / 2) / camera.scale,
                camera.y - (event.clientY - box.top - box.height / 2) / camera.scale,
            ];
        };
        frame.addEventListener("wheel", (event) => {
            event.preventDefault();
            const [x, y] = toModel(event);
            const factor = Math.exp(-0.0015 * event.deltaY);
            camera.x = x + (camera.x - x) / factor;
            camera.y = y + (camera.y - y) / factor;
            camera.scale *= factor;
            this.fitted = false;
            this.invalidate();
        }, { passive: false });
        let dragged: [number, number] | null = null;
        frame.addEventListener("pointerdown", (event) => {
            dragged = [event.clientX, event.clientY];
            frame.setPointerCapture(event.pointerId);
        });
        frame.addEventListener("pointerup", () => (dragged = null));
        frame.addEventListener("pointerleave", () => (this.tip.style.display = "none"));
        frame.addEventListener("pointermove", (event) => {
            if (dragged) {
                camera.x -= (event.clientX - dragged[0]) / camera.scale;
                camera.y += (event.clientY - dragged[1]) / camera.scale;
                dragged = [event.clientX, event.clientY];
                this.fitted = false;
                this.invalidate();
            }
            this.showTip(event, toModel(event));
        });
        frame.addEventListener("dblclick", () => this.fit());
        for (const query of ["(prefers-color-scheme: dark)", "print"])
            matchMedia(query).addEventListener("change", () => this.draw());
        document.addEventListener("keydown", (event) => {
            if (event.target instanceof HTMLInputElement || event.target instanceof HTMLSelectElement) return;
            if (event.target instanceof HTMLButtonElement && event.key === " ") return;
            if (event.key === " ") this.player.toggle();
            else if (event.key === "ArrowRight" || event.key === "ArrowLeft") this.step(event.key === "ArrowRight" ? 1 : -1);
            else return;
            event.preventDefault();
        });
    }

    private step(by: number): void {
        const { times } = this.model.data;
        const k = Math.min(Math.max(this.player.instant().k + by, 0), times.length - 1);
        this.player.seek(times[k]);
    }

    private showTip(event: PointerEvent, [x, y]: [number, number]): void {
        const { scene, tip } = this;
        const lines: string[] = [];
        const pair = scene.pairAt(x, y, 6 / this.camera.scale);
        if (pair >= 0) lines.push(this.pairText(pair));
        const block = scene.blockAt(x, y);
        if (block >= 0) lines.push(this.blockText(block));
        tip.style.display = lines.length ? "block" : "none";
        tip.textContent = lines.join("\n");
        const box = this.frame.getBoundingClientRect();
        const left = event.clientX - box.left + 14;
        tip.style.left = `${Math.min(left, box.width - tip.offsetWidth - 6)}px`;
        tip.style.top = `${Math.min(event.clientY - box.top + 14, box.height - tip.offsetHeight - 6)}px`;
    }

    private blockText(b: number): string {
        const { model } = this;
        const { k, part } = this.player.instant();
        const value = (series: Series) => at(series, model.frames, b, k, part);
        const moved = Math.hypot(value(model.x), value(model.y));
        const turned = (value(model.rotation) * 180) / Math.PI;
        return (
            `block ${model.blocks.number[b]}, ${model.data.materials[model.blocks.material[b]] ?? ""}\n` +
            `  moved ${units.length(moved)}, turned ${units.plain(turned)}°` +
            (model.stress ? `, compression ${units.stress(-value(model.stress))}` : "")
        );
    }

    private pairText(p: number): string {
        const { model } = this;
        const { k, part } = this.player.instant();
        const joint = model.data.joints[model.pairs.joint[p]];
        const material = model.data.joint_materials[model.pairs.jointMaterial[p]] ?? "";
        const state = ["apart", "open", "sliding", "locked"][model.states[p * model.frames + k]];
        const numbers = [model.pairs.block[p], model.pairs.other[p]].map((b) => model.blocks.number[b]).sort((a, b) => a - b);
        const rough = model.roughness ? at(model.roughness, model.frames, p, k, part) : 0;
        return (
            `joint ${joint ? `'${joint}', ` : ""}${material}, between blocks ${numbers[0]} and ${numbers[1]}\n` +
            `  ${state}` +
            (model.slip ? `, slip ${units.length(at(model.slip, model.frames, p, k, part))}` : "") +
            (rough ? `, roughness left ${units.percent(rough)}` : "")
        );
    }

    private fit(): void {
        const { camera, model, frame } = this;
        camera.x = model.width / 2;
        camera.y = model.height / 2;
        camera.scale = Math.min(frame.clientWidth / (1.06 * model.width), (frame.clientHeight - 20) / (1.1 * model.height));
        this.fitted = true;
        this.invalidate();
    }

    private resize(): void {
        const ratio = Math.max(1, devicePixelRatio);
        this.canvas.width = Math.round(this.frame.clientWidth * ratio);
        this.canvas.height = Math.round(this.frame.clientHeight * ratio);
        if (this.fitted) this.fit();
        this.draw();
    }

    private timeChanged(): void {
        const { player } = this;
        this.playButton.textContent = player.playing ? "❚❚ Pause" : "▶ Play";
        this.scrub.value = String(player.time);
        this.onTime(player.time);
        this.invalidate();
    }

    private invalidate(): void {
        if (this.drawn) requestAnimationFrame(() => this.draw());
        this.drawn = false;
    }

    /** The stage that is shown, and the time since it began. */
    private title(k: number): string {
        const { stages, times } = this.model.data;
        if (this.mechanism && k === times.length - 1) return `${stages[k]}: ${this.mechanism}`;
        let first = k;
        while (first > 0 && stages[first - 1] === stages[k]) --first;
        const time = (this.player.time - times[first]).toFixed(2);
        return stages[k] ? `${stages[k]}: ${time} s` : `t = ${time} s`;
    }

    draw(): void {
        this.drawn = true;
        const instant = this.player.instant();
        this.when.textContent = this.title(instant.k);
        if (!this.legend.hasChildNodes()) this.drawLegend();
        this.scene.update(instant, rgbOf("--rock"));
        this.view.draw(this.scene, this.camera, rgbOf("--outline"));
        const length = units.roundAbove(60 / this.camera.scale);
        this.scaleBar.style.width = `${length * this.camera.scale}px`;
        this.scaleBar.textContent = units.length(length);
    }
}
