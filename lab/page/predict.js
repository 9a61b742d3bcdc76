// Ask a question that the reader answers before the scene runs, and then show the verdict.

export function ask(place, question, {watch, skip}) {
  place.hidden = !question;
  if (!question) return;
  const form = document.createElement("form");
  const field = document.createElement("fieldset");
  const legend = document.createElement("legend");
  legend.textContent = `Predict: ${question.words}`;
  field.append(legend);
  question.options.forEach((words, number) => {
    const label = document.createElement("label");
    const radio = document.createElement("input");
    Object.assign(radio, {type: "radio", name: "option", value: number, required: true});
    label.append(radio, ` ${words}`);
    field.append(label, document.createElement("br"));
  });
  const commit = document.createElement("button");
  commit.textContent = "This is my answer: run the scene";
  const later = document.createElement("button");
  Object.assign(later, {type: "button", textContent: "Skip the question"});
  form.append(field, commit, " ", later);
  form.onsubmit = (event) => {
    event.preventDefault();
    const option = Number(new FormData(form).get("option"));
    for (const each of form.elements) each.disabled = true;
    watch(option, (answer) => show(place, question, answer));
  };
  later.onclick = () => {
    place.hidden = true;
    skip();
  };
  place.replaceChildren(form);
}

function show(place, question, {right, answer, why}) {
  const words = document.createElement("p");
  words.setAttribute("role", "status");
  words.textContent = `${right ? "Right." : `Not quite: ${question.options[answer]}`} ${why}`;
  place.append(words);
}
