// A link to one engine. It sends messages one at a time and receives the answers.

export class EngineLink {
  constructor(engine, onAnswer) {
    this.engine = engine;
    this.onAnswer = onAnswer;
    this.waiting = [];
    this.busy = false;
    this.open();
  }

  open() {
    const address = new URL(`engine?engine=${this.engine}`, location.href);
    address.protocol = "ws:";
    this.socket = new WebSocket(address);
    this.socket.onopen = () => this.next();
    this.socket.onmessage = (event) => this.answered(JSON.parse(event.data));
    this.socket.onclose = () => {
      this.busy = false;
      if (!this.closed) this.onAnswer({kind: "stopped", why: "The lab's server has stopped. Start it again with make lab."});
    };
  }

  // Queue a message. Messages are sent one at a time, so that a slow engine is not flooded.
  send(message) {
    this.waiting.push(message);
    this.next();
  }

  next() {
    if (this.busy || !this.waiting.length || this.socket.readyState !== WebSocket.OPEN) return;
    this.busy = true;
    this.socket.send(JSON.stringify(this.waiting.shift()));
  }

  answered(answer) {
    // The engine is ready for the next message after any of these answers.
    if (["frame", "stopped", "refused", "judged"].includes(answer.kind)) {
      this.busy = false;
    }
    this.onAnswer(answer);
    this.next();
  }

  close() {
    this.closed = true;
    this.socket.close();
  }
}
