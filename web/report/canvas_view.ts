import { css, type Rgb } from "./colours";
import type { Camera, Scene, View } from "./scene";

/** Draws by the two-dimensional canvas, where WebGL2 is missing. */
export class CanvasView implements View {
    private readonly context: CanvasRenderingContext2D;

    constructor(private readonly canvas: HTMLCanvasElement) {
        const context = canvas.getContext("2d");
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
        context.lineWidth = 0.6 * ratio;
        context.strokeStyle = css(outline);
        for (let b = 0; b < scene.model.blocks.count; ++b) {
            if (scene.places[4 * b + 3] === 0) continue;
            const ring = scene.ringOf(b);
            context.beginPath();
            for (let i = 0; i < ring.length; i += 2) context.lineTo(x(ring[i]), y(ring[i + 1]));
            context.closePath();
            context.fillStyle = scene.blockColour(b);
            context.fill();
            context.stroke();
        }
        context.lineWidth = 2 * ratio;
        for (let p = 0; p < scene.model.pairs.count; ++p) {
            if (scene.pairColours[4 * p + 3] === 0) continue;
            const [ax, ay, bx, by] = scene.lineOf(p);
            context.strokeStyle = scene.pairColour(p);
            context.beginPath();
            context.moveTo(x(ax), y(ay));
            context.lineTo(x(bx), y(by));
            context.stroke();
        }
    }
}
