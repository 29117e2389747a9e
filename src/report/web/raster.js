// SPDX-License-Identifier: GPL-3.0-or-later
// Draws the patches of a part as values in a buffer of pixels. By the processor: no graphics card is needed, a picture is the
// same everywhere, and components are interpolated before any norm is taken.
const longest = 10;      // pixels: patches drawn larger are divided
const mostPieces = 40;   // along a side
const corner = new Float64Array(4 * 8), node = new Float64Array(8 * (mostPieces + 1) * (mostPieces + 1));

/// A triangle of nodes a, b, c (offsets into `from`: x, y, six components) into target {values, left, top, width, height}.
function triangle(from, a, b, c, target, quantity, part) {
    const ax = from[a], ay = from[a + 1], bx = from[b], by = from[b + 1], cx = from[c], cy = from[c + 1];
    const area = (bx - ax) * (cy - ay) - (cx - ax) * (by - ay);
    if (!(Math.abs(area) > 1e-12)) return;
    const top = Math.max(target.top, Math.ceil(Math.min(ay, by, cy) - 0.5));
    const bottom = Math.min(target.top + target.height - 1, Math.floor(Math.max(ay, by, cy) - 0.5 + 1e-9));
    const of = quantity.of;
    for (let row = top; row <= bottom; ++row) {
        const y = row + 0.5;
        let x0 = Infinity, x1 = -Infinity;
        const cut = (px, py, qx, qy) => {
            if ((py <= y) === (qy <= y) && py !== y && qy !== y) return;
            const x = py === qy ? px : px + (y - py) / (qy - py) * (qx - px);
            if (x < x0) x0 = x;
            if (x > x1) x1 = x;
        };
        cut(ax, ay, bx, by);
        cut(bx, by, cx, cy);
        cut(cx, cy, ax, ay);
        const left = Math.max(target.left, Math.ceil(x0 - 0.5 - 1e-6)), right = Math.min(target.left + target.width - 1, Math.floor(x1 - 0.5 + 1e-6));
        for (let column = left; column <= right; ++column) {
            const x = column + 0.5;
            const v = ((x - ax) * (cy - ay) - (cx - ax) * (y - ay)) / area, w = ((bx - ax) * (y - ay) - (x - ax) * (by - ay)) / area, u = 1 - v - w;
            target.values[(row - target.top) * target.width + column - target.left] = of(
                u * from[a + 2] + v * from[b + 2] + w * from[c + 2], u * from[a + 3] + v * from[b + 3] + w * from[c + 3],
                u * from[a + 4] + v * from[b + 4] + w * from[c + 4], u * from[a + 5] + v * from[b + 5] + w * from[c + 5],
                u * from[a + 6] + v * from[b + 6] + w * from[c + 6], u * from[a + 7] + v * from[b + 7] + w * from[c + 7], part);
        }
    }
}

/// Corners counter-clockwise in `corner`, divided into n x m, bilinear between them.
function divided(n, m, target, quantity, part) {
    for (let j = 0; j <= m; ++j)
        for (let i = 0; i <= n; ++i) {
            const u = i / n, v = j / m, k = 8 * (j * (n + 1) + i);
            for (let c = 0; c < 8; ++c)
                node[k + c] = (1 - u) * (1 - v) * corner[c] + u * (1 - v) * corner[8 + c] + u * v * corner[16 + c] + (1 - u) * v * corner[24 + c];
        }
    for (let j = 0; j < m; ++j)
        for (let i = 0; i < n; ++i) {
            const a = 8 * (j * (n + 1) + i), b = a + 8, d = a + 8 * (n + 1), c = d + 8;
            triangle(node, a, b, c, target, quantity, part);
            triangle(node, a, c, d, target, quantity, part);
        }
}

/// The values of a part. place: {scale, x, y, exaggeration} maps (X + exaggeration u) to pixels, y down.
export function rasterize(part, place, quantity, target) {
    const {x, y, value} = part.samples, {patches} = part, right = target.left + target.width, bottom = target.top + target.height;
    const px = new Float32Array(part.samples.n), py = new Float32Array(part.samples.n);
    for (let i = 0; i < part.samples.n; ++i) {
        px[i] = place.x + place.scale * (x[i] + place.exaggeration * value[6 * i]);
        py[i] = place.y - place.scale * (y[i] + place.exaggeration * value[6 * i + 1]);
    }
    for (let k = 0; k < patches.length; k += 4) {
        const a = patches[k], b = patches[k + 1], c = patches[k + 2], d = patches[k + 3];
        const x0 = Math.min(px[a], px[b], px[c], px[d]), x1 = Math.max(px[a], px[b], px[c], px[d]);
        const y0 = Math.min(py[a], py[b], py[c], py[d]), y1 = Math.max(py[a], py[b], py[c], py[d]);
        if (!(x1 >= target.left && x0 <= right && y1 >= target.top && y0 <= bottom)) continue;
        for (let i = 0; i < 4; ++i) {
            const sample = patches[k + i];
            corner[8 * i] = px[sample];
            corner[8 * i + 1] = py[sample];
            for (let q = 0; q < 6; ++q) corner[8 * i + 2 + q] = value[6 * sample + q];
        }
        const pieces = (p, q) => Math.min(mostPieces, Math.max(1, Math.ceil(Math.hypot(px[p] - px[q], py[p] - py[q]) / longest)));
        const n = Math.max(pieces(a, b), pieces(d, c)), m = Math.max(pieces(a, d), pieces(b, c));
        if (n === 1 && m === 1) {
            triangle(corner, 0, 8, 16, target, quantity, part);
            triangle(corner, 0, 16, 24, target, quantity, part);
        } else {
            divided(n, m, target, quantity, part);
        }
    }
}

/// Pixels of the values: colours, or pale ones with lines between bands.
export function colored(values, width, height, scale, pixels) {
    if (scale.mode !== 'lines') {
        for (let i = 0; i < values.length; ++i) pixels[i] = values[i] === values[i] ? scale.packed[scale.index(values[i])] : 0;
        return;
    }
    for (let j = 0, i = 0; j < height; ++j)
        for (let k = 0; k < width; ++k, ++i) {
            if (values[i] !== values[i]) {
                pixels[i] = 0;
                continue;
            }
            const own = scale.index(values[i]);
            const differs = (other, is) => is && values[other] === values[other] && scale.index(values[other]) !== own;
            pixels[i] = differs(i + 1, k + 1 < width) || differs(i + width, j + 1 < height) ? 0xff555555 : (scale.packed[own] & 0xffffff | 0x70000000) >>> 0;
        }
}

/// The sample of a part at a deformed point of the model, or null: {x, y (undeformed), value: six components}.
export function sampleAt(part, X, Y, exaggeration) {
    const {x, y, value} = part.samples, {patches} = part;
    const at = i => [x[i] + exaggeration * value[6 * i], y[i] + exaggeration * value[6 * i + 1]];
    for (let k = 0; k < patches.length; k += 4) {
        const [a, b, c, d] = [0, 1, 2, 3].map(i => at(patches[k + i]));
        if (X < Math.min(a[0], b[0], c[0], d[0]) || X > Math.max(a[0], b[0], c[0], d[0]) || Y < Math.min(a[1], b[1], c[1], d[1]) ||
            Y > Math.max(a[1], b[1], c[1], d[1])) continue;
        let u = 0.5, v = 0.5;
        for (let step = 0; step < 8; ++step) {
            const f = [0, 1].map(q => (1 - u) * (1 - v) * a[q] + u * (1 - v) * b[q] + u * v * c[q] + (1 - u) * v * d[q]);
            const fu = [0, 1].map(q => (1 - v) * (b[q] - a[q]) + v * (c[q] - d[q])), fv = [0, 1].map(q => (1 - u) * (d[q] - a[q]) + u * (c[q] - b[q]));
            const det = fu[0] * fv[1] - fu[1] * fv[0], rx = X - f[0], ry = Y - f[1];
            if (!det) break;
            u += (rx * fv[1] - ry * fv[0]) / det;
            v += (fu[0] * ry - fu[1] * rx) / det;
        }
        const slack = 1e-6;
        if (!(u >= -slack && u <= 1 + slack && v >= -slack && v <= 1 + slack)) continue;
        const weight = [(1 - u) * (1 - v), u * (1 - v), u * v, (1 - u) * v];
        const mean = of => weight.reduce((sum, w, i) => sum + w * of(patches[k + i]), 0);
        return {part, x: mean(i => x[i]), y: mean(i => y[i]), value: [0, 1, 2, 3, 4, 5].map(q => mean(i => value[6 * i + q]))};
    }
    return null;
}
