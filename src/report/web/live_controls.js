// SPDX-License-Identifier: GPL-3.0-or-later
// What is moved beside the picture: loads as numbers, parameters as sliders; what is kept and saved.
import {text} from './colors.js';
import {element} from './dom.js';

const steps = 200;  // of a slider
const short = value => Number(value.toPrecision(6));

function numberField(label, value, set) {
    const field = element('input', {type: 'number', step: 'any', 'aria-label': label, title: label, change: () => Number.isFinite(field.valueAsNumber) && set(field.valueAsNumber)});
    field.value = short(value);
    return field;
}
/// Shows a number, but not under the hands of whom types one.
const show = (field, value) => document.activeElement === field || (field.value = short(value));

const nameOf = load => load.name || `${load.kind} on ${load.on.join(', ') || 'all parts'}`;

function forceRow(live, load, k) {
    const set = (x, y) => live.move(inputs => inputs.loads[k] = [x, y]), now = () => live.force(k);
    const polar = () => [Math.hypot(...now()), Math.atan2(now()[1], now()[0]) * 180 / Math.PI];
    const turned = (size, degrees) => set(...[Math.cos, Math.sin].map(f => Number((size * f(degrees * Math.PI / 180)).toPrecision(12))));
    const name = nameOf(load), x = numberField(`${name}: x`, 0, v => set(v, now()[1])), y = numberField(`${name}: y`, 0, v => set(now()[0], v));
    const size = numberField(`${name}: size`, 0, v => turned(v, polar()[1])), angle = numberField(`${name}: angle`, 0, v => turned(polar()[0], v));
    const update = () => {
        const [length, degrees] = polar();
        show(x, now()[0]);
        show(y, now()[1]);
        show(size, length);
        show(angle, Number(degrees.toFixed(3)));
    };
    const field = (words, own, unit) => element('label', {class: 'live-field'}, element('span', {class: 'word'}, words), own, unit ? element('span', {class: 'word'}, unit) : null);
    return {update, row: element('div', {class: 'live-row'}, element('div', {class: 'live-name'}, name), element('div', {class: 'live-fields'},
        field('x', x, load.unit), field('y', y, load.unit), field('size', size, load.unit), field('angle', angle, '°')))};
}

function slider(name, low, high, set) {
    const track = element('input', {type: 'range', min: 0, max: steps, step: 1, 'aria-label': name, input: () => set(short(low + (high - low) * track.value / steps))});
    const typed = numberField(name, 0, set);
    return {track, typed, update: value => {
        if (document.activeElement !== track || !track.matches(':active')) track.value = Math.round(steps * (value - low) / (high - low));
        show(typed, value);
    }};
}

/// Any other load: its factor.
function factorRow(live, load, k) {
    const low = load.sign ? 0 : -2, given = element('span', {class: 'word'});
    const own = slider(`factor of ${nameOf(load)}`, low, 2, v => live.move(inputs => inputs.loads[k] = [v]));
    const update = () => {
        const {value, unit} = live.controls.loads[k];
        given.textContent = `(${value.length ? `${value.map(v => text(v)).join(', ')}${unit ? ' ' + unit : ''}` : 'as given'}) ×`;
        own.update(live.inputs.loads[k][0]);
    };
    return {update, row: element('div', {class: 'live-row'}, element('div', {class: 'live-name'}, nameOf(load)), element('div', {class: 'live-fields'}, given, own.track, own.typed))};
}

function parameterRow(live, parameter) {
    const {name, min, max} = parameter;
    const own = slider(name, min, max, v => live.move(inputs => inputs.parameters[name] = Math.min(max, Math.max(min, v))));
    const fault = element('div', {class: 'live-fault', hidden: true});
    const update = () => {
        own.update(live.inputs.parameters[name]);
        const wrong = live.problems.find(p => p.where.includes(parameter.where));
        fault.hidden = !wrong;
        fault.textContent = wrong?.what ?? '';
    };
    return {update, row: element('div', {class: 'live-row'}, element('div', {class: 'live-name'}, name), element('div', {class: 'live-fields'},
        element('span', {class: 'word'}, text(min)), own.track, element('span', {class: 'word'}, text(max)), own.typed), fault)};
}

/// Friction of all contacts, or the interference of a fit.
function settingRow(live, {key, kind, parts, min, max, value: [given]}) {
    const between = parts.filter(Boolean).join(' – '), name = kind === 'friction' ? 'coefficient of friction' : `interference${between ? ` of ${between}` : ''}`;
    const own = slider(name, min, max, v => live.move(inputs => inputs.settings[key] = [Math.min(max, Math.max(min, v))]));
    const update = () => own.update((live.inputs.settings[key] ?? [given])[0]);
    return {update, row: element('div', {class: 'live-row'}, element('div', {class: 'live-name'}, kind === 'friction' ? 'friction' : between || key), element('div', {class: 'live-fields'},
        element('span', {class: 'word'}, text(min)), own.track, element('span', {class: 'word'}, text(max)), own.typed))};
}

function savePanel(live) {
    const said = element('div', {class: 'live-said', 'aria-live': 'polite'});
    const stem = live.controls.file.split('/').pop().replace(/\.json$/, '');
    const name = element('input', {type: 'text', value: `${stem}_live.json`, 'aria-label': 'File name', spellcheck: 'false'});
    const say = (words, isWrong) => {
        said.textContent = words;
        said.classList.toggle('wrong', Boolean(isWrong));
    };
    const wrong = error => say(Array.isArray(error) ? error.map(p => [p.where, p.what, p.hint].filter(Boolean).join(': ')).join('; ') : 'The program does not answer', true);
    const saveScene = element('button', {type: 'button', id: 'save-scene', click: async () => {
        try {
            say('Written: ' + (await (await live.request('save', {name: name.value})).json()).saved);
        } catch (error) {
            wrong(error);
        }
    }}, 'Save scene');
    const saveReport = element('button', {type: 'button', id: 'save-report', click: async () => {
        try {
            say('Waiting for the answer …');
            const page = await (await live.request('report')).blob(), link = element('a', {href: URL.createObjectURL(page), download: `${stem}_report.html`});
            link.click();
            setTimeout(() => URL.revokeObjectURL(link.href), 10000);
            say('');
        } catch (error) {
            wrong(error);
        }
    }}, 'Save report');
    return element('div', {class: 'live-row'}, element('div', {class: 'live-fields'}, name, saveScene, saveReport), said);
}

export function controlPanel(live) {
    const root = element('div', {class: 'panel live-controls'});
    let rows = [], built = '';
    const ghost = element('button', {type: 'button', id: 'ghost', title: 'Keeps this state in the picture, and its differences beside the numbers', click: () => live.ghost.isKept ? live.ghost.forget() : live.ghost.keep()});
    const reset = element('button', {type: 'button', id: 'reset', title: 'As in the file', click: () => live.move(inputs => {
        const {controls} = live;
        inputs.loads = controls.cases.length ? structuredClone(controls.cases[0].loads) : controls.loads.map(() => [1]);
        for (const p of controls.parameters) inputs.parameters[p.name] = p.value;
        inputs.settings = {};
    })}, 'Reset');
    const move = element('button', {type: 'button', id: 'move-parts', title: 'Then a part is dragged where its supports let it slide', click: () => live.mover.toggle()}, 'Move parts');
    const build = () => {
        const {controls} = live;
        rows = [...controls.loads.map((load, k) => (load.force ? forceRow : factorRow)(live, load, k)), ...controls.parameters.map(p => parameterRow(live, p))];
        const loads = rows.slice(0, controls.loads.length), parameters = rows.slice(controls.loads.length);
        const settings = kinds => controls.settings.filter(s => kinds.includes(s.kind)).map(s => settingRow(live, s)), friction = settings(['friction']), fits = settings(['rule', 'pair']);
        const wasOpen = Boolean(root.querySelector('.live-fits')?.open);
        rows.push(...friction, ...fits);
        const cases = controls.cases.map(c => element('button', {type: 'button', click: () => live.move(inputs => inputs.loads = structuredClone(c.loads))}, c.name));
        root.replaceChildren(
            ...(live.pointing ? [live.pointing.panel()] : []),
            ...(loads.length ? [element('h2', {}, 'Loads'), element('p', {class: 'hint'}, 'Drag a tip in the picture; Shift turns it alone, Ctrl changes its length alone.')] : []),
            cases.length ? element('div', {class: 'live-fields'}, element('span', {class: 'word'}, controls.remembers ? 'Steps (each by itself, from where parts are drawn)' : 'Cases'), ...cases) : '',
            ...loads.map(r => r.row), ...(parameters.length ? [element('h2', {}, 'Parameters')] : []), ...parameters.map(r => r.row),
            ...(friction.length || fits.length ? [element('h2', {}, 'Contacts')] : []), ...friction.map(r => r.row),
            fits.length ? element('details', {class: 'live-fits', open: wasOpen}, element('summary', {}, `Fits: interference, or clearance below 0${live.data.units.length ? ` [${live.data.units.length}]` : ''}`), ...fits.map(r => r.row)) : '',
            element('div', {class: 'live-fields live-buttons'}, move, ghost, reset), savePanel(live));
    };
    const update = () => {
        // Where loads act goes with the geometry; what there is to move does not.
        const structure = JSON.stringify([live.controls.file, live.controls.loads.map(({at, value, ...rest}) => rest), live.controls.cases, live.controls.parameters.map(p => [p.name, p.min, p.max]), live.controls.settings, live.drawing?.supports, live.drawing?.loads]);
        if (structure !== built) build();
        built = structure;
        rows.forEach(r => r.update());
        ghost.textContent = live.ghost.isKept ? 'Let the ghost go' : 'Pin as ghost';
        ghost.setAttribute('aria-pressed', live.ghost.isKept);
        move.setAttribute('aria-pressed', live.mover.isOn);
    };
    live.on(what => ['controls', 'inputs', 'edges', 'problems', 'ghost', 'moving'].includes(what) && update());
    update();
    return root;
}

