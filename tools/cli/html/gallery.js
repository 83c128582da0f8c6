// The gallery of a family's page: draws tags from their codewords, page by page, and finds them by
// id or codeword. A request may stand in the address: #ids=0-9,12  #code=0x1d5c6  #page=3
"use strict";
(() => {
  const data = JSON.parse(document.getElementById("family-data").textContent);
  const perPage = 48;
  const [form, input, status, grid, pager, place, back, forth, all] =
    ["search", "query", "status", "grid", "pager", "place", "back", "forth", "all"]
      .map((id) => document.getElementById(id));

  const hexOf = (id) => data.words.slice(id * data.digits, (id + 1) * data.digits);
  const bitsOfHex = (hex) => [...hex]
    .map((digit) => parseInt(digit, 16).toString(2).padStart(4, "0")).join("")
    .padStart(data.bits, "0").slice(-data.bits);

  function cellsOf(id) {
    const cells = [...data.cells];
    const bits = bitsOfHex(hexOf(id));
    data.order.forEach((at, i) => { cells[at] = bits[i] === "1" ? "w" : "b"; });
    return cells;
  }

  // The boundaries of the black areas as one path: along each, black is on the right hand.
  const step = [[1, 0], [0, 1], [-1, 0], [0, -1]];
  const rightCell = [[0, 0], [-1, 0], [-1, -1], [0, -1]];
  const leftCell = [[0, -1], [0, 0], [-1, 0], [-1, -1]];
  function blackPath(cells) {
    const width = data.width;
    const black = (x, y) =>
      x >= 0 && y >= 0 && x < width && y < width && cells[y * width + x] === "b";
    const isEdge = (x, y, d) => black(x + rightCell[d][0], y + rightCell[d][1]) &&
      !black(x + leftCell[d][0], y + leftCell[d][1]);
    const key = (x, y, d) => (y * (width + 1) + x) * 4 + d;
    const used = new Set();
    let path = "";
    for (let y0 = 0; y0 <= width; ++y0) {
      for (let x0 = 0; x0 <= width; ++x0) {
        if (!isEdge(x0, y0, 0) || used.has(key(x0, y0, 0))) continue;
        let [x, y, direction, from] = [x0, y0, 0, 0];
        path += `M${x} ${y}`;
        while (!used.has(key(x, y, direction))) {
          used.add(key(x, y, direction));
          if (direction !== from) path += from % 2 ? `V${y}` : `H${x}`;
          x += step[direction][0];
          y += step[direction][1];
          from = direction;
          direction = [1, 0, 3].map((turn) => (from + turn) % 4).find((d) => isEdge(x, y, d));
        }
        path += "z";
      }
    }
    return path;
  }

  const svg = (name, attributes) => {
    const element = document.createElementNS("http://www.w3.org/2000/svg", name);
    for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
    return element;
  };

  function figureOf(id, remark) {
    const side = data.width + 2;
    const picture = svg("svg", { viewBox: `-1 -1 ${side} ${side}`, class: "tag", role: "img" });
    const title = svg("title", {});
    title.textContent = `${data.name} id ${id}`;
    picture.append(title, svg("path", { class: "paper", d: `M-1-1h${side}v${side}h-${side}z` }));
    if (data.blank) picture.append(svg("path", { class: "blank", d: data.blank }));
    picture.append(svg("path", { class: "ink", d: blackPath(cellsOf(id)) }));
    const figure = document.createElement("figure");
    figure.id = `tag-${id}`;
    const caption = document.createElement("figcaption");
    const code = document.createElement("code");
    code.textContent = "0x" + hexOf(id);
    caption.append(`id ${id}`, document.createElement("br"), code);
    if (remark) caption.append(document.createElement("br"), remark);
    figure.append(picture, caption);
    return figure;
  }

  // Codewords as pairs of 32-bit numbers, made when the first codeword is looked for.
  let halves = null;
  const halfWords = (bits) => {
    const wide = bits.padStart(64, "0");
    return [parseInt(wide.slice(0, 32), 2) >>> 0, parseInt(wide.slice(32), 2) >>> 0];
  };
  function allHalves() {
    if (halves) return halves;
    halves = { high: new Uint32Array(data.listed), low: new Uint32Array(data.listed) };
    for (let id = 0; id < data.listed; ++id) {
      const hex = hexOf(id).padStart(16, "0");
      halves.high[id] = parseInt(hex.slice(0, 8), 16);
      halves.low[id] = parseInt(hex.slice(8), 16);
    }
    return halves;
  }
  function ones(word) {
    word -= (word >>> 1) & 0x55555555;
    word = (word & 0x33333333) + ((word >>> 2) & 0x33333333);
    return (((word + (word >>> 4)) & 0x0f0f0f0f) * 0x01010101 >>> 24);
  }
  // A quarter turn moves each of the four blocks to the place before it; a centre bit stays.
  function quarterTurn(bits) {
    const ring = bits.length - bits.length % 4;
    const block = ring / 4;
    return bits.slice(block, ring) + bits.slice(0, block) + bits.slice(ring);
  }

  // The tags nearest to a word that was read, in any of its four turns.
  function nearestTo(hex) {
    const { high, low } = allHalves();
    let least = data.bits + 1;
    let found = [];
    let bits = bitsOfHex(hex);
    for (let turns = 0; turns < 4; ++turns, bits = quarterTurn(bits)) {
      const [wordHigh, wordLow] = halfWords(bits);
      for (let id = 0; id < data.listed; ++id) {
        const distance = ones(high[id] ^ wordHigh) + ones(low[id] ^ wordLow);
        if (distance > least) continue;
        if (distance < least) found = [];
        least = distance;
        if (!found.some((tag) => tag.id === id)) found.push({ id, turns });
      }
    }
    found.sort((a, b) => a.id - b.id);
    return { least, found };
  }

  const count = (number) => number.toLocaleString("en-US");
  const notListed = data.listed < data.size
    ? ` This page lists the first ${count(data.listed)} of ${count(data.size)} tags.` : "";

  // Ids of a list such as "0-9,12,20-"; throws a sentence for what is none.
  function idsOf(text) {
    const ids = new Set();
    for (const part of text.split(",")) {
      const match = /^\s*(\d+)\s*(?:(-)\s*(\d*)\s*)?$/.exec(part);
      if (!match) throw `“${part.trim()}” is no id: write ids and ranges, like 0-9,12,20-.`;
      const first = Number(match[1]);
      const last = !match[2] ? first : match[3] === "" ? data.listed - 1 : Number(match[3]);
      if (Math.max(first, last) >= data.listed) {
        throw `There is no id ${Math.max(first, last)} here: ids are 0 to ${data.listed - 1}.` +
          notListed;
      }
      if (first > last) throw `The range ${part.trim()} runs backwards.`;
      for (let id = first; id <= last; ++id) ids.add(id);
    }
    return [...ids].sort((a, b) => a - b);
  }

  // What is shown: ids, what is said above them, and what under each.
  let shown = { ids: null, say: null, remark: "" };
  let page = 0;

  function draw() {
    const total = shown.ids ? shown.ids.length : data.listed;
    const pages = Math.max(1, Math.ceil(total / perPage));
    page = Math.min(Math.max(page, 0), pages - 1);
    const first = page * perPage;
    const last = Math.min(total, first + perPage);
    const figures = [];
    for (let i = first; i < last; ++i) {
      const id = shown.ids ? shown.ids[i] : i;
      figures.push(figureOf(id, shown.remark));
    }
    grid.replaceChildren(...figures);
    status.textContent = shown.say ? shown.say
      : shown.ids ? `${count(total)} ${total === 1 ? "tag" : "tags"} found.`
      : `${count(total)} tags; ids ${first} to ${last - 1} are shown.` + notListed;
    pager.hidden = pages === 1;
    place.textContent = `page ${page + 1} of ${pages}`;
    back.disabled = page === 0;
    forth.disabled = page === pages - 1;
  }

  function lookFor(text) {
    text = text.trim();
    page = 0;
    const code = /^(?:0x)?([0-9a-f]+)$/i.exec(text);
    try {
      if (text === "") {
        shown = { ids: null, say: null, remark: "" };
      } else if (code && (/^0x/i.test(text) || /[a-f]/i.test(text))) {
        const hex = code[1].replace(/^0+(?=.)/, "");
        const bits = (hex.length - 1) * 4 + parseInt(hex[0], 16).toString(2).length;
        if (bits > data.bits) throw `0x${hex} has more than the ${data.bits} bits of this family.`;
        const { least, found } = nearestTo(hex);
        const say = least === 0 ? `0x${hex} is a tag, perhaps turned.`
          : `0x${hex} is no tag. ${found.length === 1 ? "The nearest one differs"
            : "The nearest ones differ"} in ${least} ${least === 1 ? "bit" : "bits"}.` +
            (found.length > 1 || least > data.safe ? " That is too many to tell which was meant." : "");
        const turns = found.length === 1 ? `hamming ${least} rotation ${found[0].turns}`
          : `hamming ${least}`;
        shown = { ids: found.map((tag) => tag.id), say: say + notListed, remark: turns };
      } else {
        shown = { ids: idsOf(text), say: null, remark: "" };
      }
    } catch (complaint) {
      if (typeof complaint !== "string") throw complaint;
      shown = { ids: [], say: complaint, remark: "" };
    }
    draw();
  }

  function followAddress() {
    const wanted = new URLSearchParams(location.hash.slice(1));
    const text = wanted.get("ids") ?? wanted.get("code");
    if (wanted.has("code") && text && !/^0x/i.test(text)) input.value = "0x" + text;
    else input.value = text ?? "";
    lookFor(input.value);
    if (wanted.has("page")) {
      page = Number(wanted.get("page")) - 1 || 0;
      draw();
    }
    if (text || wanted.has("page")) form.scrollIntoView();
  }

  form.addEventListener("submit", (event) => {
    event.preventDefault();
    lookFor(input.value);
    history.replaceState(null, "", input.value.trim() === "" ? "#gallery"
      : "#ids=" + encodeURIComponent(input.value.trim()));
  });
  all.addEventListener("click", () => { input.value = ""; lookFor(""); });
  back.addEventListener("click", () => { --page; draw(); });
  forth.addEventListener("click", () => { ++page; draw(); });
  addEventListener("hashchange", followAddress);
  form.hidden = false;
  followAddress();
})();
