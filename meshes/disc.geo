// Disc of radius 50 m about the origin: a square core and four sectors, all quadrilaterals.
radius = 50;
core = 22;       // half diagonal of the core
n = 8;           // elements along a side of the core
across = 6;      // elements from the core to the rim
Point(1) = {0, 0, 0};
For i In {0 : 3}
  Point(10 + i) = {core * Cos((2 * i + 1) * Pi / 4), core * Sin((2 * i + 1) * Pi / 4), 0};
  Point(20 + i) = {radius * Cos((2 * i + 1) * Pi / 4), radius * Sin((2 * i + 1) * Pi / 4), 0};
EndFor
For i In {0 : 3}
  j = (i + 1) % 4;
  Line(10 + i) = {10 + i, 10 + j};
  Circle(20 + i) = {20 + i, 1, 20 + j};
  Line(30 + i) = {10 + i, 20 + i};
EndFor
Curve Loop(1) = {10, 11, 12, 13};
Plane Surface(1) = {1};
For i In {0 : 3}
  j = (i + 1) % 4;
  Curve Loop(2 + i) = {30 + i, 20 + i, -(30 + j), -(10 + i)};
  Plane Surface(2 + i) = {2 + i};
EndFor
Transfinite Curve{10 : 13, 20 : 23} = n + 1;
Transfinite Curve{30 : 33} = across + 1;
Transfinite Surface{1 : 5};
Recombine Surface{1 : 5};
Physical Surface("plate") = {1 : 5};
