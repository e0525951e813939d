import earcut from "../vendor/earcut/earcut";
import type { Rgb } from "./colours";
import type { Model } from "./model";
import type { Camera, Scene, View } from "./scene";

const placeOfBlock = `#version 300 es
precision highp float;
uniform sampler2D places;
uniform vec2 centre;   // m
uniform vec2 zoom;     // clip units for a metre
vec4 clip(vec2 corner, int block, out float shown) {
    int width = textureSize(places, 0).x;
    vec4 place = texelFetch(places, ivec2(block % width, block / width), 0);
    float c = cos(place.z), s = sin(place.z);
    vec2 at = place.xy + vec2(c * corner.x - s * corner.y, s * corner.x + c * corner.y);
    shown = place.w;
    return vec4((at - centre) * zoom, 0.0, 1.0);
}
vec4 colourOf(sampler2D colours, int item) {
    int width = textureSize(colours, 0).x;
    return texelFetch(colours, ivec2(item % width, item / width), 0);
}
`;
const blockVertex =
    placeOfBlock +
    `in vec2 corner;
in float block;
uniform sampler2D colours;
uniform vec4 outline;  // opacity 0: the colour of the block
out vec4 colour;
void main() {
    float shown;
    gl_Position = clip(corner, int(block), shown);
    colour = outline.a > 0.0 ? outline : colourOf(colours, int(block));
    if (shown == 0.0) gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
}`;
const pairVertex =
    placeOfBlock +
    `in vec4 line;
in vec2 blockAndPair;
uniform sampler2D colours;
uniform vec2 pixel;    // clip units
out vec4 colour;
void main() {
    float shown;
    vec4 from = clip(line.xy, int(blockAndPair.x), shown);
    vec4 to = clip(line.zw, int(blockAndPair.x), shown);
    vec2 along = normalize((to.xy - from.xy) / pixel + vec2(1e-6, 0.0));
    int corner = gl_VertexID % 6;
    bool atEnd = corner == 1 || corner == 2 || corner == 4;
    float side = corner == 0 || corner == 1 || corner == 3 ? 1.0 : -1.0;
    gl_Position = atEnd ? to : from;
    gl_Position.xy += side * vec2(-along.y, along.x) * pixel;
    colour = colourOf(colours, int(blockAndPair.y));
    if (shown == 0.0 || colour.a == 0.0) gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
}`;
const fragment = `#version 300 es
precision mediump float;
in vec4 colour;
out vec4 shade;
void main() { shade = colour; }`;

const textureWidth = 1024;

/** Draws by WebGL2. The shapes are on the graphics card; a frame is a texture of the places of the blocks. */
export class GlView implements View {
    private readonly blockProgram: WebGLProgram;
    private readonly pairProgram: WebGLProgram;
    private readonly blockShape: WebGLVertexArrayObject;
    private readonly pairShape: WebGLVertexArrayObject;
    private readonly textures: Record<"places" | "blockColours" | "pairColours", WebGLTexture>;
    private triangles = 0;
    private edges = 0;

    /** The view of a canvas; nothing where there is no WebGL2, or one that cannot draw this. */
    static on(canvas: HTMLCanvasElement, model: Model): GlView | null {
        const gl = canvas.getContext("webgl2", { antialias: true, alpha: true, preserveDrawingBuffer: true });
        try {
            return gl && new GlView(gl, canvas, model);
        } catch {
            return null;
        }
    }

    private constructor(
        private readonly gl: WebGL2RenderingContext,
        private readonly canvas: HTMLCanvasElement,
        model: Model,
    ) {
        this.blockProgram = this.program(blockVertex);
        this.pairProgram = this.program(pairVertex);
        this.blockShape = this.shapeOfBlocks(model);
        this.pairShape = this.shapeOfPairs(model);
        this.textures = { places: this.texture(), blockColours: this.texture(), pairColours: this.texture() };
    }

    private program(vertex: string): WebGLProgram {
        const { gl } = this;
        const program = gl.createProgram()!;
        for (const [kind, source] of [
            [gl.VERTEX_SHADER, vertex],
            [gl.FRAGMENT_SHADER, fragment],
        ] as const) {
            const shader = gl.createShader(kind)!;
            gl.shaderSource(shader, source);
            gl.compileShader(shader);
            if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS))
                throw new Error(gl.getShaderInfoLog(shader) ?? "a shader does not compile");
            gl.attachShader(program, shader);
        }
        gl.linkProgram(program);
        if (!gl.getProgramParameter(program, gl.LINK_STATUS))
            throw new Error(gl.getProgramInfoLog(program) ?? "a program does not link");
        return program;
    }

    private texture(): WebGLTexture {
        const { gl } = this;
        const texture = gl.createTexture()!;
        gl.bindTexture(gl.TEXTURE_2D, texture);
        gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
        gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
        return texture;
    }

    private attribute(program: WebGLProgram, name: string, size: number, values: Float32Array): void {
        const { gl } = this;
        const place = gl.getAttribLocation(program, name);
        gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
        gl.bufferData(gl.ARRAY_BUFFER, values, gl.STATIC_DRAW);
        gl.enableVertexAttribArray(place);
        gl.vertexAttribPointer(place, size, gl.FLOAT, false, 0, 0);
    }

    private shapeOfBlocks(model: Model): WebGLVertexArrayObject {
        const { gl } = this;
        const { blocks } = model;
        const owner = new Float32Array(blocks.corner.length / 2);
        const triangles: number[] = [];
        const edges: number[] = [];
        for (let b = 0; b < blocks.count; ++b) {
            const from = blocks.first[b];
            const to = blocks.first[b + 1];
            owner.fill(b, from, to);
            for (const i of earcut(Array.from(blocks.corner.subarray(2 * from, 2 * to)))) triangles.push(from + i);
            for (let i = from; i < to; ++i) edges.push(i, i + 1 < to ? i + 1 : from);
        }
        this.triangles = triangles.length;
        this.edges = edges.length;
        const shape = gl.createVertexArray()!;
        gl.bindVertexArray(shape);
        this.attribute(this.blockProgram, "corner", 2, blocks.corner);
        this.attribute(this.blockProgram, "block", 1, owner);
        gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, gl.createBuffer());
        gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, new Uint32Array(triangles.concat(edges)), gl.STATIC_DRAW);
        return shape;
    }

    private shapeOfPairs(model: Model): WebGLVertexArrayObject {
        const { gl } = this;
        const { pairs } = model;
        const lines = new Float32Array(24 * pairs.count);
        const owners = new Float32Array(12 * pairs.count);
        for (let p = 0; p < pairs.count; ++p)
            for (let corner = 0; corner < 6; ++corner) {
                lines.set(pairs.line.subarray(4 * p, 4 * p + 4), 24 * p + 4 * corner);
                owners.set([pairs.block[p], p], 12 * p + 2 * corner);
            }
        const shape = gl.createVertexArray()!;
        gl.bindVertexArray(shape);
        this.attribute(this.pairProgram, "line", 4, lines);
        this.attribute(this.pairProgram, "blockAndPair", 2, owners);
        return shape;
    }

    /** Fills a texture with four values for each item. */
    private fill(unit: number, texture: WebGLTexture, values: Float32Array | Uint8Array): void {
        const { gl } = this;
        const rows = Math.max(1, Math.ceil(values.length / (4 * textureWidth)));
        const isFloat = values instanceof Float32Array;
        const padded = isFloat ? new Float32Array(4 * textureWidth * rows) : new Uint8Array(4 * textureWidth * rows);
        padded.set(values);
        gl.activeTexture(gl.TEXTURE0 + unit);
        gl.bindTexture(gl.TEXTURE_2D, texture);
        gl.texImage2D(gl.TEXTURE_2D, 0, isFloat ? gl.RGBA32F : gl.RGBA8, textureWidth, rows, 0, gl.RGBA,
            isFloat ? gl.FLOAT : gl.UNSIGNED_BYTE, padded);
    }

    private use(program: WebGLProgram, camera: Camera, colours: number): void {
        const { gl, canvas } = this;
        gl.useProgram(program);
        gl.uniform1i(gl.getUniformLocation(program, "places"), 0);
        gl.uniform1i(gl.getUniformLocation(program, "colours"), colours);
        gl.uniform2f(gl.getUniformLocation(program, "centre"), camera.x, camera.y);
        gl.uniform2f(gl.getUniformLocation(program, "zoom"), (2 * camera.scale) / canvas.clientWidth,
            (2 * camera.scale) / canvas.clientHeight);
    }

    draw(scene: Scene, camera: Camera, outline: Rgb): void {
        const { gl, canvas } = this;
        gl.viewport(0, 0, canvas.width, canvas.height);
        gl.clearColor(0, 0, 0, 0);
        gl.clear(gl.COLOR_BUFFER_BIT);
        this.fill(0, this.textures.places, scene.places);
        this.fill(1, this.textures.blockColours, scene.blockColours);
        this.fill(2, this.textures.pairColours, scene.pairColours);
        this.use(this.blockProgram, camera, 1);
        gl.bindVertexArray(this.blockShape);
        const edgeColour = gl.getUniformLocation(this.blockProgram, "outline");
        gl.uniform4f(edgeColour, 0, 0, 0, 0);
        gl.drawElements(gl.TRIANGLES, this.triangles, gl.UNSIGNED_INT, 0);
        if (scene.hasRoomForOutlines(camera)) {
            gl.uniform4f(edgeColour, outline[0] / 255, outline[1] / 255, outline[2] / 255, 1);
            gl.drawElements(gl.LINES, this.edges, gl.UNSIGNED_INT, 4 * this.triangles);
        }
        if (!scene.hasRoomForPairs(camera)) return;
        this.use(this.pairProgram, camera, 2);
        const lineWidth = scene.blockPixels(camera) > 12 ? 2.4 : 1.2;
        gl.uniform2f(gl.getUniformLocation(this.pairProgram, "pixel"), lineWidth / canvas.clientWidth, lineWidth / canvas.clientHeight);
        gl.bindVertexArray(this.pairShape);
        gl.drawArrays(gl.TRIANGLES, 0, 6 * scene.model.pairs.count);
    }
}
