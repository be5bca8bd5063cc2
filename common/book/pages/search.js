// The book's search, its keys, and whether it is dark or light.
'use strict';
const query = document.getElementById('query');
const found = document.getElementById('found');
const up = query.dataset.up;
let ready = null;

function load(name) {
  return new Promise((done, failed) => {
    const script = document.createElement('script');
    script.src = up + name;
    script.onload = done;
    script.onerror = failed;
    document.head.append(script);
  });
}

// Only who searches waits for it.
function prepare() {
  ready ??= Promise.all([load('lunr.min.js'), load('search_index.js')]).then(() => lunr(function () {
    this.pipeline.remove(lunr.stemmer);  // beginnings of words are looked for
    this.pipeline.remove(lunr.stopWordFilter);
    this.ref('number');
    this.field('title', {boost: 8});
    this.field('page', {boost: 3});
    this.field('text');
    sections.forEach((section, number) => this.add({number, ...section}));
  })).catch(error => { ready = null; throw error; });
  return ready;
}

// Every word, or one that begins with it, must occur.
function matches(index, words) {
  const options = {
    presence: lunr.Query.presence.REQUIRED, wildcard: lunr.Query.wildcard.TRAILING, usePipeline: false
  };
  return index.query(query => words.forEach(word => query.term(word, options))).slice(0, 20);
}

function excerpt(text, word) {
  const at = Math.max(0, text.toLowerCase().indexOf(word) - 60);
  return (at > 0 ? '… ' : '') + text.slice(at, at + 160) + ' …';
}

function show(results, words) {
  found.replaceChildren();
  found.hidden = false;
  for (const result of results) {
    const section = sections[result.ref];
    const link = document.createElement('a');
    link.href = up + section.href;
    link.textContent = `${section.page}: ${section.title}`;
    const small = document.createElement('small');
    small.textContent = excerpt(section.text, words[words.length - 1]);
    link.append(small);
    found.append(link);
  }
  if (results.length === 0) found.append(Object.assign(document.createElement('p'), {textContent: 'Nothing found.'}));
}

query.addEventListener('input', async () => {
  const words = query.value.toLowerCase().split(/[^\p{L}\p{N}]+/u).filter(Boolean);
  if (words.length === 0) { found.hidden = true; return; }
  const typed = query.value;
  const index = await prepare();
  if (query.value === typed) show(matches(index, words), words);  // else a later call is on its way
});
query.addEventListener('focus', prepare);
document.addEventListener('click', event => { if (!event.target.closest('.search')) found.hidden = true; });
document.addEventListener('keydown', event => {
  const typing = event.target.matches('input, textarea');
  if (event.key === 'Escape') { found.hidden = true; query.blur(); }
  if (typing || event.ctrlKey || event.metaKey || event.altKey) return;
  if (event.key === '/') { event.preventDefault(); query.focus(); }
  const turn = {ArrowLeft: 'prev', ArrowRight: 'next'}[event.key];
  const link = turn && document.querySelector(`a[rel="${turn}"]`);
  if (link && !event.shiftKey) location.href = link.href;
});

const root = document.documentElement;
const kept = key => { try { return localStorage.getItem(key); } catch { return null; } };
if (kept('shade')) root.dataset.shade = kept('shade');
document.getElementById('shade').addEventListener('click', () => {
  const dark = root.dataset.shade ? root.dataset.shade === 'dark' : matchMedia('(prefers-color-scheme: dark)').matches;
  root.dataset.shade = dark ? 'light' : 'dark';
  try { localStorage.setItem('shade', root.dataset.shade); } catch { /* not kept, then */ }
});
// On a narrow screen the contents would stand before the text.
if (matchMedia('(max-width: 56rem)').matches) document.getElementById('contents').open = false;
