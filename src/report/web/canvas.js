// SPDX-License-Identifier: GPL-3.0-or-later
// The canvas: the field on the deformed shape, and what lies over it. Draws what the state says; zooming and panning by d3.
import {select} from 'd3-selection';
import {zoom, zoomIdentity} from 'd3-zoom';
import {Scale} from './colors.js';
import {isInside} from './data.js';
import {sampleAt, colored, rasterize} from './raster.js';
import {contactColor, gapColor, shearColor, drawCells, drawPieces, drawContacts, drawFans, drawLoads, drawNames, drawPins, drawResultants, drawSupports, drawExtremes, drawAxes} from './layers.js';

const margin = 56;          // pixels around the model
const slowFrame = 45;       // milliseconds: while things move, frames that take longer are drawn coarser
const mostZoom = 1e5;

export class Canvas {
    constructor(element, data, state) {
        Object.assign(this, {element, data, state, coarseness: 1, frame: 0, transform: zoomIdentity, listeners: [], overlays: [], takers: [], clickTakers: []});
        this.context = element.getContext('2d', {alpha: false});
        this.scratch = document.createElement('canvas');
        this.ground = document.createElement('canvas');
        // What lies over the picture may take a drag for itself.
        const starts = event => (!event.ctrlKey || event.type === 'wheel') && !event.button && (event.type === 'wheel' || !this.takers.some(takes => takes(event)));
        this.zoom = zoom().filter(starts).scaleExtent([0.3, mostZoom]).on('zoom', event => {
            this.transform = event.transform;
            this.draw(true);
        }).on('end', () => this.state.changed('view'));
        select(element).call(this.zoom).on('dblclick.zoom', null).on('dblclick', () => this.fit());
        new ResizeObserver(() => this.resize()).observe(element);
        this.resize();
    }

    resize() {
        const box = this.element.getBoundingClientRect(), kept = this.width && !this.isFitted ? this.view() : null;
        if (!box.width || !box.height) return;
        this.ratio = Math.min(window.devicePixelRatio || 1, 2);
        this.width = box.width;
        this.height = box.height;
        this.element.width = Math.round(box.width * this.ratio);
        this.element.height = Math.round(box.height * this.ratio);
        const {x0, x1, y0, y1} = this.data.box;
        this.base = Math.min((this.width - 2 * margin) / (x1 - x0 || 1), (this.height - 2 * margin) / (y1 - y0 || 1));
        this.zoom.extent([[0, 0], [this.width, this.height]]);
        if (kept) this.show(kept);
        this.draw();
    }

    /// Where a point of the picture's model (deformed) goes, in CSS pixels, and back.
    get place() {
        const {x0, x1, y0, y1} = this.data.box, t = this.transform, scale = this.base * t.k;
        const x = t.x + t.k * (this.width / 2 - this.base * (x0 + x1) / 2), y = t.y + t.k * (this.height / 2 + this.base * (y0 + y1) / 2);
        return {scale, x, y, exaggeration: this.state.exaggeration};
    }
    pixel(x, y) {
        const p = this.place;
        return [p.x + p.scale * x, p.y - p.scale * y];
    }
    point(px, py) {
        const p = this.place;
        return [(px - p.x) / p.scale, (p.y - py) / p.scale];
    }

    /// Does the picture show everything, as large as it can?
    get isFitted() {
        return this.transform.k === 1 && this.transform.x === 0 && this.transform.y === 0;
    }

    /// The middle of the picture and its width, in the model's units.
    view() {
        const [x, y] = this.point(this.width / 2, this.height / 2);
        return {x, y, width: this.width / this.place.scale};
    }
    show({x, y, width}) {
        const {x0, x1, y0, y1} = this.data.box, k = this.width / width / this.base;
        if (!(k > 0) || !Number.isFinite(k + x + y)) return;
        const bx = this.width / 2 + this.base * (x - (x0 + x1) / 2), by = this.height / 2 - this.base * (y - (y0 + y1) / 2);
        select(this.element).call(this.zoom.transform, zoomIdentity.translate(this.width / 2 - k * bx, this.height / 2 - k * by).scale(k));
    }
    showBox(box, share = 0.5) {
        const width = Math.max(box.x1 - box.x0, (box.y1 - box.y0) * this.width / this.height, 1e-4 * this.data.size);
        this.show({x: (box.x0 + box.x1) / 2, y: (box.y0 + box.y1) / 2, width: width / share});
    }
    fit() {
        select(this.element).call(this.zoom.transform, zoomIdentity);
    }
    zoomBy(factor) {
        select(this.element).call(this.zoom.scaleBy, factor);
    }
    panBy(dx, dy) {
        select(this.element).call(this.zoom.translateBy, dx / this.transform.k, dy / this.transform.k);
    }

    /// moving: another frame follows soon; this one may be coarse.
    draw(moving = false) {
        this.moving = moving;
        if (this.frame) return;
        this.frame = requestAnimationFrame(() => {
            this.frame = 0;
            this.paint();
        });
    }

    paint() {
        if (!this.width) return;
        clearTimeout(this.later);
        const begin = performance.now(), coarseness = this.moving ? this.coarseness : 1;
        this.paintAll(coarseness);
        const took = performance.now() - begin;
        if (this.moving) {
            if (took > slowFrame) this.coarseness = Math.min(4, this.coarseness + 1);
            else if (this.paintedGround && took < slowFrame / 4) this.coarseness = Math.max(1, this.coarseness - 1);
            this.later = setTimeout(() => this.draw(), 120);
        } else if (took > slowFrame) {
            this.coarseness = Math.max(2, this.coarseness);
        }
        this.listeners.forEach(listener => listener());
    }

    paintAll(coarseness) {
        const {context: c, state} = this, style = getComputedStyle(this.element);
        const color = name => style.getPropertyValue('--' + name).trim();
        [this.ink, this.paper, this.soft] = ['ink', 'paper', 'soft'].map(color);
        this.colors = {load: color('load'), resultant: color('resultant'), reaction: color('reaction'), none: color('none')};
        this.paintGround(coarseness);
        c.setTransform(1, 0, 0, 1, 0, 0);
        c.drawImage(this.ground, 0, 0);
        c.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
        if (state.has('cells')) drawCells(this);
        if (state.has('pieces')) drawPieces(this);
        drawContacts(this);
        if (state.has('fans')) drawFans(this, 'pressure', contactColor);
        if (state.has('shear')) drawFans(this, 'shear', shearColor);
        if (state.has('gap')) drawFans(this, 'gap', gapColor);
        if (state.has('supports')) drawSupports(this);
        if (state.has('loads')) drawLoads(this);
        if (state.has('resultants')) drawResultants(this);
        drawAxes(this);
        if (state.has('names')) drawNames(this);
        if (state.has('extremes') && state.ends) drawExtremes(this);
        drawPins(this);
        this.overlays.forEach(draw => draw(this));
    }

    /// The parts with their fields: painted anew only where something of them has changed, since this is what takes time.
    paintGround(coarseness) {
        const {ground, state, data} = this, place = this.place, {low, high} = state.range;
        const shown = [...Object.values(place), this.element.width, this.element.height, low, high, state.quantity.key, state.mode, ...state.layers, state.part, state.stamp, this.ink, this.paper].join();
        this.paintedGround = this.shownGround !== shown || this.groundCoarseness > coarseness;
        if (!this.paintedGround) return;
        [this.shownGround, this.groundCoarseness] = [shown, coarseness];
        ground.width = this.element.width;
        ground.height = this.element.height;
        const c = ground.getContext('2d');
        c.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
        c.fillStyle = this.paper;
        c.fillRect(0, 0, this.width, this.height);
        this.scale = new Scale(low, high, state.quantity.signed, state.mode);
        this.paths = data.parts.map(part => this.path(part, place.exaggeration));
        if (state.has('undeformed') && place.exaggeration > 0) {
            c.setLineDash([4, 3]);
            c.strokeStyle = this.soft;
            for (const part of data.parts) c.stroke(this.path(part, 0));
            c.setLineDash([]);
        }
        data.parts.forEach((part, i) => this.paintPart(c, part, this.paths[i], place, coarseness));
    }

    path(part, exaggeration) {
        const path = new Path2D(), {x, y, value} = part.loops, p = this.place;
        for (const [from, to] of part.ranges) {
            for (let i = from; i < to; ++i) {
                const px = p.x + p.scale * (x[i] + exaggeration * value[6 * i]), py = p.y - p.scale * (y[i] + exaggeration * value[6 * i + 1]);
                if (i === from) path.moveTo(px, py);
                else path.lineTo(px, py);
            }
            path.closePath();
        }
        return path;
    }

    paintPart(c, part, path, place, coarseness) {
        const {state} = this, shown = this.data.parts[state.part] === part;
        const showsField = state.has('field') && part.hasField;
        if (showsField) this.paintField(c, part, path, place, coarseness);
        else {
            c.fillStyle = state.has('colors') ? part.color : this.colors.none;
            c.fill(path, 'evenodd');
        }
        if (showsField && state.has('colors')) {
            c.globalAlpha = 0.25;
            c.fillStyle = part.color;
            c.fill(path, 'evenodd');
            c.globalAlpha = 1;
        }
        c.lineWidth = shown ? 3 : 1;
        c.strokeStyle = shown ? '#e8590c' : this.ink;
        if (state.has('outlines') || shown) c.stroke(path);
        c.lineWidth = 1;
    }

    /// The field of a part, cut out by its outline.
    paintField(c, part, path, place, coarseness) {
        const r = this.ratio / coarseness, ex = place.exaggeration;
        const {x, y, value} = part.loops;
        let x0 = Infinity, x1 = -Infinity, y0 = Infinity, y1 = -Infinity;
        for (let i = 0; i < part.loops.n; ++i) {
            const px = place.x + place.scale * (x[i] + ex * value[6 * i]), py = place.y - place.scale * (y[i] + ex * value[6 * i + 1]);
            x0 = Math.min(x0, px);
            x1 = Math.max(x1, px);
            y0 = Math.min(y0, py);
            y1 = Math.max(y1, py);
        }
        const left = Math.max(0, Math.floor(x0 * r)), top = Math.max(0, Math.floor(y0 * r));
        const width = Math.min(Math.ceil(this.width * r), Math.ceil(x1 * r)) - left, height = Math.min(Math.ceil(this.height * r), Math.ceil(y1 * r)) - top;
        if (!(width > 0 && height > 0)) return;
        const target = {left, top, width, height, values: new Float32Array(width * height).fill(NaN)};
        rasterize(part, {scale: place.scale * r, x: place.x * r, y: place.y * r, exaggeration: ex}, this.state.quantity, target);
        const image = new ImageData(width, height);
        colored(target.values, width, height, this.scale, new Uint32Array(image.data.buffer));
        if (this.scratch.width < width || this.scratch.height < height) {
            this.scratch.width = Math.max(this.scratch.width, width);
            this.scratch.height = Math.max(this.scratch.height, height);
        }
        this.scratch.getContext('2d').putImageData(image, 0, 0);
        c.save();
        c.clip(path, 'evenodd');
        c.imageSmoothingEnabled = coarseness > 1;
        c.drawImage(this.scratch, 0, 0, width, height, left / r, top / r, width / r, height / r);
        c.restore();
    }

    /// What is at a pixel: the part with its sample (or without a field the part alone), or null.
    pick(px, py) {
        const [X, Y] = this.point(px, py);
        for (let i = this.data.parts.length - 1; i >= 0; --i) {
            this.context.setTransform(1, 0, 0, 1, 0, 0);  // isPointInPath takes untransformed pixels
            if (!this.paths?.[i] || !this.context.isPointInPath(this.paths[i], px, py, 'evenodd')) continue;
            const part = this.data.parts[i];
            return sampleAt(part, X, Y, this.state.exaggeration) ?? {part, x: X, y: Y, value: null};
        }
        return null;
    }

    /// Is a point as drawn (undeformed) inside any part?
    inside(x, y) {
        return this.data.parts.some(part => isInside(part, x, y));
    }

    /// The point of a contact's profile within some pixels, or null.
    pickContact(px, py, reach = 14) {
        let best = reach, found = null;
        for (const contact of this.data.contacts)
            for (let i = 0; i < contact.profile.x.length; ++i) {
                const [x, y] = this.profilePixel(contact, i), distance = Math.hypot(x - px, y - py);
                if (distance < best) {
                    best = distance;
                    found = {contact, i};
                }
            }
        return found;
    }
    profilePixel(contact, i) {
        const e = this.state.exaggeration;
        return this.pixel(contact.profile.x[i] + e * contact.ux[i], contact.profile.y[i] + e * contact.uy[i]);
    }
    /// Where a sample or a place of the model is drawn.
    samplePixel(sample) {
        const e = this.state.exaggeration;
        return this.pixel(sample.x + (sample.value ? e * sample.value[0] : 0), sample.y + (sample.value ? e * sample.value[1] : 0));
    }
}
