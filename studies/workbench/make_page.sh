#!/usr/bin/env bash
# The page: one file with its engine, its scripts, the player of studies/playback and the overview of the fragility
# catalogue inside.
# usage: make_page.sh gurney.wasm workbench.html
set -euo pipefail
here=$(dirname "$0")
player=$here/../playback
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT

# filled MARK FILE < page: the page with the text of a file in place of a mark
filled() {
  awk -v mark="$1" -v file="$2" '
    (at = index($0, mark)) {
      printf "%s", substr($0, 1, at - 1)
      while ((getline line < file) > 0) print line
      print substr($0, at + length(mark))
      next
    } {print}'
}

cat "$player"/{vectors,recording,meshes,shaders,renderer,camera,room,graph,widgets,saving,player}.js > "$folder/player.js"
filled '/*STYLE*/' "$player/playback.css" < "$player/page.html" |
  filled '/*SCRIPT*/' "$folder/player.js" | base64 > "$folder/playback"
for each in engine="$1" overview="$here/../../docs/catalogue/overview.html"; do
  gzip -9 --no-name --stdout "${each#*=}" | base64 > "$folder/${each%%=*}"
done
cat "$here"/{host,worker}.js > "$folder/worker.js"
cat "$here"/{engines,jobtext,textpane,plan,itemeditor,prevented,page}.js > "$folder/page.js"
filled '/*STYLE*/' "$here/workbench.css" < "$here/page.html" | filled '/*ENGINE*/' "$folder/engine" |
  filled '/*PLAYBACK*/' "$folder/playback" | filled '/*OVERVIEW*/' "$folder/overview" | filled '/*WORKER*/' "$folder/worker.js" |
  filled '/*SCRIPT*/' "$folder/page.js" > "$2"
