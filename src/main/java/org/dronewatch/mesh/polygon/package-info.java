/** Cuts the polygons of models into triangles. */
package org.dronewatch.mesh.polygon;
