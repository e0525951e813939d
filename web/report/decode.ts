/** Reads the sections of the page: compressed bytes of numbers, as packed by dda-plot. */

/** Values of several items over the frames: level[item * frames + frame] * step[item]. */
export interface Series {
    step: Float32Array;
    level: Int16Array;
}

function bytesOfBase64(text: string): Uint8Array {
    const decode = (Uint8Array as unknown as { fromBase64?: (t: string) => Uint8Array }).fromBase64;
    if (decode) return decode(text);
    const letters = atob(text);
    const bytes = new Uint8Array(letters.length);
    for (let i = 0; i < letters.length; ++i) bytes[i] = letters.charCodeAt(i);
    return bytes;
}

/** TypeScript 4.8, which is Debian's, does not know the class. */
function inflater(): ReadableWritablePair<Uint8Array, Uint8Array> {
    type Inflater = new (format: "deflate") => ReadableWritablePair<Uint8Array, Uint8Array>;
    const { DecompressionStream } = globalThis as unknown as { DecompressionStream: Inflater };
    return new DecompressionStream("deflate");
}

/** The bytes of a section; nothing when the page has none of that name. Its text is removed from the page. */
export async function readSection(name: string): Promise<Uint8Array | null> {
    const element = document.getElementById("data-" + name);
    if (!element) return null;
    const packed = bytesOfBase64(element.textContent ?? "");
    element.remove();
    const stream = new Blob([packed as BlobPart]).stream().pipeThrough(inflater());
    return new Uint8Array(await new Response(stream).arrayBuffer());
}

/** Reads numbers one after the other. */
export class ByteReader {
    private at = 0;
    constructor(private readonly bytes: Uint8Array) {}

    number(): number {
        let value = 0;
        let factor = 1;
        for (;;) {
            const byte = this.bytes[this.at++];
            value += (byte & 127) * factor;
            if (byte < 128) return value;
            factor *= 128;
        }
    }
    signed(): number {
        const value = this.number();
        return value % 2 ? -(value + 1) / 2 : value / 2;
    }
    floats(count: number): Float32Array {
        const values = new Float32Array(this.bytes.slice(this.at, this.at + 4 * count).buffer);
        this.at += 4 * count;
        return values;
    }
}

export function readSeries(bytes: Uint8Array, items: number, frames: number): Series {
    const reader = new ByteReader(bytes);
    const step = reader.floats(items);
    const level = new Int16Array(items * frames);
    for (let item = 0; item < items; ++item) {
        if (step[item] === 0) continue;
        let value = 0;
        for (let k = item * frames; k < (item + 1) * frames; ++k) level[k] = value += reader.signed();
    }
    return { step, level };
}

export function readStates(bytes: Uint8Array, items: number, frames: number): Uint8Array {
    const reader = new ByteReader(bytes);
    const states = new Uint8Array(items * frames);
    for (let at = 0; at < states.length; ) {
        const word = reader.number();
        const run = Math.floor(word / 4) + 1;
        states.fill(word % 4, at, at + run);
        at += run;
    }
    return states;
}
