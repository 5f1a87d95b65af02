// What the page knows: keyed values, set and taken away by messages. Everything shown is drawn from them.
const values = new Map();
const byId = id => document.getElementById(id);
const map = new FlightMap(byId("map"), () => wantDraw());
let vehicle = 0, chosen = null, isAiming = false, shownTime = null, isDrawWanted = false, lastMessage = 0, isComplete = false;
let token = sessionStorage.getItem("rabit-token") ?? "";

const get = key => values.get(`${vehicle}/${key}`);
const list = (key, of = vehicle) => {
  const all = [];
  for (const [k, v] of values) if (v !== null && k.startsWith(`${of}/${key}/`)) all.push([+k.slice(k.lastIndexOf("/") + 1), v]);
  return all.sort((a, b) => a[0] - b[0]).map(entry => entry[1]);
};

// Connection: a new one each half second until there is one; silence counts as loss.
function connect() {
  const socket = new WebSocket(location.origin.replace(/^http/, "ws") + "/live");
  let isFirst = true;
  socket.onmessage = e => {
    const message = JSON.parse(e.data);
    if (isFirst) { values.clear(); isFirst = false; isComplete = false; }
    lastMessage = performance.now();
    for (const key in message.set) values.set(key, message.set[key]);
    isComplete ||= message.complete;
    if (message.complete) wantDraw();
  };
  socket.onclose = () => { clearInterval(watch); isComplete = false; showConnection(); setTimeout(connect, 500); };
  const opened = performance.now();
  const watch = setInterval(() => {
    if (performance.now() - Math.max(opened, lastMessage) > 4000) socket.close();
    showConnection();
  }, 1000);
}

function showConnection() {
  const isLive = isComplete && performance.now() - lastMessage < 3000;
  const badge = byId("connection");
  badge.textContent = isLive ? "live" : values.size ? "no connection" : "connecting";
  badge.className = "badge " + (isLive ? "good" : "warn");
  document.body.classList.toggle("stale", !isLive && values.size > 0);
}

function wantDraw() {
  if (isDrawWanted) return;
  isDrawWanted = true;
  requestAnimationFrame(() => { isDrawWanted = false; draw(); });
}

const number = (value, digits = 0) => value == null ? "–" : value.toFixed(digits);
const unit = (value, digits, text) => value == null ? "–" : number(value, digits) + text;
const clock = s => s == null ? "–" : `${s < 0 ? "-" : ""}${Math.floor(Math.abs(s) / 60)}:${String(Math.floor(Math.abs(s) % 60)).padStart(2, "0")}`;
const degrees = d => d == null ? "–" : String(d).padStart(3, "0") + "°";
const show = (id, text) => { const e = byId(id); if (e.textContent !== text) e.textContent = text; };
const make = (tag, text, className) => { const e = document.createElement(tag); if (text != null) e.textContent = text; if (className) e.className = className; return e; };

// Replaces what a list shows, only where it says something else.
function fill(id, rows, render) {
  const element = byId(id), said = JSON.stringify(rows);
  if (element.said === said) return;
  element.said = said;
  element.replaceChildren(...rows.map(render));
}

function readPath() {
  const path = [];
  for (const group of list("path")) path.push(...group);
  return path;
}

function readPlan() {
  const plan = get("plan"), keepOuts = new Map(), figure = name => list("plan/" + name).flat();
  for (const key of values.keys()) {
    const match = key.match(/^(\d+)\/plan\/keepout(\d+)\/0$/);
    if (match && +match[1] === vehicle && values.get(key)) keepOuts.set(+match[2], figure("keepout" + match[2]));
  }
  return { about: plan, area: figure("area"), fence: figure("fence"), lanes: figure("lanes"), keepOuts: [...keepOuts.values()], home: plan && { lat: plan.lat, lon: plan.lon } };
}

function readSeen() {
  const frame = get("seen");
  return frame && { ...frame, bits: Array.from({ length: frame.rows }, (_, row) => get("seen/" + row)?.seen) };
}

function draw() {
  showConnection();
  const page = values.get("page") ?? {}, now = get("vehicle") ?? {}, path = readPath(), plan = readPlan();
  const slider = byId("slider");
  slider.max = Math.max(0, path.length - 1);
  let shown = path.length - 1;
  if (shownTime === null) slider.value = slider.max;
  else {
    shown = path.findIndex(s => s[0] >= shownTime);
    if (shown < 0) shown = path.length - 1;
    slider.value = shown;
  }
  const past = shownTime === null ? null : path[shown];
  byId("live").disabled = !past;
  byId("live").className = past ? "live" : "";
  drawMap(page, now, path, plan, shown, past);
  showPast(past);
  showVehicles(page);
  showFlight(now, plan);
  showEnergy();
  showHealth();
  showTracks(past);
  showLists();
  showCommands(page);
  show("about", page.up == null ? "" : `Page up ${clock(page.up)}, ${page.browsers} watching${page.refused ? `, ${page.refused} requests refused` : ""}${page.faults ? `, ${page.faults} faults of the page` : ""}`);
}

function drawMap(page, now, path, plan, shown, past) {
  const sample = past && { lat: past[1], lon: past[2], yaw: past[5] };
  const vehicles = [sample ?? now].filter(v => v.lat != null);
  if (!sample) for (let i = 0; i < (page.vehicles ?? 1); i++) {
    const other = values.get(i + "/vehicle");
    if (i !== vehicle && other?.lat != null) vehicles.push({ ...other, name: values.get(i + "/about")?.name });
  }
  const extent = [...(plan.area.length ? plan.area : plan.fence), ...path.map(s => [s[1], s[2]]), ...vehicles.map(v => [v.lat, v.lon])];
  if (plan.home) extent.push([plan.home.lat, plan.home.lon]);
  map.draw({
    hasTiles: page.tiles, seen: readSeen(), plan, path, shown, extent, vehicles, chosen,
    tracks: list("track").filter(t => !past || t.first <= past[0]), others: past ? [] : list("other"),
  });
  byId("follow").setAttribute("aria-pressed", map.follows);
}

function showPast(past) {
  byId("past").hidden = !past;
  if (past) show("past", `${clock(past[0])}: ${phaseNames[past[7]] ?? "?"}, ${number(past[3], 1)} m high, ${number(past[4], 1)} m/s, battery ${past[6] == null ? "–" : number(past[6] * 100) + " %"}, ${number(past[8] * 100, 1)} % covered`);
}

const phaseNames = ["observing", "waiting", "arming", "take-off", "transit", "searching", "revisit", "holding", "returning", "landing", "done", "handed over", "failed"];

function showVehicles(page) {
  const select = byId("vehicles"), names = Array.from({ length: page.vehicles ?? 0 }, (_, i) => values.get(i + "/about")?.name ?? "…");
  select.hidden = names.length < 2;
  fill("vehicles", names, name => make("option", name));
  select.selectedIndex = vehicle;
}

function showFlight(now, plan) {
  const mission = get("mission") ?? {}, wind = get("wind") ?? {}, camera = get("camera") ?? {};
  show("name", plan.about?.name ?? get("about")?.name ?? "Rabit");
  document.title = `${mission.phase ?? "live"}: ${plan.about?.name ?? "Rabit"}`;
  show("clock", clock(now.t));
  show("phase", mission.phase ?? "–");
  show("doing", mission.text ?? "–");
  show("next", mission.next ?? "–");
  show("lanes", mission.lanes ? `${mission.lanesFlown} of ${mission.lanes}` : "–");
  show("coverage", mission.lanes ? number(mission.coverage, 1) + " %" : "–");
  byId("coverage-bar").style.width = (mission.coverage ?? 0) + "%";
  show("targets", `${mission.confirmed ?? 0} confirmed, ${mission.revisits ?? 0} revisits`);
  show("mode", now.mode ? `${now.mode}, ${now.armed ? "armed" : "disarmed"}${now.connected ? "" : ", lost"}` : "not connected");
  show("height", now.height == null ? "–" : `${number(now.height, 1)} m, ${now.climb >= 0 ? "+" : ""}${number(now.climb, 1)} m/s`);
  show("speed", unit(now.speed, 1, " m/s"));
  show("home", now.home == null ? "–" : `${now.home} m at ${degrees(now.homeBearing)}`);
  show("wind", wind.speed == null ? "–" : `${number(wind.speed, 1)} m/s from ${degrees(wind.from)}`);
  show("gps", now.fix ? `${now.fix.replace(/^Type/, "")}, ${now.satellites ?? "?"} sats` : "–");
  show("camera", !camera.has ? "none" : camera.fault ?? (camera.usable == null ? `${camera.searched} pictures` : `${camera.usable} % usable, ${camera.searched} pictures`));
  const alarm = [mission.takenOver, mission.aborted && "given up: " + mission.aborted].filter(Boolean).join("; ");
  byId("alarm").hidden = !alarm;
  show("alarm", alarm);
}

function showEnergy() {
  const energy = get("energy") ?? {};
  show("battery", energy.volts == null && energy.remaining == null ? "–" : `${unit(energy.volts, 1, " V")} ${unit(energy.amperes, 1, " A")} ${unit(energy.remaining, 0, " %")}`);
  show("left", unit(energy.left ?? null, 0, " %"));
  show("home-takes", energy.home == null ? "–" : `${energy.home} % + ${energy.reserve} % kept`);
  show("to-return", !energy.known ? "–" : energy.outOfReach ? "home is out of reach" : energy.mustReturn ? "has to return" : clock(energy.toReturn));
  byId("energy-bar").style.width = (energy.left ?? energy.remaining ?? 0) + "%";
  byId("energy-need").style.left = energy.home == null ? "-2px" : Math.min(100, energy.home + energy.reserve) + "%";
}

function showHealth() {
  const health = get("health") ?? {}, level = health.level ?? "Unknown";
  const badge = byId("health");
  show("health", { Good: "healthy", Warning: "warning", Critical: "critical" }[level] ?? "health unknown");
  badge.className = "badge " + ({ Good: "good", Warning: "warn", Critical: "bad" }[level] ?? "");
  const reasons = (health.text ?? "").split("; ").filter(Boolean);
  if (health.advice) reasons.unshift(`advice: ${health.advice}${health.adviceText ? ", " + health.adviceText : ""}`);
  if (health.heartbeat === false) reasons.push("no heartbeat of ours");
  fill("reasons", reasons.length ? reasons : ["nothing is wrong"], text => make("li", text));
  show("computer", health.cpu == null && health.temperature == null ? "" : `computer: ${unit(health.cpu, 0, " % load")}, ${unit(health.temperature, 0, " °C")}`);
}

function showTracks(past) {
  const tracks = list("track").filter(t => !past || t.first <= past[0]).sort((a, b) => (a.state === "Confirmed" ? 0 : 1) - (b.state === "Confirmed" ? 0 : 1) || a.id - b.id);
  show("track-count", tracks.length ? `${tracks.filter(t => t.state === "Confirmed").length} confirmed of ${tracks.length}` : "none yet");
  const shown = tracks.slice(0, 60).map(t => ({ ...t, seen: undefined, isChosen: t.id === chosen, keys: t.id === chosen && canCommand() }));
  fill("tracks", shown, track => {
    const card = make("div", null, "track" + (track.isChosen ? " chosen" : ""));
    card.tabIndex = 0;
    const picture = make(track.picture ? "img" : "i");
    if (track.picture) { picture.src = `/picture/${vehicle}/${track.id}?${track.picture}`; picture.alt = `What the camera saw of track ${track.id}`; }
    const text = make("div");
    text.append(make("b", `${track.id} ${track.class}`), make("small", `${track.decision ? "by the operator: " + track.decision.toLowerCase() : track.state.toLowerCase()}, ±${number(track.major, 1)} m`), make("small", `${track.lat.toFixed(6)} ${track.lon.toFixed(6)}`));
    card.append(picture, text);
    if (track.keys) {
      const keys = make("div", null, "keys");
      for (const command of ["revisit", "confirm", "reject"]) {
        const key = make("button", command);
        key.onclick = e => { e.stopPropagation(); send({ command, track: track.id }); };
        keys.append(key);
      }
      card.append(keys);
    }
    card.onclick = () => choose(track.id);
    card.onkeydown = e => { if (e.key === "Enter" && e.target === card) choose(track.id); };
    return card;
  });
}

function choose(id) { chosen = chosen === id ? null : id; wantDraw(); }

function showLists() {
  fill("links", list("link"), link => {
    const row = make("div", null, "link");
    const isWell = link.state === "Receiving" || link.optional || link.state === "Ended";
    row.append(make("b", link.name ?? "link"), " ", make("span", link.state.toLowerCase(), isWell ? "soft" : "bad-text"), make("br"),
      `${number(link.in, 1)} frames/s in, ${number(link.out, 1)} out`);
    const lost = [link.missing && `${link.missing} missing`, link.lost && `${link.lost} bytes lost`, link.dropped && `${link.dropped} dropped`, link.roundTrip != null && `${link.roundTrip} ms round trip`, link.progress != null && `${link.progress} % of the log`, link.fault].filter(Boolean);
    if (lost.length) row.append(make("br"), make("span", lost.join(", "), "soft"));
    return row;
  });
  fill("managers", list("manager"), m => {
    const row = make("tr"), bad = ["Faulted", "Restarting", "Hanging"].includes(m.state);
    row.append(make("td", m.name), make("td", m.state.toLowerCase(), bad ? "bad-text" : ""), make("td", number(m.rate, 1), "n"), make("td", m.load == null ? "–" : number(m.load, 1) + " %", "n"), make("td", `${number(m.wake50, 1)} / ${number(m.wake99, 1)}`, "n"), make("td", String(m.missed), "n" + (m.missed ? " warn-text" : "")), make("td", String(m.faults + m.hangs), "n" + (m.faults + m.hangs ? " bad-text" : "")));
    if (m.fault) row.title = m.fault;
    return row;
  });
  fill("log", list("log").sort((a, b) => b.n - a.n), line => {
    const row = make("li", null, line.fault ? "warn-text" : "");
    row.append(make("time", clock(line.t)), make("span", line.from + ": ", "from"), line.text ?? "");
    return row;
  });
}

// Commands: with the token only, which goes in a header and stays in this tab.
const canCommand = () => token !== "" && get("about")?.commands && values.get("page")?.token;

function showCommands(page) {
  byId("commands").hidden = !(page.token && get("about")?.commands);
  byId("token-form").hidden = token !== "";
  byId("buttons").hidden = token === "";
  fill("given", list("command").sort((a, b) => b.n - a.n), c => make("li", `${clock(c.t)} ${c.name}: ${c.outcome === "InProgress" ? "…" : c.outcome.toLowerCase()}${c.answer ? ", " + c.answer : ""} (${c.by})`, c.outcome === "Refused" ? "bad-text" : ""));
}

function say(text, isBad) {
  byId("answer").textContent = text;
  byId("answer").className = "answer" + (isBad ? " bad" : "");
}

async function send(command) {
  say("…");
  try {
    const response = await fetch("/command", { method: "POST", headers: { "Authorization": "Bearer " + token, "Content-Type": "application/json" }, body: JSON.stringify({ vehicle, ...command }) });
    const text = await response.text();
    if (response.status === 401) forgetToken();
    say(response.ok ? `${text}: sent` : text, !response.ok);
  } catch { say("The command did not reach the aircraft.", true); }
}

function forgetToken() {
  token = "";
  sessionStorage.removeItem("rabit-token");
  wantDraw();
}

byId("token-form").onsubmit = e => {
  e.preventDefault();
  const given = byId("token").value.trim();
  byId("token").value = "";
  if (!/^[!-~]{16,256}$/.test(given)) { say("A token has 16 to 256 characters.", true); return; }
  token = given;
  sessionStorage.setItem("rabit-token", token);
  say("");
  wantDraw();
};

for (const button of document.querySelectorAll("[data-command]")) {
  const text = button.textContent;
  let sure = null;
  const calm = () => { clearTimeout(sure); sure = null; button.textContent = text; button.classList.remove("sure"); };
  button.onclick = () => {
    if ("twice" in button.dataset && !sure) {
      button.textContent = text + "?";
      button.classList.add("sure");
      sure = setTimeout(calm, 4000);
      return;
    }
    calm();
    send({ command: button.dataset.command });
  };
}

byId("speed-form").onsubmit = e => { e.preventDefault(); send({ command: "speed", metresPerSecond: +byId("new-speed").value }); };

function aim(isOn) {
  isAiming = isOn;
  byId("visit").setAttribute("aria-pressed", isOn);
  byId("map").classList.toggle("aim", isOn);
  say(isOn ? "Press the place on the map." : "");
}

byId("visit").onclick = () => aim(!isAiming);
map.onClick = (latitude, longitude, x, y) => {
  if (isAiming) { aim(false); send({ command: "visit", latitude, longitude }); return; }
  const near = list("track").map(t => [t.id, Math.hypot(...map.pixel(t.lat, t.lon).map((p, i) => p - [x, y][i]))]).sort((a, b) => a[1] - b[1])[0];
  chosen = near && near[1] < 18 ? near[0] : null;
  wantDraw();
};

byId("zoom-in").onclick = () => map.zoom(1.5);
byId("zoom-out").onclick = () => map.zoom(1 / 1.5);
byId("fit").onclick = () => map.fit();
byId("follow").onclick = () => { map.follows = !map.follows; map.isFitted = false; wantDraw(); };
byId("slider").oninput = e => { const path = readPath(), at = +e.target.value; shownTime = at >= path.length - 1 ? null : path[at][0]; wantDraw(); };
byId("live").onclick = () => { shownTime = null; wantDraw(); };
byId("vehicles").onchange = e => { vehicle = e.target.selectedIndex; chosen = null; shownTime = null; map.fit(); };
connect();
