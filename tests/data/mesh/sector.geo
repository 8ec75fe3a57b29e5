// Half a ring between the radii 2 m and 4 m in 4 x 1 curved elements, the reader tests' mesh. The
// centre of the arcs is a construction point that no element uses.
Point(1) = {0, 0, 0};
Point(2) = {2, 0, 0};
Point(3) = {0, 2, 0};
Point(4) = {-2, 0, 0};
Point(5) = {4, 0, 0};
Point(6) = {0, 4, 0};
Point(7) = {-4, 0, 0};
Circle(1) = {2, 1, 3};
Circle(2) = {3, 1, 4};
Circle(3) = {5, 1, 6};
Circle(4) = {6, 1, 7};
Line(5) = {2, 5};
Line(6) = {3, 6};
Line(7) = {4, 7};
Curve Loop(1) = {5, 3, -6, -1};
Curve Loop(2) = {6, 4, -7, -2};
Plane Surface(1) = {1};
Plane Surface(2) = {2};
Transfinite Curve{1 : 4} = 3;
Transfinite Curve{5 : 7} = 2;
Transfinite Surface{1, 2};
Recombine Surface{1, 2};
