/** Numbers with a unit that suits them. */

function significant(value: number): string {
    if (value === 0) return "0";
    const size = Math.abs(value);
    if (size >= 1e5 || size < 1e-3) return value.toExponential(2).replace("e", " × 10^").replace("^+", "^");
    return String(Number(value.toPrecision(3)));
}

export function length(metres: number): string {
    const size = Math.abs(metres);
    if (size === 0) return "0 mm";
    if (size < 1e-3) return significant(metres * 1e6) + " µm";
    if (size < 1) return significant(metres * 1e3) + " mm";
    return significant(metres) + " m";
}

export function speed(value: number): string {
    return length(value) + "/s";
}

function scaled(value: number, unit: string): string {
    const size = Math.abs(value);
    if (size >= 1e9) return significant(value / 1e9) + " G" + unit;
    if (size >= 1e6) return significant(value / 1e6) + " M" + unit;
    if (size >= 1e3) return significant(value / 1e3) + " k" + unit;
    return significant(value) + " " + unit;
}

export const stress = (value: number): string => scaled(value, "Pa");
export const energy = (value: number): string => scaled(value, "J/m");
export const gravities = (value: number): string => significant(value / 9.80665) + " g";
export const percent = (part: number): string =>
    part > 0 && part < 1e-5 ? "less than 0.001 %" : significant(100 * part) + " %";
/** A factor of safety. */
export const factor = (value: number): string => String(Number(value.toPrecision(4)));
export const plain = significant;

/** The smallest round number that is not below a positive one. */
export function roundAbove(value: number): number {
    const power = 10 ** Math.floor(Math.log10(value));
    for (const factor of [1, 1.5, 2, 2.5, 3, 4, 5, 6, 8]) if (factor * power >= value * (1 - 1e-9)) return factor * power;
    return 10 * power;
}
