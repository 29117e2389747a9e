// SPDX-License-Identifier: GPL-3.0-or-later
// The colour scale beside the canvas: its ends can be dragged (or moved by arrow keys) and locked.
import {Scale, text, ticks} from './colors.js';
import {element} from './dom.js';

export class Legend {
    constructor(state) {
        this.state = state;
        this.title = element('div', {class: 'legend-title'});
        this.beyond = element('div', {class: 'legend-beyond'});
        this.bar = element('canvas', {width: 16, height: 256});
        this.ticks = element('div', {class: 'legend-ticks'});
        this.ends = ['high', 'low'].map(end => element('button', {type: 'button', class: 'legend-end ' + end, role: 'slider', 'aria-label': `${end} end of the scale`,
            title: 'Drag, or arrow keys', pointerdown: e => this.drag(e, end), keydown: e => this.key(e, end)}));
        this.lock = element('button', {type: 'button', class: 'small', title: 'Keep these ends for other quantities', click: () => state.set('locked', !state.locked)});
        const reset = element('button', {type: 'button', class: 'small', title: 'Ends of the values', click: () => state.set('range', {...state.automaticRange})}, 'Reset');
        this.scale = element('div', {class: 'legend-scale'}, this.bar, this.ticks, ...this.ends);
        this.root = element('div', {class: 'legend-box'}, this.title, this.beyond, this.scale, element('div', {class: 'legend-buttons'}, this.lock, reset));
        new ResizeObserver(() => this.update()).observe(this.scale);
        state.on(() => this.update());
        this.update();
    }
    update() {
        const {state} = this, {low, high} = state.range, unit = state.data.units[state.quantity.unit], most = state.ends?.high.value, least = state.ends?.low.value;
        const shown = [low, high, most, least, state.quantity.key, state.mode, state.locked, unit, this.scale.clientHeight].join();
        if (this.shown === shown) return;
        this.shown = shown;
        this.title.textContent = state.quantity.name + (unit ? ` [${unit}]` : '');
        const slack = 1e-6 * (high - low), beyond = [most > high + slack ? `up to ${text(most, 4)}` : '', least < low - slack ? `down to ${text(least, 4)}` : ''].filter(Boolean);
        this.beyond.textContent = beyond.length ? beyond.join(', ') + ' beyond' : '';
        const scale = new Scale(low, high, state.quantity.signed, state.mode), c = this.bar.getContext('2d');
        for (let i = 0; i < 256; ++i) {
            c.fillStyle = scale.css(high - (i + 0.5) / 256 * (high - low));
            c.fillRect(0, i, 16, 1);
        }
        const room = 17 / (this.scale.clientHeight || 280) * (high - low);  // of the ends' own numbers
        const inner = ticks(low, high, 6).filter(v => v > low + room && v < high - room);
        this.ticks.replaceChildren(...inner.map(v => element('span', {style: `top:${100 * (high - v) / (high - low)}%`}, text(v, 5))));
        this.ends[0].textContent = text(high, 4);
        this.ends[1].textContent = text(low, 4);
        this.ends.forEach((end, k) => end.setAttribute('aria-valuenow', k ? low : high));
        this.lock.textContent = state.locked ? 'Locked' : 'Lock';
        this.lock.setAttribute('aria-pressed', state.locked);
    }
    move(end, by) {
        const {low, high} = this.state.range, moved = {low, high};
        moved[end] += by;
        if (moved.high - moved.low > 1e-3 * (high - low)) this.state.set('range', moved);
    }
    drag(event, end) {
        const begin = {...this.state.range}, height = this.scale.clientHeight, {target} = event, y0 = event.clientY;
        target.setPointerCapture(event.pointerId);
        const move = e => {
            const by = (y0 - e.clientY) / height * (begin.high - begin.low), moved = {...begin, [end]: begin[end] + by};
            if (moved.high - moved.low > 1e-3 * (begin.high - begin.low)) this.state.set('range', moved);
        };
        target.addEventListener('pointermove', move);
        target.addEventListener('pointerup', () => target.removeEventListener('pointermove', move), {once: true});
    }
    key(event, end) {
        const step = {ArrowUp: 1, ArrowDown: -1}[event.key];
        if (!step) return;
        event.preventDefault();
        event.stopPropagation();
        this.move(end, step * 0.02 * (this.state.range.high - this.state.range.low));
    }
}
