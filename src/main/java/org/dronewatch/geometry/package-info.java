/**
 * Geometric primitives: points, rays, boxes, triangles and meshes, and intersections of rays with them. Metres,
 * right-handed, z up in the world frame. This package does not depend on trees, sensors or scenes.
 */
package org.dronewatch.geometry;
