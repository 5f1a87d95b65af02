// The map: Web Mercator, so that tiles fit; pan by drag, zoom by wheel and two fingers.
const Mercator = {
  x: lon => (lon + 180) / 360,
  y: lat => { const s = Math.sin(lat * Math.PI / 180); return .5 - Math.log((1 + s) / (1 - s)) / (4 * Math.PI); },
  lon: x => x * 360 - 180,
  lat: y => Math.atan(Math.sinh(Math.PI * (1 - 2 * y))) * 180 / Math.PI,
  // The whole world is one wide: metres of the ground in that measure.
  metres: lat => 1 / (40075016.686 * Math.cos(lat * Math.PI / 180)),
};

const phaseColours = ["idle", "idle", "idle", "takeoff", "transit", "search", "revisit", "hold", "return", "land", "idle", "hold", "failed"];
const classColours = { red: "#cd1c20", orange: "#f27012", blue: "#1c48cd", yellow: "#f3d61c", magenta: "#d42496" };

class FlightMap {
  constructor(canvas, changed) {
    this.canvas = canvas;
    this.changed = changed;
    this.centre = null;
    this.scale = 1;
    this.isFitted = true;
    this.follows = false;
    this.tiles = new Map();
    this.pointers = new Map();
    this.onClick = () => {};
    this.readColours();
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => { this.readColours(); changed(); });
    new ResizeObserver(() => changed()).observe(canvas);
    canvas.addEventListener("wheel", e => { e.preventDefault(); this.zoom(Math.exp(-e.deltaY / 400), e.offsetX, e.offsetY); }, { passive: false });
    canvas.addEventListener("pointerdown", e => this.press(e));
    canvas.addEventListener("pointermove", e => this.drag(e));
    for (const end of ["pointerup", "pointercancel"]) canvas.addEventListener(end, e => this.release(e));
  }

  readColours() {
    const style = getComputedStyle(document.documentElement);
    this.colour = name => style.getPropertyValue("--" + name).trim();
  }

  press(e) {
    this.canvas.setPointerCapture(e.pointerId);
    this.pointers.set(e.pointerId, { x: e.offsetX, y: e.offsetY });
    this.moved = 0;
  }

  drag(e) {
    const before = this.pointers.get(e.pointerId);
    if (!before || !this.centre) return;
    const now = { x: e.offsetX, y: e.offsetY };
    const other = [...this.pointers].find(([id]) => id !== e.pointerId)?.[1];
    if (other) {
      const distance = p => Math.hypot(p.x - other.x, p.y - other.y);
      if (distance(before) > 10) this.zoom(distance(now) / distance(before), other.x, other.y);
    } else {
      this.moved += Math.hypot(now.x - before.x, now.y - before.y);
      if (this.moved > 4) this.move((before.x - now.x) / this.scale, (before.y - now.y) / this.scale);
    }
    this.pointers.set(e.pointerId, now);
  }

  release(e) {
    const wasAlone = this.pointers.size === 1 && this.pointers.has(e.pointerId);
    this.pointers.delete(e.pointerId);
    if (wasAlone && this.moved <= 4 && e.type === "pointerup" && this.centre) {
      const at = this.placeOf(e.offsetX, e.offsetY);
      this.onClick(at.lat, at.lon, e.offsetX, e.offsetY);
    }
  }

  move(dx, dy) {
    this.centre = { x: this.centre.x + dx, y: this.centre.y + dy };
    this.isFitted = this.follows = false;
    this.changed();
  }

  zoom(factor, x = this.canvas.clientWidth / 2, y = this.canvas.clientHeight / 2) {
    if (!this.centre) return;
    const to = Math.min(2 ** 31, Math.max(2 ** 9, this.scale * factor));
    const [ox, oy] = [x - this.canvas.clientWidth / 2, y - this.canvas.clientHeight / 2];
    this.centre = { x: this.centre.x + ox / this.scale - ox / to, y: this.centre.y + oy / this.scale - oy / to };
    this.scale = to;
    this.isFitted = false;
    this.changed();
  }

  fit() { this.isFitted = true; this.follows = false; this.changed(); }

  fitTo(points) {
    if (!points.length) return;
    const xs = points.map(p => Mercator.x(p[1])), ys = points.map(p => Mercator.y(p[0]));
    const [w, e, n, s] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
    const least = 60 * Mercator.metres(points[0][0]);
    this.centre = { x: (w + e) / 2, y: (n + s) / 2 };
    this.scale = .86 * Math.min(this.canvas.clientWidth / Math.max(e - w, least), this.canvas.clientHeight / Math.max(s - n, least));
  }

  placeOf(x, y) {
    return {
      lat: Mercator.lat(this.centre.y + (y - this.canvas.clientHeight / 2) / this.scale),
      lon: Mercator.lon(this.centre.x + (x - this.canvas.clientWidth / 2) / this.scale),
    };
  }

  pixel(lat, lon) {
    return [
      (Mercator.x(lon) - this.centre.x) * this.scale + this.canvas.clientWidth / 2,
      (Mercator.y(lat) - this.centre.y) * this.scale + this.canvas.clientHeight / 2,
    ];
  }

  // view: { plan, seen, path, shown, tracks, chosen, others, vehicles }; shown is the last sample that is drawn in full.
  draw(view) {
    const ratio = devicePixelRatio || 1, width = this.canvas.clientWidth, height = this.canvas.clientHeight;
    if (this.canvas.width !== Math.round(width * ratio) || this.canvas.height !== Math.round(height * ratio)) {
      this.canvas.width = Math.round(width * ratio);
      this.canvas.height = Math.round(height * ratio);
    }
    const c = this.context = this.canvas.getContext("2d");
    c.setTransform(ratio, 0, 0, ratio, 0, 0);
    c.clearRect(0, 0, width, height);
    const vehicle = view.vehicles[0];
    if (this.isFitted) this.fitTo(view.extent);
    if (this.follows && vehicle) this.centre = { x: Mercator.x(vehicle.lon), y: Mercator.y(vehicle.lat) };
    if (!this.centre) return;
    if (view.hasTiles) this.drawTiles(width, height);
    this.drawSeen(view.seen);
    this.drawPlan(view.plan);
    this.drawPath(view.path, view.shown);
    for (const track of view.tracks) this.drawTrack(track, track.id === view.chosen);
    for (const other of view.others) this.drawVehicle(other, this.colour("p-hold"), "" + other.system);
    for (const v of view.vehicles.slice(1)) this.drawVehicle(v, this.colour("p-revisit"), v.name);
    if (vehicle) this.drawVehicle(vehicle, this.colour("accent"));
    this.drawScale(height);
  }

  drawTiles(width, height) {
    const zoom = Math.max(0, Math.min(22, Math.round(Math.log2(this.scale / 256)))), count = 2 ** zoom, side = this.scale / count;
    const from = this.placeOf(0, 0), to = this.placeOf(width, height);
    const [x0, x1] = [from.lon, to.lon].map(l => Math.floor(Mercator.x(l) * count));
    const [y0, y1] = [from.lat, to.lat].map(l => Math.floor(Mercator.y(l) * count));
    if ((x1 - x0 + 1) * (y1 - y0 + 1) > 120) return;
    for (let x = x0; x <= x1; x++) for (let y = y0; y <= y1; y++) {
      if (x < 0 || y < 0 || x >= count || y >= count) continue;
      const key = `${zoom}/${x}/${y}`;
      let tile = this.tiles.get(key);
      if (!tile) {
        if (this.tiles.size > 400) this.tiles.clear();
        this.tiles.set(key, tile = new Image());
        tile.onload = () => this.changed();
        tile.src = `/tiles/${key}.png`;
      }
      if (!tile.complete || !tile.naturalWidth) continue;
      this.context.drawImage(tile, (x / count - this.centre.x) * this.scale + width / 2, (y / count - this.centre.y) * this.scale + height / 2, side + .5, side + .5);
    }
  }

  drawSeen(seen) {
    if (!seen) return;
    const cells = document.createElement("canvas");
    cells.width = seen.columns;
    cells.height = seen.rows;
    const c = cells.getContext("2d");
    c.fillStyle = this.colour("seen");
    for (let row = 0; row < seen.rows; row++) {
      const bits = seen.bits[row] ?? "";
      for (let column = 0; column < seen.columns; column++)
        if (parseInt(bits[column >> 2] ?? "0", 16) & (8 >> (column & 3))) c.fillRect(column, seen.rows - 1 - row, 1, 1);
    }
    const [left, top] = this.pixel(seen.north, seen.west), [right, bottom] = this.pixel(seen.south, seen.east);
    this.context.save();
    this.context.globalAlpha = .3;
    this.context.imageSmoothingEnabled = false;
    this.context.drawImage(cells, left, top, right - left, bottom - top);
    this.context.restore();
  }

  line(points, isClosed) {
    const c = this.context;
    c.beginPath();
    points.forEach((p, i) => { const [x, y] = this.pixel(p[0], p[1]); i ? c.lineTo(x, y) : c.moveTo(x, y); });
    if (isClosed) c.closePath();
  }

  stroke(colour, width, dash = []) {
    const c = this.context;
    c.setLineDash(dash);
    c.lineWidth = width;
    c.strokeStyle = colour;
    c.stroke();
    c.setLineDash([]);
  }

  drawPlan(plan) {
    const c = this.context;
    if (plan.area) { this.line(plan.area, true); this.stroke(this.colour("ink"), 1.8); }
    if (plan.fence) { this.line(plan.fence, true); this.stroke(this.colour("bad"), 1.4, [9, 6]); }
    for (const keepOut of plan.keepOuts) {
      this.line(keepOut, true);
      c.save(); c.globalAlpha = .18; c.fillStyle = this.colour("bad"); c.fill(); c.restore();
      this.stroke(this.colour("bad"), 1.4);
    }
    for (let i = 0; i + 1 < (plan.lanes?.length ?? 0); i += 2) { this.line([plan.lanes[i], plan.lanes[i + 1]]); this.stroke(this.colour("soft"), 1, [3, 6]); }
    if (plan.home) {
      const [x, y] = this.pixel(plan.home.lat, plan.home.lon);
      c.beginPath(); c.moveTo(x, y - 8); c.lineTo(x + 8, y); c.lineTo(x + 5, y); c.lineTo(x + 5, y + 7); c.lineTo(x - 5, y + 7); c.lineTo(x - 5, y); c.lineTo(x - 8, y); c.closePath();
      c.fillStyle = this.colour("card"); c.fill(); this.stroke(this.colour("ink"), 1.6);
    }
  }

  // One line for each stretch of a phase.
  drawPath(path, shown) {
    for (let from = 0; from + 1 < path.length;) {
      const phase = path[from + 1][7];
      let to = from + 1;
      while (to + 1 < path.length && path[to + 1][7] === phase && to !== shown) to++;
      this.line(path.slice(from, to + 1).map(s => [s[1], s[2]]));
      this.context.globalAlpha = from >= shown ? .25 : 1;
      this.stroke(this.colour("p-" + (phaseColours[phase] ?? "idle")), 2.4);
      from = to;
    }
    this.context.globalAlpha = 1;
  }

  drawTrack(track, isChosen) {
    const c = this.context, [x, y] = this.pixel(track.lat, track.lon), metre = Mercator.metres(track.lat) * this.scale;
    const colour = classColours[track.class] ?? "#808080";
    c.save();
    if (track.state !== "Confirmed") c.globalAlpha = .55;
    c.beginPath();
    c.ellipse(x, y, Math.max(1, track.major * metre), Math.max(1, track.minor * metre), (track.axis - 90) * Math.PI / 180, 0, 7);
    c.fillStyle = colour + "22"; c.fill(); this.stroke(colour, isChosen ? 3 : 1.4, track.state === "Tentative" ? [4, 3] : []);
    c.beginPath(); c.arc(x, y, isChosen ? 6 : 4, 0, 7); c.fillStyle = colour; c.fill(); this.stroke(this.colour("halo"), 1.5);
    this.label(track.id, x + 7, y - 6);
    c.restore();
  }

  label(text, x, y) {
    const c = this.context;
    c.font = "600 12px system-ui, sans-serif";
    c.lineWidth = 3; c.strokeStyle = this.colour("halo"); c.strokeText(text, x, y);
    c.fillStyle = this.colour("ink"); c.fillText(text, x, y);
  }

  drawVehicle(vehicle, colour, name) {
    if (vehicle.lat == null) return;
    const c = this.context, [x, y] = this.pixel(vehicle.lat, vehicle.lon);
    c.save();
    c.translate(x, y);
    c.rotate((vehicle.yaw ?? 0) * Math.PI / 180);
    c.beginPath(); c.moveTo(0, -13); c.lineTo(9, 10); c.lineTo(0, 5); c.lineTo(-9, 10); c.closePath();
    c.fillStyle = colour; c.fill(); this.stroke(this.colour("halo"), 1.8);
    c.restore();
    if (name) this.label(name, x + 12, y + 4);
  }

  drawScale(height) {
    const metre = Mercator.metres(Mercator.lat(this.centre.y)) * this.scale;
    const power = 10 ** Math.floor(Math.log10(120 / metre)), metres = [5, 2, 1].map(n => n * power).find(n => n * metre <= 120) ?? power;
    const c = this.context, y = height - 12;
    c.beginPath(); c.moveTo(12, y - 5); c.lineTo(12, y); c.lineTo(12 + metres * metre, y); c.lineTo(12 + metres * metre, y - 5);
    this.stroke(this.colour("ink"), 1.5);
    this.label(metres >= 1000 ? metres / 1000 + " km" : metres + " m", 16, y - 5);
  }
}
