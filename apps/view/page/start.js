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
  complain("This browser shows no WebGL; switch on hardware acceleration, or use another browser.");
const text = document.getElementById("three").textContent;
const address = URL.createObjectURL(new Blob([text], { type: "text/javascript" }));
const THREE = await import(address);
URL.revokeObjectURL(address);
