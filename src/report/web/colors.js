// SPDX-License-Identifier: GPL-3.0-or-later
// Colour scales that the colour-blind can read: one for sizes, one with a middle for what has a sign.

const sequential = ['440154', '481a6c', '472f7d', '414487', '39568c', '31688e', '2a788e', '23888e', '1f988b', '22a884', '35b779',
    '54c568', '7ad151', 'a5db36', 'd2e21b', 'fde725'];
const diverging = ['053061', '2166ac', '4393c3', '92c5de', 'd1e5f0', 'f7f7f7', 'fde0b5', 'fdb863', 'e08214', 'b35806', '7f3b08'];
export const steps = 1024, bands = 12;

function mixed(stops, t) {
    const at = Math.min(Math.max(t, 0), 1) * (stops.length - 1), i = Math.min(Math.floor(at), stops.length - 2);
    const channel = (stop, c) => parseInt(stop.slice(2 * c, 2 * c + 2), 16);
    return [0, 1, 2].map(c => Math.round(channel(stops[i], c) + (at - i) * (channel(stops[i + 1], c) - channel(stops[i], c))));
}

const table = stops => Array.from({length: steps}, (_, i) => mixed(stops, i / (steps - 1)));
const tables = {sequential: table(sequential), diverging: table(diverging)};

/// A scale from low to high: position (0 to 1) of a value, its colour, its band. Zero of a scale with a sign is in the middle.
export class Scale {
    constructor(low, high, signed, mode) {
        Object.assign(this, {low, high, mode});
        this.splits = Boolean(signed) && low < 0 && high > 0;
        this.table = signed ? tables.diverging : tables.sequential;
        this.from = signed && low >= 0 ? 0.5 : 0;  // one side alone keeps its colours
        this.to = signed && high <= 0 ? 0.5 : 1;
        this.packed = Uint32Array.from(this.table, ([r, g, b]) => (255 << 24 | b << 16 | g << 8 | r) >>> 0);
    }
    share(value) {
        return Math.min(Math.max((value - this.low) / (this.high - this.low), 0), 1);
    }
    index(value) {
        let t = this.share(value);
        if (this.mode !== 'smooth') t = (Math.min(Math.floor(t * bands), bands - 1) + 0.5) / bands;
        if (this.splits) {
            const v = this.low + t * (this.high - this.low);
            t = v < 0 ? 0.5 - 0.5 * v / this.low : 0.5 + 0.5 * v / this.high;
        } else {
            t = this.from + t * (this.to - this.from);
        }
        return Math.round(t * (steps - 1));
    }
    css(value) {
        return `rgb(${this.table[this.index(value)].join(',')})`;
    }
}

/// Round numbers from low to high, about n of them.
export function ticks(low, high, n) {
    const raw = (high - low) / n, decade = 10 ** Math.floor(Math.log10(raw));
    const step = [1, 2, 5, 10].map(m => m * decade).find(s => s >= raw) ?? raw;
    const list = [];
    for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; ++k) list.push(k * step);
    return list;
}

/// A number as people read it, to so many digits.
export function text(value, digits = 4) {
    if (!Number.isFinite(value)) return '–';
    const rounded = Number(value.toPrecision(digits)), size = Math.abs(rounded);
    if (rounded === 0) return '0';
    return size < 1e-4 || size >= 1e7 ? rounded.toExponential().replace('e+', 'e') : String(rounded);
}

export const withUnit = (value, unit, digits) => text(value, digits) + (unit ? ' ' + unit : '');
