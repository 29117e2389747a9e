// SPDX-License-Identifier: GPL-3.0-or-later
// The canvas as a PNG file, with its colour scale.
import {text, ticks} from './colors.js';
import {element} from './dom.js';

const margin = 110, barWidth = 16;  // pixels: room for the scale

/// The picture with its scale beside it, as a canvas.
export function withScale(canvas) {
    const {state, data, ratio, width, height, scale} = canvas, {low, high} = state.range, made = element('canvas', {width: Math.round((width + margin) * ratio), height: Math.round(height * ratio)});
    const c = made.getContext('2d'), unit = data.units[state.quantity.unit], top = 46, bottom = height - 24, left = width + 12;
    c.scale(ratio, ratio);
    c.fillStyle = canvas.paper;
    c.fillRect(0, 0, width + margin, height);
    c.drawImage(canvas.element, 0, 0, width, height);
    for (let y = top; y < bottom; ++y) {
        c.fillStyle = scale.css(high - (y + 0.5 - top) / (bottom - top) * (high - low));
        c.fillRect(left, y, barWidth, 1);
    }
    c.fillStyle = canvas.ink;
    c.font = '12px system-ui, "DejaVu Sans", sans-serif';
    c.fillText(state.quantity.name, left, 18, margin - 14);
    if (unit) c.fillText(`[${unit}]`, left, 34);
    for (const v of [low, ...ticks(low, high, 6).filter(t => t > low + 0.06 * (high - low) && t < high - 0.06 * (high - low)), high])
        c.fillText(text(v, 4), left + barWidth + 6, top + (high - v) / (high - low) * (bottom - top) + 4);
    return made;
}

export function savePicture(canvas) {
    canvas.paint();
    withScale(canvas).toBlob(blob => {
        const link = element('a', {href: URL.createObjectURL(blob), download: `${(document.title || 'abut').replace(/[^\w -]+/g, '_').slice(0, 80)} ${canvas.state.quantity.key}.png`});
        link.click();
        setTimeout(() => URL.revokeObjectURL(link.href), 10000);
    });
}
