// Tooltips that explain a term when the pointer or the focus is on it. Escape closes them.

let shown = null;

export function startTips() {
  const all = document.getElementById("tips");
  if (!all) return;
  const show = (link) => {
    hide();
    const tip = document.getElementById(link.getAttribute("aria-describedby"));
    if (!tip) return;
    shown = {tip, link};
    document.querySelector("main").append(tip); // move it out of the hidden list
    const box = link.getBoundingClientRect();
    const left = Math.min(box.left, document.documentElement.clientWidth - tip.offsetWidth - 8);
    const below = box.bottom + tip.offsetHeight + 8 < innerHeight;
    tip.style.left = `${Math.max(8, left) + scrollX}px`;
    tip.style.top = `${(below ? box.bottom + 4 : box.top - tip.offsetHeight - 4) + scrollY}px`;
  };
  const hide = () => {
    if (!shown) return;
    all.append(shown.tip);
    shown = null;
  };
  const termAt = (target) => target.closest?.(".term");
  document.addEventListener("focusin", ({target}) => (termAt(target) ? show(termAt(target)) : hide()));
  document.addEventListener("focusout", hide);
  document.addEventListener("pointerover", ({target}) => {
    const term = termAt(target);
    if (term && term !== shown?.link) show(term);
    else if (!term && shown && !shown.tip.contains(target) && shown.link !== document.activeElement) hideSoon();
  });
  // The pointer may move from the term to its tooltip.
  const hideSoon = () => {
    const {tip, link} = shown;
    setTimeout(() => {
      if (shown?.tip === tip && !tip.matches(":hover") && !link.matches(":hover, :focus")) hide();
    }, 200);
  };
  document.addEventListener("keydown", ({key}) => key === "Escape" && hide());
}
