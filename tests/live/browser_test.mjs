// SPDX-License-Identifier: GPL-3.0-or-later
// The page of abut live in a browser without a window: node browser_test.mjs SOURCES ABUT. Status 77: there is no browser.
import {execFileSync, spawn} from 'node:child_process';
import {existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
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
const folder = mkdtempSync(join(tmpdir(), 'abut_live_')), pictures = process.env.ABUT_PICTURES;
let faults = 0, checks = 0;
function check(what, holds, ...found) {
    ++checks;
    if (holds) return;
    ++faults;
    console.error('FAILED:', what, ...found);
}
const near = (a, b, tolerance) => Math.abs(a - b) <= tolerance;

const servers = [];
/// Serves a scene; the page's address.
async function served(name, text, ...options) {
    const file = join(folder, name.includes('.') ? name : name + '.json');
    writeFileSync(file, text);
    const process = spawn(abut, ['live', file, ...options], {stdio: ['ignore', 'pipe', 'inherit']});
    servers.push(process);
    const line = await new Promise(resolve => process.stdout.once('data', data => resolve(String(data))));
    return {address: line.split(' ')[1].trim(), file};
}
const browser = await chromium.launch({executablePath: browserPath, args: ['--no-sandbox', '--disable-gpu']});
async function open(address, options = {}) {
    const context = await browser.newContext({viewport: {width: 1500, height: 950}, acceptDownloads: true, ...options}), page = await context.newPage(), said = [];
    page.on('console', m => m.type() === 'error' && !m.text().includes('400 (Bad Request)') && said.push(m.text()));
    page.on('pageerror', e => said.push(e.stack));
    page.on('request', r => r.url().startsWith(address) || r.url().startsWith('data:') || r.url().startsWith('blob:') || said.push('asks for ' + r.url()));
    await page.goto(address);
    await page.waitForFunction(() => window.abutReport?.canvas.paths, null, {timeout: 60000});
    return {page, said, close: () => context.close()};
}
const isSettled = page => page.waitForFunction(() => window.abutLive.settled && !window.abutLive.shown.quick && !window.abutLive.sending && window.abutLive.shownVersion === window.abutLive.version, null, {timeout: 60000});
const picture = (page, name) => pictures && page.screenshot({path: join(pictures, name + '.png')});
/// Where the tip of a force is in the window.
const tip = (page, k = 0) => page.evaluate(k => {
    const {handles, view} = window.abutLive, box = view.canvas.element.getBoundingClientRect(), e = handles.ends(handles.list()[k]);
    return [box.left + e.tipX, box.top + e.tipY];
}, k);
const force = (page, k = 0) => page.evaluate(k => window.abutLive.force(k), k);

/// What analyze says of the scene as it was saved.
function analyzed(file, out) {
    execFileSync(abut, ['analyze', file, '-o', join(folder, out), '--quiet'], {stdio: 'inherit'});
    return JSON.parse(readFileSync(join(folder, out, 'result.json'), 'utf8'));
}

async function dragsATip(page, name) {
    const [x, y] = await tip(page), before = await force(page), view = await page.evaluate(() => window.abutReport.canvas.view());
    await page.mouse.move(x, y);
    await page.mouse.down();
    const answers = await page.evaluate(() => window.abutLive.answers), begin = Date.now(), n = 200;
    for (let k = 1; k <= n; ++k) await page.mouse.move(x + 45 * Math.sin(k / 25), y - 25 * (1 - Math.cos(k / 15)));
    await page.waitForFunction(() => !window.abutLive.sending);
    const took = (Date.now() - begin) / 1000, given = await page.evaluate(() => window.abutLive.answers) - answers;
    await picture(page, name + '_dragged');
    check('the force has moved', (await force(page)).join() !== before.join());
    check('the picture has not', near((await page.evaluate(() => window.abutReport.canvas.view())).x, view.x, 1e-9 * view.width));
    check('answers came along the way', given > n / 10, given);  // how many a second depends on who draws the picture
    console.log(`${given} answers to ${n} moves in ${took.toFixed(1)} s: ${(given / took).toFixed(0)} a second`);
    await page.mouse.up();
    check('a drag pins nothing', await page.evaluate(() => window.abutReport.state.pins.length === 0));
}

async function showsWhatAnalyzeSays(page, file, out, result = analyzed(file, out)) {
    await isSettled(page);
    const shown = await page.evaluate(() => ({contacts: window.abutReport.data.contacts.map(c => ({force: c.force, peak: c.max_pressure.value})), parts: window.abutReport.data.parts.map(p => p.max_von_mises.value)}));
    const largest = Math.max(...result.contacts.map(c => c.max_pressure.value)), strongest = Math.max(...result.contacts.map(c => Math.hypot(...c.force)));
    result.contacts.forEach((c, k) => {
        check(`force of contact ${k + 1}`, c.force.every((f, i) => near(f, shown.contacts[k].force[i], 1e-9 * strongest)), c.force, shown.contacts[k].force);
        check(`pressure of contact ${k + 1}`, near(c.max_pressure.value, shown.contacts[k].peak, 1e-9 * largest), c.max_pressure.value, shown.contacts[k].peak);
    });
    result.parts.forEach((p, i) => check(`stress of ${p.name}`, near(p.max_von_mises.value, shown.parts[i], 1e-9 * p.max_von_mises.value), p.max_von_mises.value, shown.parts[i]));
}

async function ofTheBracket() {
    const scene = readFileSync(join(sources, 'data/scenes/pin_bracket.json'), 'utf8').replace('../sketches/', join(sources, 'data/sketches/'));
    const {address, file} = await served('bracket', scene), {page, said, close} = await open(address);
    await showsWhatAnalyzeSays(page, file, 'as_given');
    await picture(page, 'live_bracket');
    await page.click('#ghost');
    check('a ghost differs by nothing', (await page.$$eval('.change', list => list.map(e => e.textContent))).every(t => t === '±0 %'));
    await page.click('text=auto');
    await dragsATip(page, 'live_bracket');
    await isSettled(page);
    check('and then by something', (await page.$$eval('.change', list => list.map(e => e.textContent))).some(t => /^[+−]/.test(t)));
    await picture(page, 'live_bracket_ghost');
    await page.click('#save-scene');
    await page.waitForSelector('.live-said:has-text("Written")');
    await showsWhatAnalyzeSays(page, join(folder, 'bracket_live.json'), 'moved');
    check('the saved scene keeps its comments', readFileSync(join(folder, 'bracket_live.json'), 'utf8').includes('// a shackle pulls the pin down'));
    await page.click('#save-scene');
    await page.waitForSelector('.live-said.wrong:has-text("is there already")');
    const [download] = await Promise.all([page.waitForEvent('download'), page.click('#save-report')]);
    check('a report is saved', readFileSync(await download.path(), 'utf8').includes('abut-data'));
    await page.click('#ghost');
    check('the ghost goes', await page.$$eval('.change', list => list.length) === 0);

    const fields = page.locator('.live-field input');
    await fields.nth(2).fill('12000');
    await fields.nth(2).press('Enter');
    await fields.nth(3).fill('-60');
    await fields.nth(3).press('Enter');
    const typed = await force(page);
    check('a force is typed', near(typed[0], 6000, 1e-6) && near(typed[1], -12000 * Math.sin(Math.PI / 3), 1e-6), typed);
    await isSettled(page);
    check('and answered', near(Math.hypot(...await page.evaluate(() => window.abutReport.data.contacts[0].force)), 12000, 6000));
    await page.click('#theme');
    await picture(page, 'live_bracket_dark');
    await page.click('#theme');
    await page.click('#reset');
    await isSettled(page);
    await showsWhatAnalyzeSays(page, file, 'as_given');

    // another page shows the same state, and moves it
    const other = await open(address);
    const [x, y] = await tip(other.page);
    await other.page.mouse.move(x, y);
    await other.page.mouse.down();
    await other.page.mouse.move(x + 30, y, {steps: 5});
    await other.page.mouse.up();
    await isSettled(other.page);
    await page.waitForFunction(f => window.abutLive.force(0).join() === f, (await force(other.page)).join());
    await isSettled(page);
    check('two pages, one state', (await page.evaluate(() => window.abutReport.data.contacts[0].force.join())) === (await other.page.evaluate(() => window.abutReport.data.contacts[0].force.join())));
    await other.close();
    const tabs = await Promise.all(Array.from({length: 10}, () => open(address)));
    await Promise.all(tabs.map(async ({page: tab}, k) => {
        await tab.evaluate(k => window.abutLive.move(inputs => inputs.loads[0] = [100 * k, -15000]), k);
        await isSettled(tab);
    }));
    // every tab knows of its own move by now, and hears of the others' in its time
    const last = Math.max(...await Promise.all(tabs.map(({page: tab}) => tab.evaluate(() => window.abutLive.version))));
    const states = await Promise.all(tabs.map(async ({page: tab}) => {
        await tab.waitForFunction(v => window.abutLive.settled && window.abutLive.version >= v && window.abutLive.shownVersion === window.abutLive.version, last);
        return tab.evaluate(() => window.abutReport.data.contacts[0].force.join());
    }));
    check('ten tabs, one state', new Set(states).size === 1, states);
    for (const tab of tabs) {
        check('no errors in a tab', tab.said.length === 0, tab.said);
        await tab.close();
    }
    check('no errors, nothing loaded', said.length === 0, said);
    await close();
}

async function ofParameters() {
    const text = `{"abut": 1, "title": "Roller on a beam", "units": {"length": "mm", "force": "N"}, "thickness": 10, "parameters": {"R": {"value": 12, "min": 6, "max": 16}, "place": {"value": 0, "min": -30, "max": 30}},
      "materials": {"steel": {"E": 210000, "nu": 0.3, "yield": 355}},
      "parts": [{"name": "beam", "material": "steel", "geometry": {"rectangle": {"min": [-60, -12], "max": [60, 0]}}},
        {"name": "roller", "material": "steel", "geometry": {"circle": {"center": ["place", "R"], "radius": "R"}}}],
      "supports": [{"on": "beam/left", "fix": ["x", "y"]}, {"on": "beam/right", "fix": ["x", "y"]}, {"part": "roller", "rigid": {"translation": [0, null], "rotation": 0}}],
      "loads": [{"name": "press", "part": "roller", "force": [0, -4000]}, {"on": "beam/bottom", "pressure": 2}]}`;
    const {address, file} = await served('roller', text), {page, said, close} = await open(address);
    await isSettled(page);
    const slider = page.locator('.live-row input[type=range]').nth(2);
    await page.evaluate(() => window.seen = []);
    await page.evaluate(() => window.abutLive.on(what => what === 'whole' && window.seen.push(performance.now())));
    const begin = Date.now();
    for (let k = 0; k <= 40; ++k) {
        await slider.evaluate((s, v) => {
            s.value = v;
            s.dispatchEvent(new Event('input'));
        }, 100 + 2 * k);
        await page.waitForTimeout(50);
    }
    const took = (Date.now() - begin) / 1000, drafts = await page.evaluate(() => window.seen.length);
    console.log(`${drafts} drafts in ${took.toFixed(1)} s of a slider: ${(drafts / took).toFixed(1)} a second`);
    check('drafts follow the slider', drafts > 2, drafts, took);
    await isSettled(page);
    check('the roller is where the slider is', near(await page.evaluate(() => (window.abutReport.data.parts[1].box.x0 + window.abutReport.data.parts[1].box.x1) / 2), 24, 0.01));
    check('so is its arrow', near(await page.evaluate(() => window.abutLive.controls.loads[0].at[0]), 24, 0.01));
    await picture(page, 'live_parameters');
    writeFileSync(file, text.replace('-4000', '4000'));
    await page.waitForSelector('.verdict.failed:has-text("roller")', {timeout: 30000});
    check('a mechanism names its motion', (await page.textContent('.verdict')).includes('roller slides along'), await page.textContent('.verdict'));
    await picture(page, 'live_mechanism');
    writeFileSync(file, text.replace('"E": 210000', '"E": "soft"'));
    await page.waitForSelector('.verdict.failed:has-text("/materials/steel/E")', {timeout: 30000});
    await picture(page, 'live_problem');
    writeFileSync(file, text);
    await page.waitForSelector('.verdict:not(.failed)', {timeout: 30000});
    await isSettled(page);
    servers.at(-1).kill();
    await page.waitForSelector('.verdict.failed:has-text("does not answer")', {timeout: 30000});
    check('no errors, nothing loaded', said.filter(s => !s.includes('ERR_CONNECTION')).length === 0, said);
    await close();
}

/// Where a point of the model is in the window.
const windowPoint = (page, x, y) => page.evaluate(([x, y]) => {
    const {canvas} = window.abutReport, box = canvas.element.getBoundingClientRect(), [px, py] = canvas.pixel(x, y);
    return [box.left + px, box.top + py];
}, [x, y]);

/// A part that is dragged, fits and friction that are set, and a motion that nothing holds.
async function ofParts() {
    const block = (name, min, max) => ({name, material: 'm', geometry: {rectangle: {min, max}}});
    const text = JSON.stringify({abut: 1, title: 'Block', units: {length: 'mm', force: 'N'}, materials: {m: {E: 210000, nu: 0.3}}, parts: [block('base', [-40, -20], [40, 0]), block('block', [-8, 0], [8, 12])],
        supports: [{on: 'base/bottom', fix: ['x', 'y']}, {part: 'block', rigid: {translation: [null, null], rotation: 0}}], loads: [{on: 'block/top', force: [0, -500]}], accuracy: {level: 'draft'}});
    const {address, file} = await served('parts', text), {page, said, close} = await open(address);
    await isSettled(page);
    const drag = async (from, to) => {
        const [a, b] = [await windowPoint(page, ...from), await windowPoint(page, ...to)];
        await page.mouse.move(...a);
        await page.mouse.down();
        await page.mouse.move(...b, {steps: 6});
        await page.mouse.up();
    };
    const places = () => page.evaluate(() => window.abutLive.inputs.settings);
    await drag([4, 6], [12, 6]);
    check('parts stay where they are', Object.keys(await places()).length === 0, await places());
    await page.click('#fit');
    await page.click('#move-parts');
    await drag([20, -10], [25, -10]);
    check('what is held is not dragged', Object.keys(await places()).length === 0, await places());
    await page.click('#fit');
    await drag([4, 6], [14, 6]);
    const moved = (await places())['place block'];
    check('a part is dragged', near(moved[0], 10, 0.3) && near(moved[1], 0, 0.3), moved);
    await drag([14, 6], [14, 6 - moved[1]]);
    await page.evaluate(() => window.abutLive.move(inputs => inputs.settings['place block'][1] = 0));
    await isSettled(page);
    await picture(page, 'live_moved');
    check('and answered there', near(await page.evaluate(() => window.abutReport.data.parts[1].box.x0), -8 + (await places())['place block'][0], 1e-3));
    await page.click('#save-scene');
    await page.waitForSelector('.live-said:has-text("Written")');
    await showsWhatAnalyzeSays(page, join(folder, 'parts_live.json'), 'moved_part');
    await page.click('#reset');
    await isSettled(page);
    await page.click('.live-fits summary');
    const typed = page.locator('.live-fits input[type=number]').first();
    await typed.fill('0.01');
    await typed.press('Enter');
    await isSettled(page);
    check('an interference is typed', (await places())['pair base, block'][0] === 0.01, await places());
    await page.click('#reset');
    await isSettled(page);
    writeFileSync(file, text.replace('-500]', '500]'));
    await page.waitForFunction(() => window.abutLive.mechanism.driven.length === 1, null, {timeout: 30000});
    const still = async () => page.evaluate(() => [...window.abutReport.canvas.context.getImageData(0, 0, window.abutReport.canvas.element.width, window.abutReport.canvas.element.height).data].reduce((s, v, i) => (s + v * (i % 977)) % 1e9, 0));
    const a = await still();
    await page.waitForTimeout(400);
    check('a mechanism moves', await still() !== a);
    await picture(page, 'live_driven');
    check('no errors, nothing loaded', said.length === 0, said);
    await close();
}

/// A drawing whose edges are clicked, to a scene.
async function ofADrawing() {
    const drawing = readFileSync(join(sources, 'data/sketches/pin_bracket_r14.dxf'));
    const {address} = await served('drawn.dxf', drawing, '--thickness', '10'), {page, said, close} = await open(address);
    await isSettled(page);
    const choose = async (at, item, edge = null) => {
        await page.mouse.click(...await windowPoint(page, ...at));
        if (edge) await page.click(`.edge-names >> text="${edge}"`);
        const n = await page.locator('.conditions li').count();
        await page.click(`.edge-menu button:text-is("${item}")`);
        await page.waitForFunction(n => document.querySelectorAll('.conditions li').length === n, n + 1, {timeout: 30000});
        await isSettled(page);
    };
    await choose([30, -15], 'x and y');
    await choose([45, 9], 'x');
    await picture(page, 'live_drawing');
    await choose([0, 60], 'force', 'pin/hA15');
    const conditions = await page.evaluate(() => ({supports: window.abutLive.drawing.supports, loads: window.abutLive.drawing.loads}));
    check('what was clicked', JSON.stringify(conditions.supports) === '[{"on":"base/hA16","fix":["x","y"]},{"on":"bracket/hA13","fix":["x"]}]' && conditions.loads[0].on === 'pin/hA15', conditions);
    const fields = page.locator('.live-field input');
    await fields.nth(0).fill('0');
    await fields.nth(0).press('Enter');
    await fields.nth(1).fill('-20000');
    await fields.nth(1).press('Enter');
    await isSettled(page);
    check('it is answered', await page.evaluate(() => window.abutLive.shown.status) === 'ok');
    await choose([-45, 9], 'x');
    check('forces stay as they were moved', (await force(page)).join() === '0,-20000', await force(page));
    await picture(page, 'live_pointed');
    await page.click('#save-scene');
    await page.waitForSelector('.live-said:has-text("Written")');
    await showsWhatAnalyzeSays(page, join(folder, 'drawn_live.json'), 'drawn');
    await page.click('.conditions li:last-child button');
    await page.waitForFunction(() => document.querySelectorAll('.conditions li').length === 3);
    check('no errors, nothing loaded', said.length === 0, said);
    await close();
}

await ofTheBracket();
await ofParameters();
await ofParts();
await ofADrawing();
await browser.close();
servers.forEach(server => server.kill());
rmSync(folder, {recursive: true});
console.log(`${checks} checks, ${faults} faults`);
process.exit(faults ? 1 : 0);
