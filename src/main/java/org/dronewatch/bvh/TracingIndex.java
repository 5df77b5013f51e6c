package org.dronewatch.bvh;

import java.util.Optional;
import java.util.concurrent.CancellationException;
import org.dronewatch.geometry.AABB;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.kdtree.KDTree;
import org.dronewatch.kdtree.RayTracer;
import org.dronewatch.kdtree.SequentialTraversal;
import org.dronewatch.kdtree.StackTraversal;
import org.dronewatch.parallel.VectorInstructions;

/**
 * The acceleration structures that find the triangles of a mesh along rays: its kd-tree, and a BVH for incoherent rays
 * that is built when first needed and then kept. Immutable for callers, and shared by all threads.
 */
public final class TracingIndex {
    private final KDTree tree;
    private final RayTraversal traversal;
    private final Optional<FewTriangles> few;
    private final Optional<ConvexRoom> room;
    private Bvh bvh;

    /** An index of a finished tree; the BVH is only built when needed. */
    public TracingIndex(KDTree tree) {
        this(tree, RayTraversal.FASTEST);
    }

    /** An index of a finished tree that is traversed by a given method. */
    public TracingIndex(KDTree tree, RayTraversal traversal) {
        this.tree = tree;
        this.traversal = traversal;
        this.few = Optional.of(tree.triangles())
                .filter(triangles -> triangles.count() <= FewTriangles.MOST)
                .map(FewTriangles::new);
        this.room = few.flatMap(triangles -> ConvexRoom.of(tree.triangles()));
    }

    /**
     * Builds the index of a mesh; if the mesh has no triangles, no ray hits anything.
     *
     * @throws CancellationException when the thread is interrupted while the index is built
     */
    public static TracingIndex of(TriangleMesh mesh) {
        return of(mesh, TracingSettings.DEFAULT);
    }

    /**
     * Builds the index of a mesh.
     *
     * @param settings how the tree is built, and how rays traverse it
     * @throws CancellationException when the thread is interrupted while the index is built
     */
    public static TracingIndex of(TriangleMesh mesh, TracingSettings settings) {
        return new TracingIndex(KDTree.of(mesh, settings.costs()), settings.traversal());
    }

    /** The method of traversal by rays. */
    public RayTraversal traversal() {
        return traversal;
    }

    /** The kd-tree of the mesh. */
    public KDTree tree() {
        return tree;
    }

    /**
     * A new ray tracer for single rays, for use by one thread: a stack-based traversal of the kd-tree, unless the
     * settings choose another one.
     */
    public RayTracer newRayTracer() {
        return newRayTracer(tree);
    }

    /** A new ray tracer for single rays in another tree, such as a drone's, with the same traversal. */
    public RayTracer newRayTracer(KDTree other) {
        return traversal == RayTraversal.SEQUENTIAL ? new SequentialTraversal(other) : new StackTraversal(other);
    }

    /**
     * A new ray tracer for incoherent rays, which are unrelated to each other, such as those of diffuse sound, for use
     * by one thread. Where the processor's vector instructions can be used
     * ({@code --add-modules jdk.incubator.vector}), this tracer is three to four times as fast as that of
     * {@link #newRayTracer()} in large models, once the BVH has been built (in parallel if threads are available);
     * otherwise it is the same tracer. Both tracers find the same hits; where triangles meet at the very point that a
     * ray hits, they may report different triangles, and distances that differ in the last bit.
     *
     * @throws CancellationException when the thread is interrupted while the BVH is built
     */
    public RayTracer newIncoherentRayTracer() {
        if (traversal != RayTraversal.FASTEST || !suitsVectors()) {
            return newRayTracer();
        }
        return few.isPresent() ? new FewTrianglesTraversal(tree.triangles(), few.get()) : new BvhTraversal(tree, bvh());
    }

    /**
     * A new packet of incoherent rays that are traced together, or empty where that is not faster. Packets are faster
     * in meshes of a few triangles if the processor's vector instructions can be used, and in convex rooms of a few
     * triangles in any case. In such rooms, distances may differ from those of single rays by rounding, but do not
     * depend on the processor or the traversal.
     */
    public Optional<RayPacket> newRayPacket() {
        if (few.isEmpty()) {
            return Optional.empty();
        }
        RayTracer alone = newIncoherentRayTracer();
        if (room.isPresent()) {
            return Optional.of(
                    suitsVectors()
                            ? new VectorConvexRoomPacket(tree.triangles(), room.get(), alone)
                            : new ConvexRoomPacket(tree.triangles(), room.get(), alone));
        }
        return traversal == RayTraversal.FASTEST && suitsVectors()
                ? Optional.of(new FewTrianglesPacket(tree.triangles(), alone))
                : Optional.empty();
    }

    /**
     * A new tracer of segments with a common origin, for use by one thread. It is faster than single rays where the
     * processor's vector instructions can be used; the answers are the same.
     */
    public SegmentFan newSegmentFan() {
        return new SegmentFan(tree, newRayTracer(), traversal == RayTraversal.FASTEST && suitsVectors());
    }

    /**
     * Whether incoherent rays have a BVH: only if the processor's vector instructions can be used, and the mesh has
     * more than a few triangles, all of them near enough to the origin to be bounded in single precision.
     */
    public boolean hasBvh() {
        return suitsVectors() && few.isEmpty();
    }

    private boolean suitsVectors() {
        return VectorInstructions.areAvailable()
                && tree.mesh().triangleCount() > 0
                && reach(tree.bounds()) < Bvh.FARTHEST;
    }

    private static double reach(AABB box) {
        double x = Math.max(Math.abs(box.minX()), Math.abs(box.maxX()));
        double y = Math.max(Math.abs(box.minY()), Math.abs(box.maxY()));
        double z = Math.max(Math.abs(box.minZ()), Math.abs(box.maxZ()));
        return Math.max(x, Math.max(y, z));
    }

    /** The BVH, built when first needed. */
    synchronized Bvh bvh() {
        if (bvh == null) {
            bvh = new BvhBuilder(tree.triangles()).build();
        }
        return bvh;
    }
}
