/**
 * A bounding volume hierarchy with eight children per node, for incoherent rays, where the processor's vector
 * instructions can be used; segments with a common origin, which are traced together; and the index of a mesh, which
 * has such a hierarchy in addition to its kd-tree. Trees are immutable and shared by all threads; a ray tracer holds
 * the scratch state of one thread.
 */
package org.dronewatch.bvh;
