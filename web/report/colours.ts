/** Colours of values: the same scale as the pictures of dda-plot. */
export type Rgb = [number, number, number];

const sequence: Rgb[] = [
    [0xfd, 0xf3, 0xdc],
    [0xf7, 0xcf, 0x8f],
    [0xe9, 0x92, 0x5a],
    [0xc8, 0x50, 0x3f],
    [0x7f, 0x1d, 0x3f],
];

export const materialColours: Rgb[] = [
    [0xe3, 0xd5, 0xbd],
    [0xc3, 0xce, 0xd2],
    [0xd3, 0xdc, 0xc0],
    [0xe0, 0xc4, 0xba],
    [0xcd, 0xc6, 0xda],
    [0xea, 0xd9, 0xa6],
    [0xbc, 0xd5, 0xcd],
    [0xd9, 0xcf, 0xca],
];

export const lineColours = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#b8860b", "#56b4e9", "#7b3294", "#808080"];
export const openColour: Rgb = [0, 114, 178];
export const slidingColour: Rgb = [214, 94, 0];
export const lockedColour: Rgb = [120, 120, 124];

/** The colour at a position from 0 to 1, clamped. */
export function scaleColour(position: number): Rgb {
    const along = Math.min(Math.max(position, 0), 1) * (sequence.length - 1);
    const k = Math.min(Math.floor(along), sequence.length - 2);
    const part = along - k;
    const mix = (i: number) => sequence[k][i] + part * (sequence[k + 1][i] - sequence[k][i]);
    return [mix(0), mix(1), mix(2)];
}

export function css([red, green, blue]: Rgb): string {
    return `rgb(${Math.round(red)},${Math.round(green)},${Math.round(blue)})`;
}

/** The scale as a background, with its palest part left out where lines would not be seen. */
export function gradient(pale: number): string {
    const stops = [0, 0.25, 0.5, 0.75, 1].map((t) => css(scaleColour(pale + (1 - pale) * t)));
    return `linear-gradient(to right, ${stops.join(", ")})`;
}
