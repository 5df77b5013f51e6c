// A search box on every page. The text of all pages but the changelog is in js/pages.js, which is loaded when the box is first used, so that the
// site also works as plain files, without a server.
"use strict";
(function () {
  const MOST = 20;
  const AROUND = 60;

  /** Words in lower case. */
  function words(query) {
    return query.toLowerCase().split(/\s+/).filter(word => word.length > 0);
  }

  /** How well a section fits; 0 unless it contains every word. */
  function score(section, query) {
    let sum = 0;
    for (const word of query) {
      const inHeading = section.heading.toLowerCase().includes(word);
      const inTitle = section.title.toLowerCase().includes(word);
      const inText = section.text.toLowerCase().split(word).length - 1;
      if (!inHeading && !inTitle && inText === 0) {
        return 0;
      }
      sum += (inHeading ? 20 : 0) + (inTitle ? 10 : 0) + Math.min(inText, 9);
    }
    return sum;
  }

  function found(pages, text) {
    const query = words(text);
    if (query.length === 0) {
      return [];
    }
    return pages
      .map(section => ({ section, score: score(section, query) }))
      .filter(hit => hit.score > 0)
      .sort((a, b) => b.score - a.score)
      .slice(0, MOST)
      .map(hit => hit.section);
  }

  /** The words around the first one that was searched for. */
  function excerpt(section, text) {
    const at = Math.max(0, section.text.toLowerCase().indexOf(words(text)[0]));
    const from = Math.max(0, at - AROUND);
    const to = Math.min(section.text.length, at + 2 * AROUND);
    return (from > 0 ? "\u2026 " : "") + section.text.slice(from, to) + (to < section.text.length ? " \u2026" : "");
  }

  function entry(section, text) {
    const item = document.createElement("li");
    const link = document.createElement("a");
    link.href = section.page + (section.anchor ? "#" + section.anchor : "");
    link.textContent = section.heading === section.title ? section.title : section.title + ": " + section.heading;
    const about = document.createElement("span");
    about.textContent = excerpt(section, text);
    item.append(link, about);
    return item;
  }

  let loading;

  /** The sections of all pages, loaded once. */
  function load() {
    loading ??= new Promise((resolve, reject) => {
      const script = document.createElement("script");
      script.src = "js/pages.js";
      script.onload = () => resolve(window.dronewatchPages);
      script.onerror = reject;
      document.head.append(script);
    });
    return loading;
  }

  /** What is wider than the page scrolls by itself. */
  function wrapTables() {
    for (const table of document.querySelectorAll("#bodyColumn table")) {
      const wide = document.createElement("div");
      wide.className = "wide";
      table.before(wide);
      wide.append(table);
    }
  }

  document.addEventListener("DOMContentLoaded", () => {
    wrapTables();
    const place = document.querySelector("#banner .pull-right");
    if (!place) {
      return;
    }
    const form = document.createElement("form");
    form.id = "search";
    form.setAttribute("role", "search");
    const input = document.createElement("input");
    input.type = "search";
    input.placeholder = "Search";
    input.setAttribute("aria-label", "search the pages");
    const count = document.createElement("p");
    count.setAttribute("role", "status");
    const results = document.createElement("ol");
    results.hidden = true;
    form.append(input, count, results);
    place.append(form);

    function show(pages) {
      const hits = found(pages, input.value);
      const isAsked = words(input.value).length > 0;
      results.replaceChildren(...hits.map(section => entry(section, input.value)));
      results.hidden = hits.length === 0;
      count.textContent = !isAsked
        ? ""
        : hits.length === 0
          ? "nothing found"
          : hits.length === MOST
            ? MOST + " results or more"
            : hits.length === 1
              ? "1 result"
              : hits.length + " results";
    }

    form.addEventListener("submit", event => {
      event.preventDefault();
      const first = results.querySelector("a");
      if (first) {
        window.location.href = first.href;
      }
    });
    function search() {
      load().then(show, () => (count.textContent = "js/pages.js cannot be read"));
    }

    input.addEventListener("input", search);
    form.addEventListener("keydown", event => {
      if (event.key === "Escape") {
        input.value = "";
        search();
        input.focus();
      }
    });
  });
})();
