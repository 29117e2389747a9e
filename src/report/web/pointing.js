// SPDX-License-Identifier: GPL-3.0-or-later
// Of a drawing: edges that are clicked to hold and to load them. What comes of it are the scene's supports and loads.
import {text} from './colors.js';
import {element} from './dom.js';

const reach = 9, together = 3;  // pixels: of the pointer; between edges that lie on each other

function distanceTo([px, py], [ax, ay], [bx, by]) {
    const dx = bx - ax, dy = by - ay, length = dx * dx + dy * dy, t = length > 0 ? Math.min(1, Math.max(0, ((px - ax) * dx + (py - ay) * dy) / length)) : 0;
    return Math.hypot(px - ax - t * dx, py - ay - t * dy);
}

/// 1, 2, 5 times a power of ten, near a number.
const nice = value => Number((10 ** Math.round(Math.log10(value))).toPrecision(1));

export class Pointing {
    constructor(live) {
        const {canvas} = live.view;
        Object.assign(this, {live, canvas, hovered: null, chosen: null});
        this.menu = element('div', {class: 'edge-menu', hidden: true, role: 'menu'});
        canvas.element.parentElement.append(this.menu);
        canvas.overlays.push(() => this.draw());
        canvas.element.addEventListener('pointermove', event => {
            const before = this.hovered;
            this.hovered = event.buttons ? null : this.near(event)[0] ?? null;
            if (before !== this.hovered) canvas.draw();
        });
        canvas.clickTakers.push(event => {
            const near = this.near(event);
            this.choose(near[0] ?? null, event, near);
            return this.chosen !== null;
        });
        this.menu.addEventListener('keydown', event => event.key === 'Escape' && this.choose(null));
    }
    /// The edges under the pointer, the nearest first: those of two parts may lie on each other.
    near(event) {
        const box = this.canvas.element.getBoundingClientRect(), p = [event.clientX - box.left, event.clientY - box.top];
        const distanceOf = edge => {
            const points = edge.points.map(q => this.canvas.pixel(...q));
            return Math.min(...points.slice(1).map((q, i) => distanceTo(p, points[i], q)));
        };
        const all = this.live.drawing.edges.map(edge => ({edge, distance: distanceOf(edge)})).filter(e => e.distance < reach).sort((a, b) => a.distance - b.distance);
        return all.filter(e => e.distance < all[0].distance + together).map(e => e.edge);
    }
    draw() {
        const c = this.canvas.context, held = new Set(this.live.drawing.supports.map(s => s.on));
        const stroke = (edge, color, width) => {
            c.beginPath();
            edge.points.forEach((p, i) => i ? c.lineTo(...this.canvas.pixel(...p)) : c.moveTo(...this.canvas.pixel(...p)));
            c.strokeStyle = color;
            c.lineWidth = width;
            c.stroke();
            c.lineWidth = 1;
        };
        for (const edge of this.live.drawing.edges) if (held.has(edge.name)) stroke(edge, this.canvas.ink, 2.5);
        for (const edge of new Set([this.hovered, this.chosen])) if (edge) stroke(edge, '#e8590c', 4);
    }
    choose(edge, event = null, near = []) {
        this.chosen = edge;
        this.menu.hidden = !edge;
        this.canvas.draw();
        if (!edge) return;
        const box = this.canvas.element.getBoundingClientRect(), {model, size} = this.live.data, thickness = model.parts?.[0]?.thickness ?? 1;
        const item = (words, act) => element('button', {type: 'button', class: 'small', role: 'menuitem', click: () => {
            act();
            this.choose(null);
        }}, words);
        const hold = axes => () => this.add('supports', {on: edge.name, fix: axes});
        // Of the size that steel feels: 1 MPa over a tenth of the model, or its like in other units.
        const [nx, ny] = this.inward(edge), stiffness = model.materials?.[0]?.E ?? 2e5, usual = nice(5e-6 * stiffness), force = nice(usual * 0.1 * size * thickness);
        const names = near.length < 2 ? [element('b', {}, edge.name)] : near.map(other => element('button', {type: 'button', class: 'small', 'aria-pressed': other === edge, click: () => this.choose(other, event, near)}, other.name));
        this.menu.replaceChildren(element('div', {class: 'edge-names'}, ...names), element('span', {class: 'word'}, 'hold'), item('x and y', hold(['x', 'y'])), item('x', hold(['x'])), item('y', hold(['y'])),
            element('span', {class: 'word'}, 'load'), item('force', () => this.add('loads', {on: edge.name, force: [nx, ny].map(v => Number((force * v).toPrecision(4)))})), item('pressure', () => this.add('loads', {on: edge.name, pressure: usual})));
        const x = event.clientX - box.left, y = event.clientY - box.top;
        this.menu.style.left = `${Math.max(4, Math.min(x + 10, this.canvas.width - this.menu.offsetWidth - 4))}px`;
        this.menu.style.top = `${Math.max(4, Math.min(y + 10, this.canvas.height - this.menu.offsetHeight - 4))}px`;
        this.menu.querySelector('button').focus({preventScroll: true});
    }
    /// The direction into the part at the middle of an edge, which has the part on its left.
    inward(edge) {
        const i = (edge.points.length - 1) >> 1, [a, b] = [edge.points[i], edge.points[i + 1]], l = Math.hypot(b[0] - a[0], b[1] - a[1]) || 1;
        return [-(b[1] - a[1]) / l, (b[0] - a[0]) / l];
    }
    /// What there is, with forces and factors as they were moved.
    conditions() {
        const {drawing, inputs, controls} = this.live;
        const loads = drawing.loads.map((load, k) => controls.loads[k]?.force ? {...load, force: this.live.force(k)} : {...load, pressure: load.pressure * (inputs.loads[k]?.[0] ?? 1)});
        return {supports: drawing.supports, loads};
    }
    add(list, condition) {
        const now = this.conditions();
        this.send({...now, [list]: [...now[list], condition]});
    }
    remove(list, index) {
        const now = this.conditions();
        this.send({...now, [list]: now[list].filter((_, k) => k !== index)});
    }
    async send(conditions) {
        try {
            await this.live.request('conditions', conditions);
        } catch (error) {
            this.live.failed(error);
        }
    }
    panel() {
        const {supports, loads} = this.live.drawing, row = (list, k, words) => element('li', {}, words, ' ',
            element('button', {type: 'button', class: 'small', 'aria-label': 'Remove ' + words, title: 'Remove', click: () => this.remove(list, k)}, '×'));
        return element('div', {class: 'pointing'}, element('h2', {}, 'Hold and load'), element('p', {class: 'hint'}, 'Click an edge in the picture to hold it, or to load it.'),
            element('ul', {class: 'conditions'}, ...supports.map((s, k) => row('supports', k, `${s.on}: held in ${s.fix.join(' and ')}`)),
                ...loads.map((l, k) => row('loads', k, l.force ? `${l.on}: force` : `${l.on}: pressure ${text(l.pressure)}`))));
    }
}
