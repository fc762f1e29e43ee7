# The files of the page, one a line.
set(HADA_PAGE_FILES
  api.js
  fold/camera.js
  fold/marks.js
  fold/paper.js
  fold/pointer.js
  fold/room.js
  fold/steps.js
  index.html
  main.js
  parts.js
  style.css
)
