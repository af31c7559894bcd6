# For the tests that open pages in a browser: Debian's headless Chromium, without a network and with
# a profile of its own. Sourced after expect.sh, which makes the folder of the test.

browser=${GURNEY_BROWSER:-$(command -v chromium || true)}
[ -n "$browser" ] || { echo "skipped: there is no chromium"; exit 77; }
profile="$folder/profile"

# in_browser ARGUMENTS... PAGE.html: headless; what the page logs goes to `console`. A page that goes on
# by itself after its load is given time by --virtual-time-budget=MILLISECONDS, which passes at once.
in_browser() {
  local page=${*: -1}
  timeout -k 5 120 "$browser" --headless --no-sandbox --disable-gpu --disable-quic --no-first-run \
    --disable-background-networking --disable-component-update --disable-sync \
    --disable-dev-shm-usage --host-resolver-rules='MAP * ~NOTFOUND' --user-data-dir="$profile" \
    --enable-logging=stderr --v=0 "${@:1:$#-1}" \
    "file://$(realpath "$page" | sed 's/ /%20/g')" 2> log
  local code=$?
  grep -a ':CONSOLE' log > console
  return "$code"
}

# dom PAGE.html [ARGUMENTS...]: prints the page as it is once its scripts have run
dom() { in_browser --dump-dom "${@:2}" "$1"; }

# screenshot PAGE.html PICTURE.png WIDTH,HEIGHT [ARGUMENTS...]
screenshot() {
  in_browser --hide-scrollbars --screenshot="$PWD/$2" --window-size="$3" "${@:4}" "$1" > stdout
}

# quiet WHAT: the page that was opened last logged nothing
quiet() { [ -s console ] && { cp console stdout; complain "$1 logs"; }; }

# with_script PAGE.html SCRIPT.js COPY.html: a copy that runs a script at its end and shows what it
# returns, or throws, in the element <output id="found">
with_script() {
  awk -v script="$2" '
    /<\/body>/ {
      print "<output id=\"found\"></output><script>try { document.getElementById(\"found\").textContent ="
      print "JSON.stringify((() => {"
      while ((getline line < script) > 0) print line
      print "})()); } catch (error) { document.getElementById(\"found\").textContent = \"thrown: \" + error; }</script>"
    } {print}' "$1" > "$3"
}

# found: what the script of with_script returned, from the DOM on standard input
found() { sed -n 's/.*<output id="found">\(.*\)<\/output>.*/\1/p' | sed 's/&quot;/"/g; s/&lt;/</g; s/&gt;/>/g; s/&amp;/\&/g'; }
