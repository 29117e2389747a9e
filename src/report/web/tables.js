// SPDX-License-Identifier: GPL-3.0-or-later
// Contacts and parts as tables beside the canvas; a row and its place light up together.
import {boxOf} from './data.js';
import {text, withUnit} from './colors.js';
import {element, sortableTable} from './dom.js';

const inBrackets = unit => unit ? ` [${unit}]` : '';

/// A value, and how much it differs from what it was in a state that is kept to compare with.
function compared(words, now, before) {
    if (before === undefined || before === null || !Number.isFinite(now)) return words;
    const change = before ? 100 * (now - before) / Math.abs(before) : 0, size = Math.abs(change);
    const said = before === now || size < 0.05 ? '±0 %' : !before ? 'new' : `${change > 0 ? '+' : '−'}${size >= 1000 ? '>1000' : text(size, size < 10 ? 2 : 3)} %`;
    return element('span', {class: 'compared'}, words, element('small', {class: 'change'}, said));
}

/// Names of contacts that stay the same from answer to answer: the same edges may touch more than once.
export function contactKeys(contacts) {
    const seen = new Map();
    return contacts.map(c => {
        const name = c.between.join(' – '), n = (seen.get(name) ?? 0) + 1;
        seen.set(name, n);
        return `${name} ${n}`;
    });
}

function markRows(root, attribute, index) {
    for (const row of root.querySelectorAll('tr[' + attribute + ']')) row.classList.toggle('lit', Number(row.getAttribute(attribute)) === index);
}

export function contactPanel(data, state, canvas) {
    const {units} = data, size = c => Math.hypot(...c.force), before = c => data.ghost?.contacts.get(contactKeys(data.contacts)[c.index]);
    const columns = [
        {name: '#', number: true, value: c => c.index + 1},
        {name: 'contact', value: c => [0, 1].map(k => c.between[k] || data.parts[c.parts[k]].name).join(' – ')},
        {name: 'status', value: c => c.kind === 'contact' ? c.status : c.kind},
        {name: 'force' + inBrackets(units.force), number: true, value: size, show: c => compared(text(size(c)), size(c), before(c)?.size)},
        {name: 'max pressure' + inBrackets(units.stress), number: true, value: c => c.max_pressure.value ?? 0,
            show: c => compared(text(c.max_pressure.value) + (c.at_corner ? '*' : '') + (data.tellsErrors && c.error && !c.at_corner && !c.isOpen ? ` ± ${text(100 * c.error, 2)} %` : ''), c.max_pressure.value ?? 0, before(c)?.peak)},
    ];
    const decorate = (contact, row) => {
        const pick = () => state.set('contact', state.contact === contact.index ? -1 : contact.index);
        row.setAttribute('data-contact', contact.index);
        row.tabIndex = 0;
        row.title = [contact.interface, 'length ' + withUnit(contact.length, units.length), 'double click: zoom there',
            contact.at_corner ? '* at a sharp corner, where pressure has no limit' : ''].filter(Boolean).join('; ');
        row.addEventListener('pointerenter', () => state.set('hovered', contact.index));
        row.addEventListener('pointerleave', () => state.set('hovered', -1));
        row.addEventListener('click', pick);
        row.addEventListener('keydown', e => e.key === 'Enter' && pick());
        row.addEventListener('dblclick', () => {
            state.set('contact', contact.index);
            const p = contact.profile, carries = p.x.map((_, i) => contact.isOpen || p.pressure[i] !== 0);
            canvas.showBox(boxOf(p.x.filter((_, i) => carries[i]), p.y.filter((_, i) => carries[i])));
        });
        row.classList.toggle('lit', state.contact === contact.index);
        return row;
    };
    const search = element('input', {type: 'search', placeholder: 'Search parts and edges', 'aria-label': 'Search contacts', input: () => find()});
    const find = () => {
        const words = search.value.toLowerCase().split(/\s+/).filter(Boolean);
        for (const row of root.querySelectorAll('tr[data-contact]')) row.hidden = !words.every(w => row.textContent.toLowerCase().includes(w));
        if (words.length) folded.open = true;
    };
    const closed = sortableTable(columns, () => data.contacts.filter(c => !c.isOpen), decorate, 'Contacts');
    const open = sortableTable(columns, () => data.contacts.filter(c => c.isOpen), decorate, 'Open contacts');
    const none = element('p', {}, 'No parts touch.'), closedBox = element('div', {class: 'scroll'}, closed);
    const summary = element('summary'), folded = element('details', {class: 'open-contacts', open: data.contacts.every(c => c.isOpen)}, summary, open);
    const note = cornerNote(), root = element('div', {class: 'panel contacts-panel'}, none, search, closedBox, note, folded);
    const update = () => {
        const n = data.contacts.filter(c => c.isOpen).length;
        none.hidden = data.contacts.length > 0;
        search.hidden = data.contacts.length <= 6;
        closedBox.hidden = n === data.contacts.length;
        folded.hidden = n === 0;
        note.hidden = !data.contacts.some(c => c.at_corner);
        summary.textContent = `${n} open`;
        find();
    };
    state.on(what => {
        if (what === 'contact' || what === 'hover') markRows(root, 'data-contact', state.hovered >= 0 ? state.hovered : state.contact);
        if (what !== 'data') return;
        closed.refill();
        open.refill();
        update();
    });
    update();
    return root;
}

const cornerNote = () => element('p', {class: 'note'}, '* at a sharp corner: it has no limit and grows with every finer grid');

/// What is nothing but rounding beside the largest reads as 0.
const beside = (value, largest) => Math.abs(value) < 1e-9 * largest ? 0 : value;

export function partPanel(data, state, canvas) {
    const largest = key => Math.max(0, ...data.parts.map(p => p[key].value ?? 0));
    const {units} = data, hasYield = data.parts.some(p => p.utilisation !== null), before = p => data.ghost?.parts.get(p.name);
    const columns = [
        {name: 'part', value: p => p.name, show: p => element('span', {class: 'part-cell'}, element('span', {class: 'swatch', style: 'background:' + p.color}), p.name)},
        {name: 'material', value: p => p.material},
        {name: 'max von Mises' + inBrackets(units.stress), number: true, value: p => p.max_von_mises.value ?? 0,
            show: p => p.solved && p.hasField ? compared(text(beside(p.max_von_mises.value, largest('max_von_mises'))) + (p.at_corner ? '*' : ''), p.max_von_mises.value, before(p)?.stress) : p.rigid ? 'rigid' : '–'},
    ];
    if (hasYield)
        columns.push({name: 'of yield', number: true, value: p => p.utilisation ?? -1, show: p => p.utilisation === null ? '–' : element('span', {class: 'meter'},
            element('span', {class: 'fill' + (p.utilisation > 1 ? ' over' : ''), style: `width:${Math.min(100, 100 * p.utilisation)}%`}),
            element('span', {}, text(100 * p.utilisation, 3) + ' %'))});
    columns.push({name: 'max |u|' + inBrackets(units.length), number: true, value: p => p.max_displacement.value ?? 0, show: p => p.solved ? compared(text(beside(p.max_displacement.value, largest('max_displacement'))), p.max_displacement.value, before(p)?.displacement) : '–'});
    const decorate = (part, row) => {
        const index = data.parts.indexOf(part);
        row.setAttribute('data-part', index);
        row.tabIndex = 0;
        row.title = part.at_corner ? '* at a corner, where stress has no limit; double click: zoom there' : 'double click: zoom there';
        row.addEventListener('pointerenter', () => state.set('part', index));
        row.addEventListener('pointerleave', () => state.set('part', -1));
        row.addEventListener('dblclick', () => canvas.showBox(part.box, 0.8));
        row.addEventListener('keydown', e => e.key === 'Enter' && canvas.showBox(part.box, 0.8));
        return row;
    };
    const table = sortableTable(columns, () => data.parts, decorate, 'Parts'), note = cornerNote(), root = element('div', {class: 'panel'}, element('div', {class: 'scroll'}, table), note);
    const update = () => note.hidden = !data.parts.some(p => p.at_corner);
    state.on(what => {
        if (what === 'hover') markRows(root, 'data-part', state.part);
        if (what !== 'data') return;
        table.refill();
        update();
    });
    update();
    return root;
}
