// A link to one engine: messages go out one at a time, and answers come back.

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
      if (!this.closed) this.onAnswer({kind: "stopped", why: "The lab's server has ended. Start it again, and load this page anew."});
    };
  }

  // Frames are asked for one message at a time: a slow engine is not flooded.
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
    // Every message is answered by a frame, a verdict or the reason why there is none.
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
