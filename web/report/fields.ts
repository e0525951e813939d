import { lockedColour, materialColours, openColour, scaleColour, slidingColour, type Rgb } from "./colours";
import type { Series } from "./decode";
import { PairState, type Model } from "./model";
import * as units from "./units";

/** A quantity that colours blocks or joints. */
export interface Field {
    name: string;
    title: string;
    ofPairs: boolean;
    /** Value of an item at frame k and a part of the way to the next; nothing: no colour. */
    value(item: number, k: number, part: number): number | null;
    text(value: number): string;
    /** Value at the dark end; 0 where the colours are not a scale. */
    readonly largest: number;
    colour(value: number): Rgb;
}

/** Part of the scale left out at its pale end for lines. */
export const paleOfLines = 0.25;

export function at(series: Series, frames: number, item: number, k: number, part: number): number {
    const first = item * frames + k;
    const from = series.level[first];
    const to = k + 1 < frames ? series.level[first + 1] : from;
    return series.step[item] * (from + part * (to - from));
}

/** A round value that 99 % of the items do not exceed in a hundred of the frames. */
function largestOf(count: number, frames: number, value: (item: number, k: number) => number): number {
    const largest = new Float64Array(count);
    const stride = Math.max(1, Math.floor(frames / 100));
    for (let item = 0; item < count; ++item)
        for (let k = (frames - 1) % stride; k < frames; k += stride) largest[item] = Math.max(largest[item], Math.abs(value(item, k)));
    largest.sort();
    const end = largest[Math.min(count - 1, Math.floor(0.99 * count))] || largest[count - 1];
    return end > 0 ? units.roundAbove(end) : 1e-3;
}

/** The quantities that have been read. */
export function fieldsOf(model: Model): Field[] {
    const { frames, data, blocks, pairs } = model;
    const times = data.times;
    const displacement = (b: number, k: number, part: number) =>
        Math.hypot(at(model.x, frames, b, k, part), at(model.y, frames, b, k, part));
    const velocity = (b: number, k: number) => {
        const from = Math.min(k, frames - 2);
        const span = times[from + 1] - times[from];
        if (from < 0 || span <= 0 || data.stages[from] !== data.stages[from + 1]) return 0;
        const dx = at(model.x, frames, b, from + 1, 0) - at(model.x, frames, b, from, 0);
        const dy = at(model.y, frames, b, from + 1, 0) - at(model.y, frames, b, from, 0);
        return Math.hypot(dx, dy) / span;
    };
    /** A field of a scale, whose end is found when it is first asked for: not all fields are looked at. */
    const scaled = (name: string, title: string, ofPairs: boolean, value: Field["value"], text: Field["text"], find: () => number): Field => {
        let largest: number | null = null;
        const pale = ofPairs ? paleOfLines : 0;
        const end = () => (largest ??= find());
        return {
            name,
            title,
            ofPairs,
            value,
            text,
            get largest() {
                return end();
            },
            colour: (v) => scaleColour(pale + ((1 - pale) * v) / end()),
        };
    };
    const ofBlocks = (name: string, title: string, value: Field["value"], text: Field["text"]): Field =>
        scaled(name, title, false, value, text,
            () => largestOf(blocks.count, frames, (b, k) => (blocks.moves[b] ? (value(b, k, 0) ?? 0) : 0)));
    const touches = (p: number, k: number) => model.states[p * frames + k] !== PairState.apart;
    const { stress, slip, roughness } = model;
    const fields: Field[] = [
        ofBlocks("displacement", "displacement from the base", displacement, units.length),
        ofBlocks("velocity", "velocity between frames, from the base", velocity, units.speed),
        ...(stress
            ? [ofBlocks("stress", "largest compression", (b, k, part) => Math.max(0, -at(stress, frames, b, k, part)), units.stress)]
            : []),
        {
            name: "material",
            title: "material",
            ofPairs: false,
            value: (b) => blocks.material[b],
            text: (m) => data.materials[m] ?? String(m),
            largest: 0,
            colour: (m) => materialColours[m % materialColours.length],
        },
        ...(slip
            ? [scaled("slip", "slip of joints", true, (p, k, part) => (touches(p, k) ? at(slip, frames, p, k, part) : null), units.length,
                () => largestOf(pairs.count, frames, (p, k) => at(slip, frames, p, k, 0)))]
            : []),
        {
            name: "state",
            title: "state of joints",
            ofPairs: true,
            value: (p, k) => (touches(p, k) ? model.states[p * frames + k] : null),
            text: (s) => ["", "open", "sliding", "locked"][s],
            largest: 0,
            colour: (s) => (s === PairState.open ? openColour : s === PairState.sliding ? slidingColour : lockedColour),
        },
    ];
    if (roughness)
        fields.push(scaled("roughness", "roughness left: mobilised over peak", true,
            (p, k, part) => at(roughness, frames, p, k, part) || null, units.plain, () => 1));
    return fields;
}
