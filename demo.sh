#!/usr/bin/env bash
# From nothing to a tree: installs what is missing, builds, makes a sample capture, turns its photographs
# into a package, and leaves in demo-out/ the package, a contact sheet of views that were held out, a table
# of figures and report.html that shows it all. No display needed.
set -euo pipefail
cd "$(dirname "$0")"

./third_party/install.sh
cmake --preset release
cmake --build --preset release --target bosk
bosk=build/app/bosk

out=demo-out
mkdir -p "$out"
if [ ! -d "$out/sample" ]; then
  "$bosk" phantom "$out/sample.part" --preset dense --seed 7 --width_px 480 --height_px 640
  mv "$out/sample.part" "$out/sample"
fi
"$bosk" new "$out/tree" "$out/sample/photos" --cameras "$out/sample/transforms.json" \
  --mattes "$out/sample/mattes" --replace
"$bosk" run "$out/tree" -o "$out/tree.bosk"
"$bosk" evaluate "$out/tree" --cameras "$out/sample/transforms_heldout.json" \
  --truth "$out/sample/heldout" --report "$out"

echo
echo "Done. Look at $out/report.html, or at:"
ls -l "$out/tree.bosk" "$out/contact-sheet.png" "$out/figures.txt" "$out/figures.json" "$out/report.html"
