const films = document.querySelectorAll("svg");
const [button] = document.getElementsByTagName("button");
const [slider] = document.getElementsByTagName("input");
const [time] = document.getElementsByTagName("output");
let plays = true;
const show = () => { time.textContent = Number(slider.value).toFixed(2) + " s"; };
const play = (wanted) => {
  plays = wanted;
  button.textContent = plays ? "Pause" : "Play";
  for (const film of films) plays ? film.unpauseAnimations() : film.pauseAnimations();
};
button.addEventListener("click", () => play(!plays));
slider.addEventListener("input", () => {
  play(false);
  for (const film of films) film.setCurrentTime(Number(slider.value));
  show();
});
const tick = () => {
  if (plays) { slider.value = films[0].getCurrentTime() % length; show(); }
  requestAnimationFrame(tick);
};
if (matchMedia("(prefers-reduced-motion: reduce)").matches) play(false);
tick();
