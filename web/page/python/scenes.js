// All scenes play in one worker. Each link has its own engine there, and messages are answered in turn.
// If the answer to one never ends, the worker is ended, and the scenes of the other links begin again.

export class Scenes {
  constructor(next) {
    this.next = next; // promises an interpreter
    this.interpreter = null;
    this.links = new Map();
    this.waiting = []; // waiting messages of all links
    this.busy = false;
    this.count = 0;
  }

  link(onAnswer) {
    const link = new Link(this, ++this.count, onAnswer);
    this.links.set(link.number, link);
    return link;
  }

  send(link, message) {
    this.waiting.push({link, message});
    this.work();
  }

  async work() {
    if (this.busy || !this.waiting.length) return;
    this.busy = true;
    const {link, message} = this.waiting.shift();
    if (!link.closed) await this.ask(link, message);
    this.busy = false;
    this.work();
  }

  async ask(link, message) {
    try {
      if (!this.interpreter || this.interpreter.ended) this.interpreter = await this.next();
    } catch (error) {
      return link.answered([{kind: "stopped", why: error.message}]);
    }
    const limit = message.kind === "load" ? "load" : "other";
    const end = await this.interpreter.answer({kind: "scene", link: link.number, message}, limit);
    if (end.kind === "answers") return link.answered(end.answers);
    const ended = end.kind === "left" || end.kind === "crashed";
    link.answered([{kind: "stopped", why: ended ? this.interpreter.words.left : end.why}]);
    if (end.kind === "failed" || end.kind === "lost") return;
    this.interpreter.end("A scene did not end.");
    for (const other of this.links.values()) if (other !== link) other.begin();
  }

  close(link) {
    this.links.delete(link.number);
    if (this.interpreter && !this.interpreter.ended) this.interpreter.send({kind: "close", link: link.number});
  }
}

class Link {
  constructor(scenes, number, onAnswer) {
    Object.assign(this, {scenes, number, onAnswer});
    this.pending = 0; // the number of messages that are not answered yet
    this.load = null; // the last message that loaded a scene
    this.closed = false;
  }

  get busy() {
    return this.pending > 0;
  }

  send(message) {
    if (message.kind === "load") this.load = message;
    this.pending += 1;
    this.scenes.send(this, message);
  }

  // The worker of this link has been ended, so its scene begins again.
  begin() {
    if (this.load) this.send(this.load);
  }

  answered(answers) {
    this.pending -= 1;
    if (this.closed) return;
    for (const answer of answers) this.onAnswer(answer);
  }

  close() {
    this.closed = true;
    this.scenes.close(this);
  }
}
