(function () {
  "use strict";
  // No less-than sign and no ampersand in here: the page is well-formed XML too.
  function copyByMark(text) {
    var area = document.createElement("textarea");
    area.value = text;
    document.body.appendChild(area);
    area.select();
    var done = document.execCommand("copy");
    area.remove();
    return done;
  }
  function showCopied(button, done) {
    button.textContent = done ? "copied" : "mark it and copy";
    button.classList.toggle("done", done);
    setTimeout(function () { button.textContent = "copy"; button.classList.remove("done"); }, 1500);
  }
  document.addEventListener("click", function (event) {
    var text = event.target.dataset ? event.target.dataset.copy : undefined;
    if (!text) { return; }
    if (!navigator.clipboard) { showCopied(event.target, copyByMark(text)); return; }
    navigator.clipboard.writeText(text).then(
      function () { showCopied(event.target, true); },
      function () { showCopied(event.target, copyByMark(text)); });
  });

  var points = JSON.parse(document.getElementById("flight").textContent);
  var times = document.getElementById("times");
  var map = document.getElementById("map");
  if (!times || !map || !points.length) { return; }
  var cursor = document.getElementById("cursor");
  var here = document.getElementById("here");
  var readout = document.getElementById("readout");
  var hint = readout.textContent;
  var left = Number(times.dataset.left), right = Number(times.dataset.right);
  var start = Number(times.dataset.start), end = Number(times.dataset.end);

  function nearest(t) {
    var low = 0, high = points.length - 1;
    while (high > low) {
      var middle = Math.floor((low + high) / 2);
      if (points[middle][0] >= t) { high = middle; } else { low = middle + 1; }
    }
    return points[low];
  }
  function show(value, digits, unit) { return value === null ? "–" : value.toFixed(digits) + unit; }
  function clock(t) {
    var seconds = Math.floor(t % 60);
    return Math.floor(t / 60) + ":" + (seconds > 9 ? "" : "0") + seconds;
  }
  function move(event) {
    var box = times.getBoundingClientRect();
    var x = (event.clientX - box.left) / box.width * 1000;
    x = Math.max(left, Math.min(right, x));
    var p = nearest(start + (x - left) / (right - left) * (end - start));
    cursor.setAttribute("x1", x);
    cursor.setAttribute("x2", x);
    here.setAttribute("cx", p[1]);
    here.setAttribute("cy", p[2]);
    readout.textContent = clock(p[0]) + "   height " + show(p[3], 1, " m") + "   speed " + show(p[4], 1, " m/s")
      + "   battery " + show(p[5], 0, " %") + "   coverage " + show(p[6], 1, " %");
  }
  times.addEventListener("pointermove", move);
  times.addEventListener("pointerdown", move);
  times.addEventListener("pointerleave", function () {
    cursor.setAttribute("x1", -9);
    cursor.setAttribute("x2", -9);
    here.setAttribute("cx", -50);
    readout.textContent = hint;
  });
}());
