package org.dronewatch.geometry;

/**
 * The hit of a ray on a triangle.
 *
 * @param distance the ray parameter of the hit: metres for a ray of unit direction
 * @param triangle the triangle's number in its mesh
 * @param u barycentric coordinate of the triangle's second corner, 0 to 1
 * @param v barycentric coordinate of the third corner, 0 to 1; that of the first corner is 1 - u - v
 */
public record Hit(double distance, int triangle, double u, double v) {}
