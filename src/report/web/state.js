// SPDX-License-Identifier: GPL-3.0-or-later
// What the instrument shows; whoever shows it listens. The address keeps it: #c=2&q=s1&view=0,40,30
import {automaticRange, extremes, quantities, quantityOf} from './quantities.js';

export const layers = [
    ['field', 'Field'], ['outlines', 'Outlines'], ['undeformed', 'Undeformed shape'], ['colors', 'Parts by colour'], ['names', 'Names'],
    ['contacts', 'Contacts'], ['fans', 'Pressure'], ['shear', 'Shear'], ['gap', 'Gap'], ['resultants', 'Resultants'], ['supports', 'Supports'], ['loads', 'Loads'],
    ['extremes', 'Maximum, minimum'], ['cells', 'Grid cells'], ['pieces', 'Boundary pieces'],
];
const shownAtFirst = ['field', 'outlines', 'contacts', 'fans', 'supports', 'loads', 'extremes'];
export const modes = [['smooth', 'Smooth'], ['bands', 'Bands'], ['lines', 'Contours']];

/// The nearest of 1, 2, 5 x 10^k.
function nearestNice(value) {
    const decade = 10 ** Math.floor(Math.log10(value));
    return [1, 2, 5, 10].map(m => m * decade).reduce((a, b) => Math.abs(Math.log(b / value)) < Math.abs(Math.log(a / value)) ? b : a);
}

export class State {
    constructor(data) {
        this.data = data;
        this.setAutomatic(data.largestDisplacement);
        Object.assign(this, {shownCase: 0, exaggeration: 0, mode: 'smooth', layers: new Set(shownAtFirst), contact: -1, hovered: -1, part: -1, pins: [], cursor: null,
            locked: false, listeners: [], stamp: 0});
        this.setQuantity('vm');
    }
    /// The enlargement that shows a displacement.
    setAutomatic(displacement) {
        this.automatic = displacement > 0 ? nearestNice(0.05 * this.data.size / displacement) : 1;
    }
    has(layer) {
        return this.layers.has(layer);
    }
    on(listener) {
        this.listeners.push(listener);
    }
    /// what: quantity, range, deformation, layers, contact, hover, pins, cursor, view, theme, data.
    changed(what) {
        this.listeners.forEach(listener => listener(what));
    }
    setQuantity(key) {
        this.quantity = quantityOf(key);
        this.measure();
        this.changed('quantity');
    }
    /// Takes smallest and largest values of what is shown; stamp: of the fields that this was done for.
    measure() {
        ++this.stamp;
        this.ends = extremes(this.quantity, this.data);
        this.automaticRange = this.ends ? automaticRange(this.quantity, this.data, this.ends) : {low: 0, high: 1};
        if (!this.locked) this.range = {...this.automaticRange};
    }
    /// Takes what has become of the data.
    renew() {
        if (!this.data.contacts[this.contact]) this.contact = -1;
        Object.assign(this, {hovered: -1, part: -1, cursor: null, pins: []});
        this.measure();
        this.changed('data');
    }
    nextQuantity(step) {
        this.setQuantity(quantities[(quantities.indexOf(this.quantity) + step + quantities.length) % quantities.length].key);
    }
    set(name, value) {
        if (this[name] === value) return;
        this[name] = value;
        this.changed({exaggeration: 'deformation', mode: 'layers', range: 'range', contact: 'contact', hovered: 'hover', part: 'hover', cursor: 'cursor', locked: 'range'}[name] ?? name);
    }
    toggle(layer, on = !this.has(layer)) {
        if (on) this.layers.add(layer);
        else this.layers.delete(layer);
        this.changed('layers');
    }

    address(view, isFitted) {
        const keys = new URLSearchParams();
        if (this.shownCase > 0) keys.set('k', this.shownCase + 1);
        if (this.contact >= 0) keys.set('c', this.contact + 1);
        if (this.quantity.key !== 'vm') keys.set('q', this.quantity.key);
        if (this.exaggeration) keys.set('d', Number(this.exaggeration.toPrecision(4)));
        if (this.mode !== 'smooth') keys.set('m', this.mode);
        const extra = layers.map(l => l[0]).filter(l => this.has(l) !== shownAtFirst.includes(l));
        if (extra.length) keys.set('layers', extra.map(l => (this.has(l) ? '' : '-') + l).join(','));
        if (this.locked || this.range.low !== this.automaticRange.low || this.range.high !== this.automaticRange.high)
            keys.set('range', [this.range.low, this.range.high].map(v => Number(v.toPrecision(6))).join(','));
        if (!isFitted) keys.set('view', [view.x, view.y, view.width].map(v => Number(v.toPrecision(7))).join(','));
        return keys.toString().replace(/%2C/g, ',');
    }
    /// Takes what an address says; returns the view that it asks for, or null.
    take(address) {
        const keys = new URLSearchParams(address.replace(/^#/, '')), numbers = key => (keys.get(key) ?? '').split(',').map(Number);
        if (keys.has('q')) this.setQuantity(keys.get('q'));
        if (keys.has('d')) this.set('exaggeration', keys.get('d') === 'auto' ? this.automatic : Math.max(0, Number(keys.get('d')) || 0));
        if (keys.has('m') && modes.some(m => m[0] === keys.get('m'))) this.set('mode', keys.get('m'));
        for (const word of (keys.get('layers') ?? '').split(','))
            if (layers.some(l => l[0] === word.replace('-', ''))) this.toggle(word.replace('-', ''), !word.startsWith('-'));
        const [low, high] = numbers('range');
        if (keys.has('range') && high > low) this.set('range', {low, high});
        const contact = Number(keys.get('c')) - 1;
        if (keys.has('c') && this.data.contacts[contact]) this.set('contact', contact);
        const [x, y, width] = numbers('view');
        return keys.has('view') && width > 0 ? {x, y, width} : null;
    }
}
