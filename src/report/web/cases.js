// SPDX-License-Identifier: GPL-3.0-or-later
// Load cases, or steps, in one instrument: tabs, a slider, and what becomes of contacts and parts over them.
import uPlot from 'uplot';
import {text} from './colors.js';
import {unpack} from './data.js';
import {element} from './dom.js';
import {start} from './instrument.js';
import {contactKeys} from './tables.js';

const height = 220, mostCurves = 8, curveColors = ['#1864ab', '#d3102b', '#2b8a3e', '#7b2fbf', '#d98200', '#0b7285', '#a61e4d', '#5c940d'];

/// What may be followed: a name, a unit, and curves {name, values} over the cases, the largest first.
function followed(cases) {
    const size = list => Math.max(0, ...list.map(v => Math.abs(v ?? 0)));
    const ofContacts = value => {
        const names = new Map();
        cases.forEach((c, k) => {
            const keys = contactKeys(c.data.contacts);
            c.data.contacts.forEach((contact, i) => {
                if (!names.has(keys[i])) names.set(keys[i], {name: contact.between.join(' – '), values: cases.map(() => null)});
                names.get(keys[i]).values[k] = value(contact);
            });
        });
        return [...names.values()];
    };
    const ofParts = value => cases[0].data.parts.map((part, i) => ({name: part.name, values: cases.map(c => c.data.parts[i] ? value(c.data.parts[i]) : null)}));
    const largest = (contact, key) => contact.profile[key] ? size(contact.profile[key]) : null;
    const {units} = cases[0].data, energy = units.force && units.length ? `${units.force} ${units.length}` : '';
    return [
        ['largest pressure', units.stress, ofContacts(c => c.max_pressure.value)], ['contact force', units.force, ofContacts(c => Math.hypot(...c.force))],
        ['contact length', units.length, ofContacts(c => c.length)], ['shear force', units.force, ofContacts(c => c.shear_force ?? null)],
        ['largest slip', units.length, ofContacts(c => largest(c, 'slip'))], ['work against slip', energy, ofContacts(c => c.dissipated ?? null)],
        ['largest von Mises stress', units.stress, ofParts(p => p.max_von_mises.value)], ['largest displacement', units.length, ofParts(p => p.max_displacement.value)],
    ].map(([name, unit, curves]) => ({name, unit, curves: curves.filter(c => size(c.values) > 0).sort((a, b) => size(b.values) - size(a.values)).slice(0, mostCurves)}))
        .filter(f => f.curves.length);
}

/// Curves over the cases; a click chooses one.
function curvePanel(cases, word, state, choose) {
    const choices = followed(cases);
    if (!choices.length || cases.length < 3) return null;  // two points are no curve
    const box = element('div', {class: 'plot-box'}), key = element('div', {class: 'curve-key'}), reading = element('div', {class: 'plot-reading'});
    const quantity = element('select', {'aria-label': `Quantity over the ${word}s`, change: () => make()}, ...choices.map((c, k) => element('option', {value: k}, c.name)));
    const root = element('div', {class: 'plot'}, element('div', {class: 'plot-head'}, element('div', {class: 'plot-title'}, `Over the ${word}s`), quantity), box, key, reading);
    let chart = null;
    const make = () => {
        chart?.destroy();
        const {name, unit, curves} = choices[quantity.value], style = getComputedStyle(root), of = variable => style.getPropertyValue(variable).trim();
        const axis = {stroke: of('--ink'), grid: {stroke: of('--line'), width: 1}, ticks: {stroke: of('--line'), width: 1}, font: '11px system-ui', labelFont: '12px system-ui'};
        const marked = u => {
            const x = u.valToPos(state.shownCase + 1, 'x', true), c = u.ctx;
            c.save();
            c.strokeStyle = of('--soft');
            c.setLineDash([4, 4]);
            c.beginPath();
            c.moveTo(x, u.bbox.top);
            c.lineTo(x, u.bbox.top + u.bbox.height);
            c.stroke();
            c.restore();
        };
        chart = new uPlot({
            width: box.clientWidth || 600, height, legend: {show: false}, cursor: {y: false, drag: {x: false, y: false}},
            scales: {x: {time: false, range: () => [0.7, cases.length + 0.3]}, y: {range: (u, low, high) => [1.08 * Math.min(0, low), 1.08 * Math.max(0, high) || 1]}},
            series: [{}, ...curves.map((curve, k) => ({stroke: curveColors[k], width: 2, points: {show: true, size: 6, fill: curveColors[k]}}))],
            axes: [{...axis, label: word, size: 32, labelSize: 18, incrs: [1, 2, 5, 10, 20, 50, 100], values: (u, list) => list.map(v => Number.isInteger(v) && cases[v - 1] ? cases.length > 6 ? String(v) : cases[v - 1].name : '')},
                {...axis, label: name + (unit ? ` [${unit}]` : ''), size: 62, labelSize: 18, values: (u, list) => list.map(v => text(v, 5))}],
            hooks: {draw: [marked], setCursor: [u => read(u.cursor.idx)]},
        }, [cases.map((_, k) => k + 1), ...curves.map(c => c.values)], box);
        chart.over.addEventListener('click', () => Number.isInteger(chart.cursor.idx) && choose(chart.cursor.idx));
        key.replaceChildren(...curves.map((curve, k) => element('span', {class: 'curve-name'}, element('span', {class: 'swatch', style: 'background:' + curveColors[k]}), curve.name)));
        read(null);
    };
    const read = k => {
        const {name, unit, curves} = choices[quantity.value], at = k ?? state.shownCase;
        reading.textContent = `${cases[at].name}: ${name} ` + curves.slice(0, 4).map(c => `${c.name} ${text(c.values[at])}`).join('; ') + (unit ? ` ${unit}` : '');
    };
    new ResizeObserver(() => chart ? chart.setSize({width: box.clientWidth, height}) : box.clientWidth && make()).observe(box);
    state.on(what => {
        if (what === 'theme') make();
        if (what === 'shownCase') {
            chart?.redraw();
            read(null);
        }
    });
    return root;
}

/// The instrument over all cases of a page.
export function startCases({cases, steps}, root) {
    const word = steps ? 'step' : 'load case', fresh = cases.map(() => null);
    // What is drawn is unpacked where it is looked at; numbers of tables are as they came.
    const dataOf = k => fresh[k] ??= unpack(structuredClone(cases[k].data));
    const data = {...dataOf(0)}, instrument = element('div');
    root.append(instrument);
    const sentence = element('p', {class: 'verdict', 'aria-live': 'polite'}), loads = element('p', {class: 'facts'});
    const tabs = cases.map((c, k) => element('button', {type: 'button', role: 'tab', title: c.loads, click: () => choose(k)}, c.name));
    const slider = cases.length > 3 ? element('input', {type: 'range', min: 0, max: cases.length - 1, step: 1, 'aria-label': word, input: () => choose(Number(slider.value))}) : null;
    const made = start(data, instrument), {state, canvas} = made;
    // One enlargement for all, so that they can be compared; of the one that moves most.
    state.shownCase = 0;
    const most = Math.max(...cases.map(c => Math.max(0, ...c.data.parts.map(p => p.max_displacement.value ?? 0))));
    state.setAutomatic(most);
    const show = () => {
        const k = state.shownCase, kept = canvas.isFitted ? null : canvas.view();
        Object.assign(data, dataOf(k));
        canvas.resize();
        if (kept) canvas.show(kept);
        state.renew();
        tabs.forEach((tab, i) => tab.setAttribute('aria-selected', i === k));
        if (slider) slider.value = k;
        sentence.className = 'verdict ' + ({reached: '', solved_but: 'doubtful', failed: 'failed'}[cases[k].verdict] ?? '');
        sentence.textContent = `${cases[k].name}: ${cases[k].sentence}`;
        loads.textContent = cases[k].loads === cases[k].sentence ? '' : cases[k].loads;
    };
    const choose = k => state.set('shownCase', k);
    state.on(what => what === 'shownCase' && show());
    const curves = curvePanel(cases, word, state, choose);
    root.prepend(element('div', {class: 'tabs', role: 'tablist', 'aria-label': `${word}s`}, ...tabs, slider), sentence, loads);
    if (curves) root.append(curves);
    const take = () => {
        const k = Number(new URLSearchParams(location.hash.slice(1)).get('k')) - 1;
        if (cases[k]) choose(k);
    };
    addEventListener('hashchange', take);
    show();
    take();
    return {...made, cases, choose};
}
