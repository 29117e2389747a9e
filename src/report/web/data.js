// SPDX-License-Identifier: GPL-3.0-or-later
// The page's data (src/report/page_data.hpp), unpacked.

export const components = ['ux', 'uy', 'xx', 'yy', 'xy', 'zz'];

/// Signed integers in groups of seven bits.
function integers(base64) {
    const text = atob(base64), n = text.length, list = new Int32Array(n);
    let size = 0;
    for (let i = 0; i < n;) {
        let rest = 0, factor = 1, byte;
        do {
            byte = text.charCodeAt(i++);
            rest += (byte & 127) * factor;
            factor *= 128;
        } while (byte > 127);
        list[size++] = rest % 2 ? -(rest + 1) / 2 : rest / 2;
    }
    return list.subarray(0, size);
}

/// Places and components: x, y of n samples; value[6 i + c].
function unpackSamples(packed, field) {
    const from = integers(packed), n = from.length / 8, x = new Float64Array(n), y = new Float64Array(n), value = new Float32Array(6 * n), now = new Float64Array(8);
    for (let i = 0; i < n; ++i) {
        for (let c = 0; c < 8; ++c) now[c] += from[8 * i + c];
        x[i] = field.origin[0] + field.step * now[0];
        y[i] = field.origin[1] + field.step * now[1];
        for (let c = 0; c < 6; ++c) value[6 * i + c] = now[2 + c] === -32768 ? NaN : now[2 + c] / 32767 * field.scale[c];
    }
    return {n, x, y, value};
}

/// Four samples for each patch, counter-clockwise.
function unpackPatches(packed) {
    const list = integers(packed);
    for (let k = 0, first = 0; k < list.length; ++k) list[k] = k % 4 === 0 ? first += list[k] : first + list[k];
    return list;
}

/// The field of a part and its outline; before: what it was under other loads, in the same places.
export function unpackField(field, before = null) {
    const samples = unpackSamples(field.samples, field), loops = unpackSamples(field.loops, field);
    let end = 0;
    return {field, samples, loops, ranges: field.loop_sizes.map(size => [end, end += size]), inside: field.inside,
        patches: before?.field.patches === field.patches ? before.patches : unpackPatches(field.patches), hasField: samples.n > 0};
}

function unpackPart(part, facts) {
    const own = facts.parts.find(p => p.name === part.name), shape = unpackField(part.field);
    const material = own && facts.materials.find(m => m.name === own.material);
    return {...part, ...shape, E: material?.E ?? NaN, nu: material?.nu ?? NaN, yield: material?.yield ?? null, box: boxOf(shape.loops.x, shape.loops.y)};
}

export function boxOf(x, y) {
    const box = {x0: Infinity, x1: -Infinity, y0: Infinity, y1: -Infinity};
    for (let i = 0; i < x.length; ++i) {
        box.x0 = Math.min(box.x0, x[i]);
        box.x1 = Math.max(box.x1, x[i]);
        box.y0 = Math.min(box.y0, y[i]);
        box.y1 = Math.max(box.y1, y[i]);
    }
    return box;
}

export function joinedBox(boxes) {
    return boxes.reduce((a, b) => ({x0: Math.min(a.x0, b.x0), x1: Math.max(a.x1, b.x1), y0: Math.min(a.y0, b.y0), y1: Math.max(a.y1, b.y1)}));
}

/// Is a point inside the loops of a part (as drawn, undeformed)?
export function isInside(part, px, py) {
    let inside = false;
    const {x, y} = part.loops;
    for (const [from, to] of part.ranges)
        for (let i = from, j = to - 1; i < to; j = i++)
            if ((y[i] > py) !== (y[j] > py) && px < (x[j] - x[i]) * (py - y[i]) / (y[j] - y[i]) + x[i]) inside = !inside;
    return inside;
}

/// Where the boundary of a part is nearest to a point: between which of its samples, and how far along.
function footOf(part, px, py) {
    const {x, y} = part.loops, foot = {x: px, y: py, i: 0, j: 0, t: 0};
    let best = Infinity;
    for (const [from, to] of part.ranges)
        for (let i = from, j = to - 1; i < to; j = i++) {
            const dx = x[i] - x[j], dy = y[i] - y[j], length = dx * dx + dy * dy;
            const t = length > 0 ? Math.min(1, Math.max(0, ((px - x[j]) * dx + (py - y[j]) * dy) / length)) : 0;
            const distance = (px - x[j] - t * dx) ** 2 + (py - y[j] - t * dy) ** 2;
            if (distance >= best) continue;
            best = distance;
            Object.assign(foot, {i, j, t});
        }
    return foot;
}

/// Outward normals of the first part along a profile.
function normalsOf({profile: p, first}) {
    const n = p.x.length, nx = new Float64Array(n), ny = new Float64Array(n), length = n > 1 ? Math.hypot(p.x[n - 1] - p.x[0], p.y[n - 1] - p.y[0]) + 1e-12 : 1;
    let votes = 0;
    for (let i = 0; i < n; ++i) {
        const a = Math.max(0, i - 1), b = Math.min(n - 1, i + 1), tx = p.x[b] - p.x[a], ty = p.y[b] - p.y[a], l = Math.hypot(tx, ty) || 1;
        nx[i] = ty / l;
        ny[i] = -tx / l;
        votes += isInside(first, p.x[i] + 1e-3 * length * nx[i], p.y[i] + 1e-3 * length * ny[i]) ? -1 : 1;
    }
    return votes < 0 ? {nx: nx.map(v => -v), ny: ny.map(v => -v)} : {nx, ny};
}

/// Adds to a contact what drawing it needs: displacements and outward normals of the first part along its profile, and a common
/// abscissa where the profile runs over several edges.
export function prepareContact(contact, parts) {
    const p = contact.profile, first = parts[contact.parts[0]], n = p.x.length;
    contact.first = first;
    p.gap ??= p.x.map(() => null);  // not asked for
    // Under other loads a contact stays where it is.
    const stays = contact.feet?.length === n && contact.feet.of === first.loops.n && contact.feet.every((foot, i) => foot.x === p.x[i] && foot.y === p.y[i]);
    if (!stays) {
        contact.feet = p.x.map((x, i) => footOf(first, x, p.y[i]));
        contact.feet.of = first.loops.n;
        Object.assign(contact, normalsOf(contact));
    }
    const displacement = component => Float64Array.from(contact.feet, ({i, j, t}) => (1 - t) * first.loops.value[6 * j + component] + t * first.loops.value[6 * i + component]);
    contact.ux = displacement(0);
    contact.uy = displacement(1);
    // Arc length on one edge, in either direction; from its beginning on where the contact runs over several, or over the edge's start.
    const falls = n > 1 && p.s[n - 1] < p.s[0], isMonotone = p.s.every((s, i) => i === 0 || (falls ? s <= p.s[i - 1] : s >= p.s[i - 1]));
    contact.hasArc = p.edges.length === 1 && isMonotone;
    contact.falls = contact.hasArc && falls;
    contact.along = p.s.slice();
    if (!contact.hasArc)
        for (let i = 0, s = 0; i < n; ++i) contact.along[i] = s += i ? Math.hypot(p.x[i] - p.x[i - 1], p.y[i] - p.y[i - 1]) : 0;
    contact.peak = Math.max(0, ...p.pressure.map(Math.abs));
    contact.isOpen = contact.status === 'open';
}

/// data: the page's data, which is changed.
export function unpack(data) {
    data.parts = data.parts.map(part => unpackPart(part, {parts: data.model.parts ?? [], materials: data.model.materials ?? []}));
    data.contacts.forEach((contact, k) => {
        contact.index = k;
        prepareContact(contact, data.parts);
    });
    data.box = joinedBox(data.parts.map(p => p.box));
    data.size = Math.hypot(data.box.x1 - data.box.x0, data.box.y1 - data.box.y0);
    // A hundred-thousandth of the model: finer places tell a reader nothing.
    const step = 10 ** Math.floor(Math.log10(1e-5 * data.size));
    data.rounded = v => Math.round(v / step) * step;
    data.largestDisplacement = Math.max(0, ...data.parts.map(p => p.max_displacement.value ?? 0));
    return data;
}
