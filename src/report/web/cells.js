// SPDX-License-Identifier: GPL-3.0-or-later
// The cells of a part's grid, which lines make and halving; by class.
import {isInside} from './data.js';

/// The interval of ascending lines that holds a value.
function intervalOf(lines, v) {
    let low = 0, high = lines.length - 1;
    while (high - low > 1) {
        const middle = (low + high) >> 1;
        if (lines[middle] <= v) low = middle;
        else high = middle;
    }
    return low;
}

/// A cell and those that it is halved into: an index into boxes, or {u, v, quarters}. halved: of the last cells that were halved
/// those in this one, each [, column, row, times] among cells of its size; a cell is halved where one of them is it, or in it.
function halvedCell(box, level, halved, boxes) {
    if (!halved.some(h => h[3] > level)) return boxes.push(box) - 1;
    const [u0, v0, u1, v1] = box, u = (u0 + u1) / 2, v = (v0 + v1) / 2;
    const half = (place, h) => place >> (h[3] - 2 - level) & 1;
    const quarters = [[u0, v0, u, v], [u, v0, u1, v], [u0, v, u, v1], [u, v, u1, v1]].map((own, k) =>
        halvedCell(own, level + 1, halved.filter(h => h[3] > level + 1 && half(h[1], h) === k % 2 && half(h[2], h) === k >> 1), boxes));
    return {u, v, quarters};
}

/// boxes: of all cells, in the grid's frame; classes: 0 outer, 1 boundary, 2 inner; ends: points of the part's loops at which
/// the boundary goes from cell to cell. null: the part has no grid.
export function cellsOf(part) {
    const {x, y, angle, halved} = part.grid, nx = x.length - 1, ny = y.length - 1;
    if (nx < 1 || ny < 1) return null;
    const boxes = [], within = Array.from({length: nx * ny}, () => []);
    for (const h of halved) within[h[0]].push(h);
    const base = within.map((own, k) => halvedCell([x[k % nx], y[Math.floor(k / nx)], x[k % nx + 1], y[Math.floor(k / nx) + 1]], 0, own, boxes));
    const cellAt = (u, v) => {
        let cell = base[intervalOf(y, v) * nx + intervalOf(x, u)];
        while (typeof cell !== 'number') cell = cell.quarters[(u < cell.u ? 0 : 1) + (v < cell.v ? 0 : 2)];
        return cell;
    };
    const cos = Math.cos(angle), sin = Math.sin(angle), {loops, ranges} = part, classes = new Uint8Array(boxes.length), ends = [];
    const turned = i => [cos * loops.x[i] + sin * loops.y[i], -sin * loops.x[i] + cos * loops.y[i]];
    // Points of the boundary stand where it goes from cell to cell, so that what is between two of them is in one cell.
    // What runs along a side belongs to no cell; places are known to a step.
    for (const [from, to] of ranges) {
        let before = -1;
        for (let i = from, j = to - 1; i < to; j = i++) {
            const a = turned(j), b = turned(i), u = (a[0] + b[0]) / 2, v = (a[1] + b[1]) / 2, cell = cellAt(u, v), [u0, v0, u1, v1] = boxes[cell];
            const isOnSide = Math.min(Math.abs(u - u0), Math.abs(u - u1), Math.abs(v - v0), Math.abs(v - v1)) < 2 * part.field.step;
            if (Math.hypot(a[0] - b[0], a[1] - b[1]) > 0 && !isOnSide) classes[cell] = 1;
            if (cell !== before && before >= 0) ends.push(j);
            before = cell;
        }
    }
    boxes.forEach(([u0, v0, u1, v1], k) => {
        const u = (u0 + u1) / 2, v = (v0 + v1) / 2;
        if (classes[k] !== 1 && isInside(part, cos * u - sin * v, sin * u + cos * v)) classes[k] = 2;
    });
    return {boxes, classes, ends};
}
