/** Makes elements of the page. */

type Child = Node | string | null | undefined;

export function element<K extends keyof HTMLElementTagNameMap>(
    tag: K,
    properties: Partial<HTMLElementTagNameMap[K]> = {},
    ...children: Child[]
): HTMLElementTagNameMap[K] {
    const made = Object.assign(document.createElement(tag), properties);
    made.append(...children.filter((child): child is Node | string => child != null));
    return made;
}

export function section(title: string, ...children: Child[]): HTMLElement {
    return element("section", {}, element("h2", { textContent: title }), ...children);
}

/** A table; a column whose heading ends in "#" holds numbers. */
export function table(headings: string[], rows: string[][]): HTMLElement {
    const isNumber = headings.map((heading) => heading.endsWith("#"));
    const cell = (tag: "th" | "td", text: string, column: number) =>
        element(tag, { textContent: text, className: isNumber[column] ? "number" : "" });
    const head = element("tr", {}, ...headings.map((text, k) => cell("th", text.replace(/#$/, ""), k)));
    const body = rows.map((row) => element("tr", {}, ...row.map((text, k) => cell("td", text, k))));
    return element("div", { className: "scroll" },
        element("table", {}, element("thead", {}, head), element("tbody", {}, ...body)));
}

/** The value of a custom property of the style, such as "--ink". */
export function themed(property: string): string {
    return getComputedStyle(document.documentElement).getPropertyValue(property).trim();
}
