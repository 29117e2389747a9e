// SPDX-License-Identifier: GPL-3.0-or-later
// The page of `abut live`: the report's instrument, whose loads and parameters are moved. What is moved is sent, the latest
// wins; what comes back are pieces (src/live/live_model.hpp), each shown in its place.
import './live.css';
import {prepareContact, unpack, unpackField} from './data.js';
import {element} from './dom.js';
import {Ghost} from './ghost.js';
import {ForceHandles} from './handles.js';
import {start} from './instrument.js';
import {controlPanel} from './live_controls.js';
import {Mechanism} from './mechanism.js';
import {PartMover} from './moving.js';
import {Pointing} from './pointing.js';
import {extremes, quantityOf} from './quantities.js';

const pause = 400, hiddenPause = 3000;  // milliseconds between questions for news where nothing is computed

class Live {
    constructor(root) {
        this.client = Math.random().toString(36).slice(2);
        Object.assign(this, {serial: 0, version: 0, inputs: null, controls: null, data: null, drawing: null, sending: false, wanted: false, problems: [], lost: false, moved: 0, times: [], answers: 0});
        this.listeners = [];
        this.verdict = element('p', {class: 'verdict', 'aria-live': 'polite'}, 'Reading the scene …');
        this.status = element('span', {class: 'live-status'});
        this.doubts = element('ul', {class: 'live-doubts', hidden: true});
        this.title = element('h1', {}, 'abut live');
        this.instrument = element('div', {id: 'instrument'});
        root.append(this.title, this.verdict, element('p', {class: 'facts'}, this.status), this.doubts, this.instrument);
        this.ask();
    }
    /// what: controls, inputs, edges, whole, answer, fields, problems, ghost, moving.
    changed(what) {
        this.listeners.forEach(listener => listener(what));
    }
    on(listener) {
        this.listeners.push(listener);
    }

    async request(path, body) {
        const reply = await fetch(path, body === undefined ? {cache: 'no-store'} : {method: 'POST', body: JSON.stringify(body)});
        this.setLost(false);
        if (reply.status === 400) throw await reply.json();
        if (!reply.ok) throw [{where: '', what: `the program answers with status ${reply.status}`, hint: 'see its terminal'}];
        return reply;
    }
    setLost(lost) {
        if (this.lost === lost) return;
        this.lost = lost;
        this.say();
    }
    failed(error) {
        if (Array.isArray(error)) this.take({pieces: {problems: error}});
        else this.setLost(true);
    }

    /// Asks for news, again and again.
    async ask() {
        let busy = false;
        try {
            const news = await (await this.request('news?after=' + this.serial)).json();
            this.take(news);
            busy = Boolean(news.busy) || (news.version !== this.shownVersion && !this.problems.length);
        } catch (error) {
            this.failed(error);
        }
        setTimeout(() => this.ask(), document.hidden ? hiddenPause : busy ? 15 : this.data ? pause : 50);
    }

    /// Sends the numbers as they are now; while an answer is on its way, the latest wait for it.
    async send() {
        this.wanted = true;
        if (this.sending) return;
        this.sending = true;
        while (this.wanted) {
            this.wanted = false;
            const begin = performance.now();
            try {
                const news = await (await this.request('act', {client: this.client, after: this.serial, ...this.inputs})).json();
                this.take(news);
                if (news.pieces.answer) this.took(performance.now() - begin);
            } catch (error) {
                this.failed(error);
                break;
            }
        }
        this.sending = false;
    }
    took(time) {
        const now = performance.now();
        this.times = [...this.times.filter(t => now - t.at < 1000), {at: now, time}];
        ++this.answers;
        this.say();
    }
    /// The components of a force: as it was turned, or as the scene gives it times a factor.
    force(k) {
        const moved = this.inputs.loads[k];
        return moved.length === 2 ? moved : this.controls.loads[k].value.map(v => v * moved[0]);
    }
    /// Moves a load or a parameter: change(inputs).
    move(change) {
        change(this.inputs);
        this.moved = performance.now();
        this.changed('inputs');
        this.send();
    }

    take(news) {
        if (news.serial !== undefined && news.serial < this.serial) return;  // overtaken by newer ones
        const {pieces} = news;
        if (news.serial !== undefined) this.serial = news.serial;
        this.busy = news.busy ?? this.busy;
        this.settled = news.settled ?? this.settled;
        this.version = news.version ?? this.version;
        if (pieces.controls) this.controls = pieces.controls;
        if (pieces.inputs && pieces.inputs.client !== this.client) this.inputs = {parameters: pieces.inputs.parameters, loads: pieces.inputs.loads, settings: pieces.inputs.settings};
        if (pieces.edges) this.drawing = pieces.edges;
        if (pieces.problems) this.problems = pieces.problems;
        if (pieces.whole) this.takeWhole(pieces.whole);
        if (pieces.answer && this.data) this.takeAnswer(pieces.answer);
        if (pieces.fields && this.data) this.takeFields(pieces.fields);
        for (const what of ['controls', 'inputs', 'edges', 'whole', 'problems']) if (pieces[what]) this.changed(what);
        this.say();
    }

    takeWhole(whole) {
        this.shown = {...whole, data: null};
        this.shownVersion = whole.version;
        if (!whole.data.parts.length) return;  // nothing is known of it
        const fresh = Object.assign(unpack(whole.data), {tellsErrors: true});
        // Forces are shown by what they are moved with.
        fresh.model.loads = (fresh.model.loads ?? []).filter(l => l.kind !== 'force');
        this.title.textContent = fresh.title || 'abut live';
        document.title = `${fresh.title || 'scene'} – abut live`;
        if (this.data) {
            Object.assign(this.data, fresh);
            if (!this.hasScale) this.setScale();
            this.view.canvas.resize();
            this.view.state.renew();
            return;
        }
        this.data = fresh;
        const place = element('div');
        this.view = start(fresh, this.instrument, place);
        this.ghost = new Ghost(this);
        this.mover = new PartMover(this);
        this.mechanism = new Mechanism(this);
        this.pointing = this.drawing && new Pointing(this);
        place.replaceWith(controlPanel(this));
        this.handles = new ForceHandles(this);
        window.abutReport = this.view;
        this.setScale();
    }
    /// One enlargement for all that follows: what grows is seen to grow.
    setScale() {
        this.hasScale = this.data.largestDisplacement > 0;
        this.view.state.setAutomatic(this.data.largestDisplacement);
    }

    takeAnswer(answer) {
        this.shown = {...this.shown, status: answer.status, message: answer.message, doubts: answer.doubts, driven: answer.driven, quick: true};
        this.shownVersion = answer.version;
        if (answer.status !== 'ok') return this.view.canvas.draw();
        const own = new Map(answer.contacts.map(c => [c.between.join() + c.profile.x[0], c]));
        this.data.contacts.forEach((contact, k) => {
            const now = answer.contacts[k]?.between.join() === contact.between.join() ? answer.contacts[k] : own.get(contact.between.join() + contact.profile.x[0]);
            if (!now) return;
            contact.known ??= contact.error ?? 0;  // of the analysis
            Object.assign(contact, {...now, ends: [], error: Math.max(contact.known, now.error_at_ends), at_corner: contact.at_corner});
            prepareContact(contact, this.data.parts);
        });
        this.data.reactions = [];  // of other loads
        this.view.state.changed('data');
        this.changed('answer');
    }

    takeFields(fields) {
        const {data, view} = this;
        fields.fields.forEach((field, i) => Object.assign(data.parts[i], unpackField(field, data.parts[i])));
        // Largest values at the points of the picture: those of the analysis come after a rest.
        for (const part of data.parts) {
            if (!part.hasField) continue;
            for (const [key, name] of [['vm', 'max_von_mises'], ['u', 'max_displacement']]) {
                part[name] = {value: NaN, at: [0, 0]};
                const high = extremes(quantityOf(key), {parts: [part]})?.high;
                if (high) part[name] = {value: high.value, at: [high.x, high.y]};
            }
            part.utilisation = part.yield ? part.max_von_mises.value / part.yield : null;
        }
        data.contacts.forEach(contact => prepareContact(contact, data.parts));
        view.state.measure();
        view.state.changed('data');
        this.changed('fields');
    }

    /// The verdict, and how the answer came about.
    say() {
        const {shown, verdict} = this;
        const wrong = this.problems.length > 0;
        let mood = '', words = shown?.sentence ?? 'Computing …';
        if (this.lost) [mood, words] = ['failed', 'The program does not answer: was it ended?'];
        else if (wrong) [mood, words] = ['failed', this.problems.map(p => [p.where, p.what, p.hint].filter(Boolean).join(': ')).join('\n')];
        else if (shown?.quick && shown.status !== 'ok') [mood, words] = ['failed', 'Failed: ' + shown.message];
        else if (shown?.quick) [mood, words] = ['', 'Solved under these loads, on the grids made for others' + (shown.doubts.length ? '; with doubts' : '')];
        else if (shown) mood = {reached: '', solved_but: 'doubtful', failed: 'failed'}[shown.verdict];
        if (shown?.quick && shown.status === 'ok' && shown.doubts.length && !wrong) mood = 'doubtful';
        verdict.className = `verdict ${mood}`;
        if (verdict.textContent !== words) verdict.textContent = words;
        const doubts = wrong ? [] : shown?.quick ? shown.doubts : shown?.warnings ?? [];
        this.doubts.hidden = !doubts.length;
        this.doubts.replaceChildren(...doubts.map(d => element('li', {}, d)));
        this.instrument.classList.toggle('stale', wrong || this.lost || (mood === 'failed' && !shown?.driven?.length));  // motions are to be seen
        const recent = this.times.filter(t => performance.now() - t.at < 1000), last = this.times.at(-1);
        const state = this.busy === 'draft' ? 'Computing a draft …' : this.busy === 'accuracy' ? 'Computing as accurately as asked …'
            : shown?.status !== 'ok' || wrong ? '' : this.settled ? 'As accurate as asked for' : shown.draft ? 'A draft' : '';
        this.status.textContent = [state, last ? `answered in ${last.time.toFixed(0)} ms` + (recent.length > 1 ? `, ${recent.length} in the last second` : '') : ''].filter(Boolean).join('; ');
    }
}

window.abutLive = new Live(document.getElementById('live'));
