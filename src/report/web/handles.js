// SPDX-License-Identifier: GPL-3.0-or-later
// Forces as arrows whose tips are dragged: with Shift they are turned alone, with Ctrl (or Alt) made longer or shorter alone.
import {withUnit} from './colors.js';
import {arrow, label, ring} from './layers.js';

const usual = 110, reach = 14, knob = 7;  // pixels: the largest force as given; of the pointer; the tip

export class ForceHandles {
    constructor(live) {
        const {canvas} = live.view;
        Object.assign(this, {live, canvas, dragged: -1, scale: 0});
        this.fit();
        canvas.overlays.push(() => this.draw());
        canvas.takers.push(event => {
            const touch = event.touches?.[0] ?? event;
            return this.at(touch.clientX, touch.clientY) >= 0;
        });
        canvas.element.addEventListener('pointerdown', event => this.begin(event));
        canvas.element.addEventListener('pointermove', event => this.move(event));
        canvas.element.addEventListener('pointerup', () => this.end());
        canvas.element.addEventListener('pointercancel', () => this.end());
        live.on(what => {
            if (!['inputs', 'controls'].includes(what)) return;
            if (this.dragged < 0) this.refit();
            canvas.draw(true);
        });
    }
    /// Pixels a unit of force: so that the largest is as long as usual.
    fit() {
        const sizes = this.list().map(h => Math.hypot(...h.force)), largest = Math.max(0, ...sizes);
        this.scale = largest > 0 ? usual / largest : this.scale || usual / 1000;
    }
    list() {
        const {controls} = this.live;
        return controls.loads.flatMap((load, k) => load.force && load.at ? [{load, k, force: this.live.force(k)}] : []);
    }
    ends({load, force}) {
        const [x, y] = this.canvas.pixel(...load.at);
        return {x, y, tipX: x + this.scale * force[0], tipY: y - this.scale * force[1]};
    }
    at(clientX, clientY) {
        const box = this.canvas.element.getBoundingClientRect();
        const hits = this.list().map(h => ({k: h.k, ...this.ends(h)})).map(e => ({k: e.k, distance: Math.hypot(e.tipX - clientX + box.left, e.tipY - clientY + box.top)}));
        const best = hits.reduce((a, b) => b.distance < a.distance ? b : a, {k: -1, distance: reach});
        return best.k;
    }
    draw() {
        const c = this.canvas.context, color = this.canvas.colors.load;
        for (const h of this.list()) {
            const {x, y, tipX, tipY} = this.ends(h);
            arrow(c, x, y, tipX - x, tipY - y, color, 3);
            ring(c, x, y, 2.5, color, this.canvas.paper);
            c.beginPath();
            c.arc(tipX, tipY, knob, 0, 2 * Math.PI);
            c.fillStyle = h.k === this.dragged ? color : this.canvas.paper;
            c.globalAlpha = 0.85;
            c.fill();
            c.globalAlpha = 1;
            c.strokeStyle = color;
            c.lineWidth = 2.5;
            c.stroke();
            c.lineWidth = 1;
            label(this.canvas, (h.load.name ? h.load.name + ': ' : '') + withUnit(Math.hypot(...h.force), h.load.unit), tipX, tipY, {color, bold: h.k === this.dragged, side: tipX >= x ? 1 : -1});
        }
    }
    begin(event) {
        if (event.button) return;
        this.dragged = this.at(event.clientX, event.clientY);
        if (this.dragged < 0) return;
        this.canvas.element.setPointerCapture(event.pointerId);
        this.canvas.element.style.cursor = 'grabbing';
        this.canvas.draw();
    }
    move(event) {
        if (this.dragged < 0) {
            this.canvas.element.style.cursor = this.at(event.clientX, event.clientY) >= 0 ? 'grab' : '';
            return;
        }
        const h = this.list().find(one => one.k === this.dragged);
        if (!h) return this.end();
        const box = this.canvas.element.getBoundingClientRect(), {x, y} = this.ends(h), old = Math.hypot(...h.force) || 1;
        let fx = (event.clientX - box.left - x) / this.scale, fy = (y - event.clientY + box.top) / this.scale;
        const now = Math.hypot(fx, fy);
        if (event.shiftKey && now > 0) [fx, fy] = [fx / now * old, fy / now * old];
        else if (event.ctrlKey || event.altKey) {
            const along = (fx * h.force[0] + fy * h.force[1]) / old;
            [fx, fy] = [h.force[0] / old * along, h.force[1] / old * along];
        } else {
            const step = 10 ** Math.floor(Math.log10(2 / this.scale));  // no finer than a hand
            [fx, fy] = [fx, fy].map(v => Number((Math.round(v / step) * step).toPrecision(12)));
        }
        this.live.move(inputs => inputs.loads[this.dragged] = [fx, fy]);
    }
    end() {
        if (this.dragged < 0) return;
        this.dragged = -1;
        this.canvas.element.style.cursor = '';
        this.refit();
        this.canvas.draw();
    }
    /// Where arrows have become too long or too short to be dragged.
    refit() {
        const longest = Math.max(0, ...this.list().map(h => Math.hypot(...h.force))) * this.scale;
        if (longest > 0.42 * Math.min(this.canvas.width, this.canvas.height) || longest < 0.25 * usual) this.fit();
    }
}
