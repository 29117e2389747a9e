// SPDX-License-Identifier: GPL-3.0-or-later
// Parts that are dragged: along the directions in which their supports let them slide.
const still = [0, 0];

export const placeKey = part => 'place ' + part.name;

export class PartMover {
    constructor(live) {
        const {canvas} = live.view;
        Object.assign(this, {live, canvas, isOn: false, dragged: null});
        canvas.overlays.push(() => this.draw());
        canvas.takers.push(event => {
            const touch = event.touches?.[0] ?? event;
            return this.at(touch.clientX, touch.clientY) !== null;
        });
        canvas.element.addEventListener('pointerdown', event => this.begin(event));
        canvas.element.addEventListener('pointermove', event => this.move(event));
        for (const end of ['pointerup', 'pointercancel']) canvas.element.addEventListener(end, () => this.end());
    }
    toggle() {
        this.isOn = !this.isOn;
        this.live.changed('moving');
        this.canvas.draw();
    }
    slides(part) {
        return this.live.shown?.slides?.[this.live.data.parts.indexOf(part)] ?? [];
    }
    local(clientX, clientY) {
        const box = this.canvas.element.getBoundingClientRect();
        return [clientX - box.left, clientY - box.top];
    }
    /// The part under the pointer that may be moved, or null.
    at(clientX, clientY) {
        if (!this.isOn || this.live.handles.at(clientX, clientY) >= 0) return null;
        const part = this.canvas.pick(...this.local(clientX, clientY))?.part ?? null;
        return part && this.slides(part).length ? part : null;
    }
    /// Where a part is wanted, of where the scene draws it.
    wanted(part) {
        return this.live.inputs.settings[placeKey(part)] ?? still;
    }
    begin(event) {
        const part = event.button ? null : this.at(event.clientX, event.clientY);
        if (!part) return;
        this.dragged = {part, name: part.name, slides: this.slides(part), from: [event.clientX, event.clientY], scale: this.canvas.place.scale, place: this.wanted(part)};
        this.canvas.element.setPointerCapture(event.pointerId);
    }
    move(event) {
        if (!this.dragged) {
            if (this.isOn) this.canvas.element.style.cursor = this.at(event.clientX, event.clientY) ? 'move' : '';
            return;
        }
        // By how far the pointer went: answers on the way may move the picture below it.
        const {part, slides, from, scale, place} = this.dragged;
        let by = [(event.clientX - from[0]) / scale, (from[1] - event.clientY) / scale];
        if (slides.length === 1) {
            const [x, y] = slides[0], along = (by[0] * x + by[1] * y) / (x * x + y * y);
            by = [along * x, along * y];
        }
        const step = 10 ** Math.floor(Math.log10(2 / scale)), limit = this.live.controls.settings.find(s => s.key === placeKey(part)).max;
        // Along an oblique direction rounding would lead off it.
        const isFree = slides.length > 1 || slides[0].includes(0), round = v => isFree ? Number((Math.round(v / step) * step).toPrecision(12)) : v;
        this.live.move(inputs => inputs.settings[placeKey(part)] = by.map((v, k) => Math.min(limit, Math.max(-limit, round(place[k] + v)))));
    }
    end() {
        this.dragged = null;
    }
    /// Outlines where parts are wanted, until they are answered there.
    draw() {
        const {live, canvas} = this, c = canvas.context, shown = live.shown?.settings ?? {};
        c.save();
        c.setLineDash([5, 3]);
        c.strokeStyle = canvas.colors.load;
        c.lineWidth = 1.5;
        for (const part of live.data.parts) {
            const now = shown[placeKey(part)] ?? still, to = this.wanted(part), dx = to[0] - now[0], dy = to[1] - now[1];
            if (dx || dy) strokeMoved(canvas, part, (x, y) => [x + dx, y + dy]);
        }
        c.restore();
    }
}

/// The outline of a part with every point somewhere else.
export function strokeMoved(canvas, part, place, fill = null) {
    const path = new Path2D(), {x, y} = part.loops;
    for (const [from, to] of part.ranges) {
        for (let i = from; i < to; ++i) {
            const p = canvas.pixel(...place(x[i], y[i]));
            if (i === from) path.moveTo(...p);
            else path.lineTo(...p);
        }
        path.closePath();
    }
    if (fill) {
        canvas.context.fillStyle = fill;
        canvas.context.fill(path, 'evenodd');
    }
    canvas.context.stroke(path);
}
