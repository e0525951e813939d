import type { Instant } from "./scene";

/** Keeps the time that is shown, and lets it run. */
export class Player {
    time: number;
    speed = 1;
    playing = false;
    private last = 0;

    constructor(
        private readonly times: number[],
        private readonly changed: () => void,
    ) {
        this.time = times[times.length - 1];
    }

    get start(): number {
        return this.times[0];
    }
    get end(): number {
        return this.times[this.times.length - 1];
    }

    seek(time: number): void {
        this.time = Math.min(Math.max(time, this.start), this.end);
        this.changed();
    }

    toggle(): void {
        this.playing = !this.playing;
        if (this.playing && this.time >= this.end) this.time = this.start;
        this.last = performance.now();
        if (this.playing) requestAnimationFrame((now) => this.tick(now));
        this.changed();
    }

    private tick(now: number): void {
        if (!this.playing) return;
        this.time += (this.speed * Math.max(0, now - this.last)) / 1000;
        this.last = now;
        if (this.time >= this.end) {
            this.time = this.end;
            this.playing = false;
        }
        this.changed();
        if (this.playing) requestAnimationFrame((next) => this.tick(next));
    }

    /** The frame at or before the time, and the part of the way to the next. */
    instant(): Instant {
        const { times, time } = this;
        let low = 0;
        let high = times.length - 1;
        while (high - low > 1) {
            const middle = (low + high) >> 1;
            if (times[middle] <= time) low = middle;
            else high = middle;
        }
        if (high === low || time >= times[high]) return { k: high, part: 0 };
        return { k: low, part: Math.max(0, (time - times[low]) / (times[high] - times[low])) };
    }
}
