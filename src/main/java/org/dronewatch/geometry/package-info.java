/**
 * The vocabulary of shapes: points, rays, boxes, triangles and meshes, and where a ray hits them. Metres, right-handed,
 * z up in the world frame. This package knows nothing of trees, sensors or scenes.
 */
package org.dronewatch.geometry;
