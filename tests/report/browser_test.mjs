// SPDX-License-Identifier: GPL-3.0-or-later
// Reports in a browser without a window: node browser_test.mjs SOURCES ABUT. Status 77: there is no browser.
import {execFileSync} from 'node:child_process';
import {existsSync, mkdtempSync, readFileSync, rmSync, statSync, writeFileSync} from 'node:fs';
import {createRequire} from 'node:module';
import {tmpdir} from 'node:os';
import {join} from 'node:path';

const [sources, abut] = process.argv.slice(2);
const browserPath = [process.env.CHROMIUM, '/usr/bin/chromium', '/usr/bin/chromium-browser', '/usr/bin/google-chrome'].find(p => p && existsSync(p));
if (!browserPath) {
    console.log('skipped: chromium is not installed');
    process.exit(77);
}
const {chromium} = createRequire(join(sources, 'src/report/web/package.json'))('playwright-core');
const folder = mkdtempSync(join(tmpdir(), 'abut_report_'));
let faults = 0, checks = 0;

function check(what, holds, ...found) {
    ++checks;
    if (holds) return;
    ++faults;
    console.error('FAILED:', what, ...found);
}
const near = (a, b, tolerance) => Math.abs(a - b) <= tolerance;

/// Seven rows of bricks, 9 below and 3 on top, each on two others: 42.
function heap() {
    const parts = [];
    for (let row = 0; row < 7; ++row)
        for (let k = 0; k < 9 - row; ++k)
            parts.push({name: `brick_${row + 1}_${k + 1}`, material: 'stone', geometry: {rectangle: {min: [22 * k + 11 * row, 10 * row], max: [22 * k + 11 * row + 20, 10 * row + 10]}}});
    const bottom = parts.slice(0, 9), top = parts.slice(-3);
    return {abut: 1, title: 'Heap of 42 bricks', units: {length: 'mm', force: 'N'}, thickness: 10, materials: {stone: {E: 20000, nu: 0.2, yield: 30}}, parts,
        supports: bottom.map(p => ({on: p.name + '/bottom', fix: ['x', 'y']})), loads: top.map(p => ({on: p.name + '/top', pressure: 2})), accuracy: {level: 'draft'}};
}

/// The answer of a scene (text or file), and the path of its report.
function analyzed(name, scene) {
    const file = typeof scene === 'string' && existsSync(scene) ? scene : join(folder, name + '.json'), out = join(folder, name);
    if (file !== scene) writeFileSync(file, scene);
    execFileSync(abut, ['analyze', file, '-o', out, '--quiet'], {stdio: 'inherit'});
    return {result: JSON.parse(readFileSync(join(out, 'result.json'), 'utf8')), report: join(out, 'report.html')};
}

const browser = await chromium.launch({executablePath: browserPath, args: ['--no-sandbox', '--disable-gpu']});

async function open({report}, hash = '', options = {}) {
    const context = await browser.newContext({viewport: {width: 1400, height: 950}, ...options}), page = await context.newPage(), said = [];
    page.on('console', m => m.type() === 'error' && said.push(m.text()));
    page.on('pageerror', e => said.push(e.stack));
    page.on('request', r => r.url().startsWith('file://' + report) || said.push('asks for ' + r.url()));
    await page.goto('file://' + report + hash);
    if (options.javaScriptEnabled !== false) await page.waitForFunction(() => window.abutReport?.canvas.paths);
    return {page, said, close: () => context.close()};
}
const settled = page => page.waitForTimeout(350);
/// Of a point of the model: where it is in the window.
const windowPoint = (page, x, y) => page.evaluate(([x, y]) => {
    const {canvas} = window.abutReport, box = canvas.element.getBoundingClientRect(), [px, py] = canvas.pixel(x, y);
    return [box.left + px, box.top + py];
}, [x, y]);
/// As colors.js writes numbers.
const shown = (value, digits = 4) => String(Number(value.toPrecision(digits)));

async function valuesAreThoseOfTheResult(page, result) {
    const data = await page.evaluate(() => {
        const {data, state} = window.abutReport, cells = data.parts.map(p => p.name);
        state.toggle('cells', true);
        return {parts: data.parts.map(p => ({u: p.max_displacement, vm: p.max_von_mises, utilisation: p.utilisation})), contacts: data.contacts.map(c => ({force: c.force, peak: c.max_pressure, length: c.length, pressure: c.profile.pressure})), cells};
    });
    await settled(page);
    const classes = await page.evaluate(() => {
        window.abutReport.state.toggle('cells', false);
        return window.abutReport.data.parts.map(p => p.cells && [2, 1, 0].map(kind => p.cells.classes.filter(c => c === kind).length));
    });
    result.parts.forEach((p, i) => {
        check(`largest displacement of ${p.name}`, data.parts[i].u.value === p.max_displacement.value && data.parts[i].u.at.join() === p.max_displacement.at.join());
        check(`largest stress of ${p.name}`, data.parts[i].vm.value === p.max_von_mises.value);
        check(`utilisation of ${p.name}`, data.parts[i].utilisation === p.utilisation);
        if (p.cells) check(`cells of ${p.name}`, classes[i].join() === [p.cells.inner, p.cells.boundary, p.cells.outer].join(), classes[i], p.cells);
    });
    result.contacts.forEach((c, k) => {
        check(`contact ${k + 1}`, data.contacts[k].force.join() === c.force.join() && data.contacts[k].peak.value === c.max_pressure.value && data.contacts[k].length === c.contact_length);
        check(`curve of contact ${k + 1}`, data.contacts[k].pressure.every((p, i) => near(p, c.profile.pressure[i], 1e-6 * c.max_pressure.value)));
    });
    const rows = await page.$$eval('tr[data-contact]', list => list.map(r => [Number(r.dataset.contact), ...[...r.cells].map(c => c.textContent)]));
    check('a row for each contact', rows.length === result.contacts.length, rows.length);
    for (const [k, number, , , force, peak] of rows) {
        const c = result.contacts[k];
        check(`row of contact ${k + 1}`, Number(number) === k + 1 && force === shown(Math.hypot(...c.force)) && peak.replace('*', '') === shown(c.max_pressure.value), number, force, peak);
    }
}

async function hoverReads(page, result) {
    // Between the samples of the pictures fields are linear: a patch is a 160th of the model.
    const scale = {};
    for (const p of result.probes) {
        const [ux, uy] = p.displacement, all = {ux, uy, ...p.stress};
        for (const [key, value] of Object.entries(all)) scale[key[0] === 'u' ? 'u' : 's'] = Math.max(scale[key[0] === 'u' ? 'u' : 's'] ?? 0, Math.abs(value));
    }
    for (const p of result.probes) {
        const [x, y] = await windowPoint(page, ...p.at);
        await page.mouse.move(x, y);
        const tip = await page.textContent('.tip');
        check('the tip names the part', tip.startsWith(p.part), tip);
        const value = await page.evaluate(([x, y]) => {
            const {canvas} = window.abutReport, box = canvas.element.getBoundingClientRect(), hit = canvas.pick(x - box.left, y - box.top);
            return hit.value;
        }, [x, y]);
        [...p.displacement, p.stress.xx, p.stress.yy, p.stress.xy, p.stress.zz].forEach((exact, c) =>
            check(`component ${c} at ${p.at}`, near(value[c], exact, 0.01 * scale[c < 2 ? 'u' : 's']), value[c], exact));
        check('the tip says the stress', tip.includes('von Mises') && tip.includes('MPa'));
    }
    await page.mouse.move(5, 5);
    check('no tip outside', await page.isHidden('.tip'));
}

async function zoomsAndPans(page) {
    const view = () => page.evaluate(() => window.abutReport.canvas.view());
    const box = await (await page.$('.stage canvas')).boundingBox(), x = Math.round(box.x + box.width / 3), y = Math.round(box.y + box.height / 3), before = await view();
    const pointOf = () => page.evaluate(([x, y]) => window.abutReport.canvas.point(x, y), [x - box.x, y - box.y]);
    const anchor = await pointOf();
    await page.mouse.move(x, y);
    await page.mouse.wheel(0, -400);
    await settled(page);
    const zoomed = await view(), kept = await pointOf();
    check('the wheel zooms', zoomed.width < 0.8 * before.width, zoomed, before);
    check('about the pointer', near(kept[0], anchor[0], 1e-6 * before.width) && near(kept[1], anchor[1], 1e-6 * before.width), kept, anchor);
    await page.mouse.down();
    await page.mouse.move(x + 50, y + 20, {steps: 4});
    await page.mouse.up();
    await settled(page);
    const panned = await view();
    check('dragging pans', near(panned.x, zoomed.x - 50 * zoomed.width / box.width, 1e-3 * zoomed.width) && panned.y > zoomed.y, panned, zoomed);
    check('dragging pins nothing', await page.evaluate(() => window.abutReport.state.pins.length === 0));
    check('the address keeps the view', (await page.evaluate(() => location.hash)).includes('view='));
    await page.mouse.dblclick(x, y);
    await settled(page);
    check('a double click fits', near((await view()).width, before.width, 1e-9 * before.width));
    await page.evaluate(() => {
        window.abutReport.state.pins.length = 0;
    });
}

async function picksContacts(page, {result, report}) {
    await page.click('tr[data-contact="0"]');
    check('a row picks its contact', await page.evaluate(() => window.abutReport.state.contact) === 0);
    check('its curves are shown', await page.isVisible('.plot .u-over'));
    await page.hover('.plot .u-over');
    await settled(page);
    const cursor = await page.evaluate(() => window.abutReport.state.cursor && {i: window.abutReport.state.cursor.i, contact: window.abutReport.state.cursor.contact.index});
    check('the cursor of the curves is in the canvas', cursor?.contact === 0 && cursor.i > 0, cursor);
    const reading = await page.textContent('.plot-reading'), profile = result.contacts[0].profile;
    check('and its values are read', reading.includes(shown(profile.pressure[cursor.i])) && reading.includes(profile.edge[cursor.i]), reading, profile.pressure[cursor.i]);
    await page.context().grantPermissions(['clipboard-read', 'clipboard-write']);
    await page.click('text=Copy as CSV');
    await settled(page);
    const copied = (await page.evaluate(() => navigator.clipboard.readText())).trim().split('\n'), written = readFileSync(join(report, '../contact_1.csv'), 'utf8').trim().split('\n');
    check('copied as CSV', copied[0] === written[0] && copied.length === written.length && copied.every((line, i) => line.split(',').every((cell, k) =>
        cell === written[i].split(',')[k] || near(Number(cell), Number(written[i].split(',')[k]), 1e-6 * Math.max(1, Math.abs(Number(cell)))))), copied[1], written[1]);
    await page.hover('.stage canvas', {position: {x: 5, y: 40}});
    const top = result.contacts[0].max_pressure.at, [x, y] = await windowPoint(page, ...top);
    await page.mouse.move(x + 1, y + 1);
    await settled(page);
    check('the canvas lights up the row', await page.$eval('tr[data-contact="0"]', r => r.classList.contains('lit')));
    check('and moves the cursor of the curves', await page.evaluate(() => window.abutReport.state.cursor?.contact.index === 0));
    check('and reads the pressure', (await page.textContent('.tip')).includes('contact 1'), await page.textContent('.tip'));
}

async function pinsAndKeys(page, probe) {
    const [x, y] = await windowPoint(page, ...probe.at), state = get => page.evaluate(get);
    await page.mouse.click(x, y);
    check('a click pins a label', await state(() => window.abutReport.state.pins.length) === 1);
    await page.focus('.stage canvas');
    await page.keyboard.press('q');
    check('q changes the quantity', await state(() => window.abutReport.state.quantity.key) === 's1');
    const width = await state(() => window.abutReport.canvas.view().width);
    await page.keyboard.press('+');
    check('+ zooms', await state(() => window.abutReport.canvas.view().width) < width);
    await page.keyboard.press('f');
    check('f fits', near(await state(() => window.abutReport.canvas.view().width), width, 1e-6 * width));
    await page.keyboard.press('Escape');
    check('Escape clears', await state(() => window.abutReport.state.pins.length) === 0 && await state(() => window.abutReport.state.contact) === -1);
}

async function deforms(page) {
    const times = () => page.evaluate(() => window.abutReport.state.exaggeration);
    check('as drawn at first', await times() === 0);
    await page.click('text=1:1');
    check('1:1', await times() === 1);
    await page.$eval('#instrument input[type=range]', slider => {
        slider.value = 250;
        slider.dispatchEvent(new Event('input'));
    });
    check('the slider', await times() === await page.evaluate(() => 0.5 * window.abutReport.state.automatic));
    await page.click('#play');
    await page.waitForTimeout(500);
    const a = await times();
    await page.waitForTimeout(300);
    check('play moves', await times() !== a);
    await page.click('#play');
    await page.click('.group >> text="0"');
    check('and back', await times() === 0);
}

async function scales(page) {
    const range = () => page.evaluate(() => ({...window.abutReport.state.range}));
    const before = await range(), handle = await (await page.$('.legend-end.high')).boundingBox();
    await page.mouse.move(handle.x + handle.width / 2, handle.y + handle.height / 2);
    await page.mouse.down();
    await page.mouse.move(handle.x + handle.width / 2, handle.y + 100, {steps: 3});
    await page.mouse.up();
    const dragged = await range();
    check("the legend's end is dragged", dragged.high < before.high && dragged.low === before.low, dragged, before);
    await page.click('text=Lock');
    await page.selectOption('#quantity', 's1');
    check('and locked', (await range()).high === dragged.high);
    await page.click('text=Locked');
    await page.selectOption('#quantity', 'vm');
    check('and set free', (await range()).high === before.high);
    for (const [key] of await page.$$eval('#quantity option', list => list.map(o => [o.value]))) {
        await page.selectOption('#quantity', key);
        const ends = await page.evaluate(() => [window.abutReport.state.ends.low.value, window.abutReport.state.ends.high.value]);
        check(`${key} has a smallest and a largest value`, ends.every(Number.isFinite) && ends[0] <= ends[1], ends);
    }
    for (const mode of ['bands', 'lines', 'smooth']) await page.selectOption('#mode', mode);
    await page.selectOption('#quantity', 'vm');
}

async function isLightAndDark(page) {
    const corner = () => page.evaluate(() => [...window.abutReport.canvas.context.getImageData(30, 30, 1, 1).data].slice(0, 3).reduce((a, b) => a + b));
    const light = await corner();
    await page.click('#theme');
    await settled(page);
    const dark = await corner();
    check('light and dark', light > 700 && dark < 150, light, dark);
    await page.click('#theme');
}

async function pages(page) {
    const text = (await page.pdf({preferCSSPageSize: true})).toString('latin1');
    return (text.match(/\/Type\s*\/Page\b/g) ?? []).length;
}

const bracket = readFileSync(join(sources, 'data/scenes/pin_bracket.json'), 'utf8').replace('../sketches/', join(sources, 'data/sketches/'))
    .replace(/\}\s*$/, ', "output": {"probes": [{"part": "bracket", "at": [3, 25]}, {"part": "base", "at": [10, -7]}, {"part": "pin", "at": [-2, 48]}, {"part": "bracket", "at": [-16, 40]}]}}');
const scenes = {two: join(sources, 'data/scenes/case_b.json'), three: bracket, many: JSON.stringify(heap())};
const most = {two: [1, 5], three: [3, 5], many: [4, 9]};

for (const [name, scene] of Object.entries(scenes)) {
    const before = faults, made = analyzed(name, scene), {page, said, close} = await open(made);
    await valuesAreThoseOfTheResult(page, made.result);
    await scales(page);
    await deforms(page);
    await zoomsAndPans(page);
    await isLightAndDark(page);
    if (name === 'three') {
        await hoverReads(page, made.result);
        await pinsAndKeys(page, made.result.probes[0]);
        await picksContacts(page, made);
        const size = statSync(made.report).size;
        check('below 1 MB', size < 1e6, size);
    }
    const weakest = made.result.contacts.reduce((a, c, k, all) => c.max_pressure.value <= all[a].max_pressure.value ? k : a, 0);
    const numbers = await page.evaluate(k => {
        const {canvas, state} = window.abutReport, shown = () => {
            canvas.paint();
            return canvas.numbered.map(c => c.index);
        }, before = shown();
        state.set('contact', k);
        return [before, shown()];
    }, weakest);
    check('ten contacts have their numbers', numbers[0].length === Math.min(10, made.result.contacts.length), numbers);
    check('and the one that is picked', numbers[1].includes(weakest), numbers, weakest);
    await page.evaluate(() => window.abutReport.state.set('contact', -1));
    const [download] = await Promise.all([page.waitForEvent('download'), page.click('#picture')]);
    const png = readFileSync(await download.path());
    check('a picture is saved', png.subarray(1, 4).toString() === 'PNG' && png.readUInt32BE(16) > await page.evaluate(() => window.abutReport.canvas.element.width), png.length);
    const n = await pages(page);
    check('pages on A4', n >= most[name][0] && n <= most[name][1], n);
    check('no errors, nothing loaded', said.length === 0, said);
    await close();
    const again = await open(made, '#c=1&q=s2&view=1,2,30&m=bands');
    const kept = await again.page.evaluate(() => [window.abutReport.state.contact, window.abutReport.state.quantity.key, window.abutReport.canvas.view(), window.abutReport.state.mode]);
    check('an address is a view', kept[0] === 0 && kept[1] === 's2' && near(kept[2].x, 1, 1e-6) && near(kept[2].width, 30, 1e-6) && kept[3] === 'bands', kept);
    await again.close();
    const without = await open(made, '', {javaScriptEnabled: false});
    check('pictures without a script', await without.page.isVisible('.pictures svg'));
    await without.close();
    console.log(`${name}: ${faults - before ? 'FAILED' : 'ok'}, ${made.result.parts.length} parts, ${(statSync(made.report).size / 1e6).toFixed(2)} MB, ${n} pages`);
}
/// A thin ring, bent by two rollers, with a thousand probes: stresses change sign across it.
function bentRing() {
    const probes = Array.from({length: 1000}, (_, k) => {
        const radius = 19.02 + 0.96 * ((k * 0.618) % 1), angle = 2 * Math.PI * (k + 0.5) / 1000;
        return {part: 'ring', at: [radius * Math.cos(angle), radius * Math.sin(angle)]};
    });
    const block = (name, min, max) => ({name, material: 'm', geometry: {rectangle: {min, max}}});
    return {abut: 1, title: 'Ring', units: {length: 'mm', force: 'N'}, materials: {m: {E: 210000, nu: 0.3}}, parts: [
        {name: 'ring', material: 'm', geometry: {difference: [{circle: {center: [0, 0], radius: 20}, name: 'o'}, {circle: {center: [0, 0], radius: 19}, name: 'i'}]}},
        block('anvil', [-6, -30], [6, -20]), block('stamp', [-6, 20], [6, 30])],
    supports: [{on: 'anvil/bottom', fix: ['x', 'y']}, ...['stamp', 'ring'].map(part => ({part, rigid: {translation: [0, null], rotation: 0}}))],
    loads: [{on: 'stamp/top', traction: [0, -1]}], output: {probes}};
}

/// The picture's values, unpacked and interpolated as pixels are, beside the splines' own.
async function pictureIsTheField() {
    const made = analyzed('ring', JSON.stringify(bentRing())), {page, said, close} = await open(made);
    const shown = await page.evaluate(points => {
        const {canvas} = window.abutReport;
        return points.map(([x, y]) => canvas.pick(...canvas.pixel(x, y))?.value ?? null);
    }, made.result.probes.map(p => p.at));
    const vonMises = ({xx, yy, xy, zz}) => Math.sqrt(((xx - yy) ** 2 + (yy - zz) ** 2 + (zz - xx) ** 2) / 2 + 3 * xy * xy);
    const largest = made.result.parts[0].max_von_mises.value;
    const differences = made.result.probes.map((p, k) => shown[k] ? Math.abs(vonMises({xx: shown[k][2], yy: shown[k][3], xy: shown[k][4], zz: shown[k][5]}) - vonMises(p.stress)) / largest : 1);
    // Patches are a 160th of the model, 7 across the ring: as far as tests/src/answers/field_results_test.cpp has it.
    check('a bent ring is drawn as it is', Math.max(...differences) < 0.04 && differences.reduce((a, b) => a + b) / 1000 < 0.005, Math.max(...differences));
    check('nothing else is asked or said', said.length === 0, said);
    console.log(`ring: 1000 points, largest difference ${(100 * Math.max(...differences)).toFixed(2)} % of the largest stress, mean ${(100 * differences.reduce((a, b) => a + b) / 1000).toFixed(3)} %`);
    await close();
}

/// Steps and load cases: tabs, a slider, curves over them.
async function showsCases(name, file, word) {
    const before = faults, out = join(folder, name);
    execFileSync(abut, ['analyze', file, '-o', out, '--quiet', '--accuracy', 'draft'], {stdio: 'inherit'});
    const list = JSON.parse(readFileSync(join(out, 'cases.json'), 'utf8')).cases, {page, said, close} = await open({report: join(out, 'report.html')});
    const tabs = page.locator('.tabs [role=tab]');
    check('a tab for each', await tabs.count() === list.length, await tabs.count(), list.length);
    for (let k = 0; k < list.length; ++k) {
        await tabs.nth(k).click();
        const result = JSON.parse(readFileSync(join(out, `case_${k + 1}`, 'result.json'), 'utf8'));
        const shown = await page.evaluate(() => ({contacts: window.abutReport.data.contacts.map(c => [...c.force, c.max_pressure.value]), rows: document.querySelectorAll('tr[data-contact]').length, parts: window.abutReport.data.parts.map(p => p.max_von_mises.value), verdict: document.querySelector('#instrument .verdict').textContent}));
        check(`contacts of ${word} ${k + 1}`, result.contacts.every((c, i) => [...c.force, c.max_pressure.value].join() === shown.contacts[i].join()) && shown.rows === result.contacts.length);
        check(`parts of ${word} ${k + 1}`, result.parts.every((p, i) => p.max_von_mises.value === shown.parts[i]));
        check(`verdict of ${word} ${k + 1}`, shown.verdict.startsWith(list[k].name + ': '), shown.verdict);
    }
    if (list.length > 3) {
        await page.$eval('.tabs input[type=range]', slider => {
            slider.value = 1;
            slider.dispatchEvent(new Event('input'));
        });
        check('the slider chooses', await page.evaluate(() => window.abutReport.state.shownCase) === 1);
    }
    check(`curves over the ${word}s`, await page.isVisible('#instrument > .plot .u-over') && (await page.textContent('#instrument > .plot .plot-title')).includes(word));
    if (process.env.ABUT_PICTURES) await page.screenshot({path: join(process.env.ABUT_PICTURES, name + '.png'), fullPage: true});
    await settled(page);
    check('the address keeps it', (await page.evaluate(() => location.hash)).includes('k='));
    check('no errors, nothing loaded', said.length === 0, said);
    await close();
    console.log(`${name}: ${faults - before ? 'FAILED' : 'ok'}, ${list.length} ${word}s, ${(statSync(join(out, 'report.html')).size / 1e6).toFixed(2)} MB`);
}
/// Cells that are halved where small ones are wanted are shown so.
async function showsHalvedCells() {
    const text = readFileSync(join(sources, 'data/scenes/roller_bearing.json'), 'utf8'), made = analyzed('bearing', text), {page, said, close} = await open(made);
    check('cells are halved', await page.evaluate(() => window.abutReport.data.parts.some(p => p.grid.halved.length > 0)));
    const counts = await page.evaluate(() => {
        const {canvas, data, state} = window.abutReport;
        state.toggle('cells', true);
        state.toggle('pieces', true);
        canvas.paint();
        return data.parts.map(p => p.cells.boxes.length);
    });
    // all cells; which of them the boundary only just enters chords do not tell
    made.result.parts.forEach((p, i) => check(`cells of ${p.name}`, counts[i] === p.cells.inner + p.cells.boundary + p.cells.outer, counts[i], p.cells));
    check('no errors, nothing loaded', said.length === 0, said);
    await close();
    console.log(`bearing: ${made.result.contacts.length} contacts, ${made.result.unknowns} unknowns, ${(statSync(made.report).size / 1e6).toFixed(2)} MB`);
}
await pictureIsTheField();
await showsHalvedCells();
await showsCases('cases', join(sources, 'data/scenes/pin_bracket_cases.json'), 'load case');
await showsCases('steps', join(sources, 'data/scenes/clamped_strip.json'), 'step');

await browser.close();
rmSync(folder, {recursive: true});
console.log(`${checks} checks, ${faults} faults`);
process.exit(faults ? 1 : 0);
