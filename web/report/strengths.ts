/** Reads the effective model file, which dda-run writes one key a line, for the tables of strengths. */
export interface MaterialTable {
    kind: "block" | "joint";
    name: string;
    values: { key: string; value: string; isDefault: boolean }[];
}

export function materialTables(model: string): MaterialTable[] {
    const tables: MaterialTable[] = [];
    let open: MaterialTable | null = null;
    for (const line of model.split("\n")) {
        if (line.startsWith("[")) {
            const heading = /^\[(block|joint)_material\.(?:"(.*)"|([^"\]]*))\]$/.exec(line);
            open = heading && { kind: heading[1] as "block" | "joint", name: heading[2] ?? heading[3], values: [] };
            if (open) tables.push(open);
            continue;
        }
        const entry = /^(\w+) = (.*?)(\s+# default)?$/.exec(line);
        if (open && entry)
            open.values.push({ key: entry[1], value: readable(entry[2]), isDefault: entry[3] !== undefined });
    }
    return tables;
}

/** A value without quotes; an angle in radians in degrees. */
function readable(value: string): string {
    const text = value.replace(/^"(.*)"$/, "$1");
    const radians = /^([-+.\de]+) rad$/.exec(text);
    return radians ? `${Number(((Number(radians[1]) * 180) / Math.PI).toPrecision(6))} deg` : text;
}
