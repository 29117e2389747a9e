// SPDX-License-Identifier: GPL-3.0-or-later
// A motion that nothing holds, as the motion it is: outlines that go where the loads drive the parts, again and again.
import {strokeMoved} from './moving.js';

const period = 1800, rest = 500;  // milliseconds: a motion, and its end
const reach = 0.1;                // of the model's size

export class Mechanism {
    constructor(live) {
        Object.assign(this, {live, begin: 0});
        live.view.canvas.overlays.push(canvas => this.draw(canvas));
    }
    get driven() {
        const {shown} = this.live;
        return shown?.status === 'failed' && !this.live.problems.length ? shown.driven ?? [] : [];
    }
    draw(canvas) {
        if (!this.driven.length) return void (this.begin = 0);
        const now = performance.now(), isStill = matchMedia('(prefers-reduced-motion: reduce)').matches;
        this.begin ||= now;
        const time = Math.min(1, ((now - this.begin) % (period + rest)) / period), phase = isStill ? 1 : 0.5 - 0.5 * Math.cos(Math.PI * time);
        const c = canvas.context, {parts, size} = canvas.data, seen = new Set();
        c.save();
        c.strokeStyle = '#e8590c';
        c.lineWidth = 2;
        for (const {part: k, twist: [vx, vy, w]} of this.driven) {
            const part = parts[k];
            if (!part || seen.has(k)) continue;  // of several motions of a part the first
            seen.add(k);
            // The speed of the corners of its box: none goes further than the reach.
            const {x0, x1, y0, y1} = part.box, corners = [[x0, y0], [x1, y0], [x1, y1], [x0, y1]];
            const speed = Math.max(...corners.map(([x, y]) => Math.hypot(vx - w * y, vy + w * x)));
            if (!(speed > 0)) continue;
            const angle = phase * reach * size / speed * w;
            if (Math.abs(angle) < 1e-9) {
                const d = phase * reach * size / speed;
                strokeMoved(canvas, part, (x, y) => [x + d * vx, y + d * vy], '#e8590c30');
                continue;
            }
            const px = -vy / w, py = vx / w, cos = Math.cos(angle), sin = Math.sin(angle);  // the pole
            strokeMoved(canvas, part, (x, y) => [px + cos * (x - px) - sin * (y - py), py + sin * (x - px) + cos * (y - py)], '#e8590c30');
        }
        c.restore();
        if (!isStill) canvas.draw(true);
    }
}
