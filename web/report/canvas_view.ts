import { css, type Rgb } from "./colours";
import type { Camera, Scene, View } from "./scene";

/** Draws by the two-dimensional canvas, where WebGL2 is missing. */
export class CanvasView implements View {
    private readonly context: CanvasRenderingContext2D;

    constructor(private readonly canvas: HTMLCanvasElement) {
        // By the processor: a graphics card that is only emulated takes seconds for thousands of outlines.
        const context = canvas.getContext("2d", { willReadFrequently: true });
        if (!context) throw new Error("this browser cannot draw");
        this.context = context;
    }

    draw(scene: Scene, camera: Camera, outline: Rgb): void {
        const { context, canvas } = this;
        const ratio = canvas.width / canvas.clientWidth;
        const scale = camera.scale * ratio;
        const x = (value: number) => canvas.width / 2 + (value - camera.x) * scale;
        const y = (value: number) => canvas.height / 2 - (value - camera.y) * scale;
        context.clearRect(0, 0, canvas.width, canvas.height);
        const outlines = new Path2D();
        for (let b = 0; b < scene.model.blocks.count; ++b) {
            if (scene.places[4 * b + 3] === 0) continue;
            const ring = scene.ringOf(b);
            const block = new Path2D();
            for (let i = 0; i < ring.length; i += 2) block.lineTo(x(ring[i]), y(ring[i + 1]));
            block.closePath();
            context.fillStyle = scene.blockColour(b);
            context.fill(block);
            outlines.addPath(block);
        }
        if (scene.hasRoomForOutlines(camera)) {
            context.lineWidth = 0.6 * ratio;
            context.strokeStyle = css(outline);
            context.stroke(outlines);
        }
        if (!scene.hasRoomForPairs(camera)) return;
        context.lineWidth = 2 * ratio;
        for (const [colour, lines] of this.linesByColour(scene, x, y)) {
            context.strokeStyle = colour;
            context.stroke(lines);
        }
    }

    /** The lines of the pairs, one path a colour: to stroke each by itself takes much longer. */
    private linesByColour(scene: Scene, x: (value: number) => number, y: (value: number) => number): Map<string, Path2D> {
        const paths = new Map<string, Path2D>();
        for (let p = 0; p < scene.model.pairs.count; ++p) {
            if (scene.pairColours[4 * p + 3] === 0) continue;
            const colour = scene.pairColour(p);
            let path = paths.get(colour);
            if (!path) paths.set(colour, (path = new Path2D()));
            const [ax, ay, bx, by] = scene.lineOf(p);
            path.moveTo(x(ax), y(ay));
            path.lineTo(x(bx), y(by));
        }
        return paths;
    }
}
