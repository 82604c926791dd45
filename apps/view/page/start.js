// three.js from the text that the page carries: a module without a network, also from file://.

function complain(message) {
  const alert = document.getElementById("alert");
  if (!alert.hidden) return; // what comes after the first complaint follows from it
  alert.textContent = message;
  alert.hidden = false;
}

addEventListener("error", (e) => complain(`The viewer stopped: ${e.message}`));
addEventListener("unhandledrejection", (e) => complain(`The viewer stopped: ${e.reason?.message ?? e.reason}`));
if (!document.createElement("canvas").getContext("webgl2"))
  complain("This browser does not provide WebGL; turn on hardware acceleration, or use another browser.");
// Colours of the picture and of the plot in both of the page's; those of its controls are in viewer.css.
const LIGHT = { background: "#f6f8fa", sheet: "#e9edf0", grid: "#c3ccd4", text: "#222222", lines: "#dddddd", least: 0 };
const DARK = { background: "#16191d", sheet: "#20252b", grid: "#3a424b", text: "#d5dbe1", lines: "#343b43", least: 0.5 };

/** A colour, made as light as it must be to be seen on the background. */
function seen(colour, { least }) {
  const hsl = new THREE.Color(colour).getHSL({});
  return new THREE.Color().setHSL(hsl.h, hsl.s, Math.max(hsl.l, least));
}

const text = document.getElementById("three").textContent;
const address = URL.createObjectURL(new Blob([text], { type: "text/javascript" }));
const THREE = await import(address);
URL.revokeObjectURL(address);
