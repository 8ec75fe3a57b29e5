// Plate of 100 m x 60 m about the origin with a round hole of radius 10 m at (15, 5): unstructured.
size = 6;
Point(1) = {-50, -30, 0, size};
Point(2) = {50, -30, 0, size};
Point(3) = {50, 30, 0, size};
Point(4) = {-50, 30, 0, size};
Point(5) = {15, 5, 0};
Point(6) = {25, 5, 0, 0.5 * size};
Point(7) = {15, 15, 0, 0.5 * size};
Point(8) = {5, 5, 0, 0.5 * size};
Point(9) = {15, -5, 0, 0.5 * size};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Circle(5) = {6, 5, 7};
Circle(6) = {7, 5, 8};
Circle(7) = {8, 5, 9};
Circle(8) = {9, 5, 6};
Curve Loop(1) = {1, 2, 3, 4};
Curve Loop(2) = {5, 6, 7, 8};
Plane Surface(1) = {1, 2};
Recombine Surface{1};
Mesh.RecombinationAlgorithm = 3;  // all quadrilaterals
Physical Surface("plate") = {1};
