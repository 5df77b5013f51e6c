package org.dronewatch.bvh;

import java.util.Arrays;
import org.dronewatch.kdtree.LeafOrderTriangles;
import org.dronewatch.kdtree.RayTracer;

/**
 * Traces four rays in a {@linkplain ConvexRoom convex room}: from inside, a ray hits the wall whose plane it crosses
 * first. Rays from outside are traced one by one. {@link VectorConvexRoomPacket} gives the same results with vector
 * instructions, bit for bit.
 */
class ConvexRoomPacket extends RayPacket {
    static final int PLANE = ConvexRoom.PLANE;

    /** The last bits of a key are the wall's number: of walls whose keys differ only there, either is the nearest. */
    static final long NUMBER = FewTriangles.MOST - 1L;

    /** The planes of the walls. */
    final double[] planes;

    /** Origins and directions: x, y and z, four lanes each. */
    final double[] lanes = new double[6 * RAYS];

    /** For each wall the distances from its plane along the rays, with a minus sign if rays leave the room there. */
    final double[] parameters;

    /**
     * For each ray the smallest key: parameter bits and wall. The bits of negative numbers, which come first, are in
     * the order of their magnitudes.
     */
    final long[] nearest = new long[RAYS];

    /** Negative for rays that begin inside the room. */
    final long[] inside = new long[RAYS];

    private final RayTracer one;
    private final double[] dividers;

    /** The two triangles of each wall, as numbered in the mesh. */
    private final int[] triangles;

    ConvexRoomPacket(LeafOrderTriangles inLeafOrder, ConvexRoom room, RayTracer one) {
        super(inLeafOrder.numbers());
        this.one = one;
        this.planes = room.planes();
        this.dividers = room.dividers();
        this.triangles = Arrays.stream(room.triangles())
                .map(index -> inLeafOrder.numbers()[index])
                .toArray();
        this.parameters = new double[RAYS * room.count()];
        for (int ray = 0; ray < RAYS; ray++) {
            set(ray, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0);
        }
    }

    @Override
    public final void set(int ray, double ox, double oy, double oz, double dx, double dy, double dz) {
        lanes[ray] = ox;
        lanes[RAYS + ray] = oy;
        lanes[2 * RAYS + ray] = oz;
        lanes[3 * RAYS + ray] = dx;
        lanes[4 * RAYS + ray] = dy;
        lanes[5 * RAYS + ray] = dz;
    }

    @Override
    public final void trace(int rays) {
        findWalls();
        for (int ray = 0; ray < rays; ray++) {
            if (inside[ray] < 0L) {
                int wall = (int) (nearest[ray] & NUMBER);
                double distance = -parameters[RAYS * wall + ray];
                keepHit(ray, triangles[2 * wall + side(ray, wall, distance)], distance);
            } else {
                traceAlone(ray);
            }
        }
    }

    /** Finds the parameters of all walls, and the nearest wall on the way out, for all rays. */
    void findWalls() {
        Arrays.fill(nearest, Long.MAX_VALUE);
        Arrays.fill(inside, -1L);
        for (int wall = 0; wall < planes.length / PLANE; wall++) {
            double x = planes[PLANE * wall];
            double y = planes[PLANE * wall + 1];
            double z = planes[PLANE * wall + 2];
            for (int ray = 0; ray < RAYS; ray++) {
                double height =
                        x * lanes[ray] + y * lanes[RAYS + ray] + z * lanes[2 * RAYS + ray] - planes[PLANE * wall + 3];
                double rise = x * lanes[3 * RAYS + ray] + y * lanes[4 * RAYS + ray] + z * lanes[5 * RAYS + ray];
                double t = height / rise;
                parameters[RAYS * wall + ray] = t;
                nearest[ray] = Math.min(nearest[ray], Double.doubleToRawLongBits(t) & ~NUMBER | wall);
                inside[ray] &= Double.doubleToRawLongBits(height);
            }
        }
    }

    /** Which of a wall's triangles a ray hits, 0 or 1. */
    private int side(int ray, int wall, double distance) {
        double height = 0.0;
        for (int axis = 0; axis < 3; axis++) {
            double at = lanes[axis * RAYS + ray] + distance * lanes[(3 + axis) * RAYS + ray];
            height += dividers[PLANE * wall + axis] * at;
        }
        // Without a branch: 1 where the sign bit is set.
        return (int) (Double.doubleToRawLongBits(dividers[PLANE * wall + 3] - height) >>> Long.SIZE - 1);
    }

    private void traceAlone(int ray) {
        boolean hit = one.closestHit(
                lanes[ray],
                lanes[RAYS + ray],
                lanes[2 * RAYS + ray],
                lanes[3 * RAYS + ray],
                lanes[4 * RAYS + ray],
                lanes[5 * RAYS + ray],
                0.0,
                Double.POSITIVE_INFINITY);
        keep(ray, hit, one);
    }
}
