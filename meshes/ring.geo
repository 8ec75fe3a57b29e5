// Ring about the origin between the radii 30 m and 50 m: 48 x 4 curved elements.
inner = 30;
outer = 50;
Point(1) = {0, 0, 0};
For i In {0 : 3}
  Point(10 + i) = {inner * Cos(i * Pi / 2), inner * Sin(i * Pi / 2), 0};
  Point(20 + i) = {outer * Cos(i * Pi / 2), outer * Sin(i * Pi / 2), 0};
EndFor
For i In {0 : 3}
  j = (i + 1) % 4;
  Circle(10 + i) = {10 + i, 1, 10 + j};
  Circle(20 + i) = {20 + i, 1, 20 + j};
  Line(30 + i) = {10 + i, 20 + i};
EndFor
For i In {0 : 3}
  j = (i + 1) % 4;
  Curve Loop(1 + i) = {30 + i, 20 + i, -(30 + j), -(10 + i)};
  Plane Surface(1 + i) = {1 + i};
EndFor
Transfinite Curve{10 : 13, 20 : 23} = 13;
Transfinite Curve{30 : 33} = 5;
Transfinite Surface{1 : 4};
Recombine Surface{1 : 4};
Physical Surface("plate") = {1 : 4};
