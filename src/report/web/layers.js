// SPDX-License-Identifier: GPL-3.0-or-later
// What lies over the field: cells, contacts, pressure, supports, loads, resultants, labels.
import {cellsOf} from './cells.js';
import {text, ticks, withUnit} from './colors.js';
import {valueAt} from './quantities.js';
import {sampleAt} from './raster.js';

export const contactColor = '#d3102b', shearColor = '#7b2fbf', gapColor = '#1864ab', slipColor = '#2b8a3e';
const openColor = '#f08300', pickColor = '#e8590c';
const fanShare = 0.045, fanMost = 110;  // the largest pressure: of the model's size, and in pixels
const cellColors = ['#0000', '#f0830066', '#2f9e4433'];  // outer, boundary, inner
const arrowLength = 64, mostNumbers = 10;

export function label(canvas, words, x, y, {color = canvas.ink, side = 1, bold = false} = {}) {
    if (x < -20 || y < -20 || x > canvas.width + 20 || y > canvas.height + 20) return;
    const c = canvas.context;
    c.font = `${bold ? '600 ' : ''}12px system-ui, "Segoe UI", "DejaVu Sans", sans-serif`;
    const width = c.measureText(words).width + 10, height = 19;
    let left = x + (side > 0 ? 10 : -10 - width), top = y - height - 6;
    left = Math.min(Math.max(left, 4), canvas.width - width - 4);
    top = Math.min(Math.max(top, 4), canvas.height - height - 4);
    // labels make room for those before them
    for (let tries = 0; tries < 12 && canvas.labels.some(b => left < b.x + b.w && b.x < left + width && top < b.y + b.h && b.y < top + height); ++tries)
        top += (tries % 2 ? -1 : 1) * (tries + 1) * height;
    canvas.labels.push({x: left, y: top, w: width, h: height});
    c.beginPath();
    c.moveTo(x, y);
    c.lineTo(Math.min(Math.max(x, left), left + width), Math.min(Math.max(y, top), top + height));
    c.strokeStyle = color;
    c.lineWidth = 1;
    c.stroke();
    c.beginPath();
    c.roundRect(left, top, width, height, 3);
    c.fillStyle = canvas.paper;
    c.globalAlpha = 0.92;
    c.fill();
    c.globalAlpha = 1;
    c.stroke();
    c.fillStyle = color;
    c.textAlign = 'left';
    c.textBaseline = 'middle';
    c.fillText(words, left + 5, top + height / 2 + 0.5);
}

export function arrow(c, x, y, dx, dy, color, width = 2) {
    const length = Math.hypot(dx, dy);
    if (!(length > 1)) return;
    const ex = dx / length, ey = dy / length, head = Math.min(10, length / 2);
    c.strokeStyle = c.fillStyle = color;
    c.lineWidth = width;
    c.beginPath();
    c.moveTo(x, y);
    c.lineTo(x + dx - head * ex, y + dy - head * ey);
    c.stroke();
    c.beginPath();
    c.moveTo(x + dx, y + dy);
    c.lineTo(x + dx - head * ex - 0.45 * head * ey, y + dy - head * ey + 0.45 * head * ex);
    c.lineTo(x + dx - head * ex + 0.45 * head * ey, y + dy - head * ey - 0.45 * head * ex);
    c.fill();
    c.lineWidth = 1;
}

export function ring(c, x, y, radius, color, paper) {
    c.beginPath();
    c.arc(x, y, radius, 0, 2 * Math.PI);
    c.lineWidth = 3.5;
    c.strokeStyle = paper;
    c.stroke();
    c.lineWidth = 1.6;
    c.strokeStyle = color;
    c.stroke();
    c.lineWidth = 1;
}

export function drawCells(canvas) {
    const c = canvas.context;
    for (const part of canvas.data.parts) {
        part.cells ??= cellsOf(part);
        if (!part.cells) continue;
        const {classes, boxes} = part.cells, {angle} = part.grid, cos = Math.cos(angle), sin = Math.sin(angle);
        const at = (u, v) => canvas.pixel(cos * u - sin * v, sin * u + cos * v);
        c.lineWidth = 0.6;
        c.strokeStyle = canvas.soft;
        for (const kind of [0, 1, 2]) {
            c.beginPath();
            classes.forEach((own, k) => {
                if (own !== kind) return;
                const [u0, v0, u1, v1] = boxes[k], corners = [at(u0, v0), at(u1, v0), at(u1, v1), at(u0, v1)];
                if (corners.every(p => p[0] < 0) || corners.every(p => p[0] > canvas.width) || corners.every(p => p[1] < 0) || corners.every(p => p[1] > canvas.height)) return;
                c.moveTo(...corners[0]);
                for (let n = 1; n < 4; ++n) c.lineTo(...corners[n]);
                c.closePath();
            });
            c.fillStyle = cellColors[kind];
            c.fill();
            c.stroke();
        }
    }
}

/// The ends of the pieces into which cells cut the boundary.
export function drawPieces(canvas) {
    const c = canvas.context, e = canvas.state.exaggeration;
    for (const part of canvas.data.parts) {
        part.cells ??= cellsOf(part);
        const {x, y, value} = part.loops;
        c.beginPath();
        for (const i of part.cells?.ends ?? []) {
            const [px, py] = canvas.pixel(x[i] + e * value[6 * i], y[i] + e * value[6 * i + 1]);
            c.rect(px - 2, py - 2, 4, 4);
        }
        c.fillStyle = canvas.paper;
        c.fill();
        c.strokeStyle = canvas.ink;
        c.stroke();
    }
}

export function drawContacts(canvas) {
    const c = canvas.context, {state} = canvas;
    canvas.labels = [];
    c.lineCap = 'round';
    for (const contact of canvas.data.contacts) {
        const {profile} = contact, picked = state.contact === contact.index || state.hovered === contact.index;
        if (!state.has('contacts') && !picked) continue;
        for (const closed of [false, true]) {
            c.beginPath();
            for (let i = 0; i + 1 < profile.x.length; ++i) {
                const carries = Math.abs(profile.pressure[i]) > 1e-6 * contact.peak || Math.abs(profile.pressure[i + 1]) > 1e-6 * contact.peak;
                if ((contact.peak > 0 && carries) !== closed) continue;
                c.moveTo(...canvas.profilePixel(contact, i));
                c.lineTo(...canvas.profilePixel(contact, i + 1));
            }
            if (picked) {
                c.lineWidth = closed ? 10 : 8;
                c.strokeStyle = '#ffd43bb0';
                c.stroke();
            }
            c.lineWidth = closed ? 3.5 : 2;
            c.strokeStyle = closed ? contactColor : openColor;
            c.stroke();
        }
    }
    c.lineCap = 'butt';
    c.lineWidth = 1;
    canvas.numbered = state.has('contacts') ? numbered(canvas.data.contacts, state) : [];
    for (const contact of canvas.numbered) drawNumber(canvas, contact);
}

/// Contacts that show their numbers: those of the largest pressures, and those that are looked at.
function numbered(contacts, state) {
    const order = contacts.map((_, k) => k).sort((a, b) => contacts[b].peak - contacts[a].peak || a - b), most = new Set(order.slice(0, mostNumbers));
    return contacts.filter((c, k) => most.has(k) || state.contact === k || state.hovered === k);
}

function anchorOf(contact) {
    const p = contact.profile, n = p.x.length;
    if (!n) return -1;
    if (!(contact.peak > 0)) return n >> 1;
    return p.pressure.reduce((best, v, i) => Math.abs(v) > Math.abs(p.pressure[best]) ? i : best, 0);
}

function drawNumber(canvas, contact) {
    const i = anchorOf(contact), c = canvas.context;
    if (i < 0) return;
    const [x, y] = canvas.profilePixel(contact, i), words = String(contact.index + 1), radius = words.length < 3 ? 9 : 12;
    if (x < -20 || x > canvas.width + 20 || y < -20 || y > canvas.height + 20) return;
    // Beside the contact where nothing else stands: on the second part, on the first, further along, further away.
    const [nx, ny] = [contact.nx[i], -contact.ny[i]], isFree = ([px, py]) => canvas.labels.every(b => Math.hypot(px - b.x - b.w / 2, py - b.y - b.h / 2) > radius + b.w / 2 + 1);
    const places = [1, 2].flatMap(far => [[1, 0], [-1, 0], [1, 1], [1, -1], [-1, 1], [-1, -1]].map(([n, t]) => [x - 16 * far * n * nx - 20 * far * t * ny, y - 16 * far * n * ny + 20 * far * t * nx]));
    const free = places.find(isFree);
    if (contact.isOpen && !free) return;
    const [px, py] = free ?? places[0];
    if (Math.hypot(px - x, py - y) > 17) {
        c.beginPath();
        c.moveTo(x, y);
        c.lineTo(px, py);
        c.strokeStyle = contact.isOpen ? openColor : contactColor;
        c.stroke();
    }
    c.beginPath();
    c.arc(px, py, radius, 0, 2 * Math.PI);
    c.fillStyle = contact.isOpen ? openColor : contactColor;
    c.fill();
    c.strokeStyle = '#fff';
    c.stroke();
    c.fillStyle = '#fff';
    c.font = '700 11px system-ui, sans-serif';
    c.textAlign = 'center';
    c.textBaseline = 'middle';
    c.fillText(words, px, py + 0.5);
    canvas.labels.push({x: px - radius, y: py - radius, w: 2 * radius, h: 2 * radius});
}

/// Pixels for the largest value of all contacts.
export function fanHeight(canvas) {
    return Math.min(fanMost, fanShare * canvas.data.size * canvas.place.scale);
}

const peakOf = (contact, key) => (contact.profile[key] ?? []).reduce((most, v) => Math.max(most, Math.abs(v)), 0);
export const largestOf = (contacts, key) => Math.max(0, ...contacts.map(c => peakOf(c, key)));

/// The pressure (shear, gap) over the edge of the first part, to one scale for all contacts; the picked contact to its own.
export function drawFans(canvas, key, color) {
    const c = canvas.context, {state, data} = canvas, largest = largestOf(data.contacts, key);
    for (const contact of data.contacts) {
        const values = contact.profile[key], peak = peakOf(contact, key);
        // an open contact's gap says little beside those of closed ones
        if (!(peak > 0) || (key === 'gap' && contact.isOpen && state.contact !== contact.index)) continue;
        const n = values.length, height = fanHeight(canvas) / (state.contact === contact.index ? peak : largest);
        const tip = i => {
            const [x, y] = canvas.profilePixel(contact, i), h = values[i] * height;
            return [x + h * contact.nx[i], y - h * contact.ny[i]];
        };
        const spacing = Math.max(1, Math.round(n / 45));
        c.strokeStyle = color;
        for (let from = 0; from < n; ++from) {
            if (!values[from]) continue;
            let to = from;
            while (to + 1 < n && values[to + 1]) ++to;
            const a = Math.max(0, from - 1), b = Math.min(n - 1, to + 1);
            c.beginPath();
            for (let i = a; i <= b; ++i) c.lineTo(...tip(i));
            c.lineWidth = 1.8;
            c.stroke();
            for (let i = b; i >= a; --i) c.lineTo(...canvas.profilePixel(contact, i));
            c.fillStyle = '#ffffffa0';
            c.fill();
            c.beginPath();
            for (let i = a; i <= b; i += spacing) {
                c.moveTo(...canvas.profilePixel(contact, i));
                c.lineTo(...tip(i));
            }
            c.lineWidth = 0.8;
            c.stroke();
            from = to;
        }
    }
    c.lineWidth = 1;
}

/// Marks that keep their distance in the picture.
function thinned(canvas, marks, spacing) {
    const kept = [];
    for (const mark of marks) {
        const [x, y] = canvas.pixel(...mark.at);
        if (x < -40 || y < -40 || x > canvas.width + 40 || y > canvas.height + 40) continue;
        if (kept.every(k => Math.hypot(k.x - x, k.y - y) >= spacing)) kept.push({...mark, x, y, fixX: mark.x, fixY: mark.y, of: mark});
    }
    return kept;
}

export function drawSupports(canvas) {
    const c = canvas.context;
    c.strokeStyle = canvas.ink;
    c.fillStyle = canvas.paper;
    for (const mark of thinned(canvas, canvas.data.marks.supports, 13)) {
        let [nx, ny] = [mark.normal[0], -mark.normal[1]];
        const both = mark.fixX === mark.fixY;
        if (!both) {
            const axis = mark.fixX ? [1, 0] : [0, 1], s = nx * axis[0] + ny * axis[1] >= 0 ? 1 : -1;
            [nx, ny] = [s * axis[0], s * axis[1]];
        }
        const [tx, ty] = [-ny, nx], at = (n, t) => [mark.x + n * nx + t * tx, mark.y + n * ny + t * ty];
        c.beginPath();
        if (both && mark.fixX) {
            c.moveTo(...at(0, -6));
            c.lineTo(...at(0, 6));
            for (const t of [-4, 0, 4]) {
                c.moveTo(...at(0, t));
                c.lineTo(...at(7, t + 4));
            }
            c.lineWidth = 1.2;
            c.stroke();
        } else {
            c.moveTo(...at(0, 0));
            c.lineTo(...at(7, 4));
            c.lineTo(...at(7, -4));
            c.closePath();
            c.fill();
            c.stroke();
            c.beginPath();
            c.moveTo(...at(10, -6));
            c.lineTo(...at(10, 6));
            c.stroke();
        }
    }
    c.lineWidth = 1;
}

export function drawLoads(canvas) {
    const {data} = canvas, marks = thinned(canvas, data.marks.loads, 16), c = canvas.context, length = 34;
    for (const mark of marks) {
        const dx = length * mark.direction[0], dy = -length * mark.direction[1], [X, Y] = mark.at, step = 1e-3 * data.size;
        const isInside = side => canvas.inside(X + side * step * mark.direction[0], Y + side * step * mark.direction[1]);
        const pulls = mark.of.pulls ??= isInside(-1) && !isInside(1), x = pulls ? mark.x : mark.x - dx, y = pulls ? mark.y : mark.y - dy;
        arrow(c, x, y, dx, dy, canvas.colors.load);
        mark.tail = pulls ? [x + dx, y + dy] : [x, y];
    }
    // A load's value stands at the arrow that is nearest to it.
    for (const load of data.model.loads ?? []) {
        if (!load.at.length || !marks.length) continue;
        const [x, y] = canvas.pixel(...load.at[0]), distance = m => Math.hypot(m.x - x, m.y - y);
        const mark = marks.reduce((a, b) => distance(b) < distance(a) ? b : a);
        if (distance(mark) < 40) label(canvas, (load.name ? load.name + ': ' : '') + load.text, ...mark.tail, {color: canvas.colors.load});
    }
}

/// Resultants of contacts (on the first part, where their line of action crosses the contact) and of supports.
export function drawResultants(canvas) {
    const {data} = canvas, c = canvas.context, list = [];
    for (const contact of data.contacts) {
        const p = contact.profile, [fx, fy] = contact.force, size = Math.hypot(fx, fy);
        if (!(size > 0) || !p.x.length) continue;
        let sum = 0, x = 0, y = 0;
        for (let i = 0; i < p.x.length; ++i) {
            const a = Math.max(0, i - 1), b = Math.min(p.x.length - 1, i + 1), w = Math.abs(p.pressure[i]) * Math.hypot(p.x[b] - p.x[a], p.y[b] - p.y[a]);
            sum += w;
            x += w * (p.x[i] + canvas.state.exaggeration * contact.ux[i]);
            y += w * (p.y[i] + canvas.state.exaggeration * contact.uy[i]);
        }
        if (sum > 0) list.push({x: x / sum, y: y / sum, fx, fy, size, name: `on ${contact.first.name}: `, color: canvas.colors.resultant, side: 1});
    }
    data.reactions.forEach(reaction => {
        const points = data.model.supports?.[reaction.support]?.at ?? [], [fx, fy] = reaction.force, size = Math.hypot(fx, fy);
        if (!points.length || !(size > 0)) return;
        const mean = k => points.reduce((s, p) => s + p[k], 0) / points.length;
        list.push({x: mean(0), y: mean(1), fx, fy, size, name: '', color: canvas.colors.reaction, side: -1});
    });
    const largest = Math.max(0, ...list.map(r => r.size));
    for (const r of list.filter(r => r.size > 1e-6 * largest)) {
        const [x, y] = canvas.pixel(r.x, r.y), l = Math.max(14, arrowLength * r.size / largest), dx = l * r.fx / r.size, dy = -l * r.fy / r.size;
        arrow(c, x - dx, y - dy, dx, dy, r.color, 3);
        label(canvas, r.name + withUnit(r.size, data.units.force), x - dx, y - dy, r);
    }
}

export function drawNames(canvas) {
    const c = canvas.context;
    c.font = '12px system-ui, sans-serif';
    c.textAlign = 'center';
    c.textBaseline = 'middle';
    for (const part of canvas.data.parts) {
        const [x0, y1] = canvas.pixel(part.box.x0, part.box.y0), [x1, y0] = canvas.pixel(part.box.x1, part.box.y1), width = c.measureText(part.name).width;
        if (x1 - x0 < width + 6 || y1 - y0 < 16) continue;
        const spot = [[0.5, 0.5], [0.5, 0.25], [0.5, 0.75], [0.2, 0.5], [0.8, 0.5], [0.5, 0.1], [0.5, 0.9]].map(([u, v]) => [x0 + u * (x1 - x0), y0 + v * (y1 - y0)])
            .find(([x, y]) => [-0.5, 0, 0.5].every(s => canvas.pick(x + s * width, y)?.part === part) && x > 0 && x < canvas.width &&
                !canvas.labels.some(b => x - width / 2 < b.x + b.w && b.x < x + width / 2 && y - 8 < b.y + b.h && b.y < y + 8));
        c.setTransform(canvas.ratio, 0, 0, canvas.ratio, 0, 0);
        if (!spot) continue;
        c.lineWidth = 3;
        c.strokeStyle = canvas.paper;
        c.strokeText(part.name, ...spot);
        c.fillStyle = canvas.ink;
        c.fillText(part.name, ...spot);
        c.lineWidth = 1;
        canvas.labels.push({x: spot[0] - width / 2, y: spot[1] - 8, w: width, h: 16});
    }
}

/// Where a point of a part is drawn, whose displacement is that of the field there.
function displaced(canvas, end) {
    const {part, x, y} = end, sample = end.sample ??= sampleAt(part, x, y, 0);
    return sample ? canvas.samplePixel(sample) : canvas.pixel(x, y);
}

export function drawExtremes(canvas) {
    const {low, high} = canvas.state.ends, {quantity} = canvas.state, unit = canvas.data.units[quantity.unit];
    for (const [end, word] of [[high, 'max '], [low, 'min ']]) {
        const [x, y] = displaced(canvas, end);
        if (x < 0 || y < 0 || x > canvas.width || y > canvas.height) continue;
        ring(canvas.context, x, y, 5, canvas.ink, canvas.paper);
        const corner = quantity.key === 'vm' && word === 'max ' && end.part.at_corner ? ' at a corner' : '';
        // Samples have sixteen bits: what is smaller than their step is not known.
        const from = quantity.unit === 'length' ? 0 : 2, step = Math.max(...end.part.field.scale.slice(from, from + (from ? 4 : 2))) / 32767;
        const isNothing = quantity.key !== 'w' && word === 'min ' && Math.abs(end.value) < 2 * step;
        label(canvas, word + (isNothing ? '≈ ' + withUnit(0, unit) : withUnit(end.value, unit)) + corner, x, y, {bold: true});
    }
}

export function drawPins(canvas) {
    const {state, data, context: c} = canvas, unit = data.units[state.quantity.unit];
    for (const pin of state.pins) {
        const [x, y] = canvas.samplePixel(pin);
        ring(c, x, y, 4, pickColor, canvas.paper);
        label(canvas, pin.value ? withUnit(valueAt(state.quantity, pin.part, pin.value, 0), unit) : pin.part.name, x, y, {color: pickColor, bold: true});
    }
    const cursor = state.cursor;
    if (cursor) ring(c, ...canvas.profilePixel(cursor.contact, cursor.i), 6, contactColor, canvas.paper);
}

export function drawAxes(canvas) {
    const c = canvas.context, [left, bottom] = canvas.point(0, canvas.height), [right, top] = canvas.point(canvas.width, 0);
    const write = (words, x, y) => {
        c.lineWidth = 3;
        c.strokeStyle = canvas.paper;
        c.strokeText(words, x, y);
        c.lineWidth = 1;
        c.fillText(words, x, y);
    };
    c.fillStyle = canvas.soft;
    c.font = '11px system-ui, sans-serif';
    c.textBaseline = 'alphabetic';
    c.lineWidth = 1;
    c.textAlign = 'center';
    const digits = list => Math.min(10, Math.max(4, 2 + Math.ceil(Math.log10(Math.max(...list.map(Math.abs), 1e-300) / Math.abs((list[1] ?? 1) - (list[0] ?? 0))))));
    const xs = ticks(left, right, canvas.width / 110), ys = ticks(bottom, top, canvas.height / 80);
    c.beginPath();
    for (const v of xs) {
        const [x] = canvas.pixel(v, 0);
        if (x < 46 || x > canvas.width - 74) continue;
        c.moveTo(x, canvas.height);
        c.lineTo(x, canvas.height - 5);
        write(text(v, digits(xs)), x, canvas.height - 8);
    }
    c.textAlign = 'left';
    for (const v of ys) {
        const y = canvas.pixel(0, v)[1];
        if (y < 24 || y > canvas.height - 24) continue;
        c.moveTo(0, y);
        c.lineTo(5, y);
        write(text(v, digits(ys)), 8, y + 4);
    }
    c.strokeStyle = canvas.soft;
    c.stroke();
    const unit = canvas.data.units.length ? ` [${canvas.data.units.length}]` : '';
    write('y' + unit, 8, 14);
    c.textAlign = 'right';
    write('x' + unit, canvas.width - 8, canvas.height - 8);
}
