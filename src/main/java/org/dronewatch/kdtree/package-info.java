/**
 * An SAH kd-tree over the triangles of a mesh, packed into 64-bit words, and two ray tracers for it. Trees are
 * immutable and shared by all threads; a {@link org.dronewatch.kdtree.RayTracer} holds the scratch state of one thread.
 */
package org.dronewatch.kdtree;
