/**
 * Models read from files: their settings, a reader of OBJ files with material libraries, polygons cut into triangles.
 */
package org.dronewatch.mesh.io;
