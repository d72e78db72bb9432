// Shows the entries whose verdict, and if refuted whose fault, is ticked. Without scripts all are shown.
(function () {
  var boxes = document.querySelectorAll("input[data-filter]");
  var entries = document.querySelectorAll("details.entry");
  var shown = document.getElementById("shown");
  function ticked(group) {
    var values = {};
    boxes.forEach(function (b) { if (b.dataset.filter === group && b.checked) values[b.value] = true; });
    return values;
  }
  function apply() {
    var verdicts = ticked("verdict"), severities = ticked("severity"), count = 0;
    entries.forEach(function (e) {
      var visible = verdicts[e.dataset.verdict] && (!e.dataset.severity || severities[e.dataset.severity]);
      e.hidden = !visible;
      if (visible) count += 1;
    });
    shown.textContent = count + " of " + entries.length + " entries shown";
  }
  // a link to an entry unfolds it, whatever is filtered
  function reveal() {
    var e = location.hash.length > 1 && document.getElementById(decodeURIComponent(location.hash.slice(1)));
    if (e && e.tagName === "DETAILS") { e.hidden = false; e.open = true; e.scrollIntoView(); }
  }
  boxes.forEach(function (b) { b.addEventListener("change", apply); });
  window.addEventListener("hashchange", reveal);
  window.addEventListener("beforeprint", function () { entries.forEach(function (e) { if (e.dataset.verdict === "refuted") e.open = true; }); });
  apply();
  reveal();
})();
