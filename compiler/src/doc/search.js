// Shows the entries whose name contains the typed text; "/" focuses the field.
const field = document.getElementById("search");
const entries = [...document.querySelectorAll(".entry")];
field.addEventListener("input", () => {
  const words = field.value.toLowerCase().split(/\s+/).filter(Boolean);
  for (const entry of entries) {
    const name = entry.dataset.name.toLowerCase();
    entry.hidden = !words.every((word) => name.includes(word));
  }
});
document.addEventListener("keydown", (event) => {
  if (event.key === "/" && document.activeElement !== field) {
    event.preventDefault();
    field.focus();
  }
});
