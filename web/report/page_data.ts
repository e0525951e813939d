/** What the page is given as JSON, in SI units. Parts are missing where the run has no such file. */
export interface PageData {
    name: string;
    program: string;
    motion: MotionData;
    history?: { time: number[]; stage: string; points: { name: string; x: number[]; y: number[] }[]; relative: boolean };
    base_motion?: { time: number[]; period: number[]; x?: BaseMotion; y?: BaseMotion } | null;
    moved?: MovedBlock[] | null;
    penetration?: number | null;
    model?: string;
    summary?: Summary;
}

export interface MotionData {
    times: number[];
    stages: string[];
    base: { x: number[]; y: number[] };
    blocks: number;
    pairs: number;
    grid: { x: number; y: number; step: number };
    materials: string[];
    joint_materials: string[];
    joints: string[];
}

export interface BaseMotion {
    acceleration: number[];
    spectrum: number[];
}

export interface MovedBlock {
    distance: number;
    [column: string]: string | number;
}

/** The parts of summary.json that the page shows. */
export interface Summary {
    status: string;
    message: string;
    stage: string;
    time: number;
    steps: number;
    wall_time: number;
    blocks: number;
    version: string;
    reference?: string;
    points?: PointSummary[];
    first_slip?: { blocks: number; first: number; first_time_of_shaking: number } | null;
    factor_of_safety?: { stands: number | null; fails: number | null };
    energy: Record<string, number>;
    inputs: { file: string; sha256: string }[];
}

export interface PointSummary {
    name: string;
    kind: string;
    permanent_displacement?: [number, number];
    relative_speed?: number;
    peak_relative_displacement?: number;
    peak_velocity: number;
    peak_acceleration: number;
    amplification?: number | null;
}
