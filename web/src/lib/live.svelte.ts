/** One session as the page sees it: what the stream told, and how the connection stands. */

import * as api from './api';
import { advance, FIRST, type Link, type LinkEvent } from './connection';
import { addCycles, addRuns, runsOf } from './drive/history';
import { extended, rejoined, type Trail } from './drive/trail';
import { addEpisodes, addLog, addTrials, episodesOf, trialsOf } from './history';
import type {
  ArenaRequest,
  ClientMessage,
  CourseView,
  CycleView,
  DriveRunView,
  DriveScores,
  EpisodeView,
  LogEntry,
  NeuronView,
  Problem,
  ScoresView,
  ServerMessage,
  Session,
  StepView,
  TableRequest,
  TableView,
  TaskView,
  TickView,
  Trial,
  WorldView,
  Yardstick,
} from './protocol';
import { Throttle } from './throttle';
import { withRegret } from './yardstick';

/** Samples a second that the page asks for, by kind of experiment. */
const RATES = {
  path: { tick: 15, depths: 30, neurons: 4 },
  table: { step: 15, table: 6 },
  drive: { cycles: 30 },
};

/** A session that is watched. */
export class LiveSession {
  readonly id: string;
  session = $state.raw<Session | null>(null);
  world = $state.raw<WorldView | null>(null);
  trials = $state.raw<Trial[]>([]);
  /** The best path a planner finds. */
  yardstick = $state.raw<Yardstick>({ state: 'computing' });
  neurons = $state.raw<NeuronView[]>([]);
  tick = $state.raw<TickView | null>(null);
  sonar_m = $state.raw<number[]>([]);
  /** Where each sonar looks, from the heading, counter-clockwise. */
  readonly bearings_deg = $derived((this.world?.sonars ?? []).map((sonar) => sonar.bearing_deg));
  /** The world of a tabular experiment. */
  task = $state.raw<TaskView | null>(null);
  /** The last step of a tabular experiment. */
  step = $state.raw<StepView | null>(null);
  /** Its tables. */
  table = $state.raw<TableView | null>(null);
  /** How its competitors stand. */
  scores = $state.raw<ScoresView | null>(null);
  /** Its newest episodes. */
  episodes = $state.raw<EpisodeView[]>([]);
  /** Where the robot of chapter 2 drives. */
  course = $state.raw<CourseView | null>(null);
  /** Its newest cycles. */
  cycles = $state.raw<CycleView[]>([]);
  /** The present cycle. */
  readonly cycle = $derived(this.cycles.at(-1) ?? null);
  /** The path of the present run. */
  trail = $state.raw<Trail | null>(null);
  /** Its newest runs. */
  runs = $state.raw<DriveRunView[]>([]);
  /** How its methods stand. */
  summary = $state.raw<DriveScores | null>(null);
  log = $state.raw<LogEntry[]>([]);
  link = $state.raw<Link>(FIRST);
  /** The session cannot be shown at all; status 404 when there is none. */
  problem = $state.raw<Problem | null>(null);
  /** Events that were missed before the history was sent again. */
  gap = $state.raw<string | null>(null);
  /** What the server could not use of the page's last message. */
  complaint = $state.raw<string | null>(null);

  #socket: WebSocket | null = null;
  #timer: ReturnType<typeof setTimeout> | null = null;
  #seq: number | null = null;
  #trials: Trial[] = [];
  /** At full speed trials end faster than charts and tables need to follow. */
  #shownTrials = new Throttle<Trial[]>(250, (trials) => (this.trials = trials));
  #episodes: EpisodeView[] = [];
  /** Episodes too, with the scores that each of them changes. */
  #shownEpisodes = new Throttle<EpisodeView[]>(250, (episodes) => (this.episodes = episodes));
  #shownScores = new Throttle<ScoresView | null>(250, (scores) => (this.scores = scores));
  #runs: DriveRunView[] = [];
  /** At full speed runs end as fast as trials do. */
  #shownRuns = new Throttle<DriveRunView[]>(250, (runs) => (this.runs = runs));
  #shownSummary = new Throttle<DriveScores | null>(250, (summary) => (this.summary = summary));
  #arena: ArenaRequest | null = null;
  #onpicture: (picture: Blob) => void = () => {};

  /** `known` is shown until the stream tells more. */
  constructor(id: string, known: Session | null = null) {
    this.id = id;
    this.session = known?.id === id ? known : null;
  }

  /** Connects, and keeps connecting until [`close`](LiveSession.close). */
  async open(): Promise<void> {
    try {
      const session = await api.session(this.id);
      if (this.link.phase === 'closed') return;
      this.session = session;
      this.problem = null;
      this.#connect();
    } catch (error) {
      this.#refused(api.problemOf(error));
    }
  }

  /** Ends the connection for good. */
  close(): void {
    this.#follow({ kind: 'closed' });
    if (this.#timer !== null) clearTimeout(this.#timer);
    this.#shownTrials.stop();
    this.#shownEpisodes.stop();
    this.#shownScores.stop();
    this.#shownRuns.stop();
    this.#shownSummary.stop();
    this.#socket?.close();
    this.#onpicture = () => {};
  }

  /** Tries again now. */
  retry(): void {
    if (this.#timer !== null) clearTimeout(this.#timer);
    this.#due();
  }

  /** Asks for arena pictures of this size; `null` for none. */
  showArena(asked: ArenaRequest | null, onpicture: (picture: Blob) => void): void {
    this.#arena = asked;
    this.#onpicture = onpicture;
    this.#subscribe();
  }

  /** Sends a control and notes what it led to. */
  async control(name: api.Control, unit?: 'tick' | 'trial') {
    const ack = await api.control(this.id, name, unit);
    await this.#refreshWithoutStream();
    return ack;
  }

  /** Gives the learner advice in the place of what it has; an empty text takes it back. */
  advise(text: string) {
    return api.advise(this.id, text);
  }

  /** Changes values of the learner's table. */
  edit(change: TableRequest) {
    return api.editTable(this.id, change);
  }

  /** Changes the method that drives. */
  setMethod(method: string) {
    return api.setMethod(this.id, method);
  }

  /** Silences a sonar, or lets it answer again. */
  setSonar(sonar: number, silent: boolean) {
    return api.setSonar(this.id, sonar, silent);
  }

  /** Changes the pace. */
  async setSpeed(speed: Session['speed']) {
    const ack = await api.setSpeed(this.id, speed);
    await this.#refreshWithoutStream();
    return ack;
  }

  /** While the stream is open it alone tells the state, in order. */
  async #refreshWithoutStream(): Promise<void> {
    if (this.link.phase !== 'open') this.session = await api.session(this.id);
  }

  #connect(): void {
    const socket = new WebSocket(api.streamAddress(this.id, this.#seq));
    socket.binaryType = 'blob';
    this.#socket = socket;
    socket.onopen = () => this.#subscribe();
    socket.onclose = () => this.#lost();
    socket.onmessage = ({ data }) => {
      this.#follow({ kind: 'greeted' });
      if (typeof data === 'string') this.#take(JSON.parse(data) as ServerMessage);
      else this.#onpicture(data as Blob);
    };
  }

  #subscribe(): void {
    if (this.#socket?.readyState !== WebSocket.OPEN) return;
    this.#socket.send(JSON.stringify(this.#wanted()));
  }

  #wanted(): ClientMessage {
    const family = this.session?.family ?? 'path';
    if (family !== 'path') return { type: 'subscribe', ...RATES[family] };
    const arena = this.#arena ?? { rate: 0, width: 64, height: 64, theme: 'light' };
    return { type: 'subscribe', ...RATES.path, arena };
  }

  #take(message: ServerMessage): void {
    if ('seq' in message) this.#seq = message.seq;
    switch (message.type) {
      case 'hello':
        this.session = message.session;
        this.world = message.world;
        this.yardstick = message.yardstick ?? { state: 'computing' };
        this.#setTrials(message.trials);
        this.neurons = message.neurons;
        this.tick = message.tick;
        this.sonar_m = message.tick?.sonar_m ?? [];
        this.task = message.task;
        this.table = message.table;
        this.step = null;
        this.#shownScores.offer(message.scores);
        this.#setEpisodes(message.episodes);
        this.course = message.course;
        this.#setCycles(message.cycles);
        this.#setRuns(message.runs);
        this.#shownSummary.offer(message.summary);
        this.log = message.log;
        break;
      case 'state':
        this.#takeState(message.session);
        break;
      case 'tick':
        this.tick = message.tick;
        break;
      case 'depths':
        this.sonar_m = message.sonar_m;
        break;
      case 'neurons':
        this.neurons = message.neurons;
        break;
      case 'trial':
        this.#setTrials(addTrials(this.#trials, message.trials));
        break;
      case 'yardstick':
        this.#measure(message.yardstick);
        break;
      case 'curve':
        // The trials carry the same points and more.
        break;
      case 'step':
        this.step = message.step;
        break;
      case 'table':
        this.table = message.table;
        break;
      case 'episode':
        this.#setEpisodes(addEpisodes(this.#episodes, message.episodes));
        break;
      case 'scores':
        this.#shownScores.offer(message.scores);
        break;
      case 'cycles':
        this.cycles = addCycles(this.cycles, message.cycles);
        this.trail = extended(this.trail, message.cycles);
        break;
      case 'run':
        this.#setRuns(addRuns(this.#runs, message.runs));
        break;
      case 'summary':
        this.#shownSummary.offer(message.summary);
        break;
      case 'log':
        this.log = addLog(this.log, message.entries);
        break;
      case 'gap':
        this.gap =
          'Some events were missed while the connection was lost; the whole history was loaded again';
        break;
      case 'error':
        this.complaint = message.message;
        break;
    }
  }

  #takeState(session: Session): void {
    this.session = session;
    this.#setTrials(trialsOf(session, this.#trials));
    this.#setEpisodes(episodesOf(session, this.#episodes));
    this.#setRuns(runsOf(session, this.#runs));
    if (session.tick > 0) return;
    this.step = null;
    this.table = null;
    this.#shownScores.offer(null);
    this.#setCycles([]);
    this.#shownSummary.offer(null);
    this.tick = null;
    this.sonar_m = [];
    this.neurons = [];
  }

  /** Trials told before the best path was known get their regret now. */
  #measure(yardstick: Yardstick): void {
    this.yardstick = yardstick;
    this.#setTrials(this.#trials.map((trial) => withRegret(trial, yardstick)));
  }

  #setTrials(trials: Trial[]): void {
    if (trials === this.#trials) return;
    this.#trials = trials;
    this.#shownTrials.offer(trials);
  }

  #setEpisodes(episodes: EpisodeView[]): void {
    if (episodes === this.#episodes) return;
    this.#episodes = episodes;
    this.#shownEpisodes.offer(episodes);
  }

  /** The history anew; the path goes on where the page has seen it. */
  #setCycles(cycles: CycleView[]): void {
    this.cycles = cycles;
    this.trail = cycles.length > 0 ? rejoined(this.trail, cycles) : null;
  }

  #setRuns(runs: DriveRunView[]): void {
    if (runs === this.#runs) return;
    this.#runs = runs;
    this.#shownRuns.offer(runs);
  }

  #lost(): void {
    this.#socket = null;
    this.#follow({ kind: 'lost', now: Date.now(), chance: Math.random() });
    if (this.link.phase !== 'waiting') return;
    this.#timer = setTimeout(() => this.#due(), this.link.until - Date.now());
  }

  #due(): void {
    this.#timer = null;
    this.#follow({ kind: 'due' });
    if (this.link.phase === 'connecting') void this.open();
  }

  #refused(problem: Problem): void {
    if (problem.status === 404) {
      this.close();
      this.problem = problem;
    } else {
      if (!this.session) this.problem = problem;
      this.#lost();
    }
  }

  #follow(event: LinkEvent): void {
    this.link = advance(this.link, event);
  }
}
