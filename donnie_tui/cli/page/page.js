"use strict";
(() => {
  // The terminal makes style elements. The policy of the page allows those with its nonce only.
  const nonce = document.currentScript.nonce;
  const create = document.createElement;
  document.createElement = function (...names) {
    const made = create.apply(this, names);
    if (made instanceof HTMLStyleElement) {
      made.nonce = nonce;
    }
    return made;
  };

  // Why the server closed the connection is said on the page.
  const TOO_LARGE = 1009;
  const PlainSocket = window.WebSocket;
  window.WebSocket = class extends PlainSocket {
    constructor(...values) {
      super(...values);
      this.addEventListener("close", (event) => {
        const reason = document.getElementById("reason");
        const said = event.code === TOO_LARGE ? reason.dataset.large : event.reason;
        reason.textContent = said || reason.dataset.ended;
        document.body.classList.add("-closed");
        document.getElementById("again").focus();
      });
    }
  };

  document.addEventListener("DOMContentLoaded", () => {
    document.getElementById("again").addEventListener("click", () => window.location.reload());
    // The terminal measures its font when it begins: that must be there by then.
    const begin = window.onload;
    window.onload = (event) => document.fonts.load('16px "Roboto Mono"').finally(() => begin(event));
  });
})();
