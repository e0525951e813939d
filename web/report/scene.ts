import { css, type Rgb } from "./colours";
import { at, type Field } from "./fields";
import { PairState, type Model } from "./model";

/** A place in the frames: frame k, and the part of the way to the next one. */
export interface Instant {
    k: number;
    part: number;
}

/** Where the view looks: its centre, m from the origin of the grid, and pixels for a metre. */
export interface Camera {
    x: number;
    y: number;
    scale: number;
}

/** What the views draw, computed for an instant. */
export class Scene {
    /** Of each block: x and y of the centroid (m), rotation (rad), 1 where it is shown. */
    readonly places: Float32Array;
    readonly blockColours: Uint8Array;
    /** Red, green, blue, and opacity: 0 where a pair is not drawn. */
    readonly pairColours: Uint8Array;
    exaggeration = 1;
    private instant: Instant = { k: 0, part: 0 };

    constructor(
        readonly model: Model,
        public field: Field,
        public showsStates: boolean,
    ) {
        this.places = new Float32Array(4 * model.blocks.count);
        this.blockColours = new Uint8Array(4 * model.blocks.count);
        this.pairColours = new Uint8Array(4 * model.pairs.count);
    }

    update(instant: Instant, rock: Rgb): void {
        this.instant = instant;
        this.placeBlocks();
        this.colourBlocks(rock);
        this.colourPairs();
    }

    private placeBlocks(): void {
        const { model, places, exaggeration } = this;
        const { k, part } = this.instant;
        for (let b = 0; b < model.blocks.count; ++b) {
            places[4 * b] = model.blocks.centroid[2 * b] + exaggeration * at(model.x, model.frames, b, k, part);
            places[4 * b + 1] = model.blocks.centroid[2 * b + 1] + exaggeration * at(model.y, model.frames, b, k, part);
            places[4 * b + 2] = exaggeration * at(model.rotation, model.frames, b, k, part);
            places[4 * b + 3] = model.removed && model.removed[b * model.frames + k] ? 0 : 1;
        }
    }

    private colourBlocks(rock: Rgb): void {
        const { field, blockColours } = this;
        const { k, part } = this.instant;
        for (let b = 0; b < this.model.blocks.count; ++b) {
            const value = field.ofPairs ? null : field.value(b, k, part);
            const colour = value === null ? rock : field.colour(value);
            for (let i = 0; i < 3; ++i) blockColours[4 * b + i] = colour[i];
            blockColours[4 * b + 3] = 255;
        }
    }

    private colourPairs(): void {
        const { model, field, pairColours } = this;
        const { k, part } = this.instant;
        for (let p = 0; p < model.pairs.count; ++p) {
            const colour = field.ofPairs ? this.pairValue(p, k, part) : this.stateColour(p, k);
            pairColours[4 * p + 3] = colour ? 255 : 0;
            if (colour) for (let i = 0; i < 3; ++i) pairColours[4 * p + i] = colour[i];
        }
    }

    private pairValue(p: number, k: number, part: number): Rgb | null {
        const value = this.field.value(p, k, part);
        return value === null ? null : this.field.colour(value);
    }

    private stateColour(p: number, k: number): Rgb | null {
        if (!this.showsStates) return null;
        const state = this.model.states[p * this.model.frames + k];
        if (state === PairState.sliding) return [214, 94, 0];
        return state === PairState.open ? [0, 114, 178] : null;
    }

    /** The size of most blocks, pixels. */
    blockPixels(camera: Camera): number {
        return Math.sqrt((this.model.width * this.model.height) / this.model.blocks.count) * camera.scale;
    }
    /** Whether blocks are so large that lines along them do not hide their colours. */
    hasRoomForOutlines(camera: Camera): boolean {
        return this.blockPixels(camera) > 3;
    }
    /** Whether the lines of pairs are drawn: where the colours are theirs, or hide no others. */
    hasRoomForPairs(camera: Camera): boolean {
        return this.field.ofPairs || this.hasRoomForOutlines(camera);
    }

    /** x of a point of a block from its centroid, m from the origin of the grid. */
    private xOf(b: number, x: number, y: number): number {
        const angle = this.places[4 * b + 2];
        return this.places[4 * b] + x * Math.cos(angle) - y * Math.sin(angle);
    }
    private yOf(b: number, x: number, y: number): number {
        const angle = this.places[4 * b + 2];
        return this.places[4 * b + 1] + x * Math.sin(angle) + y * Math.cos(angle);
    }

    /** The block at a place, m; -1 for none. */
    blockAt(x: number, y: number): number {
        const { blocks } = this.model;
        for (let b = blocks.count - 1; b >= 0; --b) {
            const dx = x - this.places[4 * b];
            const dy = y - this.places[4 * b + 1];
            if (dx * dx + dy * dy > blocks.radius[b] ** 2 || this.places[4 * b + 3] === 0) continue;
            const angle = this.places[4 * b + 2];
            const px = dx * Math.cos(angle) + dy * Math.sin(angle);
            const py = dy * Math.cos(angle) - dx * Math.sin(angle);
            let inside = false;
            for (let i = blocks.first[b], j = blocks.first[b + 1] - 1; i < blocks.first[b + 1]; j = i++) {
                const xi = blocks.corner[2 * i];
                const yi = blocks.corner[2 * i + 1];
                const xj = blocks.corner[2 * j];
                const yj = blocks.corner[2 * j + 1];
                if (yi > py !== yj > py && px < ((xj - xi) * (py - yi)) / (yj - yi) + xi) inside = !inside;
            }
            if (inside) return b;
        }
        return -1;
    }

    /** The pair whose line is nearest to a place, within a distance, m; -1 for none. */
    pairAt(x: number, y: number, within: number): number {
        const { pairs } = this.model;
        let best = -1;
        let nearest = within;
        for (let p = 0; p < pairs.count; ++p) {
            if (this.model.states[p * this.model.frames + this.instant.k] === PairState.apart) continue;
            const b = pairs.block[p];
            if (Math.hypot(x - this.places[4 * b], y - this.places[4 * b + 1]) > this.model.blocks.radius[b] + within)
                continue;
            const [ax, ay, bx, by] = this.lineOf(p);
            const length = (bx - ax) ** 2 + (by - ay) ** 2;
            const along = length > 0 ? Math.min(Math.max(((x - ax) * (bx - ax) + (y - ay) * (by - ay)) / length, 0), 1) : 0;
            const distance = Math.hypot(x - ax - along * (bx - ax), y - ay - along * (by - ay));
            if (distance < nearest) {
                nearest = distance;
                best = p;
            }
        }
        return best;
    }

    lineOf(p: number): [number, number, number, number] {
        const { pairs } = this.model;
        const b = pairs.block[p];
        const [x0, y0, x1, y1] = pairs.line.subarray(4 * p, 4 * p + 4);
        return [this.xOf(b, x0, y0), this.yOf(b, x0, y0), this.xOf(b, x1, y1), this.yOf(b, x1, y1)];
    }

    /** The corners of a block, m: x and y one after the other. */
    ringOf(b: number): number[] {
        const { blocks } = this.model;
        const ring: number[] = [];
        for (let i = blocks.first[b]; i < blocks.first[b + 1]; ++i)
            ring.push(
                this.xOf(b, blocks.corner[2 * i], blocks.corner[2 * i + 1]),
                this.yOf(b, blocks.corner[2 * i], blocks.corner[2 * i + 1]),
            );
        return ring;
    }

    blockColour(b: number): string {
        return css([this.blockColours[4 * b], this.blockColours[4 * b + 1], this.blockColours[4 * b + 2]]);
    }
    pairColour(p: number): string {
        return css([this.pairColours[4 * p], this.pairColours[4 * p + 1], this.pairColours[4 * p + 2]]);
    }
}

/** Draws a scene. */
export interface View {
    draw(scene: Scene, camera: Camera, outline: Rgb): void;
}
