document.querySelectorAll('.picture').forEach(p => p.onclick = () => p.parentNode.classList.toggle('wide'));
document.querySelectorAll('button[data-show]').forEach(b => b.onclick = () => {
  document.querySelectorAll('button[data-show]').forEach(o => o.setAttribute('aria-pressed', o === b));
  document.querySelectorAll('figure').forEach(f => f.classList.toggle('hidden',
    b.dataset.show !== 'all' && f.dataset[b.dataset.show] === '0'));
});
