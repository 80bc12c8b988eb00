#!/bin/sh
# The equation of state of hard disks: a sweep of 20 packings, 4 starts each, against theory.
#
#     sh equation_of_state.sh [CAROM] [FOLDER]      writes FOLDER/equation_of_state.svg
#
# 256 disks of radius r in an area of 64 pi have a packing of 4 r^2.  The line is the theory of
# scaled particles, Z = 1 / (1 - packing)^2 (Helfand, Frisch, Lebowitz, J. Chem. Phys. 34 (1961)
# 1037), which is right to 2 % up to a packing of 0.5; the dots are those of Kolafa and Rottner (Mol.
# Phys. 104 (2006) 3435).
set -e
carom=${1:-carom}
folder=${2:-equation_of_state}
cat >"$folder.json" <<END
{
  "name": "equation of state",
  "box": {"width": 14.179630807244127, "height": 14.179630807244127, "periodic": ["x", "y"]},
  "effects": {"collisions": {"restitution": 1}},
  "fill": [{"count": 256, "radius": 0.2, "temperature": 1, "arrangement": "hexagonal"}],
  "solver": {"method": "event"}, "seed": 1, "duration": 20, "frame_rate": 2
}
END
"$carom" sweep "$folder.json" "$folder" --quiet \
  --over /fill/0/radius=0.05:0.4:20 --over /seed=1..4
cat >"$folder/known.dat" <<END
.314159,2.1514393
.392699,2.7601235
.471239,3.663691
.549779,5.082362
.628319,7.476491
END
gnuplot <<END
set terminal svg size 700,420
set output '$folder/equation_of_state.svg'
set datafile separator ','
set xlabel 'packing'
set ylabel 'Z = P A / (N k T)'
set key left top
plot [0:0.66] '$folder/summary.csv' using (4*column('/fill/0/radius')**2):'Z_mean':'Z_stderr' \
    with yerrorbars pointtype 7 pointsize 0.6 title 'carom', \
  1 / (1 - x)**2 title 'scaled particle theory', \
  '$folder/known.dat' using 1:2 \
    with points pointtype 6 title 'Kolafa, Rottner'
END
