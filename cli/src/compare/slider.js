for (const slider of document.querySelectorAll(".slider")) {
  const range = slider.querySelector("input");
  const show = () => slider.style.setProperty("--share", `${range.value}%`);
  const point = (event) => {
    const { left, width } = slider.querySelector(".stack").getBoundingClientRect();
    range.value = (100 * (event.clientX - left)) / width;
    show();
  };
  range.addEventListener("input", show);
  slider.querySelector(".stack").addEventListener("pointermove", (event) => event.buttons && point(event));
  slider.querySelector(".stack").addEventListener("pointerdown", (event) => { event.preventDefault(); point(event); range.focus(); });
  show();
}
