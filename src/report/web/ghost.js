// SPDX-License-Identifier: GPL-3.0-or-later
// A state that is kept to compare with: its outline and pressures stay in the picture, its numbers beside those of now.
import {fanHeight, largestOf} from './layers.js';
import {contactKeys} from './tables.js';

export class Ghost {
    constructor(live) {
        Object.assign(this, {live, kept: null});
        live.view.canvas.overlays.push(canvas => this.draw(canvas));
    }
    get isKept() {
        return this.kept !== null;
    }
    keep() {
        const {data} = this.live, keys = contactKeys(data.contacts);
        this.kept = {
            outlines: data.parts.map(({loops, ranges}) => ({x: loops.x, y: loops.y, value: loops.value, ranges})),
            contacts: data.contacts.map(c => ({nx: c.nx, ny: c.ny, ux: c.ux, uy: c.uy, profile: c.profile})),
            inputs: structuredClone(this.live.inputs),
        };
        data.ghost = {
            contacts: new Map(data.contacts.map((c, k) => [keys[k], {size: Math.hypot(...c.force), peak: c.max_pressure.value ?? 0}])),
            parts: new Map(data.parts.map(p => [p.name, {stress: p.max_von_mises.value, displacement: p.max_displacement.value}])),
        };
        this.shown();
    }
    forget() {
        this.kept = this.live.data.ghost = null;
        this.shown();
    }
    shown() {
        this.live.view.state.changed('data');
        this.live.changed('ghost');
    }
    draw(canvas) {
        if (!this.kept) return;
        const c = canvas.context, e = canvas.state.exaggeration;
        c.save();
        c.setLineDash([5, 4]);
        c.strokeStyle = canvas.soft;
        c.lineWidth = 1.2;
        c.beginPath();
        if (e > 0)
            for (const {x, y, value, ranges} of this.kept.outlines)
                for (const [from, to] of ranges) {
                    for (let i = from; i < to; ++i) {
                        const p = canvas.pixel(x[i] + e * value[6 * i], y[i] + e * value[6 * i + 1]);
                        if (i === from) c.moveTo(...p);
                        else c.lineTo(...p);
                    }
                    c.closePath();
                }
        c.stroke();
        const largest = largestOf(canvas.data.contacts, 'pressure'), height = largest > 0 ? fanHeight(canvas) / largest : 0;
        c.strokeStyle = canvas.ink;
        c.beginPath();
        for (const {profile: p, nx, ny, ux, uy} of this.kept.contacts) {
            let draws = false;
            for (let i = 0; i < p.x.length; ++i) {
                const carries = p.pressure[i] || p.pressure[i + 1] || p.pressure[i - 1];
                if (!carries) {
                    draws = false;
                    continue;
                }
                const [x, y] = canvas.pixel(p.x[i] + e * ux[i], p.y[i] + e * uy[i]), h = height * p.pressure[i];
                if (draws) c.lineTo(x + h * nx[i], y - h * ny[i]);
                else c.moveTo(x + h * nx[i], y - h * ny[i]);
                draws = true;
            }
        }
        c.stroke();
        c.restore();
    }
}
