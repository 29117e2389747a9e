// SPDX-License-Identifier: GPL-3.0-or-later
// Pressure, shear and gap along a contact's edges, by uPlot; its cursor and the canvas's are one.
import uPlot from 'uplot';
import {text, withUnit} from './colors.js';
import {copy, element} from './dom.js';
import {contactColor, shearColor, slipColor} from './layers.js';

const height = 230;

function csv({profile: p}) {
    const cell = words => /[",\n]/.test(words) ? `"${words.replaceAll('"', '""')}"` : words;
    const lists = ['s', 'x', 'y', 'pressure', 'gap', ...(p.slip ? ['shear', 'slip', 'state'] : [])];
    // as contact_<k>.csv is written
    return ['edge,' + lists.join(','), ...p.s.map((_, i) => [cell(p.edges[p.edge[i]]), ...lists.map(l => p[l][i] ?? '')].join(','))].join('\n') + '\n';
}

export class ContactPlot {
    constructor(data, state) {
        Object.assign(this, {data, state, chart: null, shown: null});
        this.heading = element('div', {class: 'plot-title'});
        this.reading = element('div', {class: 'plot-reading', 'aria-live': 'polite'});
        this.box = element('div', {class: 'plot-box'});
        this.copyButton = element('button', {type: 'button', class: 'small', click: async () => {
            await copy(csv(this.shown));
            this.copyButton.textContent = 'Copied';
            setTimeout(() => this.copyButton.textContent = 'Copy as CSV', 1500);
        }}, 'Copy as CSV');
        this.root = element('div', {class: 'plot', hidden: true}, element('div', {class: 'plot-head'}, this.heading, this.copyButton), this.box, this.reading);
        state.on(what => {
            if (what === 'contact' || what === 'theme') this.make();
            if (what === 'data') this.renew();
            if (what === 'cursor') this.follow();
        });
        new ResizeObserver(() => this.chart?.setSize({width: this.box.clientWidth, height})).observe(this.box);
    }

    /// The contact that is picked, or else the strongest: what most readers look for first.
    get wanted() {
        return this.data.contacts[this.state.contact] ?? this.data.contacts.reduce((best, c) => c.peak > (best?.peak ?? 0) ? c : best, null);
    }

    make() {
        this.chart?.destroy();
        this.chart = null;
        this.shown = this.wanted;
        this.root.hidden = !this.shown || this.shown.profile.x.length < 2;
        if (this.root.hidden) return;
        const contact = this.shown, p = contact.profile, {units} = this.data, style = getComputedStyle(this.root);
        const ink = style.getPropertyValue('--ink').trim(), line = style.getPropertyValue('--line').trim(), gapColor = style.getPropertyValue('--gap').trim();
        this.heading.replaceChildren(element('span', {class: 'disc' + (contact.isOpen ? ' open' : '')}, String(contact.index + 1)), ` ${contact.between[0]} – ${contact.between[1]}`);
        const axis = {stroke: ink, grid: {stroke: line, width: 1}, ticks: {stroke: line, width: 1}, font: '11px system-ui', labelFont: '12px system-ui', values: (u, list) => list.map(v => v === null ? '' : text(v, 5))};
        const name = (words, unit) => words + (unit ? ` [${unit}]` : '');
        const abscissa = contact.hasArc ? 's on ' + p.edges[0] : 'length along ' + p.edges.join(', ');
        // Gaps that are nothing beside the displacements are not drawn as if they were something.
        const least = 0.02 * this.data.largestDisplacement || 1e-6 * this.data.size;
        const tension = p.pressure.some(v => v < 0) || p.shear;
        this.chart = new uPlot({
            width: this.box.clientWidth || 600, height, legend: {show: false}, scales: {x: {time: false}, pressure: {range: (u, low, high) => [tension ? 1.08 * Math.min(low, 0) : 0, 1.08 * Math.max(high, 0) || 1]},
                gap: {range: (u, low, high) => [low < -0.1 * least ? low : 0, Math.max(1.08 * high, least)]}},
            cursor: {y: false, points: {size: 8}, drag: {x: true, y: false}},
            series: [{}, {scale: 'pressure', stroke: contactColor, width: 2, fill: '#d3102b1c', points: {show: false}},
                {scale: 'gap', stroke: gapColor, width: 1.5, dash: [6, 3], points: {show: false}},
                ...(p.shear ? [{scale: 'pressure', stroke: shearColor, width: 1.5, points: {show: false}}] : []),
                ...(p.slip ? [{scale: 'gap', stroke: slipColor, width: 1.5, dash: [2, 3], points: {show: false}}] : [])],
            axes: [{...axis, label: name(abscissa, units.length), size: 34, labelSize: 20}, {...axis, scale: 'pressure', label: name(p.shear ? 'pressure, shear' : 'pressure', units.stress), size: 56, labelSize: 18},
                {...axis, scale: 'gap', side: 1, label: name(p.slip ? 'gap, slip' : 'gap', units.length), grid: {show: false}, size: 62, labelSize: 18, stroke: gapColor}],
            hooks: {setCursor: [chart => this.read(this.turned(chart.cursor.idx))]},
        }, this.lists(), this.box);
        this.read(null);
    }

    /// What is drawn; uPlot takes ascending abscissas.
    lists() {
        const {falls, along, profile: p} = this.shown;
        return [along, p.pressure, p.gap, ...(p.shear ? [p.shear] : []), ...(p.slip ? [p.slip] : [])].map(list => falls ? list.slice().reverse() : list);
    }

    /// Takes what has become of the contact that is shown.
    renew() {
        const before = this.chart?.series.length, contact = this.wanted;
        if (!contact || contact.between.join() !== this.shown?.between.join()) return this.make();
        this.shown = contact;
        const lists = this.lists();
        if (lists.length !== before) return this.make();
        this.chart.setData(lists);
        this.read(null);
    }

    /// Between points of the profile and of the chart.
    turned(i) {
        return i !== null && i !== undefined && this.shown.falls ? this.shown.along.length - 1 - i : i;
    }

    /// Says what is at a point of the curves, and shows the place in the canvas.
    read(i) {
        const contact = this.shown, {units} = this.data;
        if (!contact) return;
        const p = contact.profile, at = i ?? p.pressure.indexOf(Math.max(...p.pressure));
        this.reading.textContent = (i === null || i === undefined ? 'Largest: ' : '') + `${p.edges[p.edge[at]]}, s = ${withUnit(p.s[at], units.length)}, (${text(this.data.rounded(p.x[at]), 6)}, ${text(this.data.rounded(p.y[at]), 6)}): pressure ${withUnit(p.pressure[at], units.stress)}, gap ${withUnit(p.gap[at], units.length)}` +
            (p.shear ? `, shear ${withUnit(p.shear[at], units.stress)}` : '') + (p.slip ? `, slip ${withUnit(p.slip[at], units.length)}, ${p.state[at]}` : '');
        if (!this.following) this.state.set('cursor', i === null || i === undefined ? null : {contact, i});
    }

    /// Takes the cursor to where the canvas has it.
    follow() {
        const {cursor} = this.state;
        if (!this.chart || (cursor && cursor.contact !== this.shown)) return;
        if (cursor && this.turned(this.chart.cursor.idx) === cursor.i) return;
        this.following = true;
        this.chart.setCursor(cursor ? {left: this.chart.valToPos(this.shown.along[cursor.i], 'x'), top: 10} : {left: -10, top: -10});
        this.following = false;
    }
}
