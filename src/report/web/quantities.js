// SPDX-License-Identifier: GPL-3.0-or-later
// The quantities that the canvas shows, from the components of a sample: components are interpolated, never norms.

function principal(xx, yy, xy) {
    const middle = (xx + yy) / 2, radius = Math.hypot((xx - yy) / 2, xy);
    return [middle + radius, middle - radius];
}

function largestShear(xx, yy, xy, zz) {
    const middle = (xx + yy) / 2, radius = Math.hypot((xx - yy) / 2, xy);
    return Math.max(radius, Math.abs(middle + radius - zz) / 2, Math.abs(middle - radius - zz) / 2);
}

export function vonMises(xx, yy, xy, zz) {
    return Math.sqrt(((xx - yy) ** 2 + (yy - zz) ** 2 + (zz - xx) ** 2) / 2 + 3 * xy * xy);
}

/// value(ux, uy, xx, yy, xy, zz, part); signed: zero has a colour of its own.
export const quantities = [
    {key: 'vm', name: 'von Mises stress', unit: 'stress', of: (ux, uy, xx, yy, xy, zz) => vonMises(xx, yy, xy, zz)},
    {key: 's1', name: 'principal stress 1', unit: 'stress', signed: true, of: (ux, uy, xx, yy, xy) => principal(xx, yy, xy)[0]},
    {key: 's2', name: 'principal stress 2', unit: 'stress', signed: true, of: (ux, uy, xx, yy, xy) => principal(xx, yy, xy)[1]},
    {key: 'tau', name: 'largest shear stress', unit: 'stress', of: (ux, uy, xx, yy, xy, zz) => largestShear(xx, yy, xy, zz)},
    {key: 'sxx', name: 'stress σxx', unit: 'stress', signed: true, of: (ux, uy, xx) => xx},
    {key: 'syy', name: 'stress σyy', unit: 'stress', signed: true, of: (ux, uy, xx, yy) => yy},
    {key: 'sxy', name: 'stress σxy', unit: 'stress', signed: true, of: (ux, uy, xx, yy, xy) => xy},
    {key: 'szz', name: 'stress σzz', unit: 'stress', signed: true, of: (ux, uy, xx, yy, xy, zz) => zz},
    {key: 'u', name: 'displacement |u|', unit: 'length', of: (ux, uy) => Math.hypot(ux, uy)},
    {key: 'ux', name: 'displacement ux', unit: 'length', signed: true, of: ux => ux},
    {key: 'uy', name: 'displacement uy', unit: 'length', signed: true, of: (ux, uy) => uy},
    {key: 'w', name: 'strain energy density', unit: 'stress', of: (ux, uy, xx, yy, xy, zz, part) =>
        (xx * xx + yy * yy + zz * zz - 2 * part.nu * (xx * yy + yy * zz + zz * xx) + 2 * (1 + part.nu) * xy * xy) / (2 * part.E)},
];

export const quantityOf = key => quantities.find(q => q.key === key) ?? quantities[0];

/// A value by its samples: of sample i of a list.
export function valueAt(quantity, part, value, i) {
    const k = 6 * i;
    return quantity.of(value[k], value[k + 1], value[k + 2], value[k + 3], value[k + 4], value[k + 5], part);
}

const reported = {vm: 'max_von_mises', u: 'max_displacement'};

/// Smallest and largest value over all parts with their places; those that the answer states are taken from it.
export function extremes(quantity, data) {
    const low = {value: Infinity}, high = {value: -Infinity};
    for (const part of data.parts) {
        if (!part.hasField) continue;
        const look = (samples, from, to) => {
            for (let i = from; i < to; ++i) {
                const v = valueAt(quantity, part, samples.value, i);
                if (v < low.value) Object.assign(low, {value: v, part, x: samples.x[i], y: samples.y[i]});
                if (v > high.value) Object.assign(high, {value: v, part, x: samples.x[i], y: samples.y[i]});
            }
        };
        look(part.samples, 0, part.inside);
        look(part.loops, 0, part.loops.n);
    }
    const key = reported[quantity.key];
    const most = key && data.parts.filter(p => p.solved && p[key].value > 0).sort((a, b) => b[key].value - a[key].value)[0];
    if (most) Object.assign(high, {value: most[key].value, part: most, x: most[key].at[0], y: most[key].at[1]});
    return low.part && high.part ? {low, high} : null;
}

/// The colour scale's ends: 0 (or the smallest value) to the largest, cut where a peak would leave one colour for all the rest.
export function automaticRange(quantity, data, ends) {
    const shown = 0.995, peak = 2.5, values = [];
    for (const part of data.parts)
        for (let k = 0; k < part.patches.length; k += 4) {
            const a = part.patches[k], c = part.patches[k + 2];
            if (a >= part.inside || c >= part.inside) continue;
            const {x, y, value} = part.samples, v = (valueAt(quantity, part, value, a) + valueAt(quantity, part, value, c)) / 2;
            if (Number.isFinite(v)) values.push([v, Math.abs((x[c] - x[a]) * (y[c] - y[a]))]);
        }
    values.sort((a, b) => a[0] - b[0]);
    const total = values.reduce((sum, v) => sum + v[1], 0);
    const quantile = share => {
        let below = 0;
        for (const [v, area] of values)
            if ((below += area) >= share * total) return v;
        return NaN;
    };
    const cut = (end, at) => Number.isFinite(at) && at * end > 0 && Math.abs(end) > peak * Math.abs(at) ? at : end;
    const high = cut(ends.high.value, quantile(shown));
    const low = quantity.signed ? cut(ends.low.value, quantile(1 - shown)) : 0;
    return high > low ? {low, high} : {low, high: low + (Math.abs(low) || 1)};
}
