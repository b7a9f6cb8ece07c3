{{! Draws a figure, or one panel of a page, as SVG. Labels differ in colour, in dashes and in symbols; roles in how they are
    drawn. gnuplot's own error bars would put a white disc below each point: bars are vectors. }}
set encoding utf8
# What tells labels apart. The colours are Okabe and Ito's, without their yellow, which is too light on white, and with a grey.
array colour[8] = ["#000000", "#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#777777"]
array open[8] = [4, 6, 8, 10, 12, 14, 1, 2]
array filled[8] = [5, 7, 9, 11, 13, 15, 3, 3]
set dashtype 1 solid
set dashtype 2 (14,5)
set dashtype 3 (5,4)
set dashtype 4 (14,4,2,4)
set dashtype 5 (2,3)
set dashtype 6 (14,4,2,4,2,4)
set dashtype 7 (8,8)
set dashtype 8 (4,2,2,2)
{{#id}}
set terminal svg enhanced size {{width}},{{height}} font "Helvetica,14" background "#ffffff"
set key outside right top Left reverse samplen 4 spacing 1.1
set multiplot layout {{rows}},{{columns}} title "{{id}}: {{title}}\n{{#notes}}{{.}}\n{{/notes}}nipref figures {{id}}" font "Helvetica,15" noenhanced
{{/id}}
{{^id}}
set terminal svg enhanced size 480,{{#long_key}}400{{/long_key}}{{^long_key}}330{{/long_key}} font "Helvetica,13" background "#ffffff"
set key below center {{#long_key}}vertical maxrows 3{{/long_key}}{{^long_key}}horizontal{{/long_key}} Left reverse samplen 2 width -2 height 1
set offsets graph 0.03, graph 0.03, graph 0.08, graph 0
set rmargin 3
{{/id}}
# Powers of ten on logarithmic axes alone are enhanced text: names with underscores stay as they are.
set key noenhanced
set grid lc rgb "#dddddd" lw 0.5
{{#panels}}
{{#series}}
$series{{number}} << END
{{{points}}}END
{{/series}}
set xlabel "{{x_axis.label}}" noenhanced{{^id}} offset 0,0.7{{/id}}
set ylabel "{{y_axis.label}}" noenhanced
set format "%g"
unset logscale
{{#x_axis.logarithmic}}
set logscale x
set format x "10^{%T}"
{{/x_axis.logarithmic}}
{{#y_axis.logarithmic}}
set logscale y
set format y "10^{%T}"
{{/y_axis.logarithmic}}
{{^y_axis.logarithmic}}
{{^id}}
set yrange [0:]
{{/id}}
{{/y_axis.logarithmic}}
unset title
set size {{#equal_scales}}ratio -1{{/equal_scales}}{{^equal_scales}}noratio{{/equal_scales}}
{{#contours}}
$grid << END
{{{points}}}END
set title "{{label}}" noenhanced
set contour base
unset surface
set cntrparam levels incremental -10,{{step}},10
set palette maxcolors 0 defined (-1 "#0072B2", -0.5 "#8fbfdd", 0 "#ffffff", 0.5 "#eeb184", 1 "#D55E00")
set palette maxcolors {{colours}}
set cbrange [-{{largest}}:{{largest}}]
set cbtics {{tics}}
set table $contours
splot $grid using 1:2:3 with lines
unset table
unset contour
set surface
set xrange [{{x_first}}:{{x_last}}]
set yrange [{{y_first}}:{{y_last}}]
{{/contours}}
plot \
{{#plots}}
  {{#contours_drawn}}$grid using 1:2:3 with image notitle, \
  $contours using 1:($3 > 1e-9 ? $2 : NaN) with lines lw 0.7 dt 1 lc rgb "#555555" notitle, \
  $contours using 1:($3 < -1e-9 ? $2 : NaN) with lines lw 0.7 dt (6,4) lc rgb "#555555" notitle, \
  $contours using 1:(abs($3) <= 1e-9 ? $2 : NaN) with lines lw 2 dt 1 lc rgb "#000000" \
  {{/contours_drawn}}{{#line}}{{data}} with lines lw 2 dt {{style}} lc rgb colour[{{style}}] \
  {{/line}}{{#dots}}{{data}} with points pt 7 ps 0.2 lc rgb colour[{{style}}] \
  {{/dots}}{{#marked-line}}{{data}} with linespoints lw 1 dt 1 pt open[{{style}}] ps 0.6 pi {{every}} lc rgb colour[{{style}}] \
  {{/marked-line}}{{#points}}{{data}} with points pt open[{{style}}] ps 1 lw 1.3 lc rgb colour[{{style}}] \
  {{/points}}{{#bars}}{{^legend}}{{data}} using 1:3:(0):($4-$3) with vectors nohead lw 1 dt 1 lc rgb colour[{{style}}] notitle, \
  {{/legend}}{{data}}{{^legend}} using 1:2{{/legend}} with points pt filled[{{style}}] ps 0.55 lc rgb colour[{{style}}] \
  {{/bars}}{{#ranges}}{{data}}{{^legend}} using 1:3:(0):($4-$3){{/legend}} with vectors nohead lw 6 dt 1 lc rgb "#999999" \
  {{/ranges}}{{#star}}{{data}} with points pt 3 ps 1.2 lw 1.5 lc rgb colour[{{style}}] \
  {{/star}}{{#label_key}}{{data}} with linespoints lw 2 dt {{style}} pt open[{{style}}] lc rgb colour[{{style}}] \
  {{/label_key}}{{#legend}}title "{{.}}"{{/legend}}{{^legend}}notitle{{/legend}}{{#more}}, \{{/more}}
{{/plots}}

{{/panels}}
{{#id}}
unset multiplot
{{/id}}
