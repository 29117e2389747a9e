// SPDX-License-Identifier: GPL-3.0-or-later
// The instrument put together: tool bar, canvas, legend, curves and tables, of the report and of the live page.
import 'uplot/dist/uPlot.min.css';
import './instrument.css';
import {Canvas} from './canvas.js';
import {text, withUnit} from './colors.js';
import {element} from './dom.js';
import {Legend} from './legend.js';
import {savePicture} from './picture.js';
import {ContactPlot} from './plot.js';
import {quantities, valueAt} from './quantities.js';
import {State, layers, modes} from './state.js';
import {contactPanel, partPanel} from './tables.js';

const period = 3000;  // milliseconds: from the drawn shape to the deformed and back

function select(name, options, value, choose) {
    const made = element('select', {'aria-label': name, title: name, change: () => choose(made.value)}, ...options.map(([key, words]) => element('option', {value: key}, words)));
    made.value = value;
    return made;
}

function deformation(state) {
    const slider = element('input', {type: 'range', min: 0, max: 1000, 'aria-label': 'Deformation', input: () => state.set('exaggeration', slider.value / 1000 * 2 * state.automatic)});
    const shown = element('output', {class: 'times'});
    let begin = 0;
    const step = now => {
        if (!begin) return;
        state.set('exaggeration', state.automatic * (0.5 - 0.5 * Math.cos(2 * Math.PI * (now - begin) / period)));
        requestAnimationFrame(step);
    };
    const play = element('button', {type: 'button', class: 'small', id: 'play', click: () => {
        begin = begin ? 0 : performance.now();
        play.textContent = begin ? 'Stop' : 'Play';
        if (begin) requestAnimationFrame(step);
        else state.set('exaggeration', state.automatic);
    }}, 'Play');
    const to = (words, value, title) => element('button', {type: 'button', class: 'small', title, click: () => {
        if (begin) play.click();
        state.set('exaggeration', value());
    }}, words);
    const update = () => {
        slider.value = Math.min(1000, 500 * state.exaggeration / state.automatic);
        shown.textContent = '×' + text(state.exaggeration, 3);
    };
    state.on(what => what === 'deformation' && update());
    update();
    return element('span', {class: 'group'}, element('span', {class: 'word'}, 'Deformation'), slider, shown, to('0', () => 0, 'As drawn'), to('1:1', () => 1, 'True size'),
        to('auto', () => state.automatic, 'Enlarged so that it can be seen'), play);
}

function layerMenu(state) {
    const boxes = layers.map(([key, words]) => {
        const box = element('input', {type: 'checkbox', 'data-layer': key, change: () => state.toggle(key, box.checked)});
        return [key, box, element('label', {}, box, ' ' + words)];
    });
    const update = () => boxes.forEach(([key, box]) => box.checked = state.has(key));
    state.on(what => what === 'layers' && update());
    update();
    const menu = element('details', {class: 'menu'}, element('summary', {}, 'Layers'), element('div', {class: 'menu-box'}, ...boxes.map(b => b[2])));
    document.addEventListener('pointerdown', e => menu.contains(e.target) || (menu.open = false));
    return menu;
}

function themeButton(state) {
    const root = document.documentElement, isDark = () => root.dataset.theme ? root.dataset.theme === 'dark' : matchMedia('(prefers-color-scheme: dark)').matches;
    const button = element('button', {type: 'button', class: 'small', id: 'theme', title: 'Light or dark', click: () => {
        root.dataset.theme = isDark() ? 'light' : 'dark';
        state.changed('theme');
    }}, '◐');
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => state.changed('theme'));
    return button;
}

function toolbar(state, canvas) {
    const quantity = select('Quantity', quantities.map(q => [q.key, q.name]), state.quantity.key, key => state.setQuantity(key));
    const mode = select('Drawn as', modes, state.mode, key => state.set('mode', key));
    quantity.id = 'quantity';
    mode.id = 'mode';
    state.on(() => {
        quantity.value = state.quantity.key;
        mode.value = state.mode;
    });
    return element('div', {class: 'toolbar', role: 'toolbar', 'aria-label': 'View'}, quantity, mode, deformation(state), layerMenu(state),
        element('button', {type: 'button', class: 'small', id: 'fit', title: 'Show all (double click, or f)', click: () => canvas.fit()}, 'Fit'),
        element('button', {type: 'button', class: 'small', id: 'picture', title: 'Saves the picture as it is, with its scale, as PNG', click: () => savePicture(canvas)}, 'Picture'), themeButton(state));
}

/// What is under the pointer, in words.
function reading(hit, near, data) {
    const {units} = data, row = (name, words) => element('tr', {}, element('th', {}, name), element('td', {}, words));
    const lines = [row('x, y', `${text(data.rounded(hit.x), 6)}, ${text(data.rounded(hit.y), 6)} ${units.length}`)];
    if (hit.value) {
        const [ux, uy, xx, yy, xy, zz] = hit.value, of = key => valueAt(quantities.find(q => q.key === key), hit.part, hit.value, 0);
        lines.push(row('u', `${text(ux)}, ${text(uy)} ${units.length}; |u| ${text(of('u'))}`), row('von Mises', withUnit(of('vm'), units.stress)),
            row('σ xx, yy, xy', `${text(xx)}, ${text(yy)}, ${text(xy)} ${units.stress}`), row('σ zz', withUnit(zz, units.stress)),
            row('principal', `${text(of('s1'))}, ${text(of('s2'))} ${units.stress}`));
    }
    if (near) {
        const p = near.contact.profile;
        lines.push(row(`contact ${near.contact.index + 1}`, `${p.edges[p.edge[near.i]]}: pressure ${withUnit(p.pressure[near.i], units.stress)}, gap ${withUnit(p.gap[near.i], units.length)}`));
    }
    return [element('b', {}, hit.part?.name ?? ''), element('table', {}, ...lines)];
}

function followPointer(canvas, data, state, tip) {
    const {element: surface} = canvas, hide = () => {
        tip.hidden = true;
        state.set('cursor', null);
    };
    surface.addEventListener('pointermove', event => {
        if (event.buttons) return hide();
        const box = surface.getBoundingClientRect(), x = event.clientX - box.left, y = event.clientY - box.top;
        const near = state.has('contacts') ? canvas.pickContact(x, y) : null;
        const hit = canvas.pick(x, y) ?? (near && {part: near.contact.first, x: near.contact.profile.x[near.i], y: near.contact.profile.y[near.i], value: null});
        state.set('hovered', near ? near.contact.index : -1);
        if (near?.i !== state.cursor?.i || near?.contact !== state.cursor?.contact) state.set('cursor', near);
        tip.hidden = !hit;
        if (!hit) return;
        tip.replaceChildren(...reading(hit, near, data));
        const w = tip.offsetWidth, h = tip.offsetHeight;
        tip.style.left = `${x + 18 + w < canvas.width ? x + 18 : Math.max(0, x - 18 - w)}px`;
        tip.style.top = `${y + 18 + h < canvas.height ? y + 18 : Math.max(0, y - 18 - h)}px`;
    });
    surface.addEventListener('pointerleave', () => {
        hide();
        state.set('hovered', -1);
    });
    let from = null;
    surface.addEventListener('pointerdown', event => from = [event.clientX, event.clientY]);
    surface.addEventListener('click', event => {
        if (event.detail > 1 || !from || Math.hypot(event.clientX - from[0], event.clientY - from[1]) > 4) return;
        const box = surface.getBoundingClientRect(), x = event.clientX - box.left, y = event.clientY - box.top;
        if (canvas.clickTakers.some(takes => takes(event))) return;
        const near = state.has('contacts') ? canvas.pickContact(x, y, 8) : null, hit = canvas.pick(x, y);
        const old = state.pins.findIndex(pin => Math.hypot(...canvas.samplePixel(pin).map((v, k) => v - [x, y][k])) < 8);
        if (old >= 0) state.pins.splice(old, 1);
        else if (near) return state.set('contact', near.contact.index);
        else if (hit) state.pins.push(hit);
        state.changed('pins');
    });
}

function keyboard(canvas, state, root) {
    const step = 60, keys = {
        ArrowLeft: () => canvas.panBy(step, 0), ArrowRight: () => canvas.panBy(-step, 0), ArrowUp: () => canvas.panBy(0, step), ArrowDown: () => canvas.panBy(0, -step),
        '+': () => canvas.zoomBy(1.4), '=': () => canvas.zoomBy(1.4), '-': () => canvas.zoomBy(1 / 1.4), f: () => canvas.fit(), 0: () => canvas.fit(),
        q: () => state.nextQuantity(1), Q: () => state.nextQuantity(-1), d: () => state.set('exaggeration', state.exaggeration ? 0 : state.automatic), ' ': () => root.querySelector('#play').click(),
        c: () => data.contacts.length && state.set('contact', (state.contact + 2) % (data.contacts.length + 1) - 1),
        Escape: () => {
            state.pins.length = 0;
            state.set('contact', -1);
            state.changed('pins');
        },
    }, {data} = state;
    canvas.element.addEventListener('keydown', event => {
        if (event.ctrlKey || event.metaKey || event.altKey || !keys[event.key]) return;
        event.preventDefault();
        keys[event.key]();
    });
}

/// Width / height of a canvas that has the model with room for labels and axes on all sides, a sixth of its width in all.
function aspectOf({x0, x1, y0, y1}) {
    const width = x1 - x0 || 1;
    return Math.min(4, Math.max(0.5, 1.17 * width / (y1 - y0 + 0.17 * width)));
}

/// Fills a root with the instrument; more: elements for the top of the column of tables.
export function start(data, root, ...more) {
    const state = new State(data);
    const surface = element('canvas', {tabindex: 0, role: 'img', 'aria-label': 'The parts with the chosen quantity; arrow keys move it, + and - zoom, f fits, q changes the quantity, d deforms, c goes through the contacts'});
    const tip = element('div', {class: 'tip', hidden: true});
    const stage = element('div', {class: 'stage'}, surface, tip);
    root.append(stage);
    stage.style.setProperty('--aspect', aspectOf(data.box));
    const canvas = new Canvas(surface, data, state), plot = new ContactPlot(data, state);
    const hint = element('p', {class: 'hint'}, 'Wheel zooms, drag moves, double click fits, click pins a label. Keys: arrows + - f q d c space.');
    root.replaceChildren(toolbar(state, canvas), element('div', {class: 'columns'}, element('div', {class: 'main-column'}, element('div', {class: 'with-legend'}, stage, new Legend(state).root), hint, plot.root),
        element('div', {class: 'side-column'}, ...more, element('h2', {}, 'Contacts'), contactPanel(data, state, canvas), element('h2', {}, 'Parts'), partPanel(data, state, canvas))));
    plot.make();
    followPointer(canvas, data, state, tip);
    keyboard(canvas, state, root);

    let saving = 0;
    const save = () => {
        clearTimeout(saving);
        saving = setTimeout(() => {
            const address = state.address(canvas.view(), canvas.isFitted);
            if (address !== location.hash.slice(1)) history.replaceState(null, '', address ? '#' + address : location.pathname + location.search);
        }, 300);
    };
    state.on(what => {
        canvas.draw(['deformation', 'range', 'data'].includes(what));
        if (!['hover', 'cursor', 'pins', 'theme', 'data'].includes(what)) save();
    });
    const take = () => {
        const view = state.take(location.hash);
        if (view) canvas.show(view);
    };
    canvas.resize();
    take();
    addEventListener('hashchange', take);
    canvas.paint();  // what a browser cannot do shows here
    return {data, state, canvas};
}
