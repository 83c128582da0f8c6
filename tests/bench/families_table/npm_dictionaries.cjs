// Writes dictionaries of the npm package js-aruco2 as files of bit strings, which families_table
// reads: those that neither libapriltag nor OpenCV 4.6 carries, and those that our own
// constructions are compared with.
//   usage: node npm_dictionaries.cjs FOLDER_OF_THE_PACKAGE OUTPUT_FOLDER
const fs = require("fs");
const path = require("path");

const [packageFolder, output] = process.argv.slice(2);
const { AR } = require(packageFolder);
const wanted = ["APRILTAG_25h7", "APRILTAG_36h9", "ARUCO_MIP_16h3", "ARUCO_MIP_25h7",
  "ARUCO_MIP_36h12", "ARTOOLKITPLUS", "ARTOOLKITPLUSBCH", "ARTAG"];
for (const name of wanted) {
  require(path.join(packageFolder, "src", "dictionaries", name.toLowerCase() + ".js"));
  const { nBits, codeList } = AR.DICTIONARIES[name];
  const rows = codeList.map((code) => code.toString(2).padStart(nBits, "0"));
  // A family holds each codeword once: a table that repeats one is cut before it.
  const repeated = rows.findIndex((row, id) => rows.indexOf(row) < id);
  const kept = repeated < 0 ? rows : rows.slice(0, repeated);
  const title = repeated < 0 ? name : `${name}_first_${repeated}`;
  if (repeated >= 0) {
    console.error(`${name}: id ${repeated} has the codeword of id ${rows.indexOf(rows[repeated])}`);
  }
  fs.writeFileSync(path.join(output, name + ".dict"),
    `name ${title}\nnbits ${nBits}\n${kept.join("\n")}\n`);
}
