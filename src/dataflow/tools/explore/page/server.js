// What the page asks the server, which knows all the rules.

/// The answer to a question; an Error with one line for what the server refuses.
async function ask(question, request) {
  const response = await fetch(question, { method: "POST", body: JSON.stringify(request), headers: { "Content-Type": "application/json" } })
    .catch(() => { throw new Error("faster-sim explore does not answer: has it ended?"); });
  const answer = await response.json().catch(() => ({ error: `status ${response.status}` }));
  if (!response.ok) throw new Error(answer.error);
  return answer;
}

/// What is in the field of a number: of an empty one none, so that the server refuses it.
function number_in(field) {
  return field.value === "" ? "" : Number(field.value);
}

/// Asks for the newest only: what was wanted meanwhile and is not any more is never asked for.
class Latest {
  constructor(question, answered, failed) {
    Object.assign(this, { question, answered, failed });
    this.is_asking = false;
  }

  is_idle() {
    return !this.is_asking;
  }

  async want(request, context) {
    this.wanted = { request, context };
    if (this.is_asking) return;
    this.is_asking = true;
    while (this.wanted) {
      const asked = this.wanted;
      this.wanted = null;
      await ask(this.question, asked.request).then(
        (answer) => this.answered(answer, asked.context, this.wanted !== null),
        (error) => this.failed(error, asked.context, this.wanted !== null));
    }
    this.is_asking = false;
  }
}

/// Work in the background of the server. `told` gets its state now and then; the promise, the result, or null if it was cancelled.
class BackgroundJob {
  constructor(name, told) {
    Object.assign(this, { name, told });
  }

  async start(request) {
    const { number } = await ask("start", { job: this.name, ...request });
    for (;;) {
      const state = await ask("state", { job: this.name });
      if (number !== state.number) return null; // another one was started
      if (state.state === "failed") throw new Error(state.error);
      if (state.state !== "running") return state.result || null;
      this.told(state);
      await new Promise((resolve) => setTimeout(resolve, 150));
    }
  }

  cancel() {
    return ask("cancel", { job: this.name });
  }
}
