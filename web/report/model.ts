import { ByteReader, readSection, readSeries, readStates, type Series } from "./decode";
import type { MotionData } from "./page_data";

/** The blocks where displacements count from. Corners of block b are corner[first[b]] ... corner[first[b + 1] - 1]. */
export interface Blocks {
    count: number;
    number: Int32Array;
    material: Uint16Array;
    moves: Uint8Array;
    first: Uint32Array;
    /** x and y of each corner from its block's centroid, m. */
    corner: Float32Array;
    /** x and y of each centroid from the origin of the grid, m. */
    centroid: Float64Array;
    /** Distance of the farthest corner from the centroid, m. */
    radius: Float32Array;
}

/** Pairs of blocks in contact, with a line from the centroid of the first. */
export interface Pairs {
    count: number;
    block: Uint32Array;
    other: Uint32Array;
    jointMaterial: Uint16Array;
    /** Number of the joint, -1 for none. */
    joint: Int32Array;
    /** x and y of both ends of each line, m. */
    line: Float32Array;
}

export const enum PairState {
    apart,
    open,
    sliding,
    locked,
}

/** The run as the page shows it. */
export interface Model {
    data: MotionData;
    frames: number;
    blocks: Blocks;
    pairs: Pairs;
    x: Series;
    y: Series;
    rotation: Series;
    /** What colours and labels alone need: nothing until readQuantities() has read it, or if the page has none. */
    stress: Series | null;
    slip: Series | null;
    roughness: Series | null;
    states: Uint8Array;
    removed: Uint8Array | null;
    /** The section: m from the origin of the grid. */
    width: number;
    height: number;
}

function readBlocks(bytes: Uint8Array, count: number, step: number): Blocks {
    const reader = new ByteReader(bytes);
    const blocks: Blocks = {
        count,
        number: new Int32Array(count),
        material: new Uint16Array(count),
        moves: new Uint8Array(count),
        first: new Uint32Array(count + 1),
        corner: new Float32Array(0),
        centroid: new Float64Array(2 * count),
        radius: new Float32Array(count),
    };
    const places: number[] = [];
    let x = 0;
    let y = 0;
    for (let b = 0; b < count; ++b) {
        blocks.number[b] = reader.number();
        const kind = reader.number();
        blocks.material[b] = kind >> 1;
        blocks.moves[b] = kind & 1;
        const corners = reader.number();
        for (let i = 0; i < corners; ++i) places.push((x += reader.signed()) * step, (y += reader.signed()) * step);
        blocks.first[b + 1] = blocks.first[b] + corners;
    }
    blocks.corner = new Float32Array(places.length);
    for (let b = 0; b < count; ++b) placeCentroid(blocks, places, b);
    return blocks;
}

function placeCentroid(blocks: Blocks, places: number[], b: number): void {
    const from = blocks.first[b];
    const to = blocks.first[b + 1];
    const x0 = places[2 * from];
    const y0 = places[2 * from + 1];
    let area = 0;
    let x = 0;
    let y = 0;
    for (let i = from; i < to; ++i) {
        const j = i + 1 < to ? i + 1 : from;
        const px = places[2 * i] - x0;
        const py = places[2 * i + 1] - y0;
        const qx = places[2 * j] - x0;
        const qy = places[2 * j + 1] - y0;
        const part = px * qy - py * qx;
        area += part;
        x += part * (px + qx);
        y += part * (py + qy);
    }
    const cx = area ? x0 + x / (3 * area) : x0;
    const cy = area ? y0 + y / (3 * area) : y0;
    blocks.centroid[2 * b] = cx;
    blocks.centroid[2 * b + 1] = cy;
    for (let i = from; i < to; ++i) {
        blocks.corner[2 * i] = places[2 * i] - cx;
        blocks.corner[2 * i + 1] = places[2 * i + 1] - cy;
        blocks.radius[b] = Math.max(blocks.radius[b], Math.hypot(places[2 * i] - cx, places[2 * i + 1] - cy));
    }
}

function readPairs(bytes: Uint8Array, count: number, step: number): Pairs {
    const reader = new ByteReader(bytes);
    const pairs: Pairs = {
        count,
        block: new Uint32Array(count),
        other: new Uint32Array(count),
        jointMaterial: new Uint16Array(count),
        joint: new Int32Array(count),
        line: new Float32Array(4 * count),
    };
    for (let p = 0; p < count; ++p) {
        pairs.block[p] = reader.number();
        pairs.other[p] = reader.number();
        pairs.jointMaterial[p] = reader.number();
        pairs.joint[p] = reader.number() - 1;
        for (let i = 0; i < 4; ++i) pairs.line[4 * p + i] = reader.signed() * step;
    }
    return pairs;
}

async function section(name: string): Promise<Uint8Array> {
    const bytes = await readSection(name);
    if (!bytes) throw new Error(`the page has no data '${name}'`);
    return bytes;
}

/** What the motion needs; the rest is read by readQuantities(). */
export async function readModel(data: MotionData): Promise<Model> {
    const frames = data.times.length;
    const { blocks: blockCount, pairs: pairCount } = data;
    const ofBlocks = async (name: string) => readSeries(await section(name), blockCount, frames);
    const blocks = readBlocks(await section("blocks"), blockCount, data.grid.step);
    const removed = await readSection("removed");
    let width = 0;
    let height = 0;
    for (let b = 0; b < blocks.count; ++b)
        for (let i = blocks.first[b]; i < blocks.first[b + 1]; ++i) {
            width = Math.max(width, blocks.centroid[2 * b] + blocks.corner[2 * i]);
            height = Math.max(height, blocks.centroid[2 * b + 1] + blocks.corner[2 * i + 1]);
        }
    return {
        data,
        frames,
        blocks,
        pairs: readPairs(await section("pairs"), pairCount, data.grid.step),
        x: await ofBlocks("x"),
        y: await ofBlocks("y"),
        rotation: await ofBlocks("rotation"),
        stress: null,
        slip: null,
        roughness: null,
        states: readStates(await section("states"), pairCount, frames),
        removed: removed && readStates(removed, blockCount, frames),
        width,
        height,
    };
}

/** Reads the quantities of the blocks and the pairs into a model. */
export async function readQuantities(model: Model): Promise<void> {
    const { frames, blocks, pairs } = model;
    model.stress = readSeries(await section("stress"), blocks.count, frames);
    model.slip = readSeries(await section("slip"), pairs.count, frames);
    const roughness = await readSection("roughness");
    model.roughness = roughness && readSeries(roughness, pairs.count, frames);
}
