G18 G71 G90 G94 G152
G00 X10 Z20
G01 Z10 F200
G02 X20 Z0 I10 K0 ; centre from the start
G03 X30 Z-10 R10
G06 G02 X40 Z-20 I40 K-10 ; centre from part zero
G08 X50 Z-30 ; goes on where the arc before has pointed
G09 X60 Z-40 I58 K-36 ; through a point
G02 Q90 I-6 K0 ; to the angle about the centre
M30
