// Formulas are set in one go, and without messages in the corner of the page.
MathJax.Hub.Config({
  messageStyle: "none",
  showProcessingMessages: false,
  SVG: {EqnChunk: 500, EqnChunkDelay: 1}
});
