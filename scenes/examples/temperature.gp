# The temperature of a gas against time:
#
#     carom run inelastic --series series.csv
#     gnuplot temperature.gp        writes temperature.svg
set terminal svg size 700,420
set output 'temperature.svg'
set datafile separator ','
set xlabel 'time, s'
set ylabel 'kT, J'
set key off
plot 'series.csv' using 'time':'temperature' with lines linewidth 2
